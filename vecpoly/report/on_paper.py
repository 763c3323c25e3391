"""How long what a step lays off is on paper: l_AB/μ_l = 30.0 mm."""

from __future__ import annotations

import re

from ..algebra.rounding import in_tenths
from ..errors import VecpolyError
from ..solution import Solution
from ..units.reading import Dim, read

_LAID = re.compile(r"\$((?:[^$]* = )?)(\d?)([lr]_\{?\w+\}?|H|e)/μ_l\$(?! =)")


def on_paper(text: str, solution: Solution) -> str:
    """The step with the lengths (mm) of what is given, at the scale of the diagram."""
    scale = next((one.scale.value for one in solution.construction.figures if one.scale.symbol == "μ_l"), 0.0)
    given = {_bare(one.symbol): one for one in solution.problem.given.data if one.symbol}

    def told(found: re.Match[str]) -> str:
        datum = given.get(_bare(found[3]))
        size = 0.0 if datum is None else datum.si or _metres(datum.text)
        return f"{found[0]} = {in_tenths(int(found[2] or 1) * size / scale)} mm" if size > 0.0 else found[0]

    return _LAID.sub(told, text) if scale else text


def _metres(text: str) -> float:
    """Of what is given as it was written; nothing of what is not known."""
    try:
        return read(text, Dim.LENGTH).si
    except VecpolyError:
        return 0.0


def _bare(symbol: str) -> str:
    return symbol.replace("{", "").replace("}", "")
