"""Claims about the sentences of a drawing that name lines: the radius of an arc is a bar from its centre, a point is on
the line that is named, or beyond that end of it which comes last, and two lines that meet are told apart."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tests.drawn_library import desk_of, drawn, ids
from tests.each import Later, each
from vecpoly.board.construction import EquationTable, View, view_of
from vecpoly.board.paper.marks import Vector
from vecpoly.methods.desk import Desk

IDS = Later(lambda: ids())
LETTER = r"[A-Z]₁?[₀-₉]?[′']?"
ARCS = (
    rf"以 \$({LETTER})\$、\$({LETTER})\$ 为圆心，以 \$l_(\S+)/μ_l\$、\$l_(\S+)/μ_l\$ 为半径画弧，交点为 \$({LETTER})\$",
    rf"由 \$({LETTER})\$、\$({LETTER})\$ 以 \$l_(\S+)/μ_l\$、\$l_(\S+)/μ_l\$ 得 \$({LETTER})\$",
    rf"rcs about \$({LETTER})\$ and \$({LETTER})\$ with radii \$l_(\S+)/μ_l\$ and \$l_(\S+)/μ_l\$ "
    rf"\w+(?: at)? \$({LETTER})\$",
)
ARC = (
    rf"以 \$({LETTER})\$ 为圆心、\$l_(\S+)/μ_l\$ 为半径画弧，与 \$({LETTER})\$ 的导路线",
    rf"arc about \$({LETTER})\$ with radius \$l_(\S+)/μ_l\$ cuts the guide line of \$({LETTER})\$",
)
LIES = (
    rf"\$({LETTER})(?:_\d+)?\$ 在 \$({LETTER})({LETTER})\$ (的延长线)?",
    rf"\$({LETTER})(?:_\d+)?\$ lies on \$({LETTER})({LETTER})\$( produced)?",
)


def sentences(name: str) -> Iterator[str]:
    """Of every step, in both languages."""
    for step in drawn(name).construction.steps:
        yield from (step.words.zh, step.words.en)


@each(IDS)
def test_the_radius_of_an_arc_that_locates_a_point_is_the_bar_from_its_centre_to_that_point(name: str) -> None:
    for text in sentences(name):
        for pattern in ARCS:
            for p, q, one, other, found in re.findall(pattern, text):
                assert set(re.findall(LETTER, one)) == {p, found}, text
                assert set(re.findall(LETTER, other)) == {q, found}, text
        for pattern in ARC:
            for p, bar, found in re.findall(pattern, text):
                assert set(re.findall(LETTER, bar)) == {p, found}, text


def share(desk: Desk, x: str, p: str, q: str) -> float | None:
    """Where a point lies on a line: 0 at its beginning, 1 at its end."""
    if not {x, p, q} <= desk.at.keys():
        return None
    a, b, c = (complex(desk.at[letter]) for letter in (p, q, x))
    return ((c - a) / (b - a)).real


@each(IDS)
def test_a_point_lies_between_the_letters_of_the_line_that_is_said_or_beyond_the_second_where_it_is_produced(
    name: str,
) -> None:
    for text in sentences(name):
        for pattern in LIES:
            for x, p, q, produced in re.findall(pattern, text):
                at = share(desk_of(name), x, p, q)
                assert at is None or (at > 1.0 if produced else -1e-9 <= at <= 1.0 + 1e-9), text


@each(IDS)
def test_of_two_lines_that_meet_each_is_told_in_a_part_of_its_own(name: str) -> None:
    for step in drawn(name).construction.steps:
        for text, meet, laid, wide, narrow, through in (
            (step.words.zh, "；两线交于 ", "自 $", "；", "，", "过 $"),
            (step.words.en, "; they meet in ", " lay off ", "; ", ", ", "hrough $"),
        ):
            if meet not in text:
                continue
            told = re.split(r"[。.:] ?(?=[自过FT])", text.split(meet)[0])[-1]
            sides = told.split(wide if laid in told else narrow)
            assert [side.count(through) for side in sides] == [1, 1], told


def sides(eq: EquationTable) -> list[list[tuple[str, str]]]:
    """Direction and magnitude of the terms on each side of an equation."""
    found = list[list[tuple[str, str]]]([[]])
    for sign, direction, magnitude in zip(eq.signs, eq.directions, eq.magnitudes, strict=True):
        if sign == "=":
            found.append([])
        found[-1].append((direction.zh, magnitude))
    return found


@each(Later(lambda: [*ids(), "lift-gate", "excavator-boom"]))
def test_a_polygon_that_two_lines_close_is_told_from_where_they_are_drawn_and_where_they_meet(name: str) -> None:
    """The given velocity of a cylinder stands behind the one that is sought: nothing was said of pr and of c_3."""
    for step in drawn(name).construction.steps:
        if step.equation is None or step.view is None or view_of(step.view) not in (View.VELOCITY, View.ACCELERATION):
            continue
        sought = [[way for way, size in side if size == "?"] for side in sides(step.equation)]
        if len(sought) == 2 and all(len(ways) == 1 and ways[0][:1] in ("⊥", "∥") for ways in sought):
            assert "两线交于" in step.words.zh and "they meet in" in step.words.en, step.words.en


ROTATED = re.compile(rf"的转动求 .*：\$[^$]+\$ ⊥ \$({LETTER})({LETTER})\$，指向与 \$[ωα]_\S+\$（(逆|顺)时针）一致")


@each(Later(lambda: [*ids(), "winch-gears", "3-11", "oldham-coupling", "stepped-planet"]))
def test_a_vector_that_follows_from_a_rotation_is_told_with_its_way_and_drawn_so(name: str) -> None:
    """The rotation of link 1 gave the velocity of H, and nothing was said of where that points."""
    desk, construction = desk_of(name), drawn(name).construction
    for step in construction.steps:
        if "的转动求" not in step.words.zh:
            continue
        found = ROTATED.search(step.words.zh)
        if found is None:
            told = "由" in step.words.zh.partition("法向分量")[2] or re.search("= 0，故 .*相同", step.words.zh)
            assert step.equation is not None or told, step.words.zh
            continue
        across = 1j * (complex(desk.at[found[2]]) - complex(desk.at[found[1]])) * (1 if found[3] == "逆" else -1)
        ways = [
            (mark.b - mark.a) / across
            for figure in construction.figures
            for mark in figure.marks
            if figure.view in (View.VELOCITY, View.ACCELERATION)
            and isinstance(mark, Vector)
            and mark.step == step.number
        ]
        assert any(way.real > 0 and abs(way.imag) < 1e-6 * abs(way) for way in ways), step.words.zh
