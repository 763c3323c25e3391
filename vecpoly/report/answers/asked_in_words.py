"""Sentences that answer what a statement asks in words: how a link translates, what is left unbalanced,
whether a wedge locks by itself, whether other planes will do."""

from __future__ import annotations

from collections.abc import Iterator

from ...devices.balancing.engine import InlineEngine
from ...devices.balancing.rotor import Rotor
from ...mechanism.model import FRAME, Mechanism, Prismatic
from ...names import Kind, Rel
from ...solution import Answer, Solution
from ...words import Lang, Words, joined
from .feasible import feasible
from .line import result_of
from .locking import locking_of

_MOTIONS = {Kind.V: "v", Kind.A: "a"}
_TERMS = {
    "F_I": Words("一阶惯性力", "the force of first order"),
    "M_I": Words("一阶惯性力偶", "the couple of first order"),
    "F_II": Words("二阶惯性力", "the force of second order"),
    "M_II": Words("二阶惯性力偶", "the couple of second order"),
}


def answered_in_words(solution: Solution, lang: Lang) -> Iterator[str]:
    """What is asked in the statement under another name, or as a question."""
    subject = solution.problem.subject
    if isinstance(subject, Mechanism):
        yield from (one.of(lang) for one in _translating(solution, subject, lang))
    elif isinstance(subject, InlineEngine) and set(_TERMS) <= set(solution.answers):
        yield _unbalanced(solution).of(lang)
    elif isinstance(subject, Rotor):
        yield from (one.of(lang) for one in feasible(solution, subject))
    elif (locking := locking_of(subject, solution.answers)) is not None:
        yield locking.of(lang)


def _translating(solution: Solution, mech: Mechanism, lang: Lang) -> Iterator[Words]:
    """v_5 = v_F: all points of a link that slides on the frame have one velocity."""
    statement = solution.problem.statement.zh
    guided = {side for joint in mech.joints if isinstance(joint, Prismatic) for side in _led(joint)}
    for link in (one for one in mech.links if one.name in guided):
        told = [
            f"${stem}_{link.name}$ = ${answer.reading.symbol}$ = {result_of(answer, lang)}"
            for kind, stem in _MOTIONS.items()
            if f"{stem}_{link.name}$" in statement
            and (answer := _of_point(solution, kind, link.name, tuple(link.points)))
        ]
        if told:
            text = Words("，", ", ").of(lang).join(told)
            yield Words(
                f"构件 {link.name} 作平动，其上各点运动相同：{text}。",
                f"Link {link.name} translates; all its points move alike: {text}.",
            )


def _led(joint: Prismatic) -> tuple[str, ...]:
    """The link that a guide of the frame keeps from turning."""
    return tuple(one for one, other in ((joint.block, joint.guide), (joint.guide, joint.block)) if other == FRAME)


def _of_point(solution: Solution, kind: Kind, link: str, letters: tuple[str, ...]) -> Answer | None:
    """The answer for a point of the link."""
    for rel in (ask.rel for ask in solution.problem.asks):
        if not isinstance(rel, Rel) or rel.kind is not kind or rel.ref is not None:
            continue
        if rel.to.link == link or (not rel.to.link and rel.to.point in letters):
            return solution.answers[rel.key]
    return None


def _unbalanced(solution: Solution) -> Words:
    """Which of the forces and couples are more than the drawing may be off."""
    there = {key: one for key in _TERMS if _is_there(one := solution.answers[key])}
    left = [_TERMS[key] + Words.same(f" ${one.reading.symbol}$") for key, one in there.items()]
    if not left:
        return Words("各阶惯性力和惯性力偶均已平衡。", "All forces and couples are balanced.")
    if len(left) == len(_TERMS):
        return Words("四项均未平衡。", "All four are unbalanced.")
    named = joined(left)
    verb = "is" if len(left) == 1 else "are"
    return Words(
        f"未平衡的是{named.zh}，其余各项均已平衡。", f"Left unbalanced {verb} {named.en}; the others are balanced."
    )


def _is_there(answer: Answer) -> bool:
    return abs(answer.drawn) > max(answer.expected_error, 1e-9)
