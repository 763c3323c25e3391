"""One name, one scale: on a board, and on every sheet of the library."""

from __future__ import annotations

from math import isclose

from tests.drawn_library import IDS, drawn
from tests.each import each
from vecpoly.board.board import Board
from vecpoly.board.construction import Scale, View
from vecpoly.board.hand import hand
from vecpoly.board.paper.marks import Role
from vecpoly.words import Words

TITLE = Words("图", "A figure")


def board() -> Board:
    return Board(hand("exact"), {View.MECHANISM: Scale(symbol="μ_l", value=0.001, unit="m")})


def length(value: float, across: float | None = None) -> Scale:
    turned = None if across is None else Scale(symbol="μ_φ", value=across, unit="rad")
    return Scale(symbol="μ_l", value=value, unit="m", across=turned)


def test_a_figure_with_another_scale_has_a_prime_and_the_next_another_one() -> None:
    sheet = board()
    sheet.step(TITLE)
    sheet.join(View.MECHANISM, 0j, 1 + 0j, Role.LINK)
    panes = [
        sheet.open_pane(View.MECHANISM, str(value), TITLE, length(value)) for value in (0.001, 0.002, 0.003, 0.004)
    ]
    assert [sheet.scale_of(pane).symbol for pane in panes] == ["μ_l", "μ_l′", "μ_l′′", "μ_l′′′"]


def test_a_kind_on_which_nothing_is_drawn_takes_no_name_away_and_one_scale_keeps_one_name() -> None:
    sheet = board()
    first, other = (sheet.open_pane(View.MECHANISM, name, TITLE, length(0.002)) for name in "ab")
    assert sheet.scale_of(first).symbol == sheet.scale_of(other).symbol == "μ_l"


def test_scales_to_the_right_are_told_apart_by_themselves() -> None:
    sheet = board()
    one, two = (sheet.open_pane(View.MECHANISM, str(a), TITLE, length(0.002, a)) for a in (0.1, 0.2))
    assert [sheet.scale_of(pane).symbol for pane in (one, two)] == ["μ_l", "μ_l"]
    assert [sheet.scale_of(pane).right.symbol for pane in (one, two)] == ["μ_φ", "μ_φ′"]


@each(IDS)
def test_on_the_sheets_of_the_library_every_symbol_of_a_scale_has_one_value(name: str) -> None:
    scales = [part for figure in drawn(name).construction.figures for part in (figure.scale, figure.scale.right)]
    told = {part.symbol: part.value for part in scales if part.symbol}
    assert all(isclose(part.value, told[part.symbol], rel_tol=1e-9) for part in scales if part.symbol)
