# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the pages of the docs say in Python, run as it stands there: blocks whole, the script of each command's page."""

import os
import re
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import FreeCAD
import numpy as np
import Part

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.job import job_to_json
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.voxels.parameters import VoxelParameters

DOCS = Path(__file__).resolve().parents[2] / "docs"
COMMANDS = DOCS / "commands"
#: Pages whose script is about what is seen: it needs a window.
OF_THE_WINDOW = {"Colours", "Help", "Section", "Sights", "Switch"}


def block(page):
    """Return the one block of Python of a page."""
    (found,) = re.findall(r"```python\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)
    return found


def scripts():
    """Return (page, piece of Python) of all scripts in the commands' pages that need no window."""
    found = []
    for page in sorted(COMMANDS.glob("[A-Z]*.md")):
        rows = re.findall(r"^\| script \| (.*) \|$", page.read_text(encoding="utf-8"), re.MULTILINE)
        if rows and page.stem not in OF_THE_WINDOW:
            found += [(page.stem, piece) for piece in re.findall(r"`([^`]+)`", rows[0])]
    return found


class PageScriptsTest(DocumentCase):
    def small_preset(self, name):
        """Return a design that is made soon, in the place of one that takes long; the name must be a preset's."""
        self.assertTrue(preset(name).pores)
        return small_job()

    def few_rods(self):
        """Return a wireframe that becomes a solid scaffold soon."""
        job = small_job()
        return self.make(replace(job, couplings=(replace(job.couplings[0], limit=2),))).wireframe

    def names(self):
        """What a page may take for granted: objects that are there, and what the list of commands imports."""
        design = make.make_design(self.document, small_job(), ("network", "scaffold"))
        ring = self.document.addObject("Part::Feature", "Ring")
        ring.Shape = Part.makeBox(2, 2, 2).cut(Part.makeBox(1, 1, 2))
        voxels = make.make_voxel_design(self.document, ring, VoxelParameters(size=(0.1, 0.1, 0.1), contacts="any"))
        analyses = [make.make_analysis(self.document, one, SliceParameters(thickness=0.5)) for one in (ring, ring)]
        found = make.voxel_design_of(voxels)
        Part.makeBox(3, 3, 3).exportStep("body.step")
        make.export(design.scaffold, "bone.stl")
        given = {
            **{"document": self.document, "body": ring, "envelope": design.envelope, "wireframe": design.wireframe},
            **{"network": design.network, "scaffold": design.scaffold, "obj": design.scaffold, "bone": analyses[0]},
            **{"analysis": analyses[0], "objs": analyses, "design": voxels, "folder": ".", "path": "report.html"},
            **{"text": job_to_json(small_job()), "seeds": [1, 2], "parameters": found.parameters},
            **{"alpha": found.alpha, "beta": found.beta},
        }
        self.assertIn("from freecad_trabecula import make\n", block(COMMANDS / "README.md"))
        exec(block(COMMANDS / "README.md"), given)  # noqa: S102  what a reader would type
        given["preset"] = self.small_preset
        return given

    def test_the_script_of_every_command_can_be_run(self):
        here = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                given = self.names()
                own = {
                    "Compare": {"design": given["objs"][1]},
                    "SaveAnalyses": {"obj": given["analysis"]},
                    "Scaffold": {"wireframe": self.few_rods()},
                    "Variants": {"obj": given["wireframe"]},
                    "VoxelTables": {"parameters": replace(given["parameters"], strategy="sequential")},
                    "Voxels": {"bone": given["body"]},
                    "WatchLayer": {"alpha": np.array([2, 1]), "beta": np.array([1, 2])},
                }
                self.assertGreater(len(scripts()), 30)
                for page, piece in scripts():
                    with self.subTest(page=page, script=piece):
                        exec(piece, {**given, **own.get(page, {})})  # noqa: S102  what a reader would type
            finally:
                os.chdir(here)

    def test_what_a_script_of_the_pages_names_must_be_there(self):
        for piece in ("make.make_nothing(document)", "make.make_network(rods)"):
            with self.assertRaises((AttributeError, NameError)):
                exec(piece, {"make": make, "document": self.document})  # noqa: S102

    def test_the_copied_script_of_the_page_on_a_design_as_a_whole_makes_its_design(self):
        names = {}
        exec(block(DOCS / "study.md"), names)  # noqa: S102  what a reader would paste
        self.assertEqual((names["wireframe"].Rods, names["scaffold"].isValid()), (146, True))
        self.assertNotEqual(names["document"].Name, self.document.Name)
        FreeCAD.closeDocument(names["document"].Name)
