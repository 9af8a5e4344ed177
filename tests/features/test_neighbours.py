# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's own tools on our results: Draft, Part, Mesh; what they make has the volume that it must have."""

import sys
import unittest
from dataclasses import replace
from pathlib import Path

import Draft
import FreeCAD
import Part

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import NO_BOOLEANS, DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core.booleans import manifold_available
from freecad_trabecula.core.voxels.parameters import VoxelParameters

_VECTOR = FreeCAD.Vector


@unittest.skipUnless(manifold_available(), NO_BOOLEANS)
class NeighboursTest(DocumentCase):
    def setUp(self):
        super().setUp()
        job = small_job(n=2)
        # three rods that do not cross
        job = replace(job, couplings=tuple(replace(coupling, limit=1) for coupling in job.couplings))
        design = make.make_design(self.document, job, ("network", "scaffold"))
        self.wireframe, self.network, self.scaffold = design.wireframe, design.network, design.scaffold
        self.solid = make.make_solid_scaffold(design.wireframe)
        self.shaped = (self.network, self.solid)

    def computed(self, obj):
        """Recompute and return an object that is whole."""
        self.document.recompute()
        self.assertTrue(obj.isValid(), obj.Label)
        return obj

    def test_draft_array_and_clone_hold_the_volume_so_many_times(self):
        for obj in self.shaped:
            volume = obj.Shape.Volume
            steps = (_VECTOR(12, 0, 0), _VECTOR(0, 12, 0), _VECTOR(0, 0, 12))
            array = self.computed(Draft.make_ortho_array(obj, *steps, 2, 1, 3, use_link=False))
            self.assertAlmostEqual(array.Shape.Volume / volume, 6, 9)
            clone = self.computed(Draft.make_clone(obj))
            self.assertAlmostEqual(clone.Shape.Volume / volume, 1, 9)

    def test_a_clone_and_an_array_follow_their_design(self):
        clone = self.computed(Draft.make_clone(self.network))
        before = clone.Shape.Volume
        make.set_pore(self.wireframe, "Face1.1.1", 0.3)
        make.set_pore(self.wireframe, "Face2.1.1", 0.3)
        self.computed(clone)
        self.assertAlmostEqual(clone.Shape.Volume, self.network.Shape.Volume)
        self.assertNotAlmostEqual(clone.Shape.Volume, before)

    def test_links_show_meshes_too(self):
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = self.scaffold
        link.Placement.Base = _VECTOR(20, 0, 0)
        self.computed(link)
        self.assertEqual(self.scaffold.Placement.Base, _VECTOR())

    def test_what_was_moved_stays_there_when_it_is_computed_anew(self):
        ring = self.document.addObject("Part::Feature", "Ring")
        ring.Shape = Part.makeBox(4, 4, 4).cut(Part.makeBox(2, 2, 4))
        voxels = make.make_voxel_design(self.document, ring, VoxelParameters(size=(0.5, 0.5, 0.5)))
        bodies = make.body_objects(self.scaffold)
        moved = [self.network, self.solid, self.scaffold, self.wireframe, bodies[0], voxels]
        Draft.move(moved, _VECTOR(20, 30, 40))
        make.set_pore(self.wireframe, "Face1.1.1", 0.4)
        voxels.VoxelSize = _VECTOR(1, 1, 1)
        self.document.recompute()
        for obj in moved:
            make.update(obj)
        for obj in moved:
            with self.subTest(object=obj.Name):
                self.assertTrue(obj.isValid())
                self.assertEqual(obj.Placement.Base, _VECTOR(20, 30, 40))
                box = (getattr(obj, "Mesh", None) or obj.Shape).BoundBox
                for low, high, edge in ((box.XMin, box.XMax, 20), (box.YMin, box.YMax, 30), (box.ZMin, box.ZMax, 40)):
                    # the box of a body of splines holds their poles too
                    self.assertGreater(low, edge - 0.3)
                    self.assertLess(high, edge + 10 + 0.3)
        self.assertEqual(self.network.Rebuilt, 1)

    def test_part_booleans_of_the_solid_scaffold_keep_the_sum_of_volumes(self):
        box = self.document.addObject("Part::Box", "Half")
        box.Length = 5
        found = {}
        for kind in ("Cut", "Common", "Fuse"):
            one = self.document.addObject("Part::" + kind, kind)
            one.Base, one.Tool = self.solid, box
            found[kind] = self.computed(one).Shape
            self.assertTrue(found[kind].isValid())
        volume = self.solid.Shape.Volume
        self.assertAlmostEqual(found["Cut"].Volume + found["Common"].Volume, volume, 3)
        self.assertAlmostEqual(found["Fuse"].Volume, volume + box.Shape.Volume - found["Common"].Volume, 3)

    def test_compound_and_mirror(self):
        compound = self.document.addObject("Part::Compound", "Compound")
        compound.Links = [self.network, self.solid, self.wireframe]
        self.assertEqual(len(self.computed(compound).Shape.Solids), 4)
        for obj in self.shaped:
            mirror = self.document.addObject("Part::Mirroring", "Mirror")
            mirror.Source, mirror.Normal = obj, _VECTOR(1, 0, 0)
            self.assertAlmostEqual(self.computed(mirror).Shape.Volume, obj.Shape.Volume, 6)

    def test_mesh_tools_find_nothing_to_mend_in_a_scaffold(self):
        mesh = self.scaffold.Mesh
        self.assertTrue(mesh.isSolid())
        self.assertFalse(mesh.hasNonManifolds() or mesh.hasSelfIntersections())
        for kind in ("FixDegenerations", "FixDuplicatedFaces", "HarmonizeNormals", "FillHoles"):
            tool = self.document.addObject("Mesh::" + kind, kind)
            tool.Source = self.scaffold
            self.assertEqual(self.computed(tool).Mesh.CountFacets, mesh.CountFacets, kind)
        fewer = mesh.copy()
        fewer.decimate(0.1, 0.5)
        self.assertLess(fewer.CountFacets, mesh.CountFacets)

    def test_a_scaffold_becomes_a_solid_by_parts_own_way(self):
        shape = Part.Shape()
        shape.makeShapeFromMesh(self.scaffold.Mesh.Topology, 0.01)
        solid = Part.makeSolid(shape)
        self.assertTrue(solid.isValid())
        self.assertAlmostEqual(solid.Volume, self.scaffold.Mesh.Volume, 2)

    def test_a_part_moves_what_it_holds(self):
        part = self.document.addObject("App::Part", "Part")
        part.addObject(self.network)
        part.Placement.Base = _VECTOR(5, 0, 0)
        self.computed(self.network)
        self.assertEqual(self.network.getGlobalPlacement().Base, _VECTOR(5, 0, 0))

    def test_a_group_holds_a_scaffold(self):
        group = self.document.addObject("App::DocumentObjectGroup", "Group")
        group.addObject(self.scaffold)
        self.computed(self.scaffold)


if FreeCAD.GuiUp:
    raise unittest.SkipTest("runs in the console")
