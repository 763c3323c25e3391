"""What a template may say of one problem:
plain words, and names of the objects (tables, equations, drawings) to be set."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import groupby
from typing import Any

from ..algebra.quantity import number
from ..board.construction import Step
from ..check.found_words import ill_conditioned, told
from ..check.shaking import shaking_of
from ..check.structure import dependence
from ..mechanism.asked.centres import count
from ..mechanism.model import Mechanism
from ..names import is_centre, is_place
from ..problem.asked.asks import AskCoriolis, AskNamed, AskPoint
from ..solution import YES_NO, Answer, Solution, fewer_digits
from ..words import Lang, Words, label
from .formulas import beside
from .structure import numbering, structure
from .tables import listed
from .values import asked_load, called, curved

_MOST, _SHORT = 4, 30.0  # formulas of a step in one line, and how long each may be (mm)


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
    data = [*problem.given.lengths, *problem.given.motion, *problem.given.loads]
    comma = "，" if lang == "zh" else ", "
    given = [d.of(lang) for d in data]
    if isinstance(problem.subject, Mechanism):
        given.insert(0, pivots(problem.subject).of(lang))
    return {
        "id": problem.id,
        "label": label(problem.id).of(lang),
        "title": problem.title.of(lang),
        "source": problem.source.of(lang) if problem.source else "",
        "statement": problem.statement.of(lang),
        "given": comma.join(given),
        "asked": ("、" if lang == "zh" else ", ").join(asked(solution, lang)),
        "structure": structure(problem).of(lang),
        "numbering": numbering(problem).of(lang),
        "scales": scales(solution, lang),
    }


def pivots(mech: Mechanism) -> Words:
    """Where the fixed points are, in mm: a student cannot draw without them."""
    places = [f"${name}$({number(1e3 * at.real, 6)}, {number(1e3 * at.imag, 6)})" for name, at in mech.frame.items()]
    return Words(
        f"固定点坐标 {'、'.join(places)} mm", f"fixed point{'s' if len(places) > 1 else ''} {', '.join(places)} mm"
    )


def conclusions(solution: Solution, lang: Lang) -> list[str]:
    """One sentence for each question that is not answered by a number alone."""
    coriolis = [
        _coriolis(solution.answers[ask.rel.key]).of(lang)
        for ask in solution.problem.asks
        if isinstance(ask, AskCoriolis)
    ]
    remarks = (
        solution.answers[ask.rel.key].reading.remark for ask in solution.problem.asks if isinstance(ask, AskNamed)
    )
    moved = [told(one).of(lang) for one in solution.verification if one.broken is not None]  # others: in a table
    shaken = shaking_of(solution.problem, {key: one.drawn for key, one in solution.answers.items()})
    told_so = dict.fromkeys(coriolis + [_told(remark).of(lang) for remark in remarks if remark is not None])
    return [*told_so, *moved, *([shaken.of(lang)] if shaken is not None else [])]


def cautions(solution: Solution, lang: Lang) -> list[str]:
    """What is hardly meant; counts in which no hand can err,
    and which still are not what the oracle says, and why, as far as the oracle knows."""
    named = [solution.answers[ask.rel.key] for ask in solution.problem.asks if isinstance(ask, AskNamed)]
    wrong = [
        answer for answer in named if answer.reading.mm is None and not answer.expected_error and not answer.computed
    ]
    why = dependence(solution.problem.subject) if wrong else None
    few = fewer_digits(solution)
    return [
        words.of(lang)
        for words in (
            *solution.warnings,
            few,
            *map(ill_conditioned, solution.verification),
            _disagreed(wrong) if wrong else None,
            why,
        )
        if words is not None
    ]


def _disagreed(wrong: list[Answer]) -> Words:
    """Counts in which no hand can err, and what the oracle says."""
    ours, its = (
        ", ".join(f"${answer.reading.symbol}$ = {number(value)}" for answer, value in zip(wrong, values, strict=True))
        for values in ([answer.drawn for answer in wrong], [answer.exact for answer in wrong])
    )
    return Words(
        f"注意：按计数 {ours.replace(', ', '，')}；按独立求得的结果（约束方程的秩）{its.replace(', ', '，')}，"
        "二者不符，以后者为准。",
        f"Beware: the count gives {ours}, the independent result (rank of the constraints) {its}. "
        "They disagree; the latter holds.",
    )


def _told(remark: Words) -> Words:
    """A method's own conclusion, as a sentence."""
    return Words(f"结论：{remark.zh.strip().rstrip('。')}。", f"Answer: {remark.en.strip().rstrip('.')}.")


def _coriolis(answer: Answer) -> Words:
    symbol = f"${answer.reading.symbol}$"
    if answer.direction is None:
        why = answer.reading.remark or Words("相对速度或角速度为零", "ω or the relative velocity is zero")
        return Words(f"结论：{why.zh}，{symbol} = 0。", f"Answer: {why.en}, so {symbol} = 0.")
    size, way = number(answer.drawn), number(answer.direction)
    return Words(
        f"结论：存在哥氏加速度，{symbol} = {size} m/s^2，方向与 $x$ 轴成 {way}°。",
        f"Answer: a Coriolis term exists, {symbol} = {size} m/s^2 at {way}° to the $x$ axis.",
    )


def asked(solution: Solution, lang: Lang) -> Iterator[str]:
    """The questions in symbols and words."""
    coriolis = {ask.rel.key for ask in solution.problem.asks if isinstance(ask, AskCoriolis)}
    centres = [ask.rel for ask in solution.problem.asks if isinstance(ask, AskNamed) and is_centre(ask.rel)]
    every = bool(centres) and len(centres) == count(solution.problem.mechanism)
    if every:
        yield Words("全部瞬心", "all instant centres").of(lang)
    for ask in solution.problem.asks:
        if (ask.rel.key in coriolis and not isinstance(ask, AskCoriolis)) or (every and ask.rel in centres):
            continue
        reading = solution.construction.readings[ask.rel.key]
        symbol = f"${reading.symbol}$"
        if isinstance(ask, AskPoint):
            yield _point_asked(ask, symbol).of(lang)
        elif isinstance(ask, AskCoriolis):
            yield Words(
                f"有无哥氏加速度 {symbol} 及其方向", f"whether a Coriolis term {symbol} exists and where it points"
            ).of(lang)
        elif is_place(ask.rel):
            of = curved(ask.rel, lang) + symbol.replace("^{∞}", "")
            yield Words(f"{of} 的位置", f"the position of {of}").of(lang)
        elif reading.unit == YES_NO:
            name = called(reading.symbol, reading.key, lang)
            yield Words(f"是否{name}", f"whether {name}").of(lang)
        elif (kind := asked_load(solution.problem, reading.key)) is not None:
            yield (kind.of(lang) if lang == "zh" else f"{kind.en} ") + called(reading.symbol, reading.key, lang)
        else:
            yield curved(ask.rel, lang) + called(reading.symbol, reading.key, lang)


def _point_asked(ask: AskPoint, symbol: str) -> Words:
    if ask.slowest is not None:
        line = "".join(ask.slowest)
        return Words(
            f"构件 {ask.link} 的 ${line}$ 线上速度最小的点 {symbol}",
            f"the slowest point {symbol} of link {ask.link} on the line ${line}$",
        )
    if ask.velocity == 0:
        return Words(f"构件 {ask.link} 的绝对瞬心 {symbol}", f"the instant centre {symbol} of link {ask.link}")
    if ask.acceleration == 0:
        return Words(f"构件 {ask.link} 的加速度中心 {symbol}", f"the acceleration pole {symbol} of link {ask.link}")
    kind = Words("速度", "velocity") if ask.velocity is not None else Words("加速度", "acceleration")
    value = ask.velocity if ask.velocity is not None else ask.acceleration
    assert value is not None
    pair = f"({number(value.real)}, {number(value.imag)})"
    unit = "m/s" if ask.velocity is not None else "m/s^2"
    return Words(
        f"构件 {ask.link} 上{kind.zh}为 {pair} {unit} 的点 {symbol}",
        f"the point {symbol} of link {ask.link} with {kind.en} {pair} {unit}",
    )


def scales(solution: Solution, lang: Lang) -> str:
    """μ_l = 0.001 m/mm, ...; each scale once, block diagrams have none."""
    drawn = [figure.scale for figure in solution.construction.figures if figure.scale.symbol and figure.scale.value]
    both = [one for scale in drawn for one in (scale, scale.across) if one is not None]
    parts = dict.fromkeys(f"${scale.symbol}$ = {number(scale.value)} {scale.per_mm}" for scale in both)
    return ("，" if lang == "zh" else ", ").join(parts)


def sections(solution: Solution, lang: Lang, objects: Objects) -> list[dict[str, Any]]:
    """The numbered steps under their headings."""
    out = []
    for title, steps in groupby(solution.construction.steps, key=lambda s: s.section.of(lang)):
        out.append({"title": title, "steps": [_step(s, lang, objects) for s in steps]})
    return out


def _step(step: Step, lang: Lang, objects: Objects) -> dict[str, Any]:
    return {
        "n": step.number,
        "words": step.words.of(lang),
        "equation": objects.add("eq", step.equation) if step.equation else "",
        "table": objects.add("tab", listed(step.listing, lang)) if step.listing else "",
        "formulas": [objects.add("f", node) for node in beside(step.formulas, _MOST, _SHORT)],
    }
