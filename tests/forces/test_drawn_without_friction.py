"""The construction without friction stands beside that with it, dashed;
every line has its side, every arm its letter."""

from __future__ import annotations

import pytest

from tests.drawn_library import IDS, drawn, given
from tests.each import Later, each
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.marks import Dot, Mark, Point, Role, Segment
from vecpoly.board.said.sides import side_of
from vecpoly.mechanism.model import Mechanism

RUBBED = Later(lambda: (name for name in IDS if (it := given(name).loads) is not None and it.friction and it.unknown))


def _diagram(name: str) -> Figure:
    (figure,) = drawn(name).figures(View.MECHANISM)
    return figure


def _dashed(marks: tuple[Mark, ...]) -> list[Segment]:
    return [mark for mark in marks if isinstance(mark, Segment) and mark.role is Role.IDEAL]


@each(RUBBED)
def test_with_friction_the_diagram_also_has_the_lines_without_it(name: str) -> None:
    """Each dashed line of a reaction bears its own name, which ends in 0; a load is the same with friction."""
    of_forces = {line.key for line in _dashed(_diagram(name).marks) if line.key.startswith("R")}
    lettered = {mark.key for mark in _diagram(name).marks if isinstance(mark, Point) and mark.dot is Dot.NONE}
    assert of_forces and all(key.endswith("_0") for key in of_forces)
    assert of_forces & lettered


@each(Later(lambda: (name for name in RUBBED if {"M_0", "M_1_0"} & drawn(name).solution.answers.keys())))
def test_the_arm_without_friction_is_drawn_as_long_as_it_was_read(name: str) -> None:
    """h_0 stands beside h, from one dashed line square to the other, and is the moment over the force."""
    figure, construction = _diagram(name), drawn(name).construction
    (letter,) = (mark for mark in figure.marks if isinstance(mark, Point) and mark.key == "h_0")
    arm = min(
        (line for line in _dashed(figure.marks) if not line.key),
        key=lambda line: abs((line.a + line.b) / 2 - letter.at),
    )
    found = construction.readings if "M_0" in construction.readings else construction.forces
    moment = next(found[key].scalar for key in ("M_0", "M_1_0") if key in found)
    forces = [abs(reading.scalar) for key, reading in construction.forces.items() if key.endswith("_0")]
    length = abs(arm.b - arm.a) * figure.scale.value
    assert any(abs(moment) == pytest.approx(force * length, rel=1e-9) for force in forces)


def test_the_point_of_concurrency_has_a_letter_in_both_constructions() -> None:
    letters = {mark.label: mark.at for mark in _diagram("4-6").marks if isinstance(mark, Point)}
    assert abs(letters["K"] - letters["K_0"]) > 5.0
    told = " ".join(step.words.zh for step in drawn("4-6").construction.steps)
    assert "交点 $K_0$，$R_{41,0}$ 过 $K_0$" in told and "交点 $K$，$R_{41}$ 过 $K$" in told


@each(RUBBED)
def test_the_side_that_a_step_names_is_the_side_on_which_the_line_touches(name: str) -> None:
    """Upper or lower, left or right: as the point at which the reaction acts lies from the pin's centre."""
    one = drawn(name)
    assert isinstance(one.problem.subject, Mechanism) and one.desk is not None
    told = [step.words for step in one.construction.steps]
    pins, scale = one.desk.at, _diagram(name).scale.value
    for key, reading in one.construction.forces.items():
        if reading.acts is None or not reading.acts.tangent or key.endswith("_0"):
            continue
        at = reading.acts.point / scale
        pin = min(pins, key=lambda letter: abs(complex(pins[letter]) - at))
        side = side_of(at - complex(pins[pin]))
        zh, en = f"${reading.symbol}$ 切于 ${pin}$ 处摩擦圆", f"${reading.symbol}$ is tangent to the friction circle"
        assert all(f"{zh}{side.zh}侧" in words.zh for words in told if zh in words.zh)
        assert all(f"at ${pin}$ on its {side.en} side" in words.en for words in told if f"{en} at ${pin}$" in words.en)


def test_no_step_leaves_the_side_to_the_reader() -> None:
    for name in ("4-3a", "4-6", "4-7", "winch-gears"):
        for step in drawn(name).construction.steps:
            assert "哪一侧" not in step.words.zh and "determines the side" not in step.words.en


def test_the_clamp_shows_beside_each_reaction_that_without_friction() -> None:
    """R_21,0 along the normal at K, R_31,0 through the pin A; both sides of the tangent are named in the steps."""
    lines = {line.key: line for figure in drawn("5-3").figures(View.BODY) for line in _dashed(figure.marks)}
    assert lines.keys() == {"R_21_0", "R_31_0"}
    normal, through = lines["R_21_0"].b - lines["R_21_0"].a, lines["R_31_0"]
    assert abs(normal.real) < 1e-9 * abs(normal) and abs(through.a) < 1e-9
    assert any("切于 $A$ 处摩擦圆右侧" in step.words.zh for step in drawn("5-3").construction.steps)
