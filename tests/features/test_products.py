# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a design: foretold, written, read again."""

import tempfile
import unittest
from collections import namedtuple
from pathlib import Path
from unittest import mock

import FreeCAD
import Mesh
import Part

from freecad_trabecula.core import meshes, stl
from freecad_trabecula.errors import ExportError
from freecad_trabecula.geometry.mesh_objects import core_mesh
from freecad_trabecula.shell.folder import ResultFolder
from freecad_trabecula.shell.products import Product, check_room, products, stl_checks, write_products

Objects = namedtuple("Objects", "wireframe network solid_scaffold")
Bodies = namedtuple("Bodies", "body_volume")


class ProductsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        document = FreeCAD.newDocument()
        self.addCleanup(FreeCAD.closeDocument, document.Name)
        network = document.addObject("Part::Feature", "Network")
        network.Shape = Part.makeCompound([Part.makeBox(1, 1, 1 + k, FreeCAD.Vector(3 * k, 0, 0)) for k in range(20)])
        solid = document.addObject("Part::Feature", "Solid")
        solid.Shape = Part.makeBox(5, 5, 5)
        self.objects = Objects(network, network, solid)
        self.mesh = core_mesh(Mesh.createSphere(3, 40))

    def test_files_come_under_their_names_as_large_as_was_said(self):
        wanted = products({"scaffold": self.mesh}, self.objects, ["3mf", "brep", "3mf"])
        said = []
        with ResultFolder(str(self.folder / "out")) as folder:
            names = write_products(wanted, folder, lambda done, total, what: said.append(what))
            for product in wanted:
                size = folder.path(product.name).stat().st_size
                if product.size:
                    self.assertLess(abs(product.size / size - 1), 0.2, product.name)
        self.assertEqual(
            names, ["scaffold.stl", "scaffold.3mf", "network.step", "network.brep", "scaffold.step", "design.FCStd"]
        )
        self.assertIn("writing scaffold.stl, about ", said[0])

    def test_a_disk_without_room_is_refused_beforehand_with_both_sizes(self):
        usage = mock.Mock(free=1_000_000)
        with mock.patch("shutil.disk_usage", return_value=usage):
            check_room(self.folder, [Product("a", None, 1_000_000)])
            with self.assertRaisesRegex(ExportError, "need about 2 MB, but the disk of .* has 1 MB free"):
                check_room(self.folder, [Product("a", None, 1_000_000), Product("b", None, 1_000_000)])

    def test_an_stl_file_of_its_mesh_passes(self):
        stl.write_stl(self.folder / "a.stl", meshes.printable(self.mesh))
        checks = stl_checks(self.folder / "a.stl", self.mesh, Bodies(113.0))
        self.assertEqual([check.ok for check in checks], [True, True])

    def test_an_stl_file_with_a_hole_or_another_volume_fails(self):
        opened = meshes.Mesh(self.mesh.vertices, self.mesh.triangles[1:])
        stl.write_stl(self.folder / "open.stl", opened)
        self.assertFalse(stl_checks(self.folder / "open.stl", self.mesh, Bodies(113.0))[0].ok)
        stl.write_stl(self.folder / "large.stl", meshes.Mesh(self.mesh.vertices * 1.01, self.mesh.triangles))
        found = stl_checks(self.folder / "large.stl", self.mesh, Bodies(113.0))
        self.assertEqual([check.ok for check in found], [True, False])


if __name__ == "__main__":
    unittest.main()
