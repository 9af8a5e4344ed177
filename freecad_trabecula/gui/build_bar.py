# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is to be built, the button that builds it, and the progress of the work."""

from __future__ import annotations

from typing import Any, Callable, Optional, Sequence, Tuple

import FreeCAD
from PySide import QtGui

from ..core.engines import Estimate
from ..core.estimates import scaffold_work
from .child_work import Progress, progress_text, time_text
from .fields import row_widget
from .language import choice, in_words, local_number
from .qt import icon

translate = FreeCAD.Qt.translate


class BuildBar(QtGui.QWidget):
    """Switches for the bodies, a button; while work goes on a bar and another button in their place.

    Parameters
    ----------
    kinds : sequence of (kind, text, chosen)
        Bodies that can be built, kinds as ``features.results`` has them.
    build, cancel : callable
        Called by the two buttons.
    text, picture : str
        Of the first button.
    leave : callable, optional
        Called by a third button, while work goes on.
    """

    def __init__(
        self,
        kinds: Sequence[Tuple[str, str, bool]],
        build: Callable[[], None],
        cancel: Callable[[], None],
        text: str = translate("Trabecula", "Build"),
        picture: str = "Trabecula_scaffold",
        leave: Optional[Callable[[], Any]] = None,
    ) -> None:
        super().__init__()
        self.boxes = {}
        self._estimate = ""
        self._choice, self._work = row_widget(), row_widget()
        for kind, words, chosen in kinds:
            box = QtGui.QCheckBox(words)
            box.setChecked(chosen)
            self.boxes[kind] = box
            self._choice.layout().addWidget(box)
        self.build_button = self._button(text, picture, build)
        self._choice.layout().addWidget(self.build_button, 1)
        self.bar = QtGui.QProgressBar()
        self.bar.setRange(0, 1000)
        self.bar.setTextVisible(False)
        self.cancel_button = self._button(translate("Trabecula", "Cancel"), "", cancel)
        self._work.layout().addWidget(self.bar, 1)
        self._work.layout().addWidget(self.cancel_button)
        if leave is not None:
            self.leave_button = self._button(translate("Trabecula", "In the background"), "", leave)
            tip = translate("Trabecula", "Close the panel; the status bar shows how far it is and can end it")
            self.leave_button.setToolTip(tip)
            self._work.layout().addWidget(self.leave_button)
        self.what = QtGui.QLabel()
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(3)
        for widget in (self._choice, self._work, self.what):
            column.addWidget(widget)
        self.show_idle()

    @staticmethod
    def _button(text: str, picture: str, pressed: Callable[[], None]) -> Any:
        button = QtGui.QPushButton(text)
        if picture:
            button.setIcon(icon(picture))
        button.clicked.connect(lambda *_: pressed())
        return button

    def show_estimate(self, work: Optional[Estimate]) -> None:
        """Show what the scaffold will take before it is built, at least where that is not little."""
        self._estimate = ""
        if work is not None:
            whole = scaffold_work(work)
            size = (
                f"{local_number(whole.memory / 1e9, '.2f')} GB"
                if whole.memory > 1e8
                else f"{whole.memory / 1e6:.0f} MB"
            )
            text = translate("Trabecula", "Scaffold: {} engine, about {}, {}")
            self._estimate = text.format(choice(work.engine), time_text(whole.seconds), size)
            self.what.setToolTip(in_words(work.reason))
        if self._work.isHidden():
            self.show_idle()

    def chosen(self) -> Tuple[str, ...]:
        """Return the kinds that are to be built."""
        return tuple(kind for kind, box in self.boxes.items() if box.isChecked())

    def show_idle(self) -> None:
        """Show the switches and the button."""
        self._choice.show()
        self._work.hide()
        self.what.setText(self._estimate)
        self.what.setVisible(bool(self._estimate))

    def show_working(self) -> None:
        """Show the bar, empty, in their place."""
        self._choice.hide()
        self._work.show()
        self.what.show()
        self.show_progress(Progress(0.0, translate("Trabecula", "starting"), None))

    def show_progress(self, progress: Progress) -> None:
        """Show how far the work is, what is being done, and how long is left."""
        self.bar.setValue(int(1000 * progress.share))
        self.what.setText(progress_text(progress))
