"""The last chapter: whether the demands are met, and what was designed."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from ...project.demand import Demand
from ...project.measured import measured
from ...project.part import Part
from ...solution import YES_NO
from ...words import Lang, Words
from ..answers.line import result_of
from .binder import Binder, allowed, amount

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
    results = [(part.problem.title.of(lang), binder.listed(list(_results(part, lang)))) for part in project.parts]
    failed = [one.say.of(lang) for one in project.demands if not one.holds]
    return {
        "table": press.table(title, _HEADER[lang], rows, "lclrrc") if rows else "",
        "results": press.table(Words("主要设计结果", "The main results"), _RESULTS[lang], results, "ll"),
        "failed": binder.listed(failed),
        "count": len(project.demands),
    }


def _row(one: Demand, binder: Binder) -> tuple[str, ...]:
    lang = binder.lang
    part, key = _of(one.name, binder)
    read = _as_read(part, key, lang) if part is not None else None
    return (
        one.say.of(lang), _symbol(part, key), allowed(one), read or amount(one.drawn), amount(one.exact),
        _VERDICT[one.holds].of(lang),
    )  # fmt: skip


def _of(name: str, binder: Binder) -> tuple[Part | None, str]:
    """The part of a quantity that is called `part.key`, and its key."""
    part, _, key = name.partition(".")
    return next((one for one in binder.project.parts if one.name == part), None), key


def _symbol(part: Part | None, key: str) -> str:
    return "—" if part is None else f"${measured(part)[key].symbol}$"


def _as_read(part: Part, key: str, lang: Lang) -> str | None:
    """An answer with the digits that it has in the chapter of its part; None of what is no answer."""
    answer = part.solution.answers.get(key)
    if answer is None or answer.reading.unit == YES_NO:
        return None
    return ("−" if answer.counted < 0 else "") + result_of(answer, lang)


def _results(part: Part, lang: Lang) -> Iterator[str]:
    """The answers of a part as read; of a mechanism the facts of its cycle."""
    gives = measured(part)
    if part.finds and part.taken == {}:
        shown = list(part.solution.answers)
    else:
        shown = [key for key in gives if not part.moves or key not in part.solution.answers]
    for key in shown:
        one = gives[key]
        if one.unit or key.startswith("i_") or key == "K":
            yield f"${one.symbol}$ = {_as_read(part, key, lang) or amount(one.drawn)}"
