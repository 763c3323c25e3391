"""Printed results that lie midway between two numbers of their figures, and go to the even one (GB/T 8170)."""

from __future__ import annotations

import ast
import re
from decimal import Decimal
from fractions import Fraction
from itertools import pairwise

from ..algebra.formula import Row, plain
from ..board.construction import Construction

_NUMBERS = re.compile(r"[\d.+*/() -]+")  # what is left of the numbers of a line, if they are all
_SIGNS = str.maketrans({"×": "*", "−": "-"})
_SQUARE = re.compile(r"([\d.]+)\^2")
_RESULT = re.compile(r"(\d+(?:\.\d+)?)(?: \S+)?")


def some_go_down(construction: Construction) -> bool:
    """Whether a reader who rounds what lies midway up would get another result of a line: 0.015 × 53.9 = 0.808."""
    lines = (line for step in construction.steps for line in step.formulas if isinstance(line, Row))
    return any(map(goes_down, map(plain, lines)))


def goes_down(line: str) -> bool:
    """The same of one line."""
    parts = re.split(" [=≈] ", line)
    return any(_goes_down(*two) for two in pairwise(parts))


def _goes_down(numbers: str, result: str) -> bool:
    found, reckoned = _RESULT.fullmatch(result.lstrip("−")), _reckoned(numbers)
    if found is None or reckoned is None:
        return False
    shown = Decimal(found[1])
    half = Decimal(5).scaleb(int(shown.as_tuple().exponent) - 1)
    return abs(reckoned) - Fraction(shown) == Fraction(half)


def _reckoned(numbers: str) -> Fraction | None:
    """What a line's numbers come to, exactly; None of what has others than + − × / and squares."""
    text = _SQUARE.sub(r"(\1*\1)", numbers).translate(_SIGNS)
    if not _NUMBERS.fullmatch(text):
        return None
    try:
        return _worth(ast.parse(text.strip(), mode="eval").body, text.strip())
    except (SyntaxError, ZeroDivisionError):  # two numbers side by side are none
        return None


def _worth(node: ast.expr, text: str) -> Fraction:
    """Of a number, a sum, a product: its decimals are taken as they are written."""
    match node:
        case ast.Constant():
            return Fraction(ast.get_source_segment(text, node) or "0")
        case ast.UnaryOp(op=ast.USub(), operand=body):
            return -_worth(body, text)
        case ast.BinOp(left=left, op=op, right=right):
            one, other = _worth(left, text), _worth(right, text)
            match op:
                case ast.Add():
                    return one + other
                case ast.Sub():
                    return one - other
                case ast.Mult():
                    return one * other
                case ast.Div():
                    return one / other
    raise SyntaxError(text)
