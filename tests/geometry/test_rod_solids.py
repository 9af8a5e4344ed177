# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rods as solids: valid, of the right volume, where their paths are."""

import math
import unittest
from dataclasses import replace
from unittest import mock

import FreeCAD
import numpy as np

from freecad_trabecula.core.parameters import RodParameters
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.rods import true_volumes
from freecad_trabecula.core.wireframe import without
from freecad_trabecula.errors import Cancelled, KernelError
from freecad_trabecula.geometry import rod_solids as module
from freecad_trabecula.geometry.brep_text import read_brep
from freecad_trabecula.geometry.design import make_design
from freecad_trabecula.geometry.rod_solids import rod_solids, rod_texts


def wireframe(name, rods=None):
    made = make_design(preset(name)).wireframe
    return made if rods is None else without(made, np.arange(0, len(made), max(1, len(made) // rods)))


class Solids(unittest.TestCase):
    def test_all_rods_of_case_6_are_valid_and_have_the_volume_of_their_triangles(self):
        some = wireframe("case6")
        solids = list(rod_solids(some, RodParameters()))
        self.assertEqual(len(solids), 147)
        for solid, volume in zip(solids, true_volumes(some.paths, some.ends)):
            self.assertTrue(solid.isValid() and solid.isClosed())
            self.assertEqual(len(solid.Faces), 6)
            self.assertAlmostEqual(solid.Volume / volume, 1, delta=1e-3)

    def test_a_round_rod_is_a_cylinder(self):
        some = wireframe("case1", 3)
        for solid, size, path in zip(rod_solids(some, RodParameters()), some.ends.first.size, some.paths):
            self.assertAlmostEqual(solid.Volume, 10 * math.pi / 4 * size**2, places=9)
            start, end = path[0, 0], path[1, 3]
            for u in (0.0, 0.3, 0.7):
                off = np.array(solid.Faces[0].Surface.value(u, 0.6)) - start
                distance = np.linalg.norm(np.cross(off, end - start)) / np.linalg.norm(end - start)
                self.assertAlmostEqual(distance, size / 2, delta=3e-4 * size)

    def test_a_rods_axis_is_its_path(self):
        some = wireframe("case6", 5)
        for solid, path in zip(rod_solids(some, RodParameters()), some.paths):
            middle = FreeCAD.Vector(*path[1, 0].tolist())
            self.assertTrue(solid.isInside(middle, 1e-6, False))

    def test_straight_rods_are_ruled_or_cubic_as_their_sections_ask_for(self):
        degrees = [
            {face.Surface.VDegree for face in next(rod_solids(wireframe(name, 1), RodParameters())).Faces[:4]}
            for name in ("case3", "case4")
        ]
        self.assertEqual(degrees, [{1}, {3}])

    def test_more_stations_bring_the_volume_nearer(self):
        some = wireframe("case6", 10)
        true = true_volumes(some.paths, some.ends)
        errors = [
            max(abs(s.Volume / v - 1) for s, v in zip(rod_solids(some, RodParameters(stations=n)), true))
            for n in (5, 9)
        ]
        self.assertLess(errors[1], errors[0] / 2)

    def test_too_few_stations_are_made_more_until_the_volume_is_right(self):
        some = wireframe("case6")
        for solid, volume in zip(rod_solids(some, RodParameters(stations=3)), true_volumes(some.paths, some.ends)):
            self.assertAlmostEqual(solid.Volume / volume, 1, delta=1e-3)

    def test_pores_of_six_corners_make_six_strips(self):
        job = preset("case6")
        pores = replace(job.pores, corners=6)
        some = without(make_design(replace(job, pores=pores)).wireframe, np.arange(3))
        for solid in rod_solids(some, RodParameters()):
            self.assertEqual(len(solid.Faces), 8)
            self.assertTrue(solid.isValid())

    def test_no_rods_make_no_solids(self):
        self.assertEqual(list(rod_solids(without(wireframe("case1"), np.arange(0)), RodParameters())), [])

    def test_prolonged_rods_are_longer_by_the_distance_at_both_ends(self):
        some = wireframe("case1", 2)
        for text, size in zip(rod_texts(some, 1, 0.25), some.ends.first.size):
            self.assertAlmostEqual(read_brep(text).Volume, 10.5 * math.pi / 4 * size**2, places=9)


class Refusals(unittest.TestCase):
    def test_a_rod_whose_volume_stays_wrong_is_named_with_both_volumes(self):
        some = wireframe("case4", 2)
        wrong = true_volumes(some.paths, some.ends) * 1.01
        with mock.patch.object(module, "true_volumes", return_value=wrong), self.assertRaises(KernelError) as caught:
            list(rod_solids(some, RodParameters()))
        self.assertIn(f"rod {some.names[0]}", str(caught.exception))
        self.assertIn(f"{wrong[0]:g} mm3", str(caught.exception))

    def test_cancelling_stops_at_the_next_rod(self):
        seen = []

        def progress(done, total, what):
            seen.append((done, total, what))
            if done == 2:
                raise Cancelled

        with self.assertRaises(Cancelled):
            list(rod_solids(wireframe("case2", 5), RodParameters(), progress))
        self.assertEqual(len(seen), 3)
