# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all document objects share: properties, states, migrations, errors, being computed again."""

from __future__ import annotations

import traceback
from typing import Any, ClassVar, Dict, NamedTuple, Tuple, Type

import FreeCAD

from ..core.progress import Progress, silent
from ..errors import KernelError, ParameterError, TrabeculaError
from ..views import attach_view, in_words
from . import migrations
from .base import add_parameters
from .stateless import Stateless

# FreeCAD's attributes of properties (App::PropertyType)
READ_ONLY, HIDDEN, OUTPUT = 1, 4, 8
UP_TO_DATE = "up to date"
ERROR = "error: "
PASTED = "pasted: recompute the document"


class Property(NamedTuple):
    """A property that is no parameter: a link, a result."""

    type: str
    name: str
    group: str
    doc: str
    attributes: int = 0
    default: Any = None


def result(type_name: str, name: str, doc: str, hidden: bool = False) -> Property:
    """Return a read-only property for a result; changing it does not make its object due for a recompute."""
    return Property("App::Property" + type_name, name, "Results", doc, OUTPUT | READ_ONLY | (HIDDEN if hidden else 0))


class Feature(Stateless):
    """Base of the proxies.

    Subclasses name their parameter classes and properties, and fill in ``compute``. Nothing is kept in the proxy: data
    live in properties, so that files stay readable whatever becomes of the code.
    """

    #: Word by which the window and the tests know the object; a file format.
    Type: ClassVar[str] = ""
    #: Parameter classes kept as properties.
    PARAMETERS: ClassVar[Tuple[type, ...]] = ()
    #: Further properties.
    PROPERTIES: ClassVar[Tuple[Property, ...]] = ()
    #: ``MIGRATIONS[n](obj)`` brings an object of schema n to schema n + 1; see ``migrations``.
    MIGRATIONS: ClassVar[Dict[int, migrations.Step]] = {}

    def __init__(self, obj: Any) -> None:
        obj.Proxy = self
        self.add_properties(obj)
        obj.SchemaVersion = migrations.SCHEMA_VERSION

    def add_properties(self, obj: Any) -> None:
        """Add the properties that the object lacks."""
        common = (
            Property(
                "App::PropertyInteger", "SchemaVersion", "Base", "Version of the object", OUTPUT | READ_ONLY | HIDDEN
            ),
            result("String", "Status", "What the last recompute said"),
        )
        for one in common + self.PROPERTIES:
            if not hasattr(obj, one.name):
                obj.addProperty(one.type, one.name, one.group, one.doc, one.attributes)
                if one.default is not None:
                    setattr(obj, one.name, one.default)
            elif one.type.endswith("Constraint"):
                setattr(obj, one.name, (getattr(obj, one.name), *one.default[1:]))
        for cls in self.PARAMETERS:
            add_parameters(obj, cls)

    def execute(self, obj: Any) -> None:
        """Compute again. On an error the object keeps what it had, and ``Status`` and the report view say why."""
        status = f"{ERROR}the computation broke off; the report view says where"
        try:
            migrations.check_schema(obj)
            status = self.compute(obj) or UP_TO_DATE
        except TrabeculaError as error:
            status = f"{ERROR}{error}"
            FreeCAD.Console.PrintLog(traceback.format_exc())
            # the report view shows the sentence in the window's language, and not our way to it
            raise type(error)(in_words(str(error))).with_traceback(None) from None
        finally:
            obj.Status = status

    def prepare(self, obj: Any, progress: Progress = silent) -> None:
        """Compute what ``compute`` will find at hand, with progress; errors go to the caller."""

    def compute(self, obj: Any) -> str:
        """Compute and assign the results, last of all the shape; return the status, "" if there is nothing to say."""
        raise NotImplementedError

    def onDocumentRestored(self, obj: Any) -> None:
        """Bring an object of an older version up to date, one step at a time.

        One that was pasted is due for a recompute: where what it is linked to was not copied with it, FreeCAD links it
        to nothing, or to what has the same name in its new document. If all is as it was nothing is computed again.
        """
        touched = "Touched" in obj.State
        migrations.migrate(obj, self.MIGRATIONS)
        if obj.SchemaVersion <= migrations.SCHEMA_VERSION:
            self.add_properties(obj)
        if obj.Document.Importing:
            obj.Status = PASTED
        if not touched:
            obj.purgeTouched()  # limits were set again, nothing else
        attach_view(obj)

    def mustExecute(self, obj: Any) -> bool:
        """Return whether the object is due for a recompute though nothing touched it; FreeCAD asks often."""
        return getattr(obj, "Status", "") == PASTED


def show_in_place(obj: Any, name: str, value: Any) -> None:
    """Assign a shape or a mesh; whoever moved the object, with Draft or by hand, it stays where it stands."""
    place = obj.Placement
    setattr(obj, name, value)
    obj.Placement = place


def is_a(obj: Any, *types: Type[Feature]) -> bool:
    """Return whether a document object is one of ours, of the given classes if any are given."""
    return isinstance(getattr(obj, "Proxy", None), types or Feature)


def update(obj: Any, progress: Progress = silent) -> None:
    """Bring a document object up to date, also one that waits to be told.

    Parameters
    ----------
    obj : document object
        One of ours or any other.
    progress : callable

    Raises
    ------
    TrabeculaError
        What its recompute would put into the report view.

    Examples
    --------
    >>> from freecad_trabecula import make
    >>> sites = make.make_prism_sites(make.make_box(FreeCAD.newDocument()))
    >>> sites.SitesX = 3
    >>> make.update(sites)
    >>> sites.Count
    182
    """
    if not hasattr(obj, "touch"):
        raise ParameterError(f"an object of a document is needed, got {obj!r:.60}")
    if is_a(obj):
        obj.Proxy.prepare(obj, progress)
    obj.touch()
    obj.Document.recompute([obj])
    if not obj.isValid():
        status = getattr(obj, "Status", "") or "the kernel refused it"
        raise KernelError(f"{obj.Label} could not be computed: {status.replace(ERROR, '', 1)}")
