# SPDX-License-Identifier: LGPL-2.1-or-later
"""Designs copied into another document, whole and in part: all arrives, and what is lacking is named."""

import sys
import unittest
from pathlib import Path

import FreeCAD
import Part

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import NO_BOOLEANS, DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core.booleans import manifold_available
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.features import results
from freecad_trabecula.features.feature import is_a

#: What is not the same in a copy: links, and texts in which names of other objects stand.
_OWN = (
    "Label",
    "Label2",
    "Proxy",
    "ExpressionEngine",
    "MarkedFace",
    "Shape",
    "Mesh",
    "Visibility",
    "_ElementMapVersion",
    "Placement",
)


def told(obj):
    """Return the values of an object's properties that a copy must have too, shape and mesh by their figures."""
    found = {}
    for name in obj.PropertiesList:
        if name not in _OWN and "Link" not in obj.getTypeIdOfProperty(name):
            value = getattr(obj, name)
            value = _rounded(getattr(value, "Value", value))
            if isinstance(value, (bool, int, float, str, list)):
                found[name] = value
    shape, mesh = getattr(obj, "Shape", None), getattr(obj, "Mesh", None)
    if shape is not None and not shape.isNull():
        found["Shape"] = (
            len(shape.Faces),
            len(shape.Edges),
            len(shape.Vertexes),
            round(shape.BoundBox.DiagonalLength, 6),
        )
    if mesh is not None:
        found["Mesh"] = (mesh.CountFacets, round(mesh.Volume, 6))
    return found


def _rounded(value):
    """Numbers as a file keeps them."""
    if isinstance(value, float):
        return float(f"{value:.12g}") if value == value else "nan"
    if isinstance(value, (list, tuple)):
        return [_rounded(one) for one in value]
    if isinstance(value, FreeCAD.Vector):
        return [_rounded(one) for one in value]
    return value


@unittest.skipUnless(manifold_available(), NO_BOOLEANS)
class CopiesTest(DocumentCase):
    def setUp(self):
        super().setUp()
        self.other = FreeCAD.newDocument("Other")
        self.addCleanup(FreeCAD.closeDocument, "Other")
        # names that the copies cannot have
        self.other.addObject("Part::Box", "Wireframe")
        self.other.addObject("Part::Box", "Envelope").Length = 3

    def design(self):
        """Return a design by hand and by an expression, with all its bodies, an analysis and voxels made of it."""
        design = make.make_design(self.document, small_job(n=2, kind="box"), ("network", "scaffold"))
        make.set_pore(design.wireframe, "Face1.1.1", 0.5)
        design.wireframe.setExpression("PoreSizeLow", "Envelope.Length / 20")
        for obj in (design.wireframe, design.network, design.scaffold, *make.body_objects(design.scaffold)):
            make.update(obj)
        self.document.recompute()
        return design

    def test_a_whole_design_arrives_with_its_links_results_and_changes_by_hand(self):
        design = self.design()
        analysis = make.make_analysis(self.document, design.scaffold)
        wanted = [obj for obj in self.document.Objects if not obj.InList]
        copies = self.other.copyObject(wanted, True)
        self.assertEqual(len(copies), len(wanted))
        results.clear()
        self.other.recompute()
        self.assertEqual([kind for kind, _ in results._kept if kind in ("network", "scaffold", "analysis")], [])
        ours = [obj for obj in self.document.Objects if is_a(obj)]
        arrived = [obj for obj in self.other.Objects if is_a(obj)]
        self.assertEqual([type(obj.Proxy) for obj in arrived], [type(obj.Proxy) for obj in ours])
        for one, copy in zip(ours, arrived):
            before, after = told(one), told(copy)
            for name in before:
                with self.subTest(object=one.Name, property=name):
                    self.assertEqual(after[name], before[name])
        for copy in arrived:
            self.assertEqual({one.Document.Name for one in copy.OutList} - {"Other"}, set())
        wireframe = next(obj for obj in arrived if is_a(obj, type(design.wireframe.Proxy)))
        self.assertEqual([text for _, text in wireframe.ExpressionEngine], [f"{wireframe.Envelope.Name}.Length / 20"])
        self.assertEqual(analysis.isValid(), True)

    def test_a_copy_computes_by_itself_and_leaves_its_model_alone(self):
        design = self.design()
        before = told(design.wireframe)
        copy = self.other.copyObject(design.network, True)
        results.clear()
        copy.Wireframe.Envelope.Length = 12
        copy.Wireframe.Seed = 77
        self.other.recompute()
        self.assertEqual([obj.Label for obj in self.other.Objects if not obj.isValid()], [])
        self.assertAlmostEqual(copy.Shape.BoundBox.XLength, 12, 2)
        self.assertAlmostEqual(copy.Wireframe.PoreSizeLow.Value, 0.6)
        self.document.recompute()
        self.assertEqual(told(design.wireframe), before)
        make.set_pore(copy.Wireframe, "Face3.1.1", 0.4)
        self.assertEqual((len(copy.Wireframe.Edits), len(design.wireframe.Edits)), (2, 1))

    def test_a_second_design_in_the_same_document_is_a_design_of_its_own(self):
        design = self.design()
        copy = self.document.copyObject(design.network, True)
        self.assertNotEqual(copy.Wireframe, design.wireframe)
        self.assertNotEqual(copy.Wireframe.Envelope, design.envelope)
        copy.Wireframe.Seed = 77
        self.document.recompute()
        self.assertEqual((copy.isValid(), design.wireframe.Seed), (True, 1))

    def test_a_scaffold_without_its_wireframe_keeps_its_mesh_and_says_what_it_lacks(self):
        design = self.design()
        copy = self.other.copyObject(design.scaffold, False)
        facets = design.scaffold.Mesh.CountFacets
        self.other.recompute()
        self.assertFalse(copy.isValid())
        self.assertEqual((copy.Mesh.CountFacets, copy.UpToDate), (facets, False))
        self.assertRegex(copy.Status, "error: Scaffold must be linked to a wireframe, got Wireframe")
        wireframe = self.other.copyObject(design.wireframe, True)
        copy.Wireframe = wireframe
        make.update(copy)
        self.assertEqual((copy.isValid(), copy.UpToDate, copy.Mesh.CountFacets), (True, True, facets))

    def test_a_scaffold_that_meets_another_design_of_that_name_does_not_pass_for_its_scaffold(self):
        design = self.design()
        self.other.removeObject("Wireframe")
        other = make.make_design(self.other, small_job(n=3))
        copy = self.other.copyObject(design.scaffold, False)
        self.other.recompute()
        self.assertEqual(copy.Wireframe, other.wireframe)
        self.assertEqual((copy.UpToDate, copy.Status), (False, "out of date: update it"))

    def test_other_parts_without_what_they_are_made_of_say_so(self):
        design = self.design()
        design.wireframe.setExpression("PoreSizeLow", None)
        for name in ("Wireframe", "Envelope"):
            self.other.removeObject(name)
        for obj, words in (
            (design.sites[0], "must be linked to a box, got nothing"),
            (design.wireframe, "an envelope must have a shape, got nothing"),
            (design.network, "must be linked to a wireframe, got nothing"),
            (make.body_objects(design.scaffold)[0], "must be linked to a scaffold, got nothing"),
        ):
            copy = self.other.copyObject(obj, False)
            self.other.recompute()
            self.assertFalse(copy.isValid(), obj.Name)
            self.assertRegex(copy.Status, words)
            self.other.removeObject(copy.Name)

    def test_a_voxel_design_arrives_with_its_sample_or_without(self):
        ring = self.document.addObject("Part::Feature", "Ring")
        ring.Shape = Part.makeBox(4, 4, 4).cut(Part.makeBox(2, 2, 4))
        design = make.make_voxel_design(self.document, ring, VoxelParameters(size=(0.5, 0.5, 0.5)))
        alone, whole = self.other.copyObject(design, False), self.other.copyObject(design, True)
        results.clear()
        self.other.recompute()
        self.assertEqual((told(whole), whole.isValid()), (told(design), True))
        self.assertEqual(make.voxel_design_of(whole).voxels.sum(), 384)
        self.assertEqual(make.voxel_design_of(alone).voxels.sum(), 384)
        self.assertRegex(alone.Status, "must have a sample, a source, a file or drawn curves, got none")
        self.assertEqual(alone.Mesh.CountFacets, design.Mesh.CountFacets)


if FreeCAD.GuiUp:
    raise unittest.SkipTest("runs in the console")
