"""Printed results that lie midway between two numbers of their figures, and go to the even one (GB/T 8170)."""

from __future__ import annotations

import re
from decimal import Decimal
from math import prod

from ..algebra.formula import Row, plain
from ..board.construction import Construction

_PRODUCT = r"(\d[\d.]*(?: × \d[\d.]*)*)"
_WORKED = re.compile(rf"= \(?{_PRODUCT}\)?(?:/\({_PRODUCT}\))? = (\d+(?:\.\d+)?)(?: \S+)?(?: [=≈] .*)?$")


def some_go_down(construction: Construction) -> bool:
    """Whether a reader who rounds what lies midway up would get another result of a line: 0.015 × 53.9 = 0.808."""
    lines = (line for step in construction.steps for line in step.formulas if isinstance(line, Row))
    return any(map(goes_down, map(plain, lines)))


def goes_down(line: str) -> bool:
    """The same of one line."""
    found = _WORKED.search(line)
    if found is None:
        return False
    over, under, shown = _product(found[1]), _product(found[2] or "1"), Decimal(found[3])
    half = Decimal(5).scaleb(int(shown.as_tuple().exponent) - 1)
    return over - shown * under == half * under


def _product(text: str) -> Decimal:
    return prod(map(Decimal, text.split(" × ")), start=Decimal(1))
