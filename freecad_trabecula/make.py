# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scripting: one function for every step of a design, with or without the window.

Step by step: ``make_box``, ``make_envelope`` or ``make_job_envelope``, ``make_prism_sites`` or ``make_face_sites``,
``make_wireframe``, then ``make_network`` (solids) and ``make_scaffold`` (mesh). At once: ``estimate_design``,
``make_design``, ``change_design``; back: ``job_of``.
By hand: ``set_pore``, ``move_site``, ``switch_off_site``, ``add_site``, ``take_back_edits``. Numbers:
``wireframe_of``, ``bodies_of``. Files: ``export``. Slices: ``make_analysis``, ``change_analysis``, ``analysis_of``,
``contours_of``, ``compare_analyses``, ``passport_of``, ``save_analysis``, ``save_comparison``. Voxels:
``estimate_voxel_design``, ``layer_areas_of``, ``make_voxel_design``, ``change_voxel_design``, ``voxel_design_of``,
``make_layer_shapes``. All as lines of Python: ``design_as_script``. Both routes to a number: ``found_routes``.
One page: ``write_report``. Other seeds: ``make_variants``. In another process:
``write_task``, ``run_task``, ``take_results``.

Functions raise an error and leave the document as it was. They open no transaction: that is the caller's.
"""

from __future__ import annotations

from .features.analysis import analysis_of, contours_of
from .features.analysis_files import save_analysis, save_comparison
from .features.analysis_makers import (
    change_analysis,
    compare_analyses,
    default_parameters,
    exact_slices,
    make_analysis,
    passport_of,
)
from .features.designs import Design, change_design, make_design, make_job_envelope
from .features.edits import add_site, edits_of, move_site, set_pore, switch_off_site, take_back_edits
from .features.estimates import estimate_design
from .features.examples import make_example
from .features.exports import export
from .features.feature import update
from .features.jobs import job_of
from .features.makers import (
    body_objects,
    make_box,
    make_envelope,
    make_face_sites,
    make_network,
    make_prism_sites,
    make_scaffold,
    make_solid_scaffold,
    make_wireframe,
    set_wireframe_parameters,
)
from .features.network import rod_at
from .features.report_sections import write_report
from .features.scaffold import bodies_of
from .features.scripts import design_as_script, named_body
from .features.second_routes import found_routes
from .features.tasks import run_task, take_results, write_task
from .features.variants import make_variants
from .features.voxel_design import voxel_design_of
from .features.voxel_makers import (
    change_voxel_design,
    combine_with_body,
    estimate_voxel_design,
    layer_areas_of,
    make_layer_shapes,
    make_voxel_design,
)
from .features.wireframe import wireframe_of

__all__ = [
    "Design",
    "add_site",
    "analysis_of",
    "bodies_of",
    "body_objects",
    "change_analysis",
    "change_design",
    "change_voxel_design",
    "combine_with_body",
    "compare_analyses",
    "contours_of",
    "default_parameters",
    "design_as_script",
    "edits_of",
    "estimate_design",
    "estimate_voxel_design",
    "exact_slices",
    "export",
    "found_routes",
    "job_of",
    "layer_areas_of",
    "make_analysis",
    "make_box",
    "make_design",
    "make_envelope",
    "make_example",
    "make_face_sites",
    "make_job_envelope",
    "make_layer_shapes",
    "make_network",
    "make_prism_sites",
    "make_scaffold",
    "make_solid_scaffold",
    "make_variants",
    "make_voxel_design",
    "make_wireframe",
    "move_site",
    "named_body",
    "passport_of",
    "rod_at",
    "run_task",
    "save_analysis",
    "save_comparison",
    "set_pore",
    "set_wireframe_parameters",
    "switch_off_site",
    "take_back_edits",
    "take_results",
    "update",
    "voxel_design_of",
    "wireframe_of",
    "write_report",
    "write_task",
]
