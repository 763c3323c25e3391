"""A linkage that is given whole, drawn in a position of no significance: in one with its crank at 60°; of one that is
to be found of which nothing can be drawn, what it looks like, in proportions that are nobody's answer."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from ...board.construction import Figure
from ...board.paper.marks import AngleMark, Mark, Point, Role, Segment, Slot, TurnArrow
from ...designs.base import Design
from ...designs.grashof import Grashof
from ...designs.limits_found import CrankRockerLimits, GuideBarLimits, SliderCrankLimits
from ...designs.linkages import shaper, whitworth
from ...designs.quick_return import QuickReturn, Shaper, Whitworth
from ...errors import AssemblyError
from ...foundation.slotted import replace
from ...problem.problem import Problem
from ...problem.values.given import Given
from ...problem.values.made import problem as made
from ...solution import solve
from ...words import Words
from ..picture import picture
from ..sizes.designs import design
from ..sizes.lines import span
from ..sizes.sized import sized

_GIVEN = (CrankRockerLimits, SliderCrankLimits, GuideBarLimits)
_LIKE = Words("机构示意图（不按比例）", "The mechanism (not to scale)")
_PROPORTIONS: tuple[tuple[type[QuickReturn], dict[str, float], float], ...] = (  # mm, and the rod DE
    (Shaper, {"AC": 60.0, "AB": 40.0, "CD": 128.0, "h": 112.0}, 120.0),
    (Whitworth, {"AC": 35.0, "AB": 80.0, "CD": 60.0}, 190.0),
)
_MILLI = 1e-3
_BEFORE = 16.0  # mm before the pivot, at which the offset is marked


def whole(problem: Problem, width: float, height: float) -> Figure | None:
    """The sketch of a linkage all of whose lengths are given, or of its kind; None of others that are to be found."""
    subject = problem.subject
    for kind, lengths, rod in _PROPORTIONS:
        if isinstance(subject, kind):
            data = (shaper if kind is Shaper else whitworth)(lengths, rod, None)
            return _pictured(problem, data, width, height, like=True)
    if isinstance(subject, Grashof):  # a chain of which any link may be the frame: with AD, as its letters say
        subject = CrankRockerLimits(AB=subject.AB, BC=subject.BC, CD=subject.CD, AD=subject.AD)
    if not isinstance(subject, _GIVEN):
        return None
    return _pictured(problem, subject.built(_lengths(subject)), width, height)


def _pictured(
    problem: Problem, data: Mapping[str, Any], width: float, height: float, *, like: bool = False
) -> Figure | None:
    """This linkage with the lengths of the problem at it. like: only of its kind, in other lengths."""
    title = {"zh": problem.title.zh, "en": problem.title.en}
    linkage = made({"id": problem.id, "title": title, **data})
    unnamed = replace(linkage, given=Given(letters=linkage.given.letters, shapes=linkage.given.shapes))
    try:
        drawn = picture(unnamed, solve(linkage, repeats=0, precise=False).construction, width, height)
    except AssemblyError:  # a chain without a crank need not reach this position
        return None
    if drawn is None:
        return None
    plain = tuple(mark for mark in drawn.marks if not _moves(mark))
    if like and isinstance(problem.subject, Design):
        named = design(problem.subject, problem.statement.zh, replace(drawn, marks=plain), true=False)
        return replace(drawn, marks=(*plain, *named, *_height(problem, drawn)), title=_LIKE)
    return sized(problem, replace(drawn, marks=(*plain, *_offset(problem, drawn))))


def _lengths(subject: Design) -> dict[str, float]:
    """By the names of the data, mm."""
    names = ("AB", "BC", "CD", "AD", "AC")
    found = {name: getattr(subject, name).si / _MILLI for name in names if hasattr(subject, name)}
    return found | {"e": getattr(subject, "offset", 0.0) / _MILLI}


def _moves(mark: Mark) -> bool:
    """What tells how the crank stands and turns, of which nothing is given: φ_1 with the line from which it counts."""
    if isinstance(mark, AngleMark):
        return mark.label.startswith("φ")
    return isinstance(mark, TurnArrow) or (isinstance(mark, Segment) and mark.role is Role.CENTRE)


def _height(problem: Problem, figure: Figure) -> Iterator[Mark]:
    """How far the guide of a ram is above the pivot of its lever."""
    if isinstance(problem.subject, Shaper):
        spots = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point)}
        yield from span(spots["C"], complex(spots["C"].real, spots["E"].imag), "h", -_BEFORE + 0j)


def _offset(problem: Problem, figure: Figure) -> Iterator[Mark]:
    """How far the guide of a slider lies below the pivot of its crank, or that of a bar beside its own pivot."""
    if isinstance(problem.subject, SliderCrankLimits) and problem.subject.offset:
        pivot = next(mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label == "A")
        slider = next(mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label == "C")
        yield Segment(a=complex(pivot.real - _BEFORE, slider.imag), b=slider, role=Role.CENTRE, step=1)
        yield from span(pivot, complex(pivot.real, slider.imag), "e", -_BEFORE + 0j)
    if isinstance(problem.subject, GuideBarLimits) and problem.subject.offset:
        pivot = next(mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label == "C")
        slot = next(mark for mark in figure.marks if isinstance(mark, Slot))
        along = (slot.b - slot.a) / abs(slot.b - slot.a)
        foot = slot.a + along * (along.conjugate() * (pivot - slot.a)).real
        yield Segment(a=foot, b=slot.a, role=Role.CENTRE, step=1)
        yield from span(pivot, foot, "e")
