# SPDX-License-Identifier: LGPL-2.1-or-later
"""Installs manifold3d, which mesh Booleans need, by pip into FreeCAD's own folder of additional packages."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path
from typing import Any, List

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ..errors import DependencyError
from .qt import Buttons

translate = FreeCAD.Qt.translate
PACKAGE = "manifold3d"


def package_folder() -> str:
    """Return FreeCAD's folder of additional packages: one per Python version since FreeCAD 0.21."""
    version = tuple(int(part) for part in FreeCAD.Version()[:2])
    folder = Path(FreeCAD.getUserAppDataDir()) / "AdditionalPythonPackages"
    if version >= (0, 21):
        folder = folder / f"py{sys.version_info.major}{sys.version_info.minor}"
    return str(folder)


def python_program() -> str:
    """Return the Python that belongs to this FreeCAD; ``sys.executable`` may be FreeCAD itself.

    Raises
    ------
    DependencyError
        If none of the same version is found.
    """
    name = f"python{sys.version_info.major}.{sys.version_info.minor}"
    folders = [Path(sys.exec_prefix) / "bin", Path(sys.exec_prefix), Path(FreeCAD.getHomePath()) / "bin"]
    for folder in folders:
        for candidate in (name, "python3", "python", "python.exe"):
            if (folder / candidate).is_file():
                return str(folder / candidate)
    found = shutil.which(name)
    if found:
        return found
    raise DependencyError(f"a Python {name[6:]} with pip must be there to install {PACKAGE}, and none was found")


def install_words(folder: str) -> List[str]:
    """Return the command that installs the package into a folder."""
    return [python_program(), "-m", "pip", "install", "--upgrade", "--no-deps", "--target", folder, PACKAGE]


def offer_installation(sentence: str) -> None:
    """Show what is missing, with a button that installs it."""
    InstallDialog(FreeCADGui.getMainWindow(), sentence).show()


class InstallDialog(QtGui.QDialog):
    """Says what is missing; installs it in a process of its own; shows what pip says."""

    def __init__(self, parent: Any, sentence: str) -> None:
        super().__init__(parent)
        self.setWindowTitle(translate("Trabecula", "A package is missing"))
        self.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self.label = QtGui.QLabel(sentence)
        self.label.setWordWrap(True)
        self.output = QtGui.QPlainTextEdit()
        self.output.setReadOnly(True)
        self.output.hide()
        self.buttons = Buttons(Buttons.Close)
        self.install_button = self.buttons.addButton(
            translate("Trabecula", "Install {}").format(PACKAGE), Buttons.ActionRole
        )
        self.install_button.clicked.connect(lambda *_: self.install())
        self.buttons.rejected.connect(self.close)
        self.process = QtCore.QProcess(self)
        self.process.setProcessChannelMode(QtCore.QProcess.MergedChannels)
        self.process.readyReadStandardOutput.connect(self._read)
        self.process.finished.connect(self._finished)
        column = QtGui.QVBoxLayout(self)
        for widget in (self.label, self.output, self.buttons):
            column.addWidget(widget)
        self.resize(460, 160)

    def install(self) -> None:
        """Start pip."""
        self.output.show()
        self.resize(560, 320)
        folder = package_folder()
        try:
            words = install_words(folder)
        except DependencyError as error:
            self.output.appendPlainText(str(error))
            return
        os.makedirs(folder, exist_ok=True)
        self.install_button.setEnabled(False)
        self.output.appendPlainText(" ".join(words))
        self.process.start(words[0], words[1:])

    def _read(self) -> None:
        self.output.appendPlainText(bytes(self.process.readAllStandardOutput()).decode("utf-8", "replace").rstrip())

    def _finished(self, code: int, *_: Any) -> None:
        self.install_button.setEnabled(True)
        if code == 0:
            folder = package_folder()
            if folder not in sys.path:
                sys.path.append(folder)
            self.label.setText(translate("Trabecula", "{} is installed.").format(PACKAGE))
        else:
            self.label.setText(translate("Trabecula", "pip could not install {}; it says why below.").format(PACKAGE))
