# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slice analyses in the document: closed forms, live when the source changes, kept in the file, compared."""

import sys
import tempfile
import unittest
from pathlib import Path

import FreeCAD
import Mesh
import numpy as np

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import NO_BOOLEANS, DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core.analysis.folder import load_analysis
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.booleans import manifold_available
from freecad_trabecula.errors import ParameterError, TrabeculaError
from freecad_trabecula.features import results
from freecad_trabecula.features.analysis import contours_at_hand, write_slice_parameters
from freecad_trabecula.features.on_demand import OUT_OF_DATE

COARSE = SliceParameters(thickness=0.5)


class AnalysisTest(DocumentCase):
    def box(self, *edges):
        return make.make_box(self.document, *(edges or (4, 6, 8)))

    def mesh(self, mesh):
        obj = self.document.addObject("Mesh::Feature", "Bone")
        obj.Mesh = mesh
        return obj

    def test_a_box_is_sliced_along_all_axes(self):
        obj = make.make_analysis(self.document, self.box(), COARSE)
        found = make.analysis_of(obj)
        for axis, area, count in (("x", 48.0, 8), ("y", 32.0, 12), ("z", 24.0, 16)):
            self.assertTrue(np.allclose(found.profiles[axis].sliced_area, area, rtol=1e-6))
            self.assertEqual(len(found.profiles[axis]), count)
        self.assertEqual((obj.Slices, obj.Contours, obj.SpoiltSlices, obj.UpToDate), (36, 36, 0, True))
        self.assertAlmostEqual(obj.BoneFraction, 100.0, 4)
        self.assertAlmostEqual(obj.SliceVolume.Value, 192.0, 4)
        self.assertIn("36 slices", obj.Status)

    def test_porosity_refers_to_the_envelope_if_there_is_one(self):
        sphere = self.document.addObject("Part::Sphere", "Sphere")
        sphere.Radius = 2
        self.document.recompute()
        around = self.document.addObject("Part::Sphere", "Around")
        around.Radius = 4
        self.document.recompute()
        obj = make.make_analysis(
            self.document, sphere, SliceParameters(0.5, ("z",), low=-1.5, high=1.5), envelope=around
        )
        profile = make.analysis_of(obj).profiles["z"]
        expected = 1 - (4 - profile.coordinate**2) / (16 - profile.coordinate**2)
        self.assertLess(np.abs(profile.porosity - expected).max(), 0.01)

    def test_a_mesh_is_sliced_where_it_is_placed(self):
        mesh = Mesh.createBox(2, 2, 2)
        mesh.Placement.Base = FreeCAD.Vector(10, 0, 0)
        obj = make.make_analysis(self.document, self.mesh(mesh), COARSE)
        self.assertAlmostEqual(float(make.analysis_of(obj).profiles["x"].coordinate.mean()), 10.0, 5)

    def test_a_file_is_sliced_and_its_unit_said(self):
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "box.stl")
            Mesh.createBox(2, 2, 2).write(path)
            obj = make.make_analysis(self.document, path, COARSE, unit="cm")
            self.assertAlmostEqual(obj.SliceVolume.Value, 8000.0, 1)
            self.assertEqual(obj.UnitFound, "cm")

    def test_it_follows_its_source(self):
        box = self.box()
        obj = make.make_analysis(self.document, box, COARSE)
        box.Length = 5
        self.document.recompute()
        self.assertAlmostEqual(obj.SliceVolume.Value, 240.0, 3)

    def test_it_waits_if_that_is_wanted(self):
        box = self.box()
        obj = make.make_analysis(self.document, box, COARSE)
        obj.AutoUpdate = False
        box.Length = 5
        self.document.recompute()
        self.assertEqual((obj.Status, obj.UpToDate), (OUT_OF_DATE, False))
        self.assertAlmostEqual(obj.SliceVolume.Value, 192.0, 3)
        make.update(obj)
        self.assertAlmostEqual(obj.SliceVolume.Value, 240.0, 3)

    def test_parameters_come_back_from_the_properties(self):
        obj = make.make_analysis(self.document, self.box(), COARSE)
        for chosen in (
            SliceParameters(),
            SliceParameters(0.2, ("z", "0.6,0.8,0"), "bottom", low=-1.0, high=3.0, gap=0.02, iterations=3),
            SliceParameters(at="heights", heights=(0.5, 1.0), compensation=-0.05, fill="union", rod_ratio=0.5),
            SliceParameters(filter_open=0.1, filter_closed=0.2, smoothing="heavy", least_area=1e-3),
        ):
            write_slice_parameters(obj, chosen)
            found = obj.Proxy.parameters(obj)
            self.assertEqual(repr(found), repr(chosen))  # nan is not equal to itself

    def test_the_file_keeps_what_plots_and_comparisons_need(self):
        torus = self.document.addObject("Part::Torus", "Torus")
        self.document.recompute()
        obj = make.make_analysis(self.document, torus, COARSE)
        before, name, status = make.analysis_of(obj), obj.Name, obj.Status
        again = self.reopened().getObject(name)
        after = make.analysis_of(again)
        self.assertEqual(again.Status, status)
        for axis, profile in before.profiles.items():
            for field in ("coordinate", "sliced_area", "porosity", "contours", "outer_contours", "holes", "spoilt"):
                self.assertTrue(np.array_equal(getattr(after.profiles[axis], field), getattr(profile, field)), field)
            for field in ("plane", "area", "net_area", "is_rod"):
                old, new = getattr(before.measures[axis], field), getattr(after.measures[axis], field)
                self.assertTrue(np.array_equal(old, new, equal_nan=old.dtype.kind == "f"), field)
        self.assertEqual(after.summary("z"), before.summary("z"))
        self.assertEqual(
            {s.value for s in make.passport_of(again, again).whole if s.symbol in ("L1", "L2", "KS", "H")}, {0.0}
        )

    def test_contours_are_those_that_were_measured(self):
        torus = self.document.addObject("Part::Torus", "Torus")
        self.document.recompute()
        obj = make.make_analysis(self.document, torus, COARSE)
        for axis in "xyz":
            contours = make.contours_of(obj, axis)
            measures = make.analysis_of(obj).measures[axis]
            self.assertTrue(np.array_equal(contours.plane, measures.plane))
            first = contours.points[contours.starts[0] : contours.starts[1]]
            u, v = first.T
            area = float((u * np.roll(v, -1) - np.roll(u, -1) * v).sum() / 2)
            self.assertAlmostEqual(area, float(measures.area[0]), 9)

    def test_exact_slices_are_the_closed_form_and_the_profile_is_near_them(self):
        torus = self.document.addObject("Part::Torus", "Torus")
        torus.Radius1, torus.Radius2 = 5, 2
        self.document.recompute()
        obj = make.make_analysis(self.document, torus, SliceParameters(0.5, ("z",)))
        profile, exact = make.analysis_of(obj).profiles["z"], make.exact_slices(obj, "z")
        expected = 20 * np.pi * np.sqrt(4 - profile.coordinate**2)
        self.assertLess(np.abs(exact / expected - 1).max(), 1e-9)
        self.assertLess(np.abs(profile.sliced_area / exact - 1).max(), 0.02)

    def test_exact_slices_of_a_mesh_are_refused(self):
        obj = make.make_analysis(self.document, self.mesh(Mesh.createBox(1, 1, 1)), COARSE)
        with self.assertRaisesRegex(ParameterError, "those of a solid, got Bone"):
            make.exact_slices(obj, "z")

    def test_contours_of_what_has_changed_or_of_no_axis_are_refused(self):
        box = self.box()
        obj = make.make_analysis(self.document, box, SliceParameters(0.5, ("z",)))
        with self.assertRaisesRegex(ParameterError, "axis must be one of z, got 'x'"):
            make.contours_of(obj, "x")
        obj.AutoUpdate = False
        box.Length = 5
        self.document.recompute()
        with self.assertRaisesRegex(ParameterError, "up to date"):
            make.contours_of(obj, "z")

    def test_another_process_computes_the_same_with_the_contours(self):
        obj = make.make_analysis(self.document, self.mesh(Mesh.createSphere(2, 40)), COARSE)
        before = make.analysis_of(obj)
        with tempfile.TemporaryDirectory() as folder:
            make.write_task(folder, [obj])
            make.run_task(folder)
            results.clear()
            self.assertEqual(make.take_results(folder), 4)
        after = results.find("analysis", obj.Proxy.key(obj))
        for axis in "xyz":
            self.assertTrue(np.array_equal(after.profiles[axis].sliced_area, before.profiles[axis].sliced_area))
            self.assertEqual(len(contours_at_hand(obj, axis)), len(before.measures[axis]))

    def test_a_folder_holds_all_that_was_measured_also_of_a_file_that_was_opened_again(self):
        torus = self.document.addObject("Part::Torus", "Torus")
        self.document.recompute()
        name = make.make_analysis(self.document, torus, COARSE).Name
        again = self.reopened().getObject(name)
        make.analysis_of(again)  # of the document: without perimeters
        with tempfile.TemporaryDirectory() as folder:
            names = make.save_analysis(again, folder, plots="none")
            self.assertEqual(sorted(names), sorted(path.name for path in Path(folder).iterdir()))
            found = load_analysis(folder)
        self.assertTrue(np.isfinite(found.measures["z"].perimeter).all())
        self.assertTrue(
            np.array_equal(found.profiles["x"].sliced_area, make.analysis_of(again).profiles["x"].sliced_area)
        )

    def test_an_unknown_kind_of_plots_is_refused(self):
        obj = make.make_analysis(self.document, self.box(), COARSE)
        with tempfile.TemporaryDirectory() as folder, self.assertRaisesRegex(ParameterError, "png, svg, pdf, none"):
            make.save_analysis(obj, folder, plots="gif")

    def test_nothing_to_slice_is_refused_and_nothing_stays(self):
        plane = self.document.addObject("Part::Plane", "Plane")
        self.document.recompute()
        for source, words in (
            (plane, "solid"),
            (self.mesh(Mesh.Mesh()), "triangles"),
            ("/none.stl", "could not be read"),
        ):
            with self.unchanged(), self.assertRaisesRegex(TrabeculaError, words):
                make.make_analysis(self.document, source)

    def test_a_range_that_misses_the_body_is_an_error_and_the_profiles_stay(self):
        obj = make.make_analysis(self.document, self.box(), COARSE)
        obj.SliceRange, obj.SliceLow, obj.SliceHigh = True, 100, 200
        with self.assertRaisesRegex(TrabeculaError, "must meet the body"):
            make.update(obj)
        self.document.recompute()
        self.assertEqual(obj.Slices, 36)
        self.assertFalse(obj.UpToDate)


class DesignTest(DocumentCase):
    def test_a_network_is_sliced_as_its_rods(self):
        design = self.make(small_job(n=2))
        network = make.make_network(design.wireframe)
        obj = make.make_analysis(self.document, network, SliceParameters(0.5, ("x",)))
        self.assertEqual(obj.Envelope, design.envelope)
        areas = make.analysis_of(obj).profiles["x"].sliced_area
        self.assertLess(abs(float(areas.sum() * 0.5) / network.MeshVolume.Value - 1), 0.02)

    @unittest.skipUnless(manifold_available(), NO_BOOLEANS)
    def test_scaffold_and_channels_fill_every_slice_of_the_envelope(self):
        scaffold = make.make_scaffold(self.make(small_job(n=2)).wireframe)
        channels = make.body_objects(scaffold)[0]
        some = SliceParameters(0.7, ("y",), low=1.0, high=9.0)
        areas = [make.analysis_of(make.make_analysis(self.document, one, some)).profiles["y"].sliced_area
                 for one in (scaffold, channels)]  # fmt: skip
        self.assertLess(np.abs(sum(areas) - 100).max(), 1e-2)

    def test_two_analyses_lie_side_by_side(self):
        small, large = make.make_box(self.document, 2, 2, 4), make.make_box(self.document, 2, 3, 6)
        both = [make.make_analysis(self.document, one, COARSE) for one in (small, large)]
        found = make.compare_analyses(both)
        self.assertEqual(found.axes["z"].values["sliced_area"].shape, (2, 8))
        self.assertTrue(np.allclose(found.axes["z"].difference("sliced_area", 1).values, 2.0, atol=1e-5))

    def test_analyses_without_a_shared_axis_cannot_be_compared(self):
        box = make.make_box(self.document)
        both = [make.make_analysis(self.document, box, SliceParameters(1.0, (axis,))) for axis in "xy"]
        with self.assertRaises(ParameterError):
            make.compare_analyses(both)


if __name__ == "__main__":
    unittest.main()
