# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files: what is written is read again and is the same; what cannot be written leaves nothing behind."""

import contextlib
import os
import resource
import signal
import tempfile
import unittest
import zipfile
from pathlib import Path
from unittest import mock

import FreeCAD
import Mesh
import numpy as np
import Part

from freecad_trabecula.core import mesh_formats, meshes, stl
from freecad_trabecula.errors import ExportError, MeshError, ParameterError
from freecad_trabecula.geometry import files
from freecad_trabecula.geometry.mesh_objects import core_mesh

VERSION = tuple(int(part) for part in FreeCAD.Version()[:2])


def ball(radius=4.0, centre=(20.0, -30.0, 40.0), sampling=60):
    """A closed mesh with uneven co-ordinates."""
    mesh = core_mesh(Mesh.createSphere(radius, sampling))
    return meshes.Mesh(mesh.vertices + centre, mesh.triangles)


def shapes(count=12):
    return [Part.makeCone(1.0, 0.3 + 0.01 * k, 3.0, FreeCAD.Vector(4 * k, 0.123 * k, 1)) for k in range(count)]


@contextlib.contextmanager
def almost_full_disk(size):
    """No file can grow beyond ``size`` bytes inside: as on a full disk, writing fails in the midst."""
    handler = signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, resource.RLIM_INFINITY))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
        signal.signal(signal.SIGXFSZ, handler)


class FilesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.mesh = ball()

    def document(self):
        document = FreeCAD.newDocument()
        self.addCleanup(FreeCAD.closeDocument, document.Name)
        document.addObject("Part::Feature", "Solids").Shape = Part.makeCompound(shapes())
        return document

    def names(self):
        return sorted(p.name for p in self.folder.iterdir())


class MeshFilesTest(FilesTest):
    def check_same(self, found, tolerance=1e-6):
        self.assertEqual(len(found.vertices), len(self.mesh.vertices))
        self.assertEqual(len(found.triangles), len(self.mesh.triangles))
        self.assertTrue(meshes.is_closed(found))
        volume = meshes.mesh_volume(self.mesh)
        self.assertLess(abs(meshes.mesh_volume(found) / volume - 1), tolerance)

    def test_stl_read_again_is_closed_and_has_the_same_volume(self):
        files.write_mesh(self.folder / "a.stl", self.mesh)
        self.check_same(stl.read_stl(self.folder / "a.stl"))

    def test_ply_keeps_every_bit(self):
        files.write_mesh(self.folder / "a.ply", self.mesh)
        found = mesh_formats.mesh_from_ply((self.folder / "a.ply").read_bytes())
        np.testing.assert_array_equal(found.vertices, self.mesh.vertices)
        np.testing.assert_array_equal(found.triangles, self.mesh.triangles)

    def test_freecad_reads_every_format_with_the_same_vertices_closed(self):
        for kind in files.MESH_FORMATS:
            if kind == "3mf" and VERSION < (1, 0):
                continue  # 0.20 writes 3MF but cannot read it; the next test reads it as what it is, XML
            with self.subTest(kind=kind):
                path = self.folder / f"a.{kind}"
                files.write_mesh(path, self.mesh)
                found = Mesh.Mesh(str(path))
                self.assertTrue(found.isSolid())
                self.check_same(core_mesh(found))

    def test_3mf_is_a_package_in_mm_with_every_vertex_and_triangle(self):
        from xml.etree import ElementTree

        files.write_mesh(self.folder / "a.3mf", self.mesh)
        with zipfile.ZipFile(self.folder / "a.3mf") as package:
            self.assertIsNone(package.testzip())
            self.assertEqual(set(package.namelist()), {"[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model"})
            model = ElementTree.fromstring(package.read("3D/3dmodel.model"))
        space = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
        self.assertEqual(model.get("unit"), "millimeter")
        points = [[float(v.get(c)) for c in "xyz"] for v in model.iter(space + "vertex")]
        corners = [[int(t.get(c)) for c in ("v1", "v2", "v3")] for t in model.iter(space + "triangle")]
        self.check_same(meshes.Mesh(np.array(points), np.array(corners)))
        self.assertEqual(model.find(f"{space}build/{space}item").get("objectid"), "1")

    def test_the_same_mesh_makes_the_same_file(self):
        for kind in files.MESH_FORMATS:
            for name in ("a", "b"):
                (self.folder / name).mkdir(exist_ok=True)
                files.write_mesh(self.folder / name / f"x.{kind}", self.mesh)
            one, other = ((self.folder / name / f"x.{kind}").read_bytes() for name in ("a", "b"))
            self.assertEqual(one, other, kind)

    def test_sizes_are_foretold_within_20_percent(self):
        for mesh in (self.mesh, ball(0.3, (0, 0, 0), 30)):
            for kind in files.MESH_FORMATS:
                path = self.folder / f"a.{kind}"
                files.write_mesh(path, mesh)
                size, expected = path.stat().st_size, files.estimate_mesh_size(kind, mesh)
                self.assertLess(abs(expected / size - 1), 0 + 1e-12 if kind in ("stl", "ply") else 0.2, kind)

    def test_capitals_in_an_extension_do_not_matter(self):
        files.write_mesh(self.folder / "A.STL", self.mesh)
        self.assertEqual(self.names(), ["A.STL"])

    def test_an_unknown_extension_is_refused_with_the_known_ones(self):
        for name in ("a.amf", "a", "a.step"):
            with self.assertRaisesRegex(ParameterError, r"must be one of \.stl, \.ply, \.obj, \.3mf, got 'a"):
                files.write_mesh(self.folder / name, self.mesh)
        with self.assertRaisesRegex(ParameterError, "must be one of stl, ply, obj, 3mf, got 'amf'"):
            files.estimate_mesh_size("amf", self.mesh)
        self.assertEqual(self.names(), [])

    def test_what_is_no_ply_of_triangles_is_refused(self):
        whole = mesh_formats.ply_bytes(self.mesh)
        for data in (b"", b"ply\n", whole[:-5], whole.replace(b"binary_little", b"binary_big"), b"solid" + whole):
            with self.assertRaises(MeshError):
                mesh_formats.mesh_from_ply(data)


class ShapeFilesTest(FilesTest):
    def test_shapes_read_again_have_the_same_volume_and_solids(self):
        whole = Part.makeCompound(shapes())
        for kind in ("step", "stp", "brep", "brp"):
            with self.subTest(kind=kind):
                path = self.folder / f"a.{kind}"
                files.write_shape(path, whole)
                found = Part.Shape()
                found.read(str(path))
                self.assertEqual(len(found.Solids), len(whole.Solids))
                self.assertAlmostEqual(found.Volume, whole.Volume, delta=1e-6 * whole.Volume)

    def test_iges_is_written_whole(self):
        files.write_shape(self.folder / "a.iges", Part.makeCompound(shapes()))
        found = Part.Shape()
        found.read(str(self.folder / "a.iges"))
        self.assertEqual(len(found.Faces), 36)

    def test_sizes_are_foretold_within_20_percent(self):
        for kind in ("step", "brep"):
            for count in (1, 3, 7, 60):
                solids = shapes(count)
                files.write_shape(self.folder / f"a.{kind}", Part.makeCompound(solids))
                size = (self.folder / f"a.{kind}").stat().st_size
                self.assertLess(abs(files.estimate_shape_size(kind, solids) / size - 1), 0.2, (kind, count))

    def test_nothing_takes_no_room(self):
        self.assertEqual(files.estimate_shape_size("step", []), 0)

    def test_an_empty_shape_is_refused(self):
        for shape in (Part.Shape(), Part.makeCompound([]), Part.makeLine((0, 0, 0), (1, 0, 0))):
            with self.assertRaisesRegex(ParameterError, "must have faces to be written into a.step, got none"):
                files.write_shape(self.folder / "a.step", shape)


class DocumentFilesTest(FilesTest):
    def test_a_document_opens_again_and_the_open_one_keeps_its_name(self):
        document = self.document()
        files.write_document(self.folder / "a.FCStd", document)
        self.assertEqual(document.FileName, "")
        again = FreeCAD.openDocument(str(self.folder / "a.FCStd"))
        self.addCleanup(FreeCAD.closeDocument, again.Name)
        self.assertAlmostEqual(again.Solids.Shape.Volume, document.Solids.Shape.Volume, places=6)

    def test_a_document_written_again_leaves_no_backup(self):
        document = self.document()
        for _ in range(3):
            files.write_document(self.folder / "a.FCStd", document)
        self.assertEqual(self.names(), ["a.FCStd"])


class FailuresTest(FilesTest):
    """On a full disk FreeCAD says nothing: it leaves half a document and returns."""

    def writers(self):
        document, solids = self.document(), Part.makeCompound(shapes(60))
        yield "a.FCStd", lambda path: files.write_document(path, document)
        for kind in ("step", "brep", "iges"):
            yield f"a.{kind}", lambda path: files.write_shape(path, solids)
        for kind in files.MESH_FORMATS:
            yield f"a.{kind}", lambda path: files.write_mesh(path, self.mesh)

    def test_a_full_disk_is_said_and_leaves_the_old_file_and_no_other(self):
        for name, write in self.writers():
            with self.subTest(name=name):
                path = self.folder / name
                path.write_text("the old one")
                with almost_full_disk(2000), self.assertRaisesRegex(ExportError, "could not be written"):
                    write(path)
                self.assertEqual(path.read_text(), "the old one")
                self.assertEqual(self.names(), [name])
                path.unlink()

    def test_a_writer_that_fails_without_a_word_is_found_out(self):
        document = self.document()
        with almost_full_disk(2000), self.assertRaisesRegex(ExportError, "written whole: is the disk full"):
            files.write_document(self.folder / "a.FCStd", document)

    def test_a_file_in_the_way_of_the_folder_is_said(self):
        (self.folder / "file").write_text("")
        for name, write in self.writers():
            with self.subTest(name=name), self.assertRaisesRegex(ExportError, "could not be written"):
                write(self.folder / "file" / name)

    def test_a_missing_folder_is_not_made(self):
        for name, write in self.writers():
            with self.subTest(name=name), self.assertRaises(ExportError):
                write(self.folder / "missing" / name)
        self.assertEqual(self.names(), [])

    def test_a_read_only_folder_is_said(self):
        writers = list(self.writers())
        self.folder.chmod(0o555)
        self.addCleanup(self.folder.chmod, 0o700)
        if os.geteuid() == 0:  # the superuser may write everywhere
            os.seteuid(65534)
            self.addCleanup(os.seteuid, 0)
        for name, write in writers:
            with self.subTest(name=name), self.assertRaisesRegex(ExportError, "could not be written"):
                write(self.folder / name)

    def test_a_disk_that_fills_when_the_file_gets_its_name_is_said(self):
        full = OSError(28, "No space left on device")
        for name, write in self.writers():
            with self.subTest(name=name), mock.patch("os.replace", side_effect=full):
                with self.assertRaisesRegex(ExportError, "No space left on device"):
                    write(self.folder / name)
                self.assertEqual(self.names(), [])


if __name__ == "__main__":
    unittest.main()
