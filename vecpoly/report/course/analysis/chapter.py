"""Chapters 8 and 9, the analysis in words and the conclusion: generated from the facts of the cycle."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import degrees
from typing import Any

from ....findings.advice import advice, is_square
from ....findings.conditioning import Conditioning, conditioning
from ....findings.motion import motion
from ....findings.study.study import Study
from ....words import Lang, Words
from ..checks.comparison import Compared
from ..numbering import Press
from . import forces as force_analysis
from . import why_peaks as peaks
from .conclusion import themes
from .peak_remarks import remarks
from .why_peaks import causes

_MACHINE = Words("机械的运转与平衡", "The machine in motion and its balance")
_HEADER = {
    "zh": ["杆组", "行列式", "最小处", "最小值/最大值", "最大处", "最小传动角", "1/$sin γ$", "判断"],
    "en": ["Group", "Determinant", "Least at", "Least/largest", "Largest at", "Least γ", "1/$sin γ$", "Verdict"],
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
    return {
        "motion": [w.of(press.lang) for w in (*motion(study, groups), *(() if told else peaks.flat(study, groups)))],
        "causes": peaks.table(study, press, told),
        "remarks": [w.of(press.lang) for w in remarks(study, told)],
        "conditioning": _conditioned(study, press, groups),
        "singular": [w.of(press.lang) for w in mending],
        "forces": [w.of(press.lang) for w in force_analysis.forces(study)],
        "conclusion": _paragraphs(
            [*themes(study, groups, drawn, tables, ("8.3" if told else "8.2") if mending else ""), (_MACHINE, found)],
            press.lang,
        ),
    }


def _paragraphs(themes: Iterable[tuple[Words, Sequence[Words]]], lang: Lang) -> list[str]:
    """A paragraph for each theme of which something is said, with its name at the head."""
    stop, blank = ("。", "") if lang == "zh" else (". ", " ")
    return [f"**{name.of(lang)}{stop}**{blank.join(w.of(lang) for w in said)}" for name, said in themes if said]


def _conditioned(study: Study, press: Press, groups: list[Conditioning]) -> str:
    """One line a group."""
    rows = []
    for one in groups:
        steady = one.ratio > 1 - 1e-9
        low, high = ("—", "—") if steady else (study.where(phi).split(" = ")[1] for phi in (one.phi, one.top))
        steady_angle = Words("恒为 90°", "always 90°").of(press.lang) if is_square(study, one) else "—"
        gamma = f"{degrees(one.gamma.least.value):.1f}°" if one.gamma is not None else steady_angle
        rows.append(
            (
                one.group.title.of(press.lang),
                f"${one.symbol}$",
                low,
                f"{one.ratio:.3f}",
                high,
                gamma,
                one.times if one.gamma is not None else "—",
                _verdict(study, one).of(press.lang),
            )
        )
    return (
        press.table(
            Words("各杆组线性方程组的行列式", "The determinants of the groups' linear equations"),
            _HEADER[press.lang],
            rows,
            "lccccccl",
        )
        if rows
        else ""
    )


def _verdict(study: Study, one: Conditioning) -> Words:
    """Of a drive that cannot turn right round the ends of the range told lie beside its dead points."""
    return Words("两端趋近死点", "dead points beyond") if one.is_poor and study.facts.dead else one.verdict
