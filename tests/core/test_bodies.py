# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of designs: closed forms with square channels, both engines against each other, wrong bodies found out."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

from freecad_trabecula.core import bodies as bodies_module
from freecad_trabecula.core.assembly import make_wireframe
from freecad_trabecula.core.bodies import Check, prolongation, scaffold_bodies, wireframe_bodies
from freecad_trabecula.core.booleans import manifold_available
from freecad_trabecula.core.laws import Region
from freecad_trabecula.core.layers import Patch
from freecad_trabecula.core.meshes import Mesh, components, is_closed, mesh_volume, printable, weld
from freecad_trabecula.core.parameters import LayerParameters, PrismParameters, ScaffoldParameters
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.rays import RayVolume
from freecad_trabecula.core.rods import rod_volumes
from freecad_trabecula.core.sites import prism_sites
from freecad_trabecula.core.wireframe import skin
from freecad_trabecula.errors import Cancelled, MeshError

needs_manifold = pytest.mark.skipif(
    not manifold_available(), reason="MANIFOLD3D IS NOT INSTALLED: bodies are NOT tested; run `make setup`"
)

BOX_TRIANGLES = np.array(
    [[0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6], [0, 1, 4], [1, 5, 4], [2, 6, 3], [3, 6, 7], [0, 4, 2], [2, 4, 6],
     [1, 3, 5], [3, 7, 5]]
)  # fmt: skip
MESH, FIELD = ScaffoldParameters(engine="mesh"), ScaffoldParameters(engine="field", cell=0.2)
KEEP = ScaffoldParameters(engine="mesh", keep_loose=True)


def corners(low, high):
    cube = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
    return np.array(low) + cube * (np.array(high, float) - np.array(low))


ENVELOPE = Mesh(corners((0, 0, 0), (10, 10, 10)), BOX_TRIANGLES)
CHANNEL = corners((4, 4, -0.1), (6, 6, 10.1))[None]
CROSSING = np.stack([CHANNEL[0], corners((-0.1, 4, 4), (10.1, 6, 6))])


def plates_around(low, high, wall):
    """Six plates that leave a closed hollow cube low..high with the given wall; all inside the envelope."""
    plates = []
    for axis in range(3):
        for start in (low, high - wall):
            a, b = np.full(3, low), np.full(3, high)
            a[axis], b[axis] = start, start + wall
            plates.append(corners(a, b))
    return np.stack(plates)


HOLLOW = plates_around(3.0, 7.0, 1.0)  # a cube of 2 mm hangs free in a channel of 4 mm
HOLLOW_AND_OPEN = np.concatenate([HOLLOW, corners((4.5, 4.5, 6.5), (5.5, 5.5, 10.1))[None]])


def made(rods, parameters=MESH, envelope=ENVELOPE, **more):
    return scaffold_bodies(rods, BOX_TRIANGLES, envelope, parameters, **more)


def failed(bodies):
    return [check.name for check in bodies.checks if not check.ok]


# -------------------------------------------------------------------------------------------------- closed forms


@needs_manifold
@pytest.mark.parametrize(("rods", "filled"), [(CHANNEL, 40), (CROSSING, 72)])
def test_square_channels_give_the_porosity_of_their_closed_form(rods, filled):
    bodies = made(rods)
    assert bodies.porosity == pytest.approx(filled / 1000, rel=1e-9)
    assert bodies.union_porosity == pytest.approx(filled / 1000, rel=1e-9)
    assert mesh_volume(bodies.scaffold) == pytest.approx(1000 - filled)
    assert mesh_volume(bodies.channels) == pytest.approx(filled)
    assert bodies.engine == "mesh" and bodies.ok and bodies.watertight and failed(bodies) == []
    assert (bodies.parts.pieces, bodies.parts.openings, bodies.loose, bodies.voids) == (1, 1, (), ())
    assert bodies.notes == ()


@needs_manifold
def test_the_plain_sum_of_the_rods_is_reported_beside():
    assert made(CROSSING, rods_volume=80.0).sum_porosity == pytest.approx(0.08)
    assert math.isnan(made(CROSSING).sum_porosity)


@needs_manifold
def test_a_piece_that_channels_cut_off_all_round_is_loose_and_counts_as_void_when_taken_away():
    bodies = made(HOLLOW_AND_OPEN)
    opening = 3.0  # mm3 above the hollow cube
    assert bodies.parts.loose_volumes == (pytest.approx(8),)
    assert mesh_volume(bodies.loose[0]) == pytest.approx(8)
    assert bodies.union_porosity == pytest.approx((56 + opening) / 1000)
    assert bodies.porosity == pytest.approx((64 + opening) / 1000)
    assert bodies.ok and failed(bodies) == []
    assert "1 loose piece, cut off" in bodies.notes[0] and "taken away" in bodies.notes[0]


@needs_manifold
def test_a_loose_piece_that_is_kept_counts_as_material():
    bodies = made(HOLLOW_AND_OPEN, KEEP)
    assert bodies.porosity == pytest.approx(59 / 1000)
    assert bodies.union_porosity == pytest.approx(59 / 1000)
    assert bodies.parts.pieces == 2
    assert bodies.loose_volume == pytest.approx(8)
    assert bodies.ok


@needs_manifold
def test_a_void_that_no_opening_reaches_is_filled_with_what_hangs_in_it():
    bodies = made(HOLLOW)
    assert bodies.parts.void_volumes == (pytest.approx(64),)
    assert bodies.loose == ()
    assert bodies.porosity == pytest.approx(0)
    assert bodies.union_porosity == pytest.approx(56 / 1000)
    assert bodies.ok
    assert "1 void that" in bodies.notes[0] and "filled" in bodies.notes[0]
    assert "6.4% of the envelope" in bodies.notes[1]


@needs_manifold
def test_a_void_that_is_kept_stays():
    bodies = made(HOLLOW, KEEP)
    assert bodies.porosity == pytest.approx(56 / 1000)
    assert bodies.void_volume == pytest.approx(64)
    assert bodies.parts.openings == 1 and bodies.ok


@needs_manifold
def test_an_envelope_cut_in_two_is_pointed_out():
    slot = corners((-0.1, -0.1, 3), (10.1, 10.1, 4))[None]
    bodies = made(slot)
    assert mesh_volume(bodies.scaffold) == pytest.approx(600)
    assert bodies.loose_volume == pytest.approx(300)
    assert "cut the scaffold apart" in bodies.notes[1]


@needs_manifold
def test_no_rods_leave_the_envelope_whole():
    bodies = made(np.zeros((0, 8, 3)))
    assert bodies.porosity == pytest.approx(0)
    assert bodies.ok


# --------------------------------------------------------------------------------------------------------- layers


def plate_faces():
    faces = []
    for z, normal in ((0.0, -1.0), (10.0, 1.0)):
        square = np.array([[0, 0, z], [10, 0, z], [10, 10, z], [0, 10, z]], float)
        turn = [[0, 1, 2], [0, 2, 3]] if normal > 0 else [[0, 2, 1], [0, 3, 2]]
        faces.append(Patch(square, np.tile([0, 0, normal], (4, 1)), np.array(turn)))
    return faces


BOTH = ("Face5", "Face6")


@needs_manifold
def test_layers_that_close_both_ends_leave_a_void_which_is_counted_and_kept():
    layers = ScaffoldParameters("mesh", layers=LayerParameters(BOTH, 1.0))
    bodies = made(CHANNEL, layers, patches=plate_faces())
    assert bodies.parts.void_volumes == (pytest.approx(2 * 2 * 8),)
    assert bodies.porosity == pytest.approx(32 / 1000)
    assert mesh_volume(bodies.scaffold) == pytest.approx(968)
    assert bodies.notes[0].endswith("32 mm3 together: kept")
    assert bodies.ok and failed(bodies) == []


@needs_manifold
def test_a_closed_layer_on_one_side_leaves_the_channel_open_on_the_other():
    layers = ScaffoldParameters("mesh", layers=LayerParameters(BOTH[:1], 1.0))
    bodies = made(CROSSING, layers, patches=plate_faces()[:1])
    assert bodies.void_volume == 0
    assert bodies.porosity == pytest.approx((36 + 40 - 8) / 1000)
    assert bodies.ok


@needs_manifold
def test_outward_layers_add_to_the_body_that_the_volumes_add_up_to():
    layers = ScaffoldParameters("mesh", layers=LayerParameters(BOTH, 1.0, "outwards", False))
    longer = corners((4, 4, -1.1), (6, 6, 11.1))[None]
    bodies = made(longer, layers, patches=plate_faces())
    assert (bodies.envelope_volume, bodies.added_volume) == (pytest.approx(1000), pytest.approx(200))
    assert bodies.porosity == pytest.approx(48 / 1200)
    assert bodies.ok


@needs_manifold
def test_the_field_engine_cuts_through_open_outward_layers_too():
    layers = ScaffoldParameters("field", 0.2, layers=LayerParameters(BOTH, 1.0, "outwards", False))
    longer = corners((4, 4, -1.1), (6, 6, 11.1))[None]
    bodies = made(longer, layers, patches=plate_faces())
    assert bodies.porosity == pytest.approx(48 / 1200, abs=2e-3)
    assert bodies.ok


@needs_manifold
def test_the_field_engine_leaves_closed_inward_layers_uncut():
    layers = ScaffoldParameters("field", 0.2, layers=LayerParameters(BOTH, 1.0, "inwards", True))
    bodies = made(CHANNEL, layers, patches=plate_faces())
    # a channel of 2 x 2 mm through 10 mm, closed by 1 mm at both ends
    assert bodies.union_volume == pytest.approx(2 * 2 * 8, rel=1e-2)  # cells of 0.2 mm blunt its four edges
    assert bodies.ok


@needs_manifold
def test_the_field_engine_keeps_the_rims_of_a_turned_box_sharp():
    turn = np.array([[0.8, -0.6, 0.0], [0.6, 0.8, 0.0], [0.0, 0.0, 1.0]])
    turned = Mesh(ENVELOPE.vertices @ turn.T, ENVELOPE.triangles)
    bodies = made(CHANNEL @ turn.T, FIELD, envelope=turned)
    assert bodies.parts.scaffold_volume == pytest.approx(1000 - 2 * 2 * 10, rel=1e-3)
    assert bodies.parts.scaffold_volume + bodies.parts.channel_volume == pytest.approx(1000, rel=1e-9)
    assert bodies.ok


@needs_manifold
def test_an_inward_layer_without_effect_is_noted():
    layers = ScaffoldParameters("mesh", layers=LayerParameters(BOTH, 1.0, "inwards", False))
    assert "nothing changes" in made(CHANNEL, layers, patches=plate_faces()).notes[0]


# -------------------------------------------------------------------------------------------------- whole designs


def design(name="case6", n=3, seed=1):
    job = preset(name)
    job = dataclasses.replace(job, prism=PrismParameters(n_x=n, n_y=n, n_z=n), seed=seed)
    wireframe = make_wireframe(job.wireframe, prism_sites(job.prism), Region((0, 0, 0), (10, 10, 10), (5, 5, 5)))
    return job, wireframe, skin(wireframe, job.rods)


@needs_manifold
@pytest.mark.parametrize("name", ["case1", "case4", "case6"])
def test_both_engines_agree_within_a_fifth_of_a_percent_and_all_checks_hold(name):
    job, wireframe, rods = design(name)
    mesh, field = (
        wireframe_bodies(wireframe, rods, job.couplings, ENVELOPE, parameters)
        for parameters in (MESH, ScaffoldParameters("field", 0.1))
    )
    assert failed(mesh) == [] and failed(field) == []
    assert field.union_porosity == pytest.approx(mesh.union_porosity, abs=2e-3)
    assert mesh.rods_volume == pytest.approx(rod_volumes(rods).sum())
    assert mesh.rods_volume > mesh.union_volume


@needs_manifold
def test_a_scaffold_as_an_stl_reader_welds_it_is_closed_and_keeps_its_volume():
    job, wireframe, rods = design(n=5)
    bodies = wireframe_bodies(wireframe, rods, job.couplings, ENVELOPE, MESH)
    for mesh in (bodies.scaffold, bodies.channels):
        read = weld(printable(mesh).corners.astype(np.float32))
        assert is_closed(read)
        assert components(read).max() == components(mesh).max()
        assert mesh_volume(read) == pytest.approx(mesh_volume(mesh), rel=1e-6)


@needs_manifold
def test_prolonged_rods_end_outside_of_the_faces_they_start_from():
    job, wireframe, rods = design()
    assert 0.03 < prolongation(rods) < 0.4
    bodies = wireframe_bodies(wireframe, rods, job.couplings, ENVELOPE, MESH)
    assert bodies.voids == () and bodies.parts.void_volumes == ()


@needs_manifold
def test_cancelling_gets_through_at_every_step():
    steps = []
    made(CROSSING, progress=lambda done, total, what: steps.append(what))
    for k in range(len(steps)):
        left = [k]

        def stop(done, total, what, left=left):
            left[0] -= 1
            if left[0] < 0:
                raise Cancelled("stopped")

        with pytest.raises(Cancelled):
            made(CROSSING, progress=stop)
    assert {"union of rods", "pieces", "volumes by rays", "checks"} <= set(steps)


# --------------------------------------------------------------------------------------- wrong bodies, bad input


@needs_manifold
def test_a_volume_that_rays_do_not_confirm_is_in_error(monkeypatch):
    monkeypatch.setattr(bodies_module, "union_volume", lambda *args: RayVolume(41.0, 0.01))
    bodies = made(CHANNEL)
    assert not bodies.ok
    assert failed(bodies) == ["channels by triangles and by rays, mm3"]


#: Rods of 0.4 mm from here lie between the nodes of cells of 1 mm.
PLACES = np.arange(1, 9) + 0.3


def test_cells_too_coarse_for_the_rods_are_in_error_and_the_note_says_what_to_do():
    thin = np.stack([corners((x, y, -0.1), (x + 0.4, y + 0.4, 10.1)) for x in PLACES for y in PLACES])
    bodies = made(thin, ScaffoldParameters("field", 1.0))
    assert failed(bodies) == ["channels by triangles and by rays, mm3"]
    assert "make them smaller" in bodies.notes[-1]


@needs_manifold
def test_a_scaffold_that_lost_material_is_in_error(monkeypatch):
    whole = bodies_module.cut_bodies

    def wrong(*args):
        cut = whole(*args)
        return cut._replace(scaffold=Mesh(cut.scaffold.vertices * (1, 1, 0.999), cut.scaffold.triangles))

    monkeypatch.setattr(bodies_module, "cut_bodies", wrong)
    assert failed(made(CHANNEL))[0] == "scaffold + channels + loose pieces = envelope, mm3"


@needs_manifold
def test_a_hole_in_the_channels_is_in_error(monkeypatch):
    whole = bodies_module.cut_bodies

    def wrong(*args):
        cut = whole(*args)
        return cut._replace(channels=Mesh(cut.channels.vertices, cut.channels.triangles[1:]))

    monkeypatch.setattr(bodies_module, "cut_bodies", wrong)
    bodies = made(CHANNEL)
    assert not bodies.watertight
    assert "watertight channels: faulty edges" in failed(bodies)


def test_a_check_without_a_number_does_not_hold():
    assert not Check("volume", 1.0, math.nan, math.nan, 1e-6).ok


def test_a_check_says_both_values_and_the_tolerance():
    assert (
        str(Check("volume, mm3", 40.0, 41.0, 1e-3, 1e-6)) == "volume, mm3: 40 against 41, 0.001 apart (at most 1e-06)"
    )


def test_an_open_envelope_is_refused_with_the_count_of_its_faults():
    with pytest.raises(MeshError, match="the envelope must be a closed mesh.*3 open edges"):
        made(CHANNEL, envelope=Mesh(ENVELOPE.vertices, BOX_TRIANGLES[:-1]))


def test_an_envelope_inside_out_is_refused():
    with pytest.raises(MeshError, match="volume above 0, got -1000 mm3"):
        made(CHANNEL, envelope=Mesh(ENVELOPE.vertices, BOX_TRIANGLES[:, ::-1]))


@needs_manifold
def test_rods_that_fill_the_envelope_are_refused():
    with pytest.raises(MeshError, match="must leave some material"):
        made(corners((-1, -1, -1), (11, 11, 11))[None])
