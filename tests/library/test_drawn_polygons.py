"""What stands in the velocity and acceleration polygons of every problem is what the steps say:
tables, arrows, letters, images."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from pathlib import Path

import numpy as np
import pytest

from tests.drawn_library import IDS as TAKEN
from tests.drawn_library import desk_of, drawn, given, ids, standing, tips
from tests.each import Later, each
from tests.found import FOUND
from vecpoly.board.construction import EquationTable, Step, View
from vecpoly.board.paper.marks import Dot, ImageOf, Point, RightAngle, Segment, Vector
from vecpoly.mechanism.groups.assur import decompose
from vecpoly.mechanism.model import FRAME, Circle, Prismatic, Rolling
from vecpoly.methods.desk import POLE, Desk
from vecpoly.names import At, alpha, omega

POLYGONS = {"Velocity analysis": View.VELOCITY, "Acceleration analysis": View.ACCELERATION}
KNOWN: dict[str, list[int]] = json.loads(
    (Path(__file__).resolve().parents[1] / "data" / "equations.json").read_text(encoding="utf-8")
)
IDS = Later(lambda: [*sorted({*ids(view=View.VELOCITY), *ids(view=View.ACCELERATION)}), *FOUND])
WORDED = ("?", "✓", "—", "∥导路", "∥平底")  # directions that are no line between two letters
POINT, LOWERED = r"[A-Z]\d?'?", str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
NEAR = 1e-6  # mm
SEEN = 0.01  # mm: what is shorter is drawn as nothing


def tables(name: str, view: View | None = None) -> list[tuple[Step, EquationTable]]:
    """The steps of a kind of analysis with their vector equations."""
    return [
        (step, step.equation)
        for step in drawn(name).construction.steps
        if step.equation is not None and (view is None or POLYGONS.get(step.section.en) is view)
    ]


# -- every step that has an equation has its table -----------------------------------------------------------------


@each([name for name in KNOWN if name in TAKEN])
def test_the_number_of_tables_of_a_problem_is_known(name: str) -> None:
    velocity, acceleration = len(tables(name, View.VELOCITY)), len(tables(name, View.ACCELERATION))
    assert [velocity, acceleration, len(tables(name)) - velocity - acceleration] == KNOWN[name]


@each(IDS)
def test_every_group_with_a_polygon_has_its_table(name: str) -> None:
    dyads = sum(group.dyad is not None for group in decompose(drawn(name).problem.mechanism))
    for view in (view for view in POLYGONS.values() if drawn(name).figures(view)):
        assert len(tables(name, view)) >= dyads, view


@each(Later(lambda: [*IDS, *ids(view=View.FORCE), *ids(mechanisms=False, view=View.FORCE)]))
def test_a_step_that_announces_an_equation_has_its_table(name: str) -> None:
    announced = [
        step
        for step in drawn(name).construction.steps
        if re.search("列(速度|加速度)?矢量方程|列构件.*力平衡方程", step.words.zh)
    ]
    assert all(step.equation is not None for step in announced)
    assert announced or not KNOWN.get(name, [0])[0]
    assert all("equation" in step.words.en or "equilibrium" in step.words.en for step in announced)


@each(Later(lambda: [name for name, counts in KNOWN.items() if sum(counts)]))
def test_a_table_has_as_many_columns_in_each_row_and_two_unknowns(name: str) -> None:
    for step, table in tables(name):
        n = len(table.symbols)
        assert n >= 2 and len(table.signs) == len(table.directions) == len(table.magnitudes) == n
        assert table.signs[0] == "" and set(table.signs[1:]) <= {"+", "="} and "=" in table.signs
        unknown = sum((d.zh == "?") + (m == "?") for d, m in zip(table.directions, table.magnitudes, strict=True))
        assert unknown in (2, 4), step.number  # 4 where the sum itself is written in front


@each(IDS)
def test_one_side_of_every_table_is_the_whole_vector_that_is_sought_and_nothing_is_said_twice(name: str) -> None:
    told = [table for view in POLYGONS.values() for _, table in tables(name, view)]
    by_symbol = vectors(desk_of(name))
    for table in told:
        sides = "".join(sign + symbol for sign, symbol in zip(table.signs, table.symbols, strict=True)).split("=")
        assert any(re.fullmatch(rf"[va]_{POINT}\d*", plain(side)) for side in sides), sides
        for symbol in {one for one in table.symbols if table.symbols.count(one) > 1}:  # of two lines: it is nothing
            _, a, b = by_symbol[plain(symbol)]
            assert abs(b - a) < SEEN, sides


# -- what a table says is what is drawn ------------------------------------------------------------------------------


def vectors(desk: Desk) -> dict[str, tuple[View, complex, complex]]:
    """Tail and head of every drawn vector by its printed symbol; of a sum of two that are parallel by both symbols."""
    found = {}
    for (view, key), stood in desk.board.ledger.vectors.items():
        if not isinstance(view, View) or view not in POLYGONS.values():
            continue
        symbols = [re.sub("^a([nktr])_", r"a^\1_", part) for part in key.strip("()").split(" + ")]
        whole = "+".join(symbols)
        found[plain(whole if len(symbols) == 1 else f"({whole})")] = (view, complex(stood.start), complex(stood.end))
    return found


def plain(symbol: str) -> str:
    """A symbol without braces and spaces, the numerals of a letter as they stand in its key."""
    return re.sub(r"[${} ]", "", symbol).translate(LOWERED)


def place(desk: Desk, letter: str) -> complex:
    """Where a letter stands on the diagram: O2 is printed O₂."""
    return complex(next(at for name, at in desk.at.items() if name.translate(LOWERED) == letter))


def along(told: str, desk: Desk) -> tuple[complex, bool]:
    """The direction that a cell tells as a vector on paper, and whether it tells the sense too."""
    cell = plain(told)
    if found := re.fullmatch(rf"({POINT})→({POINT})", cell):
        return place(desk, found[2]) - place(desk, found[1]), True
    if found := re.fullmatch(r"⊥(v_\w+)", cell):
        _, a, b = vectors(desk)[found[1]]
        return 1j * (b - a), False
    found = re.fullmatch(rf"([⊥∥])({POINT})({POINT})", cell)
    assert found is not None, told
    line = place(desk, found[3]) - place(desk, found[2])
    return (1j * line if found[1] == "⊥" else line), False


def told_directions(name: str) -> Iterator[tuple[complex, complex, bool]]:
    """(vector drawn, direction told, sense told) of every column whose direction is a line of a figure."""
    desk = desk_of(name)
    by_symbol = vectors(desk)
    for view in POLYGONS.values():
        for _, table in tables(name, view):
            for symbol, direction in zip(table.symbols, table.directions, strict=True):
                if direction.zh not in WORDED:
                    told, (_, a, b) = along(direction.zh, desk), by_symbol[plain(symbol)]
                    if abs(b - a) > SEEN:
                        yield b - a, *told


@each(IDS)
def test_a_direction_told_in_a_table_is_that_of_the_vector_drawn(name: str) -> None:
    for vector, line, sensed in told_directions(name):
        turn = vector / line / abs(vector / line)
        assert abs(turn.imag) < 1e-7 and (turn.real > 0 or not sensed), (vector, line)


@each(IDS)
def test_a_magnitude_told_in_a_table_is_that_of_the_vector_drawn(name: str) -> None:
    desk, own = desk_of(name), {datum.symbol: datum.si for datum in given(name).given.data}
    by_symbol = vectors(desk)
    for view in POLYGONS.values():
        scale = desk.board.scale_of(view).value
        for _, table in tables(name, view):
            for symbol, size in zip(table.symbols, table.magnitudes, strict=True):
                if size not in ("?", "✓"):
                    _, a, b = by_symbol.get(plain(symbol), (view, 0j, 0j))
                    told = 0.0 if size == "0" else sized(desk, size, own)
                    assert abs(b - a) * scale == pytest.approx(told, rel=1e-9, abs=SEEN * scale), (symbol, size)


def sized(desk: Desk, told: str, own: Mapping[str, float]) -> float:
    """What a cell tells: ω or α of a link, or ω², times a length, a radius or a sliding velocity; own: what is given,
    by its symbol, of the radii of a stepped gear too."""
    found = re.fullmatch(rf"(2?)([ωα])_(\w+?)(\^2)?(l_({POINT})({POINT})|r_(\w+)|v_\w+)", plain(told))
    assert found is not None, told
    turn = abs(float(desk.turns[(omega if found[2] == "ω" else alpha)(found[3])].value))
    rate = turn**2 if found[4] else turn
    if found[1]:
        view, a, b = vectors(desk)[found[5]]
        return 2.0 * rate * abs(b - a) * desk.board.scale_of(view).value
    if found[8]:
        return rate * (own.get(f"r_{found[8]}") or radius_of(desk, found[8]))
    return rate * abs(place(desk, found[6]) - place(desk, found[7])) * desk.board.scale_of(View.MECHANISM).value


def radius_of(desk: Desk, link: str) -> float:
    """The radius of a gear that is not told by the name of its link."""
    rolling = [j for j in desk.mech.joints if isinstance(j, Rolling)]
    radii = {j.gear.link: j.gear.radius for j in rolling} | {
        j.on.link: j.on.radius for j in rolling if isinstance(j.on, Circle)
    }
    return radii[link]


@each(IDS)
def test_a_coriolis_vector_is_the_sliding_velocity_turned_in_the_sense_of_the_guide(name: str) -> None:
    """And 2 ω v long: nothing where the guide does not turn, or nothing slides."""
    desk = desk_of(name)
    scales = [desk.board.scale_of(view).value for view in POLYGONS.values()]
    ends = {key: (a, b) for key, (_, a, b) in standing(desk).items()}
    for key in (key for key in ends if key.startswith("ak_")):
        (a, b), (c, d) = ends[key], ends[key.replace("ak_", "v_")]
        turns = [complex(desk.turns[omega(guide)].value) for guide in guides_of(desk, key)]
        ways = [2j * turn * (d - c) * scales[0] / scales[1] for turn in turns]
        assert any(abs(b - a - way) < 1e-7 * abs(way) + SEEN for way in ways), key


def guides_of(desk: Desk, key: str) -> set[str]:
    """The moving guides at the point of a Coriolis acceleration, or of the links that it names."""
    return {
        joint.guide
        for joint in desk.mech.joints
        if isinstance(joint, Prismatic)
        and joint.guide != FRAME
        and (joint.pin[0] == key[3] or {joint.guide, joint.block} & set(re.findall(r"\d+", key)))
    }


# -- arrows, letters, right angles, images ----------------------------------------------------------------------------


@each(IDS)
def test_every_vector_of_an_equation_is_drawn_once_from_its_tail_to_its_head(name: str) -> None:
    desk = desk_of(name)
    shown = {
        view: [m for figure in drawn(name).figures(view) for m in figure.marks if isinstance(m, Vector)]
        for view in POLYGONS.values()
    }
    for key, (view, a, b) in standing(desk).items():
        if np.abs(b - a) > SEEN:
            there = [m for m in shown[view] if np.abs(m.a - a) + np.abs(m.b - b) < 1e-6]
            back = [m for m in shown[view] if np.abs(m.a - b) + np.abs(m.b - a) < 1e-6]
            meant = any(
                where is view and np.abs(c - b) + np.abs(d - a) < 1e-6 for where, c, d in standing(desk).values()
            )
            meant = meant or bool(np.abs(b) < 1e-6 and any(np.abs(tip - a) < 1e-6 for tip in tips(desk, view).values()))
            assert there and (meant or not back), key


@each(IDS)
def test_every_tip_has_its_letter_and_the_pole_is_an_open_circle(name: str) -> None:
    desk = desk_of(name)
    for view in POLYGONS.values():
        letters = [
            m for figure in drawn(name).figures(view) if not figure.name for m in figure.marks if isinstance(m, Point)
        ]
        ends = tips(desk, view)
        if letters:
            assert [m.at for m in letters if m.dot is Dot.POLE and m.label == POLE[view]] == [0j]
            named = [
                at
                for at, tip in ends.items()
                if any(abs(m.at - tip) < 1e-6 and m.label == desk.tip_label(view, at) for m in letters)
            ]
            moved = [
                at
                for at, tip in ends.items()
                if at not in named and any(abs(tip - ends[other]) < 1e-6 for other in named)
            ]
            assert {*named, *moved} == set(
                ends
            ) and named  # a point of a link that only translates may share another's tip
        for at, tip in ends.items():
            same = [m for m in letters if m.label == desk.tip_label(view, at)]
            assert all(abs(m.at - tip) < 1e-6 for m in same), at


@each(Later(lambda: [name for name in IDS if name != "parallelogram-locomotive"]))  # its polygons are one vector each
def test_a_right_angle_stands_between_two_lines_that_are_there(name: str) -> None:
    for figure in drawn(name).construction.figures:
        lines = [m for m in figure.marks if isinstance(m, Segment | Vector)]
        for mark in (m for m in figure.marks if isinstance(m, RightAngle)):
            assert abs((mark.u.conjugate() * mark.v).real) < 1e-7
            for way in (mark.u, mark.v):
                assert any(
                    abs(((m.b - m.a).conjugate() * way).imag) < 1e-6 * abs(m.b - m.a)
                    and abs(((mark.at - m.a).conjugate() * way).imag) < 1e-6
                    for m in lines
                ), (figure.name, mark)


def test_accelerations_carry_their_right_angles() -> None:
    assert (
        sum(isinstance(m, RightAngle) for name in IDS for f in drawn(name).figures(View.ACCELERATION) for m in f.marks)
        >= 30
    )


@each(IDS)
def test_the_image_of_a_link_is_similar_to_it_with_its_letters_in_the_same_order(name: str) -> None:
    desk = desk_of(name)
    for view in POLYGONS.values():
        for mark in (m for figure in drawn(name).figures(view) for m in figure.marks if isinstance(m, ImageOf)):
            assert abs(mark.points[1] - mark.points[0]) > NEAR, mark  # on one place nothing similar stands
            assert any(similar(desk, view, link.name, mark.points) for link in desk.mech.links), mark


def similar(desk: Desk, view: View, link: str, corners: tuple[complex, ...]) -> bool:
    """Whether these corners of a polygon are the image of three points of a link."""
    places = []
    for corner in corners:
        here = [
            desk.where(at)
            for at, tip in tips(desk, view).items()
            if abs(tip - corner) < 1e-6 and (at.link == link or at.point in desk.letters(link))
        ]
        places.append(
            [complex(p) for p in here]
            + [complex(desk.at[p]) for p in desk.letters(link) if desk.at_rest(view, At(p)) and abs(corner) < 1e-6]
        )
    return any(
        abs((c - a) / (b - a) - (corners[2] - corners[0]) / (corners[1] - corners[0])) < 1e-6
        for a in places[0]
        for b in places[1]
        for c in places[2]
        if abs(b - a) > SEEN
    )
