# SPDX-License-Identifier: LGPL-2.1-or-later
"""A test case with a document of its own, and designs to put into it."""

import contextlib
import os
import tempfile
import unittest

import FreeCAD

from freecad_trabecula import make
from freecad_trabecula.core.job import Job, opposite_couplings
from freecad_trabecula.core.parameters import PathParameters, PrismParameters
from freecad_trabecula.features import results

NO_BOOLEANS = "manifold3d is not installed: nothing that needs mesh Booleans is tested"


def small_job(n=3, kind="straight", association="random", **more):
    """Return a job of 3 n^2 rods in a 10 mm cube."""
    return Job(
        name="small",
        prism=PrismParameters(n_x=n, n_y=n, n_z=n),
        path=PathParameters(kind),
        couplings=opposite_couplings(association),
        **more,
    )


class DocumentCase(unittest.TestCase):
    """Opens a document before each test and closes it after; nothing computed in one test is at hand in the next."""

    def setUp(self):
        results.clear()
        self.document = FreeCAD.newDocument("T")

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)

    def reopened(self):
        """Save the document, close it, forget all results, open the file and return the document."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)
            results.clear()
            self.document = FreeCAD.openDocument(path)
        return self.document

    def make(self, job):
        """Add a job's design and return it."""
        return make.make_design(self.document, job)

    @contextlib.contextmanager
    def unchanged(self):
        """Assert that the objects of the document are the same after the block."""
        before = [obj.Name for obj in self.document.Objects]
        yield
        self.assertEqual([obj.Name for obj in self.document.Objects], before)
