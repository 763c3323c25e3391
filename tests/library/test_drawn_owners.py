"""What every mark of the library knows: the act that left it, whose it is, and what it stands for."""

from __future__ import annotations

from tests.drawn_library import IDS, drawn, ids
from tests.each import Later, each
from vecpoly.board.paper.ink import marks
from vecpoly.board.paper.marks import (
    AngleMark,
    Block,
    Disc,
    FixedGuide,
    FrictionCircle,
    GearMark,
    Ground,
    Mark,
    Plate,
    RackMark,
    Role,
    Segment,
    Slot,
    TurnArrow,
    Vector,
)
from vecpoly.board.place import View, called
from vecpoly.mechanism.model import FRAME, Mechanism

ON_LINKS = (View.MECHANISM, View.BODY)


def is_body(mark: Mark) -> bool:
    line = isinstance(mark, Segment) and mark.role is Role.LINK
    return line or isinstance(mark, Plate | Block | Slot | Disc | GearMark | RackMark)


@each(IDS)
def test_the_figures_are_what_the_acts_left_and_each_mark_knows_its_act(name: str) -> None:
    construction = drawn(name).construction
    left = {called(place).strip(): own for place, own in marks(construction.acts).items()}
    for figure in construction.figures:
        assert left[f"{figure.view.name} {figure.name}".strip()] == figure.marks
        assert all(construction.acts[mark.act].head.step == mark.step for mark in figure.marks)


@each(IDS)
def test_every_mark_has_an_owner_and_what_is_fixed_is_the_frames(name: str) -> None:
    for figure in drawn(name).construction.figures:
        assert all(mark.owner for mark in figure.marks)
        assert {mark.owner for mark in figure.marks if isinstance(mark, Ground | FixedGuide)} <= {"frame"}


@each(Later(ids))
def test_the_lines_of_links_belong_to_links_of_the_mechanism(name: str) -> None:
    it = drawn(name)
    assert isinstance(it.problem.subject, Mechanism)
    known = {"frame", *(f"link {link.name}" for link in it.problem.subject.links if link.name != FRAME)}
    bodies = [mark for view in ON_LINKS for f in it.figures(view) for mark in f.marks if is_body(mark)]
    assert bodies and {mark.owner for mark in bodies} <= known


@each(IDS)
def test_what_carries_a_symbol_carries_the_key_of_its_quantity(name: str) -> None:
    marked = [mark for figure in drawn(name).construction.figures for mark in figure.marks]
    named = [mark for mark in marked if isinstance(mark, Vector | TurnArrow | AngleMark) and mark.label]
    assert not [mark for mark in named if not mark.key]
    assert all(mark.key.startswith("rho_") for mark in marked if isinstance(mark, FrictionCircle))
