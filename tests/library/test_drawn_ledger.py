"""The ledger of a sheet is what its acts gave, and nobody but the acts writes in it."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

import vecpoly
from tests.drawn_library import desk_of, ids
from tests.each import Later, each
from vecpoly.board.acts import Act, Arrow, Compute, LayOff, Locate
from vecpoly.board.board import Scratch
from vecpoly.board.construction import Scale, View
from vecpoly.board.hand import hand
from vecpoly.board.paper.marks import Role
from vecpoly.names import At, Kind, Rel
from vecpoly.plane import nominal
from vecpoly.words import Words

METHODS = Path(vecpoly.__file__).parent / "methods"
IDS = Later(lambda: (name for name in ids() if not isinstance(desk_of(name).board, Scratch)))
LAST = 1e-9  # mm


def by_place(acts: list[Act], kind: type[Act]) -> dict[tuple[object, str], Act]:
    """The last act of a kind under each key on each figure."""
    return {(act.head.place, act.key): act for act in acts if isinstance(act, kind) and act.key}


@each(IDS)
def test_a_letter_stands_where_its_last_act_put_it(name: str) -> None:
    board = desk_of(name).board
    last = by_place(board.acts, Locate)
    assert set(board.ledger.spots) == set(last)
    for where, at in board.ledger.spots.items():
        act = last[where]
        assert isinstance(act, Locate) and abs(act.at - complex(nominal(at))) < LAST


@each(IDS)
def test_a_vector_stands_where_it_was_drawn(name: str) -> None:
    board = desk_of(name).board
    arrows = by_place(board.acts, Arrow)
    assert set(arrows) <= set(board.ledger.vectors)
    for where, act in arrows.items():
        stood = board.ledger.vectors[where]  # type: ignore[index]
        assert isinstance(act, Arrow)
        start, end = complex(nominal(stood.start)), complex(nominal(stood.end))
        assert abs(act.b - act.a - (end - start)) < LAST


@each(IDS)
def test_what_is_not_read_again_was_computed_or_given_and_laid_off(name: str) -> None:
    board = desk_of(name).board
    sizes = {act.key: act.value for act in board.acts if isinstance(act, Compute)}
    laid = {(act.head.place, act.key) for act in board.acts if isinstance(act, LayOff)}
    for place, key in laid:
        if key in sizes and place is not None:
            size = board.ledger.laid_off(place, key)
            assert size is not None and float(nominal(size.value)) == pytest.approx(sizes[key])
    assert set(board.ledger.laid) == laid


def test_scratch_paper_sees_the_sheet_and_leaves_it_alone() -> None:
    board = desk_of("3-12").board
    before = dict(board.ledger.spots)
    over = board.scratch()
    assert (View.VELOCITY, "b") in over.ledger.spots
    over.locate(View.VELOCITY, "b", 1 + 1j)
    over.arrow(View.VELOCITY, 0j, 1 + 1j, Role.GIVEN, key="v_X")
    assert board.ledger.spots == before and board.ledger.vector(View.VELOCITY, "v_X") is None


def test_points_with_one_letter_are_kept_apart() -> None:
    """k′ is the point of K, and the end of a Coriolis acceleration."""
    board, k = Scratch(hand("exact"), {View.ACCELERATION: Scale.of(View.ACCELERATION, 1.0)}), At("K")
    board.locate(View.ACCELERATION, "k^′", 3 + 4j, k)
    board.locate(View.ACCELERATION, "k^′", 1j)
    assert board.ledger.points[View.ACCELERATION, k] == 3 + 4j
    assert board.ledger.spots[View.ACCELERATION, "k'"] == 1j


def test_a_size_is_that_with_which_the_vector_was_laid_off() -> None:
    board = Scratch(hand("exact"), {View.VELOCITY: Scale.of(View.VELOCITY, 1.0)})
    board.step(Words.same(""), View.VELOCITY)
    board.given_size("v_{B}", 2.0, "m/s")
    board.lay_off(0j, 1 + 0j, 2.0, key="v_B")
    board.given_size("v_{B}", 5.0, "m/s")
    size = board.ledger.laid_off(View.VELOCITY, "v_B")
    assert size is not None and size.value == 2.0
    assert board.ledger.laid_off(View.VELOCITY, "v_C") is None


def test_a_vector_that_was_never_drawn_is_nowhere() -> None:
    desk = desk_of("3-12")
    assert desk.stands(Rel(Kind.V, At("B"))) is not None
    assert desk.stands(Rel(Kind.V, At("Z"))) is None and desk.size(Rel(Kind.V, At("Z"))) is None


def test_no_method_writes_in_the_ledger() -> None:
    """Nor in the answers: what is kept is kept by `keep`, `answer`, `revise`."""
    kept = {"ledger", "readings", "found", "spots", "vectors", "sizes"}
    wrong = []
    for path in METHODS.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if not isinstance(node, ast.Assign | ast.AugAssign | ast.AnnAssign):
                continue
            for target in node.targets if isinstance(node, ast.Assign) else [node.target]:
                inner = target.value if isinstance(target, ast.Subscript) else target
                if isinstance(inner, ast.Attribute) and inner.attr in kept and "board" in ast.unparse(inner.value):
                    wrong.append(f"{path.relative_to(METHODS)}:{node.lineno}")
    assert not wrong
