"""The last chapter: whether the demands are met, and what was designed."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from ...project.demand import Demand
from ...project.measured import measured
from ...project.part import Part
from ...words import Words
from .binder import Binder, amount

_HEADER = {
    "zh": ["要求", "量", "允许值", "图解值", "精确值", "结论"],
    "en": ["Demand", "Quantity", "Allowed", "Drawn", "Exact", "Verdict"],
}
_VERDICT = {True: Words("满足", "met"), False: Words("不满足", "not met")}
_RESULTS = {"zh": ["部分", "结果"], "en": ["Part", "Results"]}


def chapter(binder: Binder) -> dict[str, Any]:
    """The table of demands, the results of each part."""
    project, press, lang = binder.project, binder.press, binder.lang
    rows = [_row(one, binder) for one in project.demands]
    title = Words("设计要求的校核", "The demands and what was reached")
    results = [(part.problem.title.of(lang), binder.listed(list(_results(part)))) for part in project.parts]
    failed = [one.say.of(lang) for one in project.demands if not one.holds]
    return {
        "table": press.table(title, _HEADER[lang], rows, "lclrrc") if rows else "",
        "results": press.table(Words("主要设计结果", "The main results"), _RESULTS[lang], results, "ll"),
        "failed": binder.listed(failed),
        "count": len(project.demands),
    }


def _row(one: Demand, binder: Binder) -> tuple[str, ...]:
    lang = binder.lang
    asked = f"{one.sign} {amount(one.asked)}" + (f" ± {100 * one.within:g} %" if one.sign == "=" else "")
    return (
        one.say.of(lang), _symbol(one, binder), asked, amount(one.drawn), amount(one.exact),
        _VERDICT[one.holds].of(lang),
    )  # fmt: skip


def _symbol(one: Demand, binder: Binder) -> str:
    name, _, key = one.name.partition(".")
    part = next((part for part in binder.project.parts if part.name == name), None)
    return "—" if part is None else f"${measured(part)[key].symbol}$"


def _results(part: Part) -> Iterator[str]:
    """The answers of a part as read; of a mechanism the facts of its cycle."""
    gives = measured(part)
    if part.finds and part.taken == {}:
        shown = list(part.solution.answers)
    else:
        shown = [key for key in gives if not part.moves or key not in part.solution.answers]
    for key in shown:
        one = gives[key]
        if one.unit or key.startswith("i_") or key == "K":
            yield f"${one.symbol}$ = {amount(one.drawn)}"
