# SPDX-License-Identifier: LGPL-2.1-or-later
"""Functions of ``make`` that are given something else: one sentence, and the document as it was."""

import inspect
import os
import re
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import FreeCAD
import Part

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.parameters import FaceParameters, SiteEdit
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.errors import ParameterError, TrabeculaError

SLICES, VOXELS = SliceParameters(thickness=1.0), VoxelParameters(size=(1.0, 1.0, 1.0))
#: The first argument of each function, and what follows it: ``wrong`` is put in the place of the first.
FIRST = {
    "add_site": ("Face1", (0, 1, 1)),
    "analysis_of": (),
    "bodies_of": (),
    "body_objects": (),
    "change_analysis": (SLICES,),
    "change_design": (small_job(),),
    "change_voxel_design": (VOXELS,),
    "combine_with_body": (None,),
    "compare_analyses": (),
    "contours_of": ("x",),
    "design_as_script": (),
    "edits_of": (),
    "estimate_design": (None,),
    "estimate_voxel_design": (VOXELS,),
    "exact_slices": ("x",),
    "export": ("a.stl",),
    "found_routes": ("design.porosity",),
    "job_of": (),
    "layer_areas_of": (),
    "make_analysis": (None, SLICES),
    "make_box": (),
    "make_design": (small_job(),),
    "make_envelope": ("x.step",),
    "make_example": ("rods",),
    "make_face_sites": (FaceParameters("Face1"),),
    "make_job_envelope": (small_job(),),
    "make_layer_shapes": ([0],),
    "make_network": (),
    "make_prism_sites": (),
    "make_scaffold": (),
    "make_solid_scaffold": (),
    "make_variants": ([1],),
    "make_voxel_design": (None, VOXELS),
    "make_wireframe": ([], small_job().wireframe),
    "move_site": ("Face1.1.1", (0, 1, 1)),
    "named_body": ("Box",),
    "passport_of": (None,),
    "rod_at": ("Face1",),
    "save_analysis": ("folder",),
    "save_comparison": ("folder",),
    "set_pore": ("Face1.1.1", 0.5),
    "set_wireframe_parameters": (small_job().wireframe,),
    "switch_off_site": ("Face1.1.1",),
    "take_back_edits": ("Face1.1.1",),
    "update": (),
    "voxel_design_of": (),
    "wireframe_of": (),
    "write_report": ("report.html",),
}
#: Of the functions that take anything of the document, or look at files, nothing here.
NOT_HERE = {"Design", "default_parameters", "run_task", "take_results", "write_task"}


def told(document):
    """Return what each object was told and says of itself: all but what is drawn of it."""
    return {
        (obj.Name, name): re.sub("0x[0-9a-f]+", "", str(getattr(obj, name)))  # where it lies in memory may change
        for obj in document.Objects
        for name in obj.PropertiesList
        if name not in ("Shape", "Mesh", "Proxy", "ViewObject")
    }


class ArgumentsTest(DocumentCase):
    def refuse(self, call, pattern=""):
        """Assert that a call raises an error of ours with a sentence, and that all is as it was."""
        before = told(self.document)
        with self.assertRaisesRegex(TrabeculaError, pattern) as caught:
            call()
        self.assertGreater(len(str(caught.exception)), 20)
        self.assertEqual(told(self.document), before)

    def test_every_function_is_looked_at_here(self):
        functions = {name for name in make.__all__ if inspect.isroutine(getattr(make, name))}
        self.assertEqual(sorted(functions - NOT_HERE - set(FIRST)), [])

    def test_what_is_no_object_of_a_document_is_refused_by_each_of_them(self):
        for name, rest in FIRST.items():
            for wrong in (None, 3, 2.5, [], {}, "no such thing"):
                with self.subTest(function=name, wrong=wrong):
                    self.refuse(lambda name=name, wrong=wrong, rest=rest: getattr(make, name)(wrong, *rest))

    def test_objects_of_another_kind_are_refused_with_the_kind_that_is_needed(self):
        body = make.make_box(self.document)
        for name, kind in (
            *((one, "wireframe") for one in ("make_network", "make_scaffold", "job_of", "change_design", "set_pore")),
            *((one, "analysis") for one in ("analysis_of", "change_analysis", "exact_slices", "layer_areas_of")),
            *((one, "voxel design") for one in ("voxel_design_of", "change_voxel_design", "make_layer_shapes")),
            *(("bodies_of", "scaffold"), ("rod_at", "network")),
        ):
            with self.subTest(function=name):
                self.refuse(
                    lambda name=name: getattr(make, name)(body, *FIRST[name]), f"must be of the kind {kind}, got Env"
                )

    def test_parameters_of_another_kind_are_refused(self):
        body = make.make_box(self.document)
        sites = make.make_prism_sites(body, small_job().prism)
        for call in (
            lambda: make.make_face_sites(body, "Face1"),
            lambda: make.make_prism_sites(body, 3),
            lambda: make.make_wireframe(body, [sites], small_job()),
            lambda: make.make_wireframe(body, sites, small_job().wireframe),
            lambda: make.make_wireframe(body, [body], small_job().wireframe),
            lambda: make.make_analysis(self.document, body, 0.1),
            lambda: make.make_analysis(self.document, body, SLICES, envelope="Box"),
            lambda: make.make_voxel_design(self.document, body, 0.1),
            lambda: make.make_voxel_design(self.document, body, VOXELS, envelope="Box"),
            lambda: make.make_voxel_design(self.document, body, VOXELS, tables=3),
            lambda: make.make_voxel_design(self.document, body, VOXELS, tables=[[1]]),
            lambda: make.make_analysis(self.document, "bone.stl", unit="parsec"),
            lambda: make.estimate_voxel_design(body, 0.1),
            lambda: make.make_design(self.document, "case6"),
            lambda: make.make_design(self.document, small_job(), ("netwrok",)),
            lambda: make.make_design(self.document, small_job(), "network"),
            lambda: make.make_box(self.document, "10 mm"),
            lambda: make.make_envelope(self.document, 3),
            lambda: make.export(body, None),
            lambda: make.write_report(self.document, 3),
        ):
            with self.subTest(line=inspect.getsource(call).strip()):
                self.refuse(call)

    def test_objects_of_another_document_are_refused_where_links_would_not_reach_them(self):
        job, body = small_job(), make.make_box(self.document)
        other = FreeCAD.newDocument("Other")
        foreign = make.make_box(other)
        try:
            sites = make.make_prism_sites(foreign, job.prism)
            for call in (
                lambda: make.make_design(self.document, job, envelope=foreign),
                lambda: make.make_wireframe(body, [sites], job.wireframe),
                lambda: make.make_analysis(self.document, foreign, SLICES),
                lambda: make.make_analysis(self.document, body, SLICES, envelope=foreign),
                lambda: make.make_voxel_design(self.document, foreign, VOXELS),
                lambda: make.make_voxel_design(self.document, body, VOXELS, envelope=foreign),
            ):
                with self.subTest(line=inspect.getsource(call).strip()):
                    self.refuse(call, "must be in the document T, got .* of Other")
        finally:
            FreeCAD.closeDocument(other.Name)

    def test_a_task_needs_objects_and_a_folder_that_holds_it(self):
        with tempfile.TemporaryDirectory() as folder:
            for call in (
                lambda: make.write_task(folder, []),
                lambda: make.write_task(folder, [None]),
                lambda: make.write_task(folder, [make.make_box(self.document)]),
                lambda: make.run_task(folder),
                lambda: make.run_task(None),
                lambda: make.take_results(folder),
            ):
                with self.subTest(line=inspect.getsource(call).strip()), self.assertRaises(TrabeculaError):
                    call()

    def test_hand_edits_with_values_that_are_none_are_refused(self):
        wireframe = self.make(small_job()).wireframe
        for call in (
            lambda: make.set_pore(wireframe, "Face1.1.1", "wide"),
            lambda: make.set_pore(wireframe, "Face1.1.1"),
            lambda: make.set_pore(wireframe, "Face1.1.1", turns=0.5),
            lambda: make.move_site(wireframe, "Face1.1.1", None),
            lambda: make.move_site(wireframe, "Face1.1.1", "abc"),
            lambda: make.add_site(wireframe, "Face1", 3),
            lambda: make.switch_off_site(wireframe, 3),
            lambda: make.make_variants(wireframe, []),
            lambda: make.make_variants(wireframe, [1.5]),
        ):
            with self.subTest(line=inspect.getsource(call).strip()):
                self.refuse(call)

    def test_a_change_that_is_refused_leaves_a_design_of_rods_as_it_was(self):
        wireframe = self.make(small_job()).wireframe
        job = replace(small_job(), prism=replace(small_job().prism, l=12.0), edits=(SiteEdit("Face1.9.9"),))
        self.refuse(lambda: make.change_design(wireframe, job), "Face1.9.9")
        self.assertEqual(wireframe.State, ["Up-to-date"])
        self.assertAlmostEqual(wireframe.Envelope.Shape.Volume, 1000)
        faces = (FaceParameters("Face1"), FaceParameters("Face9", "Face2"))
        other = replace(job, prism=None, envelope="x", edits=(), faces=faces, couplings=job.couplings[:1])
        self.refuse(lambda: make.change_design(wireframe, other), "Face9")
        self.assertEqual([one.Name for one in wireframe.Sites], ["Sites"])

    def test_a_change_that_is_refused_leaves_analysis_and_voxels_as_they_were(self):
        ring = self.document.addObject("Part::Feature", "Ring")
        ring.Shape = Part.makeBox(4, 4, 4).cut(Part.makeBox(2, 2, 4))
        analysis = make.make_analysis(self.document, ring, SLICES)
        voxels = make.make_voxel_design(self.document, ring, VOXELS)
        self.refuse(
            lambda: make.change_analysis(analysis, replace(SLICES, low=100.0, high=200.0)), "must meet the body"
        )
        self.refuse(lambda: make.change_voxel_design(voxels, replace(VOXELS, cap_alpha=1)), "cap on alpha")
        self.refuse(lambda: make.change_voxel_design(voxels, VOXELS, curves=3), "made of curves")
        self.assertEqual((analysis.Slices, voxels.Voxels), (12, 48))

    def test_a_sample_that_shows_nothing_is_refused_before_its_size_is_asked_for(self):
        empty = self.document.addObject("Part::Feature", "Empty")
        self.refuse(
            lambda: make.estimate_voxel_design(empty, VOXELS), "a sample must have a mesh or a shape, got Empty"
        )

    def test_layers_are_whole_numbers(self):
        ring = self.document.addObject("Part::Feature", "Ring")
        ring.Shape = Part.makeBox(4, 4, 4).cut(Part.makeBox(2, 2, 4))
        voxels = make.make_voxel_design(self.document, ring, VOXELS)
        for layers in (None, 3, [], [1.5], ["a"], "12"):
            with self.subTest(layers=layers):
                self.refuse(lambda layers=layers: make.make_layer_shapes(voxels, layers), "list of whole numbers")

    def test_paths_may_be_those_of_pathlib(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "box.step"
            make.export(make.make_box(self.document), path)
            self.assertGreater(os.path.getsize(path), 1000)
            self.assertAlmostEqual(make.make_envelope(self.document, path).Shape.Volume, 1000, 6)
            with self.assertRaises(ParameterError):
                make.export(self.document.Envelope, [path])
