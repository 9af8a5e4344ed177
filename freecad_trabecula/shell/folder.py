# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder of results: filled aside and replaced file by file at the end; a run that fails leaves it as it was."""

from __future__ import annotations

import json
import os
import shutil
from pathlib import Path
from types import TracebackType
from typing import IO, List, Optional, Type

from ..errors import ExportError, ParameterError

_LOCK = ".lock"
_REPORT = "report.json"  # every command writes one, with its kind; that of a design has none


class ResultFolder:
    """A folder that receives its files all together.

    Entering makes a hidden folder beside it (inside it, where the folder is the top of another disk); ``path`` gives
    the places there; ``keep`` moves the files over; leaving removes it. What a killed run left is removed by the next.

    Parameters
    ----------
    path : str
        Made when it is missing.

    Examples
    --------
    >>> import tempfile
    >>> target = Path(tempfile.mkdtemp()) / "result"
    >>> with ResultFolder(str(target)) as folder:
    ...     _ = folder.path("a.txt").write_text("a")
    ...     folder.keep("a.txt")
    >>> sorted(p.name for p in target.iterdir())
    ['a.txt']
    """

    def __init__(self, path: str) -> None:
        self.target = Path(os.path.realpath(path))
        try:
            self.aside = self._place()
        except OSError as error:  # a name that is too long
            raise self._refusal(error) from error
        self._made: List[Path] = []
        self._lock: Optional[IO[str]] = None

    def _place(self) -> Path:
        target, parent = self.target, self.target.parent
        name = f".{target.name}.trabecula"
        if target.is_dir() and (os.stat(target).st_dev != os.stat(parent).st_dev or not os.access(parent, os.W_OK)):
            return target / name  # files can be moved, not copied, within one disk only
        return parent / name

    def __enter__(self) -> ResultFolder:
        try:
            if self.target.exists() and not self.target.is_dir():
                raise NotADirectoryError(0, "it is a file")
            self._make(self.aside.parent)
            if self.aside.exists():
                self._remove_abandoned()
            if self.target.is_dir() and not os.access(self.target, os.W_OK | os.X_OK):
                raise PermissionError(0, "permission denied")
            self.aside.mkdir()
            self._lock = _locked(self.aside / _LOCK)
        except OSError as error:
            self._leave()
            raise self._refusal(error) from error
        return self

    def _refusal(self, error: OSError) -> ParameterError:
        return ParameterError(f"the folder {self.target} cannot be written: {error.strerror or error}")

    def _make(self, folder: Path) -> None:
        missing = [p for p in (folder, *folder.parents) if not p.exists()]
        for one in reversed(missing):
            one.mkdir()
            self._made.append(one)

    def _remove_abandoned(self) -> None:
        lock = _locked(self.aside / _LOCK)
        if lock is None:
            raise ParameterError(f"another run is writing into the folder {self.target}")
        lock.close()
        shutil.rmtree(self.aside)

    def path(self, name: str) -> Path:
        """Return where the file ``name`` is to be written."""
        return self.aside / name

    def keep(self, *names: str) -> None:
        """Move the files to their places, in this order.

        Raises
        ------
        ExportError
            If one cannot be moved.
        """
        try:
            for name in names:
                self._make((self.target / name).parent)
                os.replace(self.aside / name, self.target / name)
            self._made.clear()
        except OSError as error:
            raise ExportError(f"{self.target} could not be written: {error.strerror or error}") from error

    def __exit__(
        self, kind: Optional[Type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType]
    ) -> None:
        self._leave()

    def _leave(self) -> None:
        if self._lock is not None:
            self._lock.close()
            self._lock = None
            shutil.rmtree(self.aside, ignore_errors=True)
        for folder in reversed(self._made):
            try:
                folder.rmdir()
            except OSError:  # something else was put there
                break


def require_own_folder(path: str, kind: str = "") -> None:
    """Make sure that a folder holds no report of another kind, which would be overwritten.

    Parameters
    ----------
    path : str
    kind : str
        That of the report which is to be written; of a design it is empty.

    Raises
    ------
    ParameterError
        If it does.
    """
    try:
        record = json.loads((Path(path) / _REPORT).read_text(encoding="utf-8"))
    except (OSError, ValueError):  # there is none, or it is nobody's
        return
    if isinstance(record, dict) and record.get("kind", "") != kind:
        raise ParameterError(
            f"the folder of a {kind or 'design'} must not be that of something else: {path} holds the {_REPORT} of "
            f"a {record.get('kind') or 'design'}"
        )


def _locked(path: Path) -> Optional[IO[str]]:
    """Return the file, open and locked as long as this process lives, or None if another process holds it."""
    file = open(path, "w", encoding="ascii")  # noqa: SIM115  it stays open
    try:
        import fcntl
    except ImportError:  # Windows, where an open file cannot be removed: that holds other runs off
        return file
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        file.close()
        return None
    return file
