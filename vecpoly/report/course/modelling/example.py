"""The last section of chapter 4, the model evaluated at the given position:
with numbers put in, or as a table where there are many formulas."""

from __future__ import annotations

from typing import Any

import numpy as np

from ....algebra.quantity import number
from ....analytic.equations import Equation, GroupModel
from ....analytic.expr import Var
from ....analytic.keyed import ANGLES, as_told, size, turned
from ....analytic.numbers import unit, worked
from ....findings.study.study import Study
from ....words import Words
from ..numbering import SMALL, Press

_NOTHING = 1e-14  # SI: what rounding leaves of zero
_LEFT = 1e-10  # of the terms of a sum: what rounding leaves where they cancel
_ABREAST = 3  # quantities beside each other
_HEADER = {"zh": ["量", "数值", "单位"], "en": ["Quantity", "Value", "Unit"]}


def section(study: Study, press: Press) -> dict[str, Any]:
    """Groups with their formulas worked out, or one table of all values."""
    where = study.where(study.mech.drive.position)
    if study.dense or not study.model.closed:
        return {"where": where, "groups": [], "table": _table(study, press, by_group(study))}
    groups = [
        {
            "title": group.title.of(press.lang),
            "formulas": [press.objects.add("f", node) for node in (worked(e, env) for e in told(group))],
        }
        for group, env in zip(study.model.groups, as_told_by_group(study), strict=True)
    ]
    return {"where": where, "groups": [group for group in groups if group["formulas"]], "table": ""}


def by_group(study: Study) -> list[dict[str, float]]:
    """All variables at the given position as each group has them:
    auxiliary names such as A_0 mean something else in another group."""
    env = {
        k: float(np.asarray(v).ravel()[0]) for k, v in study.model.values(np.array([study.mech.drive.position])).items()
    }
    found = []
    for group in study.model.groups:
        own = dict(env)
        for e in told(group):
            assert isinstance(e.left, Var)
            value = float(np.asarray(e.right.value(own)).ravel()[0])
            own[e.left.symbol] = 0.0 if abs(value) < max(_NOTHING, _LEFT * size(e.right, own)) else value
        found.append({k: 0.0 if abs(v) < _NOTHING else v for k, v in own.items()})
    return found


def as_told_by_group(study: Study) -> list[dict[str, float]]:
    """The same, each rounded as it is printed and gone on with so, in the groups after it, too."""
    found, kept = [], dict[str, float]()
    for group, exact in zip(study.model.groups, by_group(study), strict=True):
        own = exact | kept
        for e in told(group):
            assert isinstance(e.left, Var)
            symbol = e.left.symbol
            kept[symbol] = own[symbol] = as_told(e.right, own, symbol[0] in ANGLES) if exact[symbol] else 0.0
        found.append(own)
    return found


def told(group: GroupModel) -> list[Equation]:
    """The equations that give a variable its value."""
    return [e for e in group.equations if e.gives and isinstance(e.left, Var)]


def _table(study: Study, press: Press, envs: list[dict[str, float]]) -> str:
    """Every variable once a group, three to a line, each with its number and its unit."""
    values = [
        (f"${e.left.symbol}$", *_valued(e.left.symbol, env[e.left.symbol]))
        for group, env in zip(study.model.groups, envs, strict=True)
        for e in told(group)
        if isinstance(e.left, Var)
        and e.left.symbol[0] not in "ABCGΔf"
        and "Δ" not in e.left.symbol
        and not e.left.symbol.startswith(("b_", "c_"))
    ]
    unknowns = [q for group in study.model.groups if group.loops is not None for q in group.loops.unknowns]
    rates = [
        rate.symbol
        for group in study.model.groups
        if group.loops is not None
        for q in group.loops.unknowns
        for rate in group.loops.rates[q]
        if isinstance(rate, Var)
    ]
    values = [(f"${s}$", *_valued(s, envs[0][s])) for s in (*unknowns, *rates)] + list(dict.fromkeys(values))
    count = -(-len(values) // _ABREAST)
    padded = [*values, *([("", "", "")] * (count * _ABREAST - len(values)))]
    rows = [tuple(text for j in range(_ABREAST) for text in (*padded[i + j * count], ""))[:-1] for i in range(count)]
    return press.table(
        Words("题设位置各变量的值", "The variables at the given position"),
        [*(*_HEADER[press.lang], "") * _ABREAST][:-1],
        rows,
        ("ldcl" * _ABREAST)[:-1],
        style=SMALL,
    )


def _valued(symbol: str, value: float) -> tuple[str, str]:
    """The number and its unit."""
    if symbol[0] in "φψ":
        return turned(value).removesuffix("°"), "°"
    return number(value, 5), unit(symbol).replace("^2", "²") or "—"
