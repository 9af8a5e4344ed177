# SPDX-License-Identifier: LGPL-2.1-or-later
"""The keys of our commands: none is the beginning of another's, ours or FreeCAD's, on any of its workbenches."""

import FreeCADGui
from window import WindowTest

from freecad_trabecula.gui import commands

#: Workbenches of FreeCAD with keys of their own; not Draft and BIM, whose start reports errors without a view.
OTHERS = ("Part", "PartDesign", "Sketcher", "Mesh", "Points", "Surface", "Spreadsheet", "Assembly")


class KeysTest(WindowTest):
    def test_no_keys_of_ours_begin_or_are_begun_by_those_of_another_command(self):
        there = FreeCADGui.listWorkbenches()
        for name in OTHERS:
            if name + "Workbench" in there:
                FreeCADGui.activateWorkbench(name + "Workbench")
        FreeCADGui.activateWorkbench("TrabeculaWorkbench")
        keys = {}
        for name in FreeCADGui.listCommands():
            words = FreeCADGui.Command.get(name).getShortcut().upper().replace(" ", "").split(",")
            if words != [""]:
                keys[name] = words
        self.assertGreater(len(keys), 60)
        ours = {name for name in keys if name in commands.COMMANDS}
        self.assertGreater(len(ours), 20)
        for name in ours:
            for other, words in keys.items():
                shared = min(len(words), len(keys[name]))
                if other != name and words[:shared] == keys[name][:shared]:
                    self.fail(f"{name} {keys[name]} and {other} {words}")

    def test_every_key_that_a_command_names_is_the_one_that_freecad_has(self):
        for name, one in commands.COMMANDS.items():
            if one.KEYS:
                self.assertEqual(FreeCADGui.Command.get(name).getShortcut().replace(" ", ""), one.KEYS.replace(" ", ""))
