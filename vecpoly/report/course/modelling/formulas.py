"""Chapter 4, the mathematical model: the formulas of each group, numbered, with the dimensions that stand in them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import groupby
from math import degrees
from typing import Any

from ....algebra.formula import Node, Power, Row, Sym, Txt, plain
from ....algebra.quantity import number
from ....analytic.equations import GroupModel, Part
from ....analytic.expr import Const
from ....findings.side_changes import side_changes
from ....findings.study.study import Study
from ....words import Lang, Words
from ..numbering import Press
from .forces import forces_group
from .order import order

_AUXILIARY = ("A_0", "B_0", "C_0", "G_1", "G_2", "G_3")  # of which each group has its own
_TRIVIAL = re.compile(r"\S+ = −?\w+")
_ANGLE = 2  # decimals of a constant angle in degrees


def chapter(study: Study, press: Press) -> dict[str, Any]:
    """The groups in order, each with its opening, its stages, its constants and its singular positions."""
    press.chapter = "4"
    forces = forces_group(study)
    return {
        "order": order(study, press),
        "auxiliary": ("、" if press.lang == "zh" else ", ").join(f"${one}$" for one in _AUXILIARY if one in study.env),
        "arctangents": any("arctan" in plain(e.node) for group in study.model.groups for e in group.equations),
        "groups": [
            *(
                _group(group, press, arcs=True) | {"sides": _sides(study, group).of(press.lang)}
                for group in study.model.groups
            ),
            *([_group(forces, press, arcs=False)] if forces else []),
        ],
    }


def _group(group: GroupModel, press: Press, *, arcs: bool) -> dict[str, Any]:
    stages = [
        {"title": stage.title.of(press.lang), "parts": [_part(part, press) for part in stage.parts]}
        for stage in group.stages
    ]
    return {
        "jacobian": _jacobian(group, press),
        "title": group.title.of(press.lang),
        "opening": group.opening.of(press.lang),
        "stages": stages,
        "sides": "",
        "constants": ("，" if press.lang == "zh" else ", ").join(_constants(group, arcs=arcs)),
        "singular": group.singular.of(press.lang) if group.singular else "",
    }


def _sides(study: Study, group: GroupModel) -> Words:
    """That σ is turned at change points, where a cycle goes through them; nothing where one σ holds throughout."""
    places = [study.where(place) for place in side_changes(study, group)]
    if not places:
        return Words("", "")
    told = [places[0], *(place.split(" = ")[1] for place in places[1:])]
    return Words(
        f"以上 $σ$ 值用于题设位置；机构按题设的装配形式连续通过变点，$σ$ 在变点 {'、'.join(told)} 处变号。",
        "This $σ$ is that of the given position; as the mechanism goes on in the given assembly, $σ$ changes its sign "
        f"at the change points {' and '.join(told)}.",
    )


def _jacobian(group: GroupModel, press: Press) -> str:
    """∂f_i/∂q_j as a table; nothing for a group with a closed form."""
    if group.loops is None:
        return ""
    header = ["$J$", *(f"$∂/∂{q}$" for q in group.loops.unknowns)]
    rows = [
        (f"$f_{i}$", *(f"${written(entry.node)}$" for entry in row)) for i, row in enumerate(group.loops.jacobian, 1)
    ]
    return press.table(Words("雅可比矩阵 $J$ = $∂f/∂q$", "The Jacobian $J$ = $∂f/∂q$"), header, rows, "c" * len(header))


def _part(part: Part, press: Press) -> dict[str, Any]:
    formulas = [
        {"ref": press.objects.add("f", node), "number": f"({press.number('equation')})"}
        for node in _in_lines([equation.node for equation in part.equations], press.lang)
    ]
    return {"said": part.said.of(press.lang), "formulas": formulas}


def _in_lines(nodes: Sequence[Node], lang: Lang) -> Iterator[Node]:
    """One formula a line; those that only name another quantity or nothing, v_Px = 0 and v_Py = v_23, share one."""
    for trivial, some in groupby(nodes, key=lambda node: _TRIVIAL.fullmatch(plain(node)) is not None):
        alike = list(some)
        if not trivial or len(alike) == 1:
            yield from alike
            continue
        comma = Txt("，" if lang == "zh" else ", ")
        yield Row(tuple(piece for n, node in enumerate(alike) for piece in ((comma, node) if n else (node,))))


def _constants(group: GroupModel, *, arcs: bool) -> Iterator[str]:
    """$l_BC$ = 350 mm, $β_BF$ = 51.50°; M is told where it is chosen. arcs: the constants of pitch points, which stand
    in lengths of arc, are in radians, $θ_H$ = 6.3429 rad."""
    for constant in sorted(group.constants, key=lambda c: "lresxy".find(c.symbol[0]) if c.unit == "m" else 9):
        if constant.unit == "m":
            yield f"${constant.symbol}$ = {number(1e3 * constant.size, 6)} mm"
        elif arcs and re.match(r"θ_\{[A-Z]", constant.symbol):
            yield f"${constant.symbol}$ = {number(constant.size, 5)} rad"
        elif constant.unit == "rad" and constant.symbol != "π":
            yield f"${constant.symbol}$ = {_degrees(constant)}"


def _degrees(constant: Const) -> str:
    return f"{degrees(constant.size):.{_ANGLE}f}".rstrip("0").rstrip(".").replace("-", "−") + "°"


def written(node: Node) -> str:
    """A formula in the notation of `formula`, for a cell of a table: sums, products, sines."""
    match node:
        case Sym(base, sub, sup):
            return base + (f"^{{{sup}}}" if sup else "") + (f"_{{{sub}}}" if sub else "")
        case Txt(text):
            return text
        case Row(items):
            return "".join(written(item) for item in items)
        case Power(body, exponent):
            return f"{written(body)}^{exponent}"
    return plain(node)
