# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wireframe as shapes: pores, paths, sites."""

import math
import unittest
from dataclasses import replace

import numpy as np
import Part

from freecad_trabecula.core.pores import Pores, circles
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.sites import Sites
from freecad_trabecula.core.wireframe import without
from freecad_trabecula.geometry.design import make_design
from freecad_trabecula.geometry.wires import path_wires, pore_wires, site_vertices, wireframe_shape


def wireframe(name="case6"):
    return make_design(preset(name)).wireframe


class Shapes(unittest.TestCase):
    def test_a_design_shows_all_its_pores_paths_and_sites(self):
        made = wireframe()
        pores, paths, sites = wireframe_shape(made).SubShapes
        self.assertEqual(len(pores.Wires), 6 * 49)
        self.assertEqual(len(paths.Wires), 147)
        self.assertEqual(len(sites.SubShapes), 6 * 49)

    def test_pores_are_closed_and_enclose_their_areas(self):
        made = wireframe("case2")
        for face, sites in made.sites.items():
            pores = made.pores[face]
            for wire, area in zip(pore_wires(sites, pores), pores.areas):
                self.assertTrue(wire.isClosed())
                self.assertAlmostEqual(Part.Face(wire).Area, area, places=9)

    def test_pores_lie_in_the_planes_of_their_faces(self):
        made = wireframe()
        for name, axis, height in (("Face1", "X", 0.0), ("Face4", "Y", 10.0), ("Face6", "Z", 10.0)):
            for wire in pore_wires(made.sites[name], made.pores[name]):
                box = wire.BoundBox
                self.assertAlmostEqual(getattr(box, axis + "Min"), height, places=6)
                self.assertAlmostEqual(getattr(box, axis + "Max"), height, places=6)

    def test_a_circle_is_as_long_as_it_should_be(self):
        sites = Sites("F", np.zeros((1, 2), int), np.zeros((1, 3)), np.array([[1.0, 0, 0]]), np.array([[0, 0, 1.0]]),
                      np.ones(1, bool))  # fmt: skip
        self.assertAlmostEqual(pore_wires(sites, circles(np.array([0.8])))[0].Length, math.pi * 0.8, delta=1e-4)

    def test_straight_paths_have_the_length_of_their_chords(self):
        made = wireframe("case3")
        chords = np.linalg.norm(made.paths[:, 1, 3] - made.paths[:, 0, 0], axis=1)
        for wire, chord in zip(path_wires(made.paths), chords):
            self.assertAlmostEqual(wire.Length, chord, places=9)

    def test_paths_start_and_end_at_their_sites(self):
        made = wireframe()
        for wire, path in zip(path_wires(made.paths), made.paths):
            np.testing.assert_allclose(wire.OrderedVertexes[0].Point, path[0, 0], atol=1e-9)
            np.testing.assert_allclose(wire.OrderedVertexes[-1].Point, path[1, 3], atol=1e-9)


class Nothing(unittest.TestCase):
    def test_sites_that_are_off_are_not_shown(self):
        made = wireframe("case1")
        sites = made.sites["Face1"]
        off = replace(sites, on=np.arange(len(sites)) > 0)
        self.assertEqual(len(site_vertices([off])), len(sites) - 1)
        shown = wireframe_shape(replace(made, sites={"Face1": off}))
        self.assertEqual(len(shown.SubShapes[0].Wires), len(sites) - 1)

    def test_a_wireframe_without_rods_has_no_paths(self):
        shape = wireframe_shape(without(wireframe("case1"), np.arange(0)))
        self.assertEqual(len(shape.SubShapes[1].SubShapes), 0)

    def test_no_pores_make_no_wires(self):
        empty = Sites("F", np.zeros((0, 2), int), *[np.zeros((0, 3))] * 3, np.zeros(0, bool))
        self.assertEqual(pore_wires(empty, Pores(np.zeros(0), np.zeros((0, 4, 2)), *[np.zeros((0, 4))] * 2)), [])
