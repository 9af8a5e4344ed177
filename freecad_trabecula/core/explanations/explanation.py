# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is known of a number that is shown: how it is worked out, where that stands, which other route there is."""

from __future__ import annotations

from types import MappingProxyType
from typing import Any, List, Mapping, NamedTuple, Sequence, Tuple

from ..language import Words

#: A second route that there is not.
NONE = "none"


class Explanation(NamedTuple):
    """One kind of number.

    Attributes
    ----------
    key : str
        By which panels, pages and reports name it: ``design.porosity``.
    name, symbol, unit : str
        Symbol and unit may be empty.
    formula : str
        How it is worked out, in text.
    source : str
        Equation, table or section of the thesis, DOI, or ``own definition``.
    second : str
        The independent route to the same number; ``none`` where there is none.
    tolerance : str
        How far both may be apart.
    check : str
        How the names of the checks begin that hold both values (``core.bodies.Check``).
    beside : str
        Key of the number that is the second route, where that is shown too.
    """

    key: str
    name: str
    symbol: str
    unit: str
    formula: str
    source: str
    second: str = NONE
    tolerance: str = ""
    check: str = ""
    beside: str = ""

    def rows(self, found: Sequence[str] = (), words: Words = str) -> List[Tuple[str, str]]:
        """Return what a reader is told, as pairs of a word and a text.

        Parameters
        ----------
        found : sequence of str
            Values by both routes and their difference, where they are at hand.
        words : callable
            Puts texts and numbers into the reader's language; the words of the pairs stay as they are.
        """
        tail = f", {words(self.unit)}" if self.unit else ""
        head = f"{words(self.name)}{f' ({self.symbol})' if self.symbol else ''}{tail}"
        second = "; ".join(words(one) for one in (self.second, self.tolerance) if one)
        rows = [("number", head), ("formula", words(self.formula)), ("source", words(self.source))]
        return [*rows, ("second route", second), *(("both routes", words(one)) for one in found)]


def routes_found(
    explanation: Explanation,
    checks: Sequence[Mapping[str, Any]] = (),
    values: Mapping[str, float] = MappingProxyType({}),
) -> List[str]:
    """Return the values by both routes and their differences, a sentence each.

    Parameters
    ----------
    explanation : Explanation
    checks : sequence of mappings
        With ``name``, ``value``, ``second``, ``difference``, ``tolerance``, as reports hold them.
    values : mapping of key to number
        Numbers that are shown beside.

    Examples
    --------
    >>> one = Explanation("a", "volume", "", "mm3", "", "", check="volume along")
    >>> checks = [{"name": "volume along x", "value": 2.0, "second": 2.1, "difference": 0.05, "tolerance": 0.1}]
    >>> routes_found(one, checks)
    ['volume along x: 2 against 2.1, 0.05 apart (at most 0.1)']
    """
    found = [
        f"{row['name']}: {row['value']:.9g} against {row['second']:.9g}, {row['difference']:.2g} apart "
        f"(at most {row['tolerance']:.2g})"
        for row in checks
        if explanation.check and row["name"].startswith(explanation.check)
    ]
    own, other = values.get(explanation.key), values.get(explanation.beside)
    if own is not None and other is not None:
        apart = f"{abs(own - other) / abs(other):.2g} of it apart" if other else f"{abs(own - other):.2g} apart"
        found.append(f"{own:.6g} against {other:.6g}, {apart}")
    return found
