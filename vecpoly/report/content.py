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
from ..solution import Answer, Solution
from ..words import Lang, Words


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
    given = [d.of(lang) for d in data]
    given.insert(0, pivots(solution).of(lang))
    return {
        "id": problem.id, "title": problem.title.of(lang), "source": problem.source.of(lang) if problem.source else "",
        "statement": problem.statement.of(lang), "given": comma.join(given),
        "asked": ("、" if lang == "zh" else ", ").join(asked(solution, lang)), "structure": structure(solution, lang),
        "scales": scales(solution, lang),
    }


def pivots(solution: Solution) -> Words:
    """Where the fixed points are, in mm: a student cannot draw without them."""
    places = ", ".join(f"${name}$({number(1e3 * at.real)}, {number(1e3 * at.imag)})" for name, at in solution.problem.mechanism.frame.items())
    return Words(f"固定点坐标 {places} mm", f"fixed points {places} mm")


def conclusions(solution: Solution, lang: Lang) -> list[str]:
    """One sentence for each question that is not answered by a number alone."""
    return [_coriolis(solution.answers[ask.rel.key]).of(lang) for ask in solution.problem.asks if isinstance(ask, AskCoriolis)]


def _coriolis(answer: Answer) -> Words:
    symbol = f"${answer.reading.symbol}$"
    if answer.direction is None:
        why = answer.reading.remark or Words("相对速度或角速度为零", "ω or the relative velocity is zero")
        return Words(f"结论：{why.zh}，{symbol} = 0。", f"Answer: {why.en}, so {symbol} = 0.")
    size, way = number(answer.drawn), number(answer.direction)
    return Words(f"结论：存在哥氏加速度，{symbol} = {size} m/s^2，方向与 $x$ 轴成 {way}°。",
                 f"Answer: a Coriolis term exists, {symbol} = {size} m/s^2 at {way}° to the $x$ axis.")


def asked(solution: Solution, lang: Lang) -> Iterator[str]:
    """The questions in symbols and words."""
    coriolis = {ask.rel.key for ask in solution.problem.asks if isinstance(ask, AskCoriolis)}
    for ask in solution.problem.asks:
        if ask.rel.key in coriolis and not isinstance(ask, AskCoriolis):
            continue
        reading = solution.construction.readings[ask.rel.key]
        symbol = f"${reading.symbol}$"
        if isinstance(ask, AskPoint):
            yield _point_asked(ask, symbol).of(lang)
        elif isinstance(ask, AskCoriolis):
            yield Words(f"有无哥氏加速度 {symbol} 及其方向", f"whether a Coriolis term {symbol} exists and where it points").of(lang)
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
    sum_up = f"$F$ = 3×{count.links} − 2×{count.lower} − {count.higher} = {count.freedom}"
    if any("G" in g.kind for g in groups):
        rolls = Words("（纯滚动副限制两个自由度，按低副计）", " (pure rolling takes two freedoms and counts as a lower pair)")
        return (Words(f"机构有 {count.links} 个活动构件，自由度 {sum_up}", f"The mechanism has {count.links} moving links and {sum_up}") + rolls
                + Words(f"；构件 {mech.drive.link} 为原动件。", f"; link {mech.drive.link} drives.")).of(lang)
    zh = "、".join(f"{g.kind} 杆组（构件 {'、'.join(g.links)}）" for g in groups)
    en = ", ".join(f"{g.kind} (links {', '.join(g.links)})" for g in groups)
    return Words(f"机构有 {count.links} 个活动构件（连机架共 {count.links + 1} 个构件），自由度 {sum_up}；构件 {mech.drive.link} 为原动件，其余为 {zh}，属 Ⅱ 级机构。",
                 f"The mechanism has {count.links} moving links ({count.links + 1} with the frame) and {sum_up}; link {mech.drive.link} drives, the rest is made up of the "
                 f"Assur groups {en}: a class II mechanism.").of(lang)


def scales(solution: Solution, lang: Lang) -> str:
    """μ_l = 0.001 m/mm, ..."""
    parts = [f"${f.scale.symbol}$ = {number(f.scale.value)} {f.scale.per_mm}" for f in solution.construction.figures]
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
    blank = tuple(Words.same("____") for _ in table.symbols)
    return EquationTable(symbols=table.symbols, signs=table.signs, directions=blank, magnitudes=tuple("____" for _ in table.symbols))
