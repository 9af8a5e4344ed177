# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walks through one door of the guide in a FreeCAD window, as a user would, with a picture of each step.

Started by ``gallery_window.py`` for ``tour.py``. Beside each step stands what the tutorial says besides.
"""

import json
import tempfile
from pathlib import Path
from unittest import mock

import FreeCAD
import FreeCADGui
from PySide import QtGui

BONES = Path(__file__).resolve().parent.parent / "resources" / "examples"
START = (
    "The guide opens with the workbench: three doors, each with its steps and an example. *Begin* goes through the "
    "door with the open document; *Example* opens a finished project in a new one. What is marked ➤ comes next."
)


class Walk:
    """One walk; ``wait`` and ``shoot`` are those of ``gallery_window.py``."""

    def __init__(self, door, folder, wait, shoot):
        from freecad_trabecula.gui import guide_dock, panels

        self.door, self.folder, self.wait, self.shoot = door, Path(folder), wait, shoot
        self.panels, self.told = panels, []
        self.guide = guide_dock.guide_dock()
        self.guide.open()

    def tell(self, name, title, text, more=""):
        """Picture the window and note what the page says of it."""
        picture = f"tour-{self.door}-{len(self.told)}-{name}"
        self.guide.look()
        self.shoot(picture)
        self.told.append({"name": name, "title": title, "text": text, "more": more, "picture": picture})

    def row(self, name):
        """Return the row of a step."""
        self.guide.look()
        return next(row for row in self.guide.rows if row.shown.step.name == name and not row.isHidden())

    def tell_step(self, name, more):
        """Picture a step that is done or shown, with the guide's own words."""
        step = self.row(name).shown.step
        self.tell(name, step.title, step.text, more)

    def click(self, name):
        """Click on a step."""
        row = self.row(name)
        if not row.button.isEnabled():
            raise SystemExit(f"{self.door}: the step {name} cannot be clicked")
        row.button.click()
        self.wait(seconds=0.5)

    def until(self, name, mark="done", seconds=150):
        """Wait until a step has its mark."""
        self.wait(lambda: self.row(name).shown.mark == mark, seconds)
        if self.row(name).shown.mark != mark:
            raise SystemExit(f"{self.door}: the step {name} is {self.row(name).shown.mark}, not {mark}")
        self.wait(lambda: not self.is_busy(), 60)
        self.wait(seconds=1.0)

    def is_busy(self):
        """Return whether contours are still being worked out."""
        from freecad_trabecula.gui.recomputing import of_window

        return bool(of_window()._works)

    def ok(self, seconds=150):
        """Press OK and wait for the panel to close."""
        panel = self.panels.current()
        panel.accept()
        self.wait(lambda: not panel.is_open, seconds)

    def bring(self, file, x=0.0):
        """Bring a mesh in, as *Body from a file* does once FreeCAD has asked for it."""
        import Mesh

        Mesh.insert(str(BONES / file), FreeCAD.ActiveDocument.Name)
        mesh = FreeCAD.ActiveDocument.Objects[-1]
        mesh.Label, mesh.Placement.Base = "Bone", FreeCAD.Vector(x, 0, 0)
        FreeCAD.ActiveDocument.recompute()
        self.fit()

    def fit(self):
        """Show all in the 3D view."""
        view = FreeCADGui.activeDocument().activeView()
        view.viewIsometric()
        view.fitAll()
        self.wait(seconds=0.3)

    def begin(self):
        """Picture the doors and go through this one."""
        self.guide.leave()
        self.tell("start", "The three doors", "", START)
        self.guide.cards[self.door].begin.click()
        self.wait(seconds=0.5)


def walk_rods(walk):
    """A box becomes a scaffold that is measured beside bone and changed."""
    from freecad_trabecula.features.examples import rods_job
    from freecad_trabecula.features.relations import parts_of
    from freecad_trabecula.gui.export_dialog import ExportDialog, exists

    box = FreeCAD.ActiveDocument.addObject("Part::Box", "Box")
    box.Length = box.Width = box.Height = 4
    FreeCAD.ActiveDocument.recompute()
    walk.fit()
    walk.tell_step("body", "Here a cube of 4 mm, made with Part; a STEP file of an implant will do as well.")
    walk.click("design")
    panel = walk.panels.current()
    walk.wait(lambda: panel.body.is_ready, 30)
    panel.fields.set_job(rods_job())
    panel._changed()  # as if typed
    walk.wait(lambda: "27 rods" in panel.outcome.headline.text() and "≈" in panel.outcome.headline.text(), 60)
    walk.fit()
    walk.tell_step("design", "Three by three sites a face and pores of 0.5 to 0.9 mm: 27 rods, about 70 % porosity.")
    panel.build()
    walk.until("build")
    walk.fit()
    walk.tell_step("build", "*Build* in the panel, or this step, makes it; the results follow by themselves.")
    walk.panels.current().reject()
    walk.click("analyse")
    walk.until("analyse")
    walk.tell_step("analyse", "The plots show the sliced area along each axis, and the slice under the cursor.")
    walk.bring("shrew_bone_a.ply", 6.0)
    walk.click("bone")
    walk.until("bone")
    walk.tell_step("bone", "Bone as large as the scaffold: `resources/examples/shrew_bone_a.ply`.")
    walk.click("compare")
    walk.until("compare")
    walk.tell_step("compare", "Area by area the scaffold swings where its sites lie; the bone does not.")
    walk.click("change")
    panel = walk.panels.current()
    walk.wait(lambda: "≈" in panel.outcome.headline.text(), 60)
    panel.fields.pores.fields["size"].high.set_value(1.1)
    walk.wait(seconds=2.0)
    walk.ok()
    walk.until("analyse")
    walk.panels.current().reject()
    walk.until("compare")
    walk.tell_step("change", "Pores of up to 1.1 mm, OK: scaffold, analysis and comparison follow by themselves.")
    wireframe = next(obj for obj in FreeCAD.ActiveDocument.Objects if obj.Name.startswith("Wireframe"))
    dialog = ExportDialog(FreeCADGui.getMainWindow(), [one for one in parts_of(wireframe) if exists(one)])
    dialog.show()
    walk.tell_step("export", "STL or 3MF for a printer; with a *STEP scaffold* built also STEP.")
    dialog.close()


def walk_measure(walk):
    """Two specimens of one bone are measured and compared."""
    from freecad_trabecula.gui.analysis_dock import dock_of_window

    walk.bring("shrew_bone_a.ply")
    walk.tell_step("file", "A specimen of bone of 4 mm: `resources/examples/shrew_bone_a.ply`.")
    walk.click("analyse")
    walk.wait(seconds=1.0)
    walk.ok()
    walk.until("analyse")
    walk.tell_step("analyse", "240 slices in a moment; the tree keeps the analysis, which follows its file or body.")
    dock_of_window().tabs.setCurrentIndex(3)
    dock_of_window().show_plane(30)
    walk.wait(seconds=0.5)
    walk.tell_step("plots", "*Areas* shows every contour of every slice: rods are blue, plates orange.")
    dock_of_window().tabs.setCurrentIndex(0)
    walk.bring("shrew_bone_b.ply", 6.0)
    walk.click("second")
    walk.until("second")
    walk.tell_step("second", "A second specimen is brought in, and measured in the same way at once.")
    walk.click("compare")
    walk.until("compare")
    dock_of_window().tabs.setCurrentIndex(dock_of_window().tabs.count() - 1)
    walk.wait(seconds=0.5)
    walk.tell_step("compare", "The *Passport* says how near they are, number by number.")
    folder = tempfile.mkdtemp(prefix="tables-")
    with mock.patch.object(QtGui.QFileDialog, "getExistingDirectory", lambda *_: folder):
        walk.click("export")
    bar = FreeCADGui.getMainWindow().statusBar()
    walk.wait(lambda: "are in" in bar.currentMessage(), 120)
    walk.tell_step("export", "Tables as CSV, a report and plots are written into a folder.")


def walk_voxels(walk):
    """A bone becomes voxels with its sliced areas."""
    from freecad_trabecula.gui.voxel_export import VoxelExportDialog

    walk.bring("shrew_bone_a.ply")
    walk.tell_step("sample", "A specimen of 4 mm: `resources/examples/shrew_bone_a.ply`.")
    walk.click("targets")
    walk.panels.current().fields.layers.fields["thickness"].set_value(0.1)
    walk.wait(seconds=0.5)
    walk.tell_step("targets", "Layers of 0.1 mm: 40 along each axis.")
    walk.ok()
    walk.until("targets")
    walk.click("voxels")
    walk.wait(seconds=1.0)
    walk.tell_step("voxels", "The voxels are as thick as the layers; the panel says beforehand what they take.")
    walk.ok()
    walk.until("voxels")
    FreeCAD.ActiveDocument.Objects[0].ViewObject.Visibility = False  # the bone lies in the same place
    walk.fit()
    walk.tell_step(
        "layers",
        "The bone's layer beside the design's, with both counts; the counts of all layers lie on the targets' curve.",
    )
    walk.click("analyse")
    walk.until("analyse")
    walk.click("compare")
    walk.until("compare")
    walk.tell_step("analyse", "A body like any other: its slices are cut from its triangles.")
    from freecad_trabecula.gui.analysis_dock import dock_of_window

    dock_of_window().tabs.setCurrentIndex(4)
    walk.wait(seconds=0.5)
    walk.tell_step("compare", "The curves lie on each other; what differs is less than half a voxel a layer.")
    walk.click("change")
    walk.wait(seconds=1.0)
    walk.tell_step("change", "Another seed gives another structure with the same areas; another strategy another look.")
    walk.panels.current().reject()
    design = next(obj for obj in FreeCAD.ActiveDocument.Objects if obj.Name.startswith("VoxelDesign"))
    dialog = VoxelExportDialog(FreeCADGui.getMainWindow(), [design])
    dialog.show()
    walk.tell_step("export", "A mesh, voxels, or one image a layer for printers that print images.")
    dialog.close()


WALKS = {"rods": walk_rods, "measure": walk_measure, "voxels": walk_voxels}


def walk_door(door, folder, wait, shoot):
    """Walk through one door and write what the page says of it."""
    walk = Walk(door, folder, wait, shoot)
    walk.begin()
    WALKS[door](walk)
    title = walk.guide.title.text().replace("<b>", "").replace("</b>", "")
    record = {"title": title, "steps": walk.told, "freecad": ".".join(FreeCAD.Version()[:3])}
    path = walk.folder / f"tour-{door}.json"
    path.write_text(json.dumps(record, ensure_ascii=False, indent=1), encoding="utf-8")
