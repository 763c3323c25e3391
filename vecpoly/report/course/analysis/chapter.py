"""Chapters 8 and 9, the analysis in words and the conclusion: generated from the facts of the cycle."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import degrees
from typing import Any

from ....findings.advice import advice, is_square
from ....findings.conditioning import Conditioning, conditioning
from ....findings.motion import motion
from ....findings.shown import dead_points, listed
from ....findings.study.study import Study
from ....words import Lang, Words
from ..checks.comparison import Compared
from ..numbering import Press
from . import forces as force_analysis
from . import why_peaks as peaks
from .conclusion import themes
from .peak_remarks import remarks
from .why_peaks import causes

_BEYOND = Words("两端趋近死点", "towards dead points")
_MACHINE = Words("机械的运转与平衡", "The machine in motion and its balance")
_HEADER = {
    "zh": ["杆组", "行列式", "最小处", "最小值/最大值", "最大处", "最小传动角", "1/$sin γ$", "判断"],
    "en": ["Group", "Determinant", "Minimum at", "Min/max", "Maximum at", "Min γ", "1/$sin γ$", "Verdict"],
}


def chapter(
    study: Study, press: Press, drawn: Compared, tables: Sequence[dict[str, Any]] = (), found: Sequence[Words] = ()
) -> dict[str, Any]:
    """Sentences and tables: how it moves, the peaks with their causes, conditioning of the groups; and the conclusion.
    tables: the printed tables as checked; found: what the chapters on the machine conclude."""
    press.chapter = "8"
    groups = conditioning(study)
    told = causes(study, groups)
    mending = [w for one in groups for w in advice(study, one)]
    section = ("8.3" if told else "8.2") if mending else ""
    concluded = [*themes(study, groups, drawn, tables, section), (_MACHINE, found)]
    return {
        "motion": [w.of(press.lang) for w in (*motion(study, groups), *(() if told else peaks.flat(study, groups)))],
        "causes": peaks.table(study, press, told),
        "peak": peaks.alone(study, told[0]).of(press.lang) if len(told) == 1 else "",
        "remarks": [w.of(press.lang) for w in remarks(study, told)],
        "conditioning": _conditioned(study, press, groups),
        "condition": _only(study, groups[0], advised=bool(mending)).of(press.lang) if len(groups) == 1 else "",
        "singular": [w.of(press.lang) for w in mending],
        "forces": [w.of(press.lang) for w in force_analysis.forces(study)],
        "conclusion": _paragraphs(concluded, press.lang),
        "concluded": _listed(concluded, press.lang),
    }


def _paragraphs(themes: Iterable[tuple[Words, Sequence[Words]]], lang: Lang) -> list[str]:
    """A paragraph for each theme of which something is said, with its name at the head."""
    stop, blank = ("。", "") if lang == "zh" else (". ", " ")
    return [f"**{name.of(lang)}{stop}**{blank.join(w.of(lang) for w in said)}" for name, said in themes if said]


def _listed(themes: Iterable[tuple[Words, Sequence[Words]]], lang: Lang) -> list[dict[str, Any]]:
    """The same with what is said of each theme item by item."""
    return [{"title": name.of(lang), "items": [w.of(lang).strip() for w in said]} for name, said in themes if said]


def _conditioned(study: Study, press: Press, groups: list[Conditioning]) -> str:
    """One line a group; of a single group nothing, for a sentence tells it."""
    rows = [_row(study, one, press.lang) for one in groups]
    title = Words("各杆组线性方程组的行列式", "The determinants of the groups' linear equations")
    return press.table(title, _HEADER[press.lang], rows, "lccccccl") if len(rows) > 1 else ""


def _row(study: Study, one: Conditioning, lang: Lang) -> tuple[str, ...]:
    low, high = ("—", "—") if _is_steady(one) else (_at(study, at, lang) for at in (one.lows, one.tops))
    square = Words("恒为 90°", "always 90°").of(lang) if is_square(study, one) else "—"
    return (
        one.group.title.of(lang),
        f"${one.symbol}$",
        low,
        f"{one.ratio:.3f}",
        high,
        square if one.gamma is None else f"{degrees(one.gamma.least.value):.1f}°",
        "—" if one.gamma is None else one.times,
        _verdict(study, one).of(lang),
    )


def _at(study: Study, at: Sequence[float], lang: Lang) -> str:
    return listed(study, at).of(lang).split(" = ")[1]


def _is_steady(one: Conditioning) -> bool:
    """Whether the determinant does not change."""
    return one.ratio > 1 - 1e-9


def _only(study: Study, one: Conditioning, *, advised: bool) -> Words:
    """The only group's determinant, its minimum transmission angle (which advice tells, too), and the verdict."""
    group, by, low, high = one.group.title, f"$|{one.symbol}|$", listed(study, one.lows), listed(study, one.tops)
    told = Words(f"{group.zh}的行列式 {by} 不变", f"The determinant {by} of the {group.en} does not change")
    if not _is_steady(one):
        share = Words(f"，为最大值的 {one.ratio:.3f} 倍", f", {one.ratio:.3f} of its largest")
        if one.is_none:
            share = Words("，为零", ", where it is zero")
        told = Words(
            f"{group.zh}的行列式 {by} 在 {high.zh} 处最大，在 {low.zh} 处最小",
            f"The determinant {by} of the {group.en} is largest at {high.en} and least at {low.en}",
        )
        told += share
    if is_square(study, one):
        told += Words("，传动角恒为 90°", ", and the transmission angle is always 90°")
    if one.gamma is not None and not advised:
        least = f"{degrees(one.gamma.least.value):.1f}°"
        told += Words(
            f"；最小传动角为 {least}，误差最多放大 1/$sin γ$ = {one.times} 倍",
            f"; the minimum transmission angle is {least}, so that errors are magnified at most 1/$sin γ$ = "
            f"{one.times} times",
        )
    verdict = _verdict(study, one)
    if verdict is _BEYOND:
        dead = dead_points(study)
        many = len(study.facts.dead) > 1
        lie = f"{'The dead points' if many else 'The dead point'}, at {dead.en},"
        return told + Words(
            f"。死点（{dead.zh}）处行列式为零，不在工作范围之内。",
            f". {lie} where the determinant vanishes, {'are' if many else 'is'} left out of the working range.",
        )
    subject = "The group" if one.is_ill else "The conditioning"
    return told + Words(f"。判断：{verdict.zh}。", f". {subject} is {verdict.en}.")


def _verdict(study: Study, one: Conditioning) -> Words:
    """Of a drive that cannot turn right round the ends of the range told lie beside its dead points."""
    return _BEYOND if one.is_poor and study.facts.dead else one.verdict
