# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a parameter varies over a design: constant, at random, or by a law of place (thesis 2.4.8 and chapter 9)."""

from __future__ import annotations

import ast
import math
from dataclasses import dataclass
from statistics import NormalDist
from typing import Any, Callable, Dict, Mapping, Tuple

import numpy as np

from ..errors import ParameterError
from .streams import Stream

KINDS = ("constant", "uniform", "normal", "linear", "radial", "expression")

_FUNCTIONS = {
    name: getattr(np, name)
    for name in ("sin", "cos", "tan", "exp", "sqrt", "floor", "ceil", "hypot", "minimum", "maximum", "sign")
}
_FUNCTIONS.update(abs=np.abs, log=np.log, min=np.minimum, max=np.maximum)
_CONSTANTS = {"pi": math.pi, "e": math.e}
_VARIABLES = ("x", "y", "z", "u")
_OPERATORS: Dict[type, Callable[..., Any]] = {
    ast.Add: np.add,
    ast.Sub: np.subtract,
    ast.Mult: np.multiply,
    ast.Div: np.divide,
    ast.Pow: np.power,
    ast.Mod: np.mod,
    ast.USub: np.negative,
    ast.UAdd: np.positive,
}
_LONGEST_EXPRESSION = 500  # characters; longer ones are mistakes, and deep nesting would exhaust the parser


@dataclass(frozen=True)
class Region:
    """The box around the envelope and its centre: what the laws of place refer to.

    Attributes
    ----------
    low, high, centre : tuple of 3 floats, mm
        Corners of the axis-aligned box and the geometrical centre of the volume.
    """

    low: Tuple[float, float, float]
    high: Tuple[float, float, float]
    centre: Tuple[float, float, float]


@dataclass(frozen=True)
class Law:
    """Variation of one number over the design.

    Attributes
    ----------
    kind : str
        ``constant`` (low), ``uniform`` (Eq. 2.4 between low and high), ``normal`` (mean half-way, sd a sixth of the
        range, values outside it are drawn again as in thesis 3.2.1), ``linear`` (low to high along ``direction`` over
        the envelope's box), ``radial`` (low at the centre, high at the farthest corner of the box), ``expression``
        (of x, y, z in mm and a random u in [0, 1), clipped to low..high).
    low, high : float
        Bounds, in the parameter's own unit; low <= high but for ``linear`` and ``radial``, which may also fall.
    direction : tuple of 3 floats
        Direction of ``linear``; need not be a unit vector.
    expression : str
        Formula for ``expression``: + - * / % ** ( ), x, y, z, u, pi, e and the usual functions; read by a parser,
        never evaluated.

    Raises
    ------
    ParameterError
        If a rule above is broken.
    """

    kind: str = "uniform"
    low: float = 0.0
    high: float = 1.0
    direction: Tuple[float, float, float] = (0.0, 0.0, 1.0)
    expression: str = ""

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise ParameterError(f"a law must be one of {', '.join(KINDS)}, got {self.kind!r}")
        if not (math.isfinite(self.low) and math.isfinite(self.high)):
            raise ParameterError(f"a law's bounds must be finite numbers, got {self.low} and {self.high}")
        if not all(math.isfinite(c) for c in self.direction):
            raise ParameterError(f"the direction of a law must be three finite numbers, got {self.direction}")
        if self.kind in ("uniform", "normal", "expression") and self.low > self.high:
            raise ParameterError(f"a law's bounds must satisfy low <= high, got {self.low:g} and {self.high:g}")
        if self.kind == "linear" and not math.hypot(*self.direction) > 0:
            raise ParameterError(f"the direction of a linear law must not be zero, got {self.direction}")
        if self.kind == "expression":
            parse_expression(self.expression)

    @property
    def range(self) -> Tuple[float, float]:
        """Least and greatest value that the law can give."""
        if self.kind == "constant":
            return self.low, self.low
        return min(self.low, self.high), max(self.low, self.high)

    def draw(self, stream: Stream, count: int, point: np.ndarray, region: Region) -> np.ndarray:
        """Return ``count`` values (count,) for a thing at ``point`` (3,) mm, with random numbers from ``stream``.

        One random number is taken per value whatever the kind (``normal`` included), so that changing the law
        of one parameter leaves the draws of the others alone.
        """
        random = stream.uniform(count)
        if self.kind == "uniform":
            return self.low + (self.high - self.low) * random
        if self.kind == "normal":
            return self._normal(random)
        if self.kind == "expression":
            values = evaluate_expression(self.expression, point, random)
            return np.clip(values, self.low, self.high)
        share = {"constant": 0.0}.get(self.kind)
        if share is None:
            share = self._linear_share(point, region) if self.kind == "linear" else _radial_share(point, region)
        return np.full(count, self.low + (self.high - self.low) * share)

    def _normal(self, random: np.ndarray) -> np.ndarray:
        """Normal law truncated to low..high (3 sd either side), by its inverse: no number is ever thrown away."""
        if self.low == self.high:
            return np.full(len(random), self.low)
        law = NormalDist()
        tail = law.cdf(-3.0)
        mean, sd = (self.low + self.high) / 2, (self.high - self.low) / 6
        return np.array([mean + sd * law.inv_cdf(tail + (1 - 2 * tail) * r) for r in random.tolist()])

    def _linear_share(self, point: np.ndarray, region: Region) -> float:
        direction = np.asarray(self.direction, float)
        corners = np.array(np.meshgrid(*zip(region.low, region.high))).reshape(3, -1).T @ direction
        return float(np.clip((point @ direction - corners.min()) / max(np.ptp(corners), 1e-12), 0, 1))


def _radial_share(point: np.ndarray, region: Region) -> float:
    centre = np.asarray(region.centre)
    farthest = np.maximum(np.abs(np.asarray(region.low) - centre), np.abs(np.asarray(region.high) - centre))
    return float(np.clip(np.linalg.norm(point - centre) / max(float(np.linalg.norm(farthest)), 1e-12), 0, 1))


def constant(value: float) -> Law:
    """Return the law that always gives ``value``."""
    return Law("constant", value, value)


def uniform(low: float, high: float) -> Law:
    """Return the uniform law between ``low`` and ``high`` (Eq. 2.4)."""
    return Law("uniform", low, high)


def parse_expression(text: str) -> ast.expr:
    """Return the syntax tree of a formula, checked node by node.

    Raises
    ------
    ParameterError
        If the text is no formula or holds anything but numbers, x, y, z, u, pi, e, + - * / % ** and the allowed
        functions.
    """
    if not text.strip() or len(text) > _LONGEST_EXPRESSION:
        raise ParameterError(f"an expression must have 1 to {_LONGEST_EXPRESSION} characters, got {len(text)}")
    try:
        tree = ast.parse(text.strip(), mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        raise ParameterError(f"the expression {text!r} cannot be read: {error}") from error
    for node in ast.walk(tree):
        _check_node(node, text)
    return tree


def _check_node(node: ast.AST, text: str) -> None:
    allowed = (ast.BinOp, ast.UnaryOp, ast.Load, ast.operator, ast.unaryop)
    if isinstance(node, ast.Constant):
        if isinstance(node.value, bool) or not isinstance(node.value, (int, float)):
            raise ParameterError(f"an expression holds numbers only, got {node.value!r} in {text!r}")
    elif isinstance(node, ast.Name):
        if node.id not in _VARIABLES and node.id not in _CONSTANTS and node.id not in _FUNCTIONS:
            names = ", ".join(list(_VARIABLES) + sorted(_CONSTANTS) + sorted(_FUNCTIONS))
            raise ParameterError(f"unknown name {node.id!r} in {text!r}; known are {names}")
    elif isinstance(node, ast.Call):
        if not isinstance(node.func, ast.Name) or node.func.id not in _FUNCTIONS or node.keywords:
            raise ParameterError(f"only {', '.join(sorted(_FUNCTIONS))} can be called in {text!r}")
    elif isinstance(node, (ast.operator, ast.unaryop)):
        if type(node) not in _OPERATORS:
            raise ParameterError(f"operator {type(node).__name__} is not allowed in {text!r}")
    elif not isinstance(node, allowed):
        raise ParameterError(f"{type(node).__name__} is not allowed in {text!r}")


def evaluate_expression(text: str, point: np.ndarray, random: np.ndarray) -> np.ndarray:
    """Return the formula's values (N,) at ``point`` (3,) mm for random numbers ``random`` (N,).

    Raises
    ------
    ParameterError
        If the formula cannot be read, or gives no finite number there.
    """
    names = {"x": float(point[0]), "y": float(point[1]), "z": float(point[2]), "u": random, **_CONSTANTS}
    try:
        with np.errstate(all="ignore"):
            values = np.broadcast_to(np.asarray(_value(parse_expression(text), names), float), random.shape)
    except (TypeError, ValueError, OverflowError, ZeroDivisionError) as error:
        raise ParameterError(f"the expression {text!r} cannot be computed: {error}") from error
    if not np.isfinite(values).all():
        where = ", ".join(f"{c:.4g}" for c in point)
        raise ParameterError(f"the expression {text!r} must give finite numbers, got {values} at ({where}) mm")
    return values.copy()


def _value(node: ast.AST, names: Mapping[str, Any]) -> Any:
    if isinstance(node, ast.Constant):
        assert isinstance(node.value, (int, float))  # parse_expression lets no other pass
        return float(node.value)
    if isinstance(node, ast.Name):
        if node.id not in names:
            raise ValueError(f"{node.id} needs brackets")
        return names[node.id]
    if isinstance(node, ast.BinOp):
        return _OPERATORS[type(node.op)](_value(node.left, names), _value(node.right, names))
    if isinstance(node, ast.UnaryOp):
        return _OPERATORS[type(node.op)](_value(node.operand, names))
    assert isinstance(node, ast.Call) and isinstance(node.func, ast.Name)  # parse_expression lets nothing else pass
    return _FUNCTIONS[node.func.id](*[_value(a, names) for a in node.args])
