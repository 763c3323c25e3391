"""What a template may say of one problem: plain words, and names of the objects (tables, equations, drawings) to be set."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import groupby
from typing import Any

from ..board.construction import EquationTable, Step
from ..mechanism.assur import decompose
from ..mechanism.mobility import mobility
from ..problem.asks import AskCoriolis, AskPoint
from ..quantity import number
from ..solution import Solution
from ..words import Lang, Words

_UNIT_ZH_EN = {"m": "m/mm", "m/s": "(m/s)/mm", "m/s^2": "(m/s^2)/mm"}


@dataclass(slots=True)
class Objects:
    """Things a template refers to by name."""

    named: dict[str, object] = field(default_factory=dict)

    def add(self, prefix: str, thing: object) -> str:
        """Keep a thing, give its name."""
        name = f"{prefix}{len(self.named)}"
        self.named[name] = thing
        return name


def statement(solution: Solution, lang: Lang) -> dict[str, str]:
    """Title, source, statement, given and asked in words."""
    problem = solution.problem
    data = [*problem.given.lengths, *problem.given.motion]
    comma = "，" if lang == "zh" else ", "
    return {
        "id": problem.id, "title": problem.title.of(lang), "source": problem.source.of(lang) if problem.source else "",
        "statement": problem.statement.of(lang), "given": comma.join(d.of(lang) for d in data),
        "asked": ("、" if lang == "zh" else ", ").join(asked(solution, lang)), "structure": structure(solution, lang),
        "scales": scales(solution, lang),
    }


def asked(solution: Solution, lang: Lang) -> Iterator[str]:
    """The questions in symbols and words."""
    for ask in solution.problem.asks:
        reading = solution.construction.readings[ask.rel.key]
        symbol = f"${reading.symbol}$"
        if isinstance(ask, AskPoint):
            yield _point_asked(ask, symbol).of(lang)
        elif isinstance(ask, AskCoriolis):
            yield Words(f"哥氏加速度 {symbol} 是否存在、指向何方", f"whether a Coriolis term {symbol} exists and where it points").of(lang)
        else:
            yield symbol


def _point_asked(ask: AskPoint, symbol: str) -> Words:
    if ask.velocity == 0:
        return Words(f"构件 {ask.link} 的绝对瞬心 {symbol}", f"the instant centre {symbol} of link {ask.link}")
    if ask.acceleration == 0:
        return Words(f"构件 {ask.link} 的加速度中心 {symbol}", f"the acceleration pole {symbol} of link {ask.link}")
    kind = Words("速度", "velocity") if ask.velocity is not None else Words("加速度", "acceleration")
    value = ask.velocity if ask.velocity is not None else ask.acceleration
    assert value is not None
    pair = f"({number(value.real)}, {number(value.imag)})"
    unit = "m/s" if ask.velocity is not None else "m/s^2"
    return Words(f"构件 {ask.link} 上{kind.zh}为 {pair} {unit} 的点 {symbol}", f"the point {symbol} of link {ask.link} with {kind.en} {pair} {unit}")


def structure(solution: Solution, lang: Lang) -> str:
    """Number of links, degree of freedom, Assur groups."""
    mech = solution.problem.mechanism
    count, groups = mobility(mech), decompose(mech)
    moving = len(mech.links)
    names = {"zh": "、".join(f"{g.kind}（{'、'.join(g.links)}）" for g in groups), "en": ", ".join(f"{g.kind} ({', '.join(g.links)})" for g in groups)}
    words = Words(f"机构有 {moving} 个活动构件（加机架共 {moving + 1} 个构件），自由度 $F$ = {count.freedom}；原动件 {mech.drive.link}，所含杆组：{names['zh']}。",
                  f"The mechanism has {moving} moving links ({moving + 1} with the frame) and $F$ = {count.freedom}; link {mech.drive.link} drives, and the Assur groups are {names['en']}.")
    return words.of(lang)


def scales(solution: Solution, lang: Lang) -> str:
    """μ_l = 0.001 m/mm, ..."""
    parts = [f"${f.scale.symbol}$ = {number(f.scale.value)} {_UNIT_ZH_EN[f.scale.unit]}" for f in solution.construction.figures]
    return ("，" if lang == "zh" else ", ").join(parts)


def sections(solution: Solution, lang: Lang, objects: Objects) -> list[dict[str, Any]]:
    """The numbered steps under their headings."""
    out = []
    for title, steps in groupby(solution.construction.steps, key=lambda s: s.section.of(lang)):
        out.append({"title": title, "steps": [_step(s, lang, objects) for s in steps]})
    return out


def _step(step: Step, lang: Lang, objects: Objects) -> dict[str, Any]:
    return {
        "n": step.number, "words": step.words.of(lang),
        "equation": objects.add("eq", step.equation) if step.equation else "",
        "formulas": [objects.add("f", node) for node in step.formulas],
    }


def blank_equations(solution: Solution, objects: Objects) -> list[str]:
    """The vector equations with empty rows, for the question sheet."""
    tables = [s.equation for s in solution.construction.steps if s.equation]
    return [objects.add("eq", _emptied(t)) for t in tables]


def _emptied(table: EquationTable) -> EquationTable:
    blank = tuple(Words("____", "____") for _ in table.symbols)
    return EquationTable(symbols=table.symbols, signs=table.signs, directions=blank, magnitudes=tuple("____" for _ in table.symbols))


__all__ = ["Objects", "blank_equations", "sections", "statement"]
