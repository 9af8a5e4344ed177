# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies in an App::Part: what is made of them lies in the same one, and so where the body is seen."""

import math
import sys
import unittest
from pathlib import Path

import FreeCAD
import numpy as np
import Part

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import NO_BOOLEANS, DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core.booleans import manifold_available
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.features.containers import frame_of, seen_at


class ContainersTest(DocumentCase):
    def setUp(self):
        super().setUp()
        self.part = self.document.addObject("App::Part", "Part")
        self.part.Placement = FreeCAD.Placement(FreeCAD.Vector(50, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90))
        self.box = make.make_box(self.document, 3, 4, 5)
        self.part.addObject(self.box)

    def assert_beside_the_box(self, *objects):
        for obj in objects:
            self.assertEqual(obj.getParentGeoFeatureGroup(), self.part, obj.Name)

    @unittest.skipUnless(manifold_available(), NO_BOOLEANS)
    def test_a_design_lies_in_the_part_of_its_envelope_and_is_seen_where_that_is(self):
        design = make.make_design(self.document, small_job(), ("network", "scaffold"), envelope=self.box)
        bodies = make.body_objects(design.scaffold)
        self.assert_beside_the_box(design.wireframe, *design.sites, design.network, design.scaffold, *bodies)
        # the quarter turn takes (x, y) to (50 - y, x): the corner (3, 4, 5) to (46, 3, 5)
        box = design.scaffold.Mesh.BoundBox
        corners = seen_at(np.array([[box.XMin, box.YMin, box.ZMin], [box.XMax, box.YMax, box.ZMax]]), design.scaffold)
        np.testing.assert_allclose(corners, [[50, 0, 0], [46, 3, 5]], atol=1e-6)

    def test_an_analysis_voxels_and_their_layers_lie_there_too(self):
        analysis = make.make_analysis(self.document, self.box)
        ring = self.document.addObject("Part::Feature", "Ring")
        ring.Shape = Part.makeBox(4, 4, 4).cut(Part.makeBox(2, 2, 4))
        self.part.addObject(ring)
        voxels = make.make_voxel_design(self.document, ring, VoxelParameters(size=(0.5, 0.5, 0.5)))
        self.assert_beside_the_box(analysis, voxels, make.make_layer_shapes(voxels, [0]))

    def test_the_frames_of_parts_in_parts_add_up(self):
        outer = self.document.addObject("App::Part", "Outer")
        outer.Placement.Base = FreeCAD.Vector(0, 0, 7)
        outer.addObject(self.part)
        np.testing.assert_allclose(seen_at(np.array([1.0, 2.0, 3.0]), self.box), [48, 1, 10], atol=1e-9)
        self.assertAlmostEqual(frame_of(self.box).Rotation.Angle, math.pi / 2)

    def test_outside_of_parts_and_for_nothing_the_frame_is_that_of_the_document(self):
        alone = make.make_box(self.document)
        points = np.array([[1.0, 2.0, 3.0]])
        self.assertTrue(frame_of(None).isIdentity())
        self.assertIs(seen_at(points, alone), points)


if FreeCAD.GuiUp:
    raise unittest.SkipTest("runs in the console")
