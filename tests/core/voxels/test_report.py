# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the report of a design says, against designs whose figures are plain to see."""

from __future__ import annotations

import json

import numpy as np
import pytest

from freecad_trabecula.core.voxels.blocks import block_mesh
from freecad_trabecula.core.voxels.design import VoxelDesign
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.core.voxels.report import connection_record, design_record, record_json
from freecad_trabecula.core.voxels.report_text import report_markdown, report_summary
from freecad_trabecula.core.voxels.targets import targets_of_voxels
from freecad_trabecula.errors import ExactnessError

VOXELS = np.zeros((4, 4, 5), bool)
VOXELS[1:3, 1:3, 0:3] = True  # 12 voxels
VOXELS[0, 0, 4] = True  # one by itself
DESIGN = VoxelDesign(
    VOXELS, targets_of_voxels(VOXELS), VoxelParameters(strategy="sequential", seed=9), seconds={"design": 1}
)


def test_the_connections_are_those_one_can_see():
    record = connection_record(VOXELS)
    assert record["components"] == 2 and record["largest_fraction"] == pytest.approx(12 / 13)
    assert (record["floating_voxels"], record["single_voxels"]) == (1, 1)
    assert (record["closed_cavities"], record["edge_contacts"], record["corner_contacts"]) == (0, 0, 0)


def test_a_closed_cavity_and_contacts_are_counted():
    hollow = np.ones((3, 3, 3), bool)
    hollow[1, 1, 1] = False
    assert connection_record(hollow)["closed_cavities"] == 1
    touching = np.zeros((2, 2, 2), bool)
    touching[0, 0, 0] = touching[0, 1, 1] = True
    assert connection_record(touching)["edge_contacts"] == 1


def test_the_record_holds_what_a_script_looks_for():
    record = design_record(DESIGN, "test", 2.5, block_mesh(VOXELS, DESIGN.targets.voxel))
    assert record["exact"] is True and record["ok"] is True
    assert (record["voxels"], record["seed"], record["seconds"]) == (13, 9, 2.5)
    assert record["layers"] == {"N": 5, "M": 4, "P": 4}
    assert record["targets"]["D"] == [4, 4, 4, 0, 1]
    assert record["trabeculae"]["z"]["per_layer"] == [1, 1, 1, 0]
    assert record["mesh"]["watertight"] is True and abs(record["mesh"]["volume_error"]) < 1e-12
    # three columns of four voxels in two layers need 2 a line; four rows of 6, 6, 1 need 3
    assert (record["tables"]["alpha_smallest_cap"], record["tables"]["beta_smallest_cap"]) == (2, 3)
    assert record["bone_fraction"] == pytest.approx(13 / 80)
    assert json.loads(record_json(record)) == json.loads(json.dumps(record))


def test_layers_that_are_wrong_are_listed_and_said():
    wrong = VOXELS.copy()
    wrong[3, 3, 3] = True
    record = design_record(VoxelDesign(wrong, DESIGN.targets, DESIGN.parameters), "test", 1.0)
    assert record["exact"] is False and record["ok"] is False
    assert record["wrong_layers"] == [["x", 3, 0, 1], ["y", 3, 0, 1], ["z", 3, 0, 1]]
    assert "**Not exact: 3 layers" in report_markdown(record)
    assert "Not exact" in report_summary(record)


def test_an_open_mesh_is_not_ok():
    mesh = block_mesh(VOXELS, (1, 1, 1))
    record = design_record(DESIGN, "test", 1.0, type(mesh)(mesh.vertices, mesh.triangles[1:]))
    assert record["ok"] is False and "not watertight" in report_markdown(record)


def test_the_page_tells_the_figures_of_the_record_and_the_thesis_times():
    record = design_record(DESIGN, "test", 1.0, more_notes=["a note"])
    record["counting"] = {"tables alpha": {"log10": 12.3456, "standard_error": 0.01, "samples": 5}}
    page = report_markdown(record, [("layers.png", "Layers along Z")])
    assert "| solid voxels | 13 |" in page and "**Note:** a note\n" in page
    assert "115 + 108 + 1217 s" in page
    assert "![Layers along Z](layers.png)" in page
    assert "| tables alpha | 12.35 | 0.01 |" in page
    assert "2 components, 92.31 % in the largest" in report_summary(record)


def test_a_design_of_another_shape_is_refused():
    with pytest.raises(ExactnessError, match="must have the shape"):
        design_record(VoxelDesign(VOXELS[1:], DESIGN.targets, DESIGN.parameters), "test", 1.0)


def test_a_record_that_is_no_json_is_refused():
    with pytest.raises(ValueError, match="not JSON compliant"):
        record_json({"value": float("nan")})
