# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sites on faces against closed forms: Eq. of thesis 4.2.2 on planes, cylinders, spheres, tori, cones, B-splines."""

import math
import unittest
from pathlib import Path

import FreeCAD
import numpy as np
import Part

from freecad_trabecula.core.parameters import FaceParameters
from freecad_trabecula.errors import Cancelled, ParameterError
from freecad_trabecula.geometry.coordinate_lines import CoordinateLine
from freecad_trabecula.geometry.face_sites import MOST_SITES, directions, face_sites, pick_site
from freecad_trabecula.geometry.surfaces import FaceSurface

Vector = FreeCAD.Vector
ROOT = Path(__file__).resolve().parent.parent.parent
EXAMPLES = ROOT / "resources" / "examples"


def sites_on(face, **parameters):
    return face_sites(face, "F", FaceParameters(**parameters))


def at(sites, i, j):
    """Return the number of the site with index (i, j)."""
    return sites.index.tolist().index([i, j])


def numbers_along(length_minus, length_plus, spacing, border):
    """Return the thesis' n- .. n+ of a line."""
    return range(-math.floor((length_minus - border) / spacing), math.floor((length_plus - border) / spacing) + 1)


class OnPlanes(unittest.TestCase):
    def test_counts_on_a_rectangle_follow_the_equation(self):
        for c_u, c_v, b_u, b_v in (
            (1.5, 1.5, 0.5, 0.5),
            (0.7, 1.3, 0.2, 1.1),
            (3.0, 2.9, 1.0, 3.0),
            (9.0, 0.6, 0.1, 0.4),
        ):
            with self.subTest(c_u=c_u, c_v=c_v):
                top = Part.makeBox(17, 11, 5).Faces[5]
                sites = sites_on(top, c_u=c_u, c_v=c_v, b_u=b_u, b_v=b_v)
                i, j = numbers_along(8.5, 8.5, c_u, b_u), numbers_along(5.5, 5.5, c_v, b_v)
                self.assertEqual(sorted(map(tuple, sites.index.tolist())), sorted((a, b) for a in i for b in j))
                expected = np.array([8.5, 5.5, 5.0]) + np.array([[a * c_u, b * c_v, 0] for a, b in sites.index])
                np.testing.assert_allclose(sites.points, expected, atol=1e-9)

    def test_counts_differ_on_the_two_sides_of_a_picked_origin(self):
        top = Part.makeBox(10, 10, 10).Faces[5]
        sites = sites_on(top, origin=(2.0, 7.0, 10.0), c_u=1.1, c_v=0.9, b_u=0.3, b_v=0.4, d1=(1, 0, 0), d2=(0, 1, 0))
        i, j = numbers_along(2, 8, 1.1, 0.3), numbers_along(7, 3, 0.9, 0.4)
        self.assertEqual(sorted(set(sites.index[:, 0].tolist())), list(i))
        self.assertEqual(sorted(set(sites.index[:, 1].tolist())), list(j))

    def test_a_length_that_the_spacing_divides_keeps_its_last_site(self):
        top = Part.makeBox(10, 10, 10).Faces[5]
        self.assertEqual(len(sites_on(top, c_u=1.0, c_v=1.0, b_u=1.0, b_v=1.0)), 81)
        self.assertEqual(len(sites_on(top, c_u=0.1, c_v=5.0, b_u=0.3, b_v=4.0)), 95)

    def test_no_border_distance_puts_sites_on_the_border_itself(self):
        top = Part.makeBox(10, 10, 10).Faces[5]
        self.assertEqual(len(sites_on(top, c_u=2.5, c_v=2.5, b_u=0.0, b_v=0.0)), 25)

    def test_a_border_distance_larger_than_half_the_face_leaves_no_site(self):
        sites = sites_on(Part.makeBox(10, 10, 10).Faces[5], c_u=1, c_v=1, b_u=5.5, b_v=0.5)
        self.assertEqual((len(sites), sites.points.shape), (0, (0, 3)))

    def test_an_origin_too_near_to_the_border_is_no_site_but_its_line_has_others(self):
        top = Part.makeBox(10, 10, 10).Faces[5]
        sites = sites_on(top, origin=(0.2, 5, 10), d1=(1, 0, 0), d2=(0, 1, 0), c_u=1, c_v=20, b_u=0.5, b_v=0.5)
        self.assertEqual(sites.index[:, 0].tolist(), list(range(1, 10)))

    def test_all_faces_of_a_solid_have_outer_normals_and_unit_first_axes(self):
        box = Part.makeBox(4, 6, 8).cut(Part.makeCylinder(1, 8, Vector(2, 3, 0)))
        box.Placement = FreeCAD.Placement(Vector(5, -3, 2), FreeCAD.Rotation(Vector(1, 2, 3), 50))
        for face in box.Faces:
            sites = sites_on(face, c_u=0.8, c_v=0.8, b_u=0.2, b_v=0.2)
            self.assertGreater(len(sites), 5)
            np.testing.assert_allclose(np.linalg.norm(sites.normals, axis=1), 1, atol=1e-12)
            np.testing.assert_allclose(np.linalg.norm(sites.u, axis=1), 1, atol=1e-12)
            np.testing.assert_allclose((sites.u * sites.normals).sum(1), 0, atol=1e-12)
            for point, normal in zip(sites.points, sites.normals):
                self.assertFalse(box.isInside(Vector(*(point + 0.01 * normal)), 1e-9, False))
                self.assertTrue(box.isInside(Vector(*(point - 0.01 * normal)), 1e-9, False))

    def test_outer_minus_one_turns_the_normals(self):
        face = Part.makeBox(4, 6, 8).Faces[5]
        inner = face_sites(face, "F", FaceParameters(), outer=-1)
        np.testing.assert_allclose(inner.normals, np.tile([0, 0, -1.0], (len(inner), 1)), atol=1e-12)

    def test_directions_are_projected_on_to_the_face(self):
        top = Part.makeBox(10, 10, 10).Faces[5]
        sites = sites_on(top, d1=(0, 3, 4), d2=(2, 0, -7), c_u=1, c_v=2, b_u=0.5, b_v=0.5)
        np.testing.assert_allclose(sites.points[at(sites, 1, 1)] - sites.points[at(sites, 0, 0)], [2, 1, 0], atol=1e-9)
        np.testing.assert_allclose(sites.u, np.tile([0, 1.0, 0], (len(sites), 1)), atol=1e-12)

    def test_directions_need_not_be_perpendicular(self):
        top = Part.makeBox(10, 10, 10).Faces[5]
        sites = sites_on(top, d1=(1, 0, 0), d2=(1, 1, 0), c_u=1, c_v=2, b_u=0.5, b_v=0.5)
        step = sites.points[at(sites, 0, 1)] - sites.points[at(sites, 0, 0)]
        np.testing.assert_allclose(step, [math.sqrt(2), math.sqrt(2), 0], atol=1e-9)

    def test_the_own_directions_of_a_plane_face_follow_its_longest_straight_edge(self):
        corners = [Vector(0, 0, 0), Vector(9, 3, 0), Vector(8, 6, 0), Vector(-1, 3, 0), Vector(0, 0, 0)]
        face = Part.Face(Part.makePolygon(corners))
        d1, d2 = directions(FaceSurface(face), FaceSurface(face).centre())
        np.testing.assert_allclose(tuple(d1), np.array([3, 1, 0]) / math.sqrt(10), atol=1e-9)
        self.assertAlmostEqual(d1.dot(d2), 0, places=12)


class AtHoles(unittest.TestCase):
    def setUp(self):
        plate = Part.makeBox(20, 20, 2).cut(Part.makeCylinder(3, 2, Vector(10, 10, 0)))
        self.top = max(plate.Faces, key=lambda f: (f.CenterOfMass.z, f.Area))

    def test_lines_stop_at_a_hole(self):
        # The line y = 11 meets the hole (radius 3 about 10, 10) at x = 10 - sqrt(8).
        sites = sites_on(self.top, origin=(4, 11, 2), d1=(1, 0, 0), d2=(0, 1, 0), c_u=0.5, c_v=50, b_u=0.25, b_v=0.25)
        self.assertEqual(sites.index[:, 0].tolist(), list(numbers_along(4, 6 - math.sqrt(8), 0.5, 0.25)))

    def test_a_hole_smaller_than_a_step_stops_the_line_too(self):
        plate = Part.makeBox(200, 20, 2).cut(Part.makeCylinder(0.05, 2, Vector(150, 10, 0)))
        top = max(plate.Faces, key=lambda f: (f.CenterOfMass.z, f.Area))
        sites = sites_on(top, origin=(20, 10.04, 2), d1=(1, 0, 0), d2=(0, 1, 0), c_u=1, c_v=50, b_u=0.1, b_v=0.1)
        self.assertAlmostEqual(sites.points[:, 0].max(), 149.0, places=9)

    def test_a_line_that_passes_a_hole_by_is_not_stopped(self):
        sites = sites_on(self.top, origin=(4, 13.001, 2), d1=(1, 0, 0), d2=(0, 1, 0), c_u=0.5, c_v=50, b_u=0.2, b_v=0.2)
        self.assertEqual(sites.index[:, 0].tolist(), list(numbers_along(4, 16, 0.5, 0.2)))

    def test_sites_lie_on_the_face_and_out_of_the_hole(self):
        sites = sites_on(self.top, c_u=0.7, c_v=0.7, b_u=0.3, b_v=0.3)
        self.assertGreater(np.linalg.norm(sites.points[:, :2] - 10, axis=1).min(), 3)


class OnCylinders(unittest.TestCase):
    def side(self, radius=5.0, height=10.0):
        return Part.makeCylinder(radius, height).Faces[0]

    def test_sites_are_spaced_by_arc_length_and_none_counts_twice(self):
        for spacing in (1.0, 2 * math.pi * 5 / 12, 1.234):
            with self.subTest(spacing=spacing):
                sites = sites_on(self.side(), c_u=spacing, c_v=2, b_u=0.5, b_v=0.5)
                around = math.floor(2 * math.pi * 5 / spacing + 1e-9)
                self.assertEqual(len(sites), around * len(numbers_along(5, 5, 2, 0.5)))
                row = sites.points[sites.index[:, 1] == 0]
                angles = np.sort(np.arctan2(row[:, 1], row[:, 0]) % (2 * math.pi))
                steps = 5 * np.diff(np.append(angles, angles[0] + 2 * math.pi))
                self.assertEqual(
                    int((np.abs(steps - spacing) < 1e-7).sum()), len(steps) - (spacing != 2 * math.pi * 5 / 12)
                )
                self.assertGreater(steps.min(), spacing - 1e-7)

    def test_the_numbers_of_a_closed_line_cover_half_a_turn_each_way(self):
        sites = sites_on(self.side(), c_u=2 * math.pi * 5 / 12, c_v=20, b_u=0.5, b_v=0.5)
        self.assertEqual(sites.index[:, 0].tolist(), list(range(-5, 7)))

    def test_lines_along_the_axis_from_origins_around_it_give_as_many_sites(self):
        across = sites_on(self.side(), d1=(0, 0, 1), c_u=2, c_v=1.0, b_u=0.5, b_v=0.5)
        self.assertEqual(len(across), 31 * 5)
        self.assertEqual(sorted(set(across.index[:, 0].tolist())), [-2, -1, 0, 1, 2])

    def test_the_seam_is_no_border(self):
        # The seam is the half-plane y = 0, x > 0; the origin is put close to it.
        sites = sites_on(self.side(), origin=(5 * math.cos(0.1), 5 * math.sin(0.1), 5), c_u=1, c_v=2, b_u=0.4, b_v=0.5)
        self.assertEqual(len(sites), 31 * 5)

    def test_normals_point_away_from_the_axis_on_the_side_and_to_it_in_a_hole(self):
        pipe = Part.makeCylinder(5, 10).cut(Part.makeCylinder(3, 10))
        for face in pipe.Faces:
            if isinstance(face.Surface, Part.Cylinder):
                sites = sites_on(face, c_u=1, c_v=1)
                sign = 1 if face.Surface.Radius == 5 else -1
                expected = sign * sites.points * [1, 1, 0] / face.Surface.Radius
                np.testing.assert_allclose(sites.normals, expected, atol=1e-9)

    def test_half_a_cylinder_ends_at_its_straight_edges(self):
        half = Part.makeCylinder(5, 10, Vector(), Vector(0, 0, 1), 180)
        side = next(f for f in half.Faces if isinstance(f.Surface, Part.Cylinder))
        sites = sites_on(side, c_u=1, c_v=2, b_u=0.5, b_v=0.5)
        around = numbers_along(2.5 * math.pi, 2.5 * math.pi, 1, 0.5)
        self.assertEqual(len(sites), len(around) * 5)


class OnOtherSurfaces(unittest.TestCase):
    def test_sites_on_a_sphere_sit_on_great_circles_and_each_counts_once(self):
        sites = sites_on(Part.makeSphere(5).Faces[0], c_u=1.5, c_v=1.5)
        np.testing.assert_allclose(np.linalg.norm(sites.points, axis=1), 5, atol=1e-9)
        np.testing.assert_allclose(sites.normals, sites.points / 5, atol=1e-9)
        origin = sites.points[at(sites, 0, 0)]
        for i in range(-5, 6):
            angle = math.acos(np.clip(sites.points[at(sites, i, 0)] @ origin / 25, -1, 1))
            self.assertAlmostEqual(5 * angle, 1.5 * abs(i), delta=1e-6)
        # The far half of each circle is the near half of its opposite: no row goes farther than a quarter.
        self.assertLessEqual(1.5 * np.abs(sites.index[:, 0]).max(), 2.5 * math.pi)
        gaps = np.linalg.norm(sites.points[:, None] - sites.points, axis=2) + 9 * np.eye(len(sites))
        self.assertGreater(gaps.min(), 1e-3)

    def test_rows_that_meet_in_a_point_have_one_site_there(self):
        # Five steps are a quarter of the circle: every row u' ends in the two points that d1 points at.
        spacing = math.pi * 5 / 2 / 5
        sites = sites_on(Part.makeSphere(5).Faces[0], d1=(0, 0, 1), d2=(0, 1, 0), c_u=spacing, c_v=spacing)
        top = np.linalg.norm(sites.points - [0, 0, 5], axis=1) < 1e-6
        self.assertEqual(int(top.sum()), 1)
        self.assertEqual(len(sites), 20 * 9 + 2)

    def test_a_pole_can_be_the_origin(self):
        sites = sites_on(Part.makeSphere(5).Faces[0], origin=(0, 0, 5), c_u=1.5, c_v=1.5)
        np.testing.assert_allclose(sites.points[at(sites, 0, 0)], [0, 0, 5], atol=1e-9)
        self.assertEqual(sorted(i for i, j in sites.index.tolist() if j == 0), list(range(-5, 6)))

    def test_sites_cover_a_torus_by_its_own_directions(self):
        sites = sites_on(Part.makeTorus(5, 2).Faces[0], c_u=1, c_v=1)
        # The line v is the inner equator (radius 3), the lines u' are meridians.
        self.assertEqual(len(sites), math.floor(6 * math.pi) * math.floor(4 * math.pi))

    def test_a_parabola_swept_as_a_b_spline_has_the_parabolas_arc_length(self):
        # y = x^2 / 4 for x = 0..6, a Bezier curve of degree two, drawn out 7 mm along z and trimmed to a window.
        curve = Part.BSplineCurve()
        curve.buildFromPolesMultsKnots([Vector(0, 0, 0), Vector(3, 0, 0), Vector(6, 9, 0)], [3, 3], [0, 1], False, 2)
        sheet = curve.toShape().extrude(Vector(0, 0, 7)).toNurbs()
        window = Part.makeBox(3, 20, 4, Vector(1, -5, 2))
        face = sheet.common(window).Faces[0]
        surface = FaceSurface(face)
        line = CoordinateLine(surface, surface.nearest(Vector(2, 1, 4)), Vector(1, 1, 0))

        def length(x):
            return 0.5 * x * math.sqrt(1 + x * x / 4) + math.asinh(x / 2)

        self.assertAlmostEqual(line.plus.length, length(4) - length(2), delta=1e-6)
        self.assertAlmostEqual(line.minus.length, length(2) - length(1), delta=1e-6)
        sites = sites_on(face, origin=(2, 1, 4), d1=(0, 0, 1), d2=(1, 1, 0), c_u=0.5, c_v=0.5, b_u=0.2, b_v=0.2)
        self.assertEqual(
            len(sites),
            len(numbers_along(2, 2, 0.5, 0.2))
            * len(numbers_along(length(2) - length(1), length(4) - length(2), 0.5, 0.2)),
        )

    def test_a_mirrored_and_placed_body_has_the_same_sites(self):
        body = Part.makeCone(5, 2, 8).toNurbs()
        other = body.mirror(Vector(), Vector(1, 0, 0))
        other.Placement = FreeCAD.Placement(Vector(40, 50, 60), FreeCAD.Rotation(Vector(0, 1, 1), 70))
        for one, two in zip(body.Faces, other.Faces):
            a, b = (sites_on(f, c_u=1, c_v=1, b_u=0.3, b_v=0.3) for f in (one, two))
            self.assertEqual(len(a), len(b))
            outside = [other.isInside(Vector(*(p + 0.01 * n)), 1e-9, False) for p, n in zip(b.points, b.normals)]
            self.assertFalse(any(outside))


class OnAnatomy(unittest.TestCase):
    def solid(self, name):
        shape = Part.Shape()
        shape.read(str(EXAMPLES / name))
        return shape.Solids[0]

    def test_rows_of_the_dome_of_the_cranial_plate_cross_its_pole_and_seam(self):
        # The top is a sphere turned into a B-spline; its pole lies inside the face, near the centre.
        face = self.solid("cranial_plate.step").Faces[0]
        sites = sites_on(face, c_u=3, c_v=3, b_u=3.5, b_v=1.5, d1=(1, 0, 0), d2=(0, 1, 0))
        centre, radius = sphere_through(sites.points)
        np.testing.assert_allclose(np.linalg.norm(sites.points - centre, axis=1), radius, atol=1e-6)
        for j in sorted(set(sites.index[:, 1].tolist())):
            row = sites.points[sites.index[:, 1] == j] - centre
            angles = np.arccos(np.clip((row[1:] * row[:-1]).sum(1) / radius**2, -1, 1))
            np.testing.assert_allclose(radius * angles, 3, atol=1e-4)  # great circles through each row's origin

    def test_sites_of_the_femur_are_on_its_face_and_apart_by_their_spacing(self):
        face = self.solid("femur_metaphysis.step").Faces[0]
        sites = sites_on(face, c_u=1.25, c_v=1.25, b_u=0.25, b_v=0.25)
        for k in range(0, len(sites), 25):
            distance = face.distToShape(Part.Vertex(*sites.points[k].tolist()))[0]
            self.assertLess(distance, 1e-7)
        for j in (-3, 0, 4):
            row = sites.points[sites.index[:, 1] == j]
            self.assertLessEqual(np.linalg.norm(np.diff(row, axis=0), axis=1).max(), 1.25 + 1e-6)
            self.assertGreater(np.linalg.norm(np.diff(row, axis=0), axis=1).min(), 1.1)


def sphere_through(points):
    """Return the centre and radius of the sphere that fits points (P, 3) best, by linear least squares."""
    solution = np.linalg.lstsq(np.c_[2 * points, np.ones(len(points))], (points**2).sum(1), rcond=None)[0]
    return solution[:3], math.sqrt(solution[3] + solution[:3] @ solution[:3])


class SitesByHand(unittest.TestCase):
    def test_a_picked_point_gets_the_frame_of_the_face(self):
        point, u, normal = pick_site(Part.makeCylinder(5, 10).Faces[0], (0.0, 5.2, 3.0), d1=(1, 1, 1))
        np.testing.assert_allclose(point, [0, 5, 3], atol=1e-9)
        np.testing.assert_allclose(normal, [0, 1, 0], atol=1e-9)
        np.testing.assert_allclose(u, np.array([1, 0, 1]) / math.sqrt(2), atol=1e-9)

    def test_a_point_beside_the_face_goes_to_its_border(self):
        point, _, _ = pick_site(Part.makeBox(10, 10, 10).Faces[5], (10.6, 4.0, 10.0))
        np.testing.assert_allclose(point, [10, 4, 10], atol=1e-9)

    def test_a_first_direction_along_the_normal_there_is_replaced_by_the_faces_own(self):
        _, u, normal = pick_site(Part.makeSphere(5).Faces[0], (0.0, 0.0, 5.0), d1=(0, 0, 1))
        self.assertAlmostEqual(float(u @ normal), 0, places=9)

    def test_a_point_far_from_the_face_is_refused_with_its_distance(self):
        with self.assertRaisesRegex(ParameterError, "distance of 3 mm"):
            pick_site(Part.makeBox(10, 10, 10).Faces[5], (5, 5, 13))


class Refusals(unittest.TestCase):
    def setUp(self):
        self.top = Part.makeBox(10, 10, 10).Faces[5]

    def test_an_origin_off_the_face_is_refused_with_its_distance(self):
        with self.assertRaisesRegex(ParameterError, "origin on face F .* distance of 5 mm"):
            sites_on(self.top, origin=(5, 15, 10))

    def test_a_direction_along_the_normal_is_refused(self):
        for directions_given in ({"d1": (0, 0, 1)}, {"d2": (0, 0, -2)}):
            with self.assertRaisesRegex(ParameterError, "along the face's normal"):
                sites_on(self.top, **directions_given)

    def test_parallel_directions_are_refused_with_their_angle(self):
        with self.assertRaisesRegex(ParameterError, "differ by at least 1 degree .* 0 degrees"):
            sites_on(self.top, d1=(1, 1, 0), d2=(-1, -1, 0.5))

    def test_spacings_that_give_too_many_sites_are_refused_with_the_estimate(self):
        with self.assertRaisesRegex(ParameterError, f"at most {MOST_SITES} sites.*1e\\+08"):
            sites_on(self.top, c_u=0.001, c_v=0.001)

    def test_cancelling_stops_between_two_lines(self):
        calls = []

        def progress(done, total, what):
            calls.append((done, total, what))
            if done == 3:
                raise Cancelled("stopped")

        with self.assertRaises(Cancelled):
            face_sites(self.top, "F", FaceParameters(c_u=1, c_v=1), progress=progress)
        self.assertEqual((len(calls), calls[-1][2]), (4, "sites on F"))
