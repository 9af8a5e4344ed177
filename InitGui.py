# SPDX-License-Identifier: LGPL-2.1-or-later
# FreeCAD executes this file when its window starts. Keep it tiny: its names are not visible inside the methods below,
# so that each imports what it needs, and nothing is loaded before the workbench is chosen.

import FreeCADGui

from freecad_trabecula import views


def _attach_view(obj):
    from freecad_trabecula.gui import view_providers

    view_providers.attach(obj)


def _in_words(text):
    from freecad_trabecula.gui import language

    return language.in_words(text)


# Objects made without a window get their view provider when they are opened in one.
views.attach_views_with(_attach_view)
views.say_with(_in_words)


class TrabeculaWorkbench(FreeCADGui.Workbench):
    MenuText = "Trabecula"
    ToolTip = "Irregular networks of rods, their channels and printable bone scaffolds in any solid"

    def __init__(self):
        import os

        import freecad_trabecula

        root = os.path.dirname(os.path.dirname(freecad_trabecula.__file__))
        self.__class__.Icon = os.path.join(root, "resources", "icons", "trabecula.svg")

    def Initialize(self):
        from freecad_trabecula.gui import commands

        commands.register(self)

    def Activated(self):
        from freecad_trabecula.gui import guide_dock

        guide_dock.welcome()

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(TrabeculaWorkbench())
