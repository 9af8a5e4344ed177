# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every number property of every object follows an expression: the value arrives, and one out of range is refused."""

import sys
import unittest
from pathlib import Path

import FreeCAD
import Part

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import NO_BOOLEANS, DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.booleans import manifold_available
from freecad_trabecula.core.parameters import FaceParameters
from freecad_trabecula.core.voxels.parameters import VoxelParameters

_NUMBERS = ("Float", "Integer", "Length", "Distance", "Angle", "Volume", "FloatConstraint", "IntegerConstraint")
_VECTORS = ("Vector", "VectorDistance")


def number_paths(obj):
    """Return what an expression can be bound to: the number properties that are no results, vectors by component."""
    paths = []
    for name in obj.PropertiesList:
        kind = obj.getTypeIdOfProperty(name).replace("App::Property", "")
        ours = obj.getGroupOfProperty(name) not in ("Results", "Attachment", "", "Tools", "Base")
        ours = ours or name in ("Seed", "Deflection")
        if "ReadOnly" in obj.getEditorMode(name) or not ours:
            continue
        if kind in _NUMBERS:
            paths.append(name)
        elif kind in _VECTORS:
            paths += [f"{name}.{axis}" for axis in "xyz"]
    return paths


def value_at(obj, path):
    """Return the number at a path."""
    name, _, axis = path.partition(".")
    value = getattr(obj, name)
    value = getattr(value, axis) if axis else value
    return float(getattr(value, "Value", value))


def unit_of(obj, path):
    """Return the unit that an expression of this property needs."""
    kind = obj.getTypeIdOfProperty(path.split(".")[0])
    return " mm" if kind.endswith(("Length", "Distance")) else ""


class ExpressionTest(DocumentCase):
    def setUp(self):
        super().setUp()
        self.sheet = self.document.addObject("Spreadsheet::Sheet", "Numbers")

    def drive(self, obj, path, value):
        """Bind a property to a cell with a value, compute its object."""
        self.sheet.set("A1", f"={value!r}{unit_of(obj, path)}")
        self.sheet.recompute()
        obj.setExpression(path, "Numbers.A1")
        self.document.recompute()

    def free(self, obj, path, value):
        """Take the expression away and give the property its value back."""
        obj.setExpression(path, None)
        name, _, axis = path.partition(".")
        if axis:
            vector = getattr(obj, name)
            setattr(vector, axis, value)
            setattr(obj, name, vector)
        else:
            whole = "Integer" in obj.getTypeIdOfProperty(name)
            setattr(obj, name, int(value) if whole else value)
        self.document.recompute()
        self.assertTrue(obj.isValid(), (path, getattr(obj, "Status", "")))

    def assert_driven(self, obj, at_least, **values):
        """Every number of an object takes a new value from a cell; ``values`` are those that its neighbours bear."""
        paths = number_paths(obj)
        self.assertGreaterEqual(len(paths), at_least, paths)
        for path in paths:
            with self.subTest(object=obj.Name, path=path):
                before, status = value_at(obj, path), []
                whole = "Integer" in obj.getTypeIdOfProperty(path.split(".")[0])
                tried = [values[path.split(".")[0]]] if path.split(".")[0] in values else []
                tried += (
                    [before + 1, before - 1]
                    if whole
                    else [before * 1.25 + 0.125, before * 0.75, before + 1, before - 1]
                )
                for value in [one for one in tried if one != before]:
                    self.drive(obj, path, value)
                    if obj.isValid():
                        break
                    status.append(obj.Status)
                found, valid = value_at(obj, path), obj.isValid()
                self.free(obj, path, before)
                self.assertTrue(valid, status)
                self.assertAlmostEqual(found, value, 6)
                self.assertNotEqual(value, before)

    def assert_refused(self, obj, path, value, words):
        """A value out of range puts the object in error with a sentence; in range again it is whole."""
        before = value_at(obj, path)
        self.drive(obj, path, value)
        valid, status = obj.isValid(), obj.Status
        self.free(obj, path, before)
        self.assertFalse(valid, (path, status))
        self.assertRegex(status, words)

    def design(self, *parts):
        return make.make_design(self.document, small_job(n=2), parts)

    def test_prism_sites(self):
        (sites,) = self.design().sites
        self.assert_driven(sites, 6)
        self.drive(sites, "SitesX", 4)
        # Eq. 2.1: two faces of n x m each
        self.assertEqual(sites.Count, 2 * (4 * 2 + 4 * 2 + 2 * 2))
        self.free(sites, "SitesX", 2)
        self.assert_refused(sites, "BorderX", 6.0, "error: .*a_x|border")

    def test_face_sites(self):
        box = make.make_box(self.document)
        sites = make.make_face_sites(box, FaceParameters("Face6", c_u=2, c_v=2, b_u=1, b_v=1))
        sites.DirectionU, sites.DirectionV = FreeCAD.Vector(1, 0, 0), FreeCAD.Vector(0, 1, 0)
        self.assert_driven(sites, 13)
        self.drive(sites, "SpacingU", 4.0)
        # from the middle, x = 1, 5, 9 and y = 1, 3 ... 9
        self.assertEqual(sites.Count, 15)
        self.assert_refused(sites, "SpacingU", 0.0, "spacing c_u must be greater than 0, got 0 mm")

    def test_wireframe(self):
        wireframe = self.design().wireframe
        self.assert_driven(wireframe, 20)
        self.drive(wireframe, "PoreSizeLow", 0.5)
        self.drive(wireframe, "PoreSizeHigh", 0.5)
        self.assertEqual({round(size, 9) for size in wireframe.PoreSizes}, {0.5})

    def test_wireframe_values_out_of_range(self):
        wireframe = self.design().wireframe
        self.assert_refused(wireframe, "PoreSizeHigh", 0.1, r"PoreSize \(mm\).*low <= high, got 0.2 and 0.1")
        self.assert_refused(wireframe, "PoreSizeLow", 0.0, "at least 0.001 mm, got 0")
        self.assert_refused(wireframe, "PoreCorners", 99, r"corners of a pore must lie in 3\.\.12, got 99")
        self.assert_refused(wireframe, "PoreScatter", 7, "scatter of the corners must lie in 0..0.3, got 7")

    @unittest.skipUnless(manifold_available(), NO_BOOLEANS)
    def test_scaffold_that_follows_every_change(self):
        design = self.design("scaffold")
        design.scaffold.AutoUpdate = True
        design.scaffold.LayerFaces = ["Face6"]
        self.assert_driven(design.scaffold, 4)
        before = design.scaffold.AddedVolume.Value + design.scaffold.ScaffoldVolume.Value
        self.drive(design.scaffold, "LayerThickness", 0.25)
        self.assertNotAlmostEqual(design.scaffold.AddedVolume.Value + design.scaffold.ScaffoldVolume.Value, before)
        self.assert_refused(design.scaffold, "LayerThickness", 0.0, "error: .*LayerThickness|thick")

    def test_solid_scaffold(self):
        design = self.design()
        solid = self.document.addObject("Part::FeaturePython", "Solid")
        from freecad_trabecula.features.solid_scaffold import SolidScaffold

        SolidScaffold(solid)
        solid.Wireframe = design.wireframe
        self.document.recompute()
        self.assert_driven(solid, 4)
        key = solid.Proxy.key(solid)
        self.drive(solid, "TimeBudget", 30.0)
        self.assertNotEqual(solid.Proxy.key(solid), key)

    def test_analysis(self):
        box = make.make_box(self.document, 2, 3, 4)
        analysis = make.make_analysis(self.document, box, SliceParameters(thickness=0.5))
        analysis.SliceRange, analysis.SliceHigh = True, 1.5
        self.assert_driven(analysis, 5)
        self.drive(analysis, "SliceThickness", 0.25)
        self.assertEqual(analysis.Slices, 3 * 6)
        self.assert_refused(analysis, "SliceThickness", 0.0, "thick")

    def test_voxel_design(self):
        ring = self.document.addObject("Part::Feature", "Ring")
        ring.Shape = Part.makeBox(4, 4, 4).cut(Part.makeBox(2, 2, 4))
        design = make.make_voxel_design(self.document, ring, VoxelParameters(size=(0.5, 0.5, 0.5)))
        self.assert_driven(design, 5, VoxelCapAlpha=8, VoxelCapBeta=8)
        self.assert_refused(design, "VoxelSize.x", 0.0, "voxel's edges must be at least 0.0001 mm, got 0 mm")
        for axis in "xyz":
            self.drive(design, f"VoxelSize.{axis}", 1.0)
        # 3/4 of 64 mm3 in voxels of 1 mm3
        self.assertEqual(design.Voxels, 48)


if FreeCAD.GuiUp:
    raise unittest.SkipTest("runs in the console")
