"""Chapter 4, the mathematical model: the formulas of each group, numbered, with the dimensions that stand in them."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees
from typing import Any

from ...quantity import number
from ...words import Lang
from .model.equations import GroupModel, Part
from .model.expr import Const
from .numbering import Press
from .study import Study


def chapter(study: Study, press: Press) -> dict[str, Any]:
    """The groups in order, each with its opening, its stages, its constants and its singular positions."""
    press.chapter = "4"
    return {"groups": [_group(group, press) for group in study.model.groups]}


def _group(group: GroupModel, press: Press) -> dict[str, Any]:
    stages = [{"title": stage.title.of(press.lang), "parts": [_part(part, press) for part in stage.parts]} for stage in group.stages]
    return {
        "title": group.title.of(press.lang), "opening": group.opening.of(press.lang), "stages": stages,
        "constants": ("，" if press.lang == "zh" else ", ").join(_constants(group, press.lang)),
        "singular": group.singular.of(press.lang) if group.singular else "",
    }


def _part(part: Part, press: Press) -> dict[str, Any]:
    formulas = [{"ref": press.objects.add("f", equation.node), "number": f"({press.number('equation')})"} for equation in part.equations]
    return {"said": part.said.of(press.lang), "formulas": formulas}


def _constants(group: GroupModel, lang: Lang) -> Iterator[str]:
    """$l_BC$ = 350 mm, $β_BF$ = 51.50°; M is told where it is chosen."""
    for constant in group.constants:
        if constant.unit == "m":
            yield f"${constant.symbol}$ = {number(1e3 * constant.size, 6)} mm"
        elif constant.unit == "rad" and constant.symbol != "π":
            yield f"${constant.symbol}$ = {_degrees(constant)}"


def _degrees(constant: Const) -> str:
    return f"{degrees(constant.size):.4f}".rstrip("0").rstrip(".").replace("-", "−") + "°"
