# SPDX-License-Identifier: LGPL-2.1-or-later
"""BREP text against the kernel's own shapes."""

import unittest

from freecad_trabecula.errors import KernelError
from freecad_trabecula.geometry.brep_text import BrepText, flat, places, read_brep

CORNERS = [(0, 0, 0), (2, 0, 0), (0, 3, 0), (0, 0, 4)]
#: Corners of the faces of a tetrahedron, counter-clockwise from outside.
SIDES = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]


def tetrahedron():
    """Return the text of a tetrahedron of straight edges and planes, each edge shared by two faces."""
    text = BrepText()
    vertices = [text.add_vertex(corner) for corner in CORNERS]
    edges, faces = {}, []
    for side in SIDES:
        uses = []
        for a, b in zip(side, side[1:] + side[:1]):
            if (b, a) in edges:
                uses.append((edges[b, a], True))
                continue
            p, q = CORNERS[a], CORNERS[b]
            curve = text.add_spline([*p, *q], (0, 1), 1)
            edges[a, b] = text.add_edge(curve, (0, 1), [], (vertices[a], vertices[b]))
            uses.append((edges[a, b], False))
        faces.append((text.add_face(plane(text, side), [text.add_wire(uses)]), False))
    return text.text(text.add_solid([faces]))


def plane(text, side):
    import FreeCAD

    a, b, c = (FreeCAD.Vector(*CORNERS[k]) for k in side)
    u = (b - a).normalize()
    normal = (b - a).cross(c - a).normalize()
    return text.add_plane(*[tuple(v) for v in (a, normal, u, normal.cross(u))])


class Text(unittest.TestCase):
    def test_a_tetrahedron_is_a_valid_solid_of_the_right_volume(self):
        solid = read_brep(tetrahedron())
        self.assertEqual(solid.ShapeType, "Solid")
        self.assertTrue(solid.isValid() and solid.isClosed())
        self.assertAlmostEqual(solid.Volume, 2 * 3 * 4 / 6, places=12)
        self.assertEqual([len(solid.Vertexes), len(solid.Edges), len(solid.Faces)], [4, 6, 4])

    def test_what_the_kernel_writes_of_it_is_read_as_the_same(self):
        solid = read_brep(tetrahedron())
        again = read_brep(solid.exportBrepToString())
        self.assertAlmostEqual(again.Volume, solid.Volume, places=12)

    def test_a_template_that_is_filled_is_the_shape(self):
        text = BrepText()
        text.add_vertex(places(3))
        self.assertEqual(
            tuple(read_brep(text.text(1) % (1.0, 2.0, 3.0)).Vertexes[0].Point),
            (1.0, 2.0, 3.0),
        )

    def test_arrays_become_flat_lists_of_floats(self):
        self.assertEqual(flat([[1, 2], [3, 4]]), [1.0, 2.0, 3.0, 4.0])


class Refusals(unittest.TestCase):
    def test_text_that_is_no_shape_is_refused_with_its_length(self):
        with self.assertRaises(KernelError) as caught:
            read_brep("no shape at all")
        self.assertIn("15 characters", str(caught.exception))
