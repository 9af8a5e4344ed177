# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results by keys: found again, handed over as files, refused when they are not whole."""

import json
import sys
import tempfile
import unittest
from dataclasses import replace
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import small_job

from freecad_trabecula.errors import ExportError
from freecad_trabecula.features import results


class KeysTest(unittest.TestCase):
    def setUp(self):
        results.clear()

    def test_equal_inputs_have_equal_keys_and_any_change_another(self):
        job = small_job()
        keys = {
            results.key_of("a", job),
            results.key_of("b", job),
            results.key_of("a", replace(job, seed=2)),
            results.key_of("a", replace(job, pores=replace(job.pores, scatter=1e-12))),
            results.key_of("a", [job]),
        }
        self.assertEqual(len(keys), 5)
        self.assertEqual(results.key_of("a", small_job()), results.key_of("a", job))

    def test_a_result_is_made_once(self):
        made = []
        for _ in range(3):
            results.found_or_made("wireframe", "k", lambda: made.append(1) or "value")
        self.assertEqual((len(made), results.find("wireframe", "k")), (1, "value"))
        self.assertIsNone(results.find("network", "k"))

    def test_the_oldest_of_a_kind_go_and_those_used_last_stay(self):
        for k in range(30):
            results.keep("network", str(k), k)
            results.find("network", "0")
        self.assertEqual(results.find("network", "0"), 0)
        self.assertEqual(results.find("network", "29"), 29)
        self.assertIsNone(results.find("network", "5"))

    def test_an_error_while_making_is_passed_on_and_nothing_is_kept(self):
        with self.assertRaises(ZeroDivisionError):
            results.found_or_made("network", "k", lambda: 1 // 0)
        self.assertIsNone(results.find("network", "k"))


class FilesTest(unittest.TestCase):
    def setUp(self):
        results.clear()
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def test_results_are_found_again_by_their_keys(self):
        results.keep("wireframe", "w", (1, 2))
        results.keep("scaffold", "s", {"porosity": 0.5})
        results.save(self.folder.name, ("wireframe", "w"), ("scaffold", "s"))
        results.clear()
        self.assertEqual(results.load(self.folder.name), 2)
        self.assertEqual(results.find("wireframe", "w"), (1, 2))
        self.assertEqual(results.find("scaffold", "s"), {"porosity": 0.5})

    def test_half_written_results_are_refused(self):
        with self.assertRaisesRegex(ExportError, "written to the end"):
            results.load(self.folder.name)
        results.keep("wireframe", "w", np.arange(3))
        results.save(self.folder.name, ("wireframe", "w"))
        (Path(self.folder.name) / "0-wireframe" / "arrays.npz").unlink()
        with self.assertRaisesRegex(ExportError, "written to the end"):
            results.load(self.folder.name)
        index = json.loads((Path(self.folder.name) / "results.json").read_text())
        self.assertEqual([one["kind"] for one in index], ["wireframe"])
