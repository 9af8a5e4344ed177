# SPDX-License-Identifier: LGPL-2.1-or-later
# FreeCAD executes this file at every start, with or without a window. Keep it tiny: its names are not visible inside
# functions.

import FreeCAD

# FreeCAD 1.1.1 and later restore an object's proxy from a file only if its top package is loaded already.
import freecad_trabecula  # noqa: F401

# The tests that need a document: freecadcmd -t TestTrabecula, or the Test workbench.
FreeCAD.__unit_test__ += ["TestTrabecula"]

# Files that FreeCAD opens and writes through us; the module is loaded when one is.
FreeCAD.addImportType("Trabecula job (*.json)", "freecad_trabecula.document_files")
for kind in ("job (*.json)", "voxels (*.npy)", "voxels (*.nrrd)", "voxels (*.vti)"):
    FreeCAD.addExportType("Trabecula " + kind, "freecad_trabecula.document_files")
