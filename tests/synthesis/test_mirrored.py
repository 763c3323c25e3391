"""Mirrored data give the mirrored solutions, of every task whose data have a sense: candidates, verdicts, pins."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import often
from tests.synthesis.inversion import drawn_anyhow, place, pose, posed, solved
from vecpoly.board.candidates import Candidate
from vecpoly.errors import AssemblyError, DeadPointError, ProblemFileError

Random = np.random.Generator
Data = dict[str, Any]
Task = Callable[[Random, int], tuple[str, Data]]  # random numbers, and −1 for the mirror image in the x axis: the task
SEED = st.integers(0, 2**32 - 1)
WIDE = 1e-6  # of a length, of the size of a figure


def _spot(rng: Random, way: int) -> str:
    x, y = rng.uniform(-60, 60, 2).round(2)
    return place(float(x), way * float(y))


def _poses(rng: Random, way: int, count: int, turn: float) -> list[str]:
    turns, places = np.cumsum(rng.uniform(8, turn, count)), np.cumsum(rng.uniform(-20, 40, (count, 2)), axis=0)
    rows = zip(places.round(2).tolist(), turns.round(2).tolist(), strict=True)
    return [pose(x, way * y, way * deg) for (x, y), deg in rows]


def _level(rng: Random, way: int) -> str:
    return f"on y = {way * int(rng.integers(-80, 80))} mm"


def _pairs(rng: Random, way: int, count: int) -> list[str]:
    one, two = np.cumsum(rng.integers(8, 50, count)), np.cumsum(rng.integers(5, 45, count)) + rng.integers(0, 180)
    return [f"{way * int(a)} deg -> {way * int(b)} deg" for a, b in zip(one, two, strict=True)]


def two_positions(rng: Random, way: int) -> tuple[str, Data]:
    """Pins on the body; pivots on the frame."""
    poses, pins = _poses(rng, way, 2, 50), (_spot(rng, way), _spot(rng, way))
    lines = (_level(rng, way), f"on x = {rng.integers(-80, 80)} mm")
    if rng.random() < 0.5:
        return "positions", {"poses": poses, "body": dict(zip("BC", pins, strict=True)), "A": lines[0], "D": lines[1]}
    return "positions", {"poses": poses, "frame": dict(zip("AD", pins, strict=True)), "B": lines[0], "C": lines[1]}


def three_positions(rng: Random, way: int) -> tuple[str, Data]:
    """The pivots are given."""
    frame = {"A": _spot(rng, way), "D": _spot(rng, way)}
    return "positions", {"poses": _poses(rng, way, 3, 40), "frame": frame}


def four_positions(rng: Random, way: int) -> tuple[str, Data]:
    """Both pivots on one line, or each on its own."""
    poses, line = _poses(rng, way, 4, 24), _level(rng, way)
    return "positions", {"poses": poses, "A": line, "D": line if rng.random() < 0.5 else _level(rng, way)}


def angle_pairs(rng: Random, way: int) -> tuple[str, Data]:
    """Two pairs with C on a line of its link, or three."""
    data: Data = {"AB": f"{rng.integers(15, 60)} mm", "AD": f"{rng.integers(40, 130)} mm"}
    count = int(rng.integers(2, 4))
    line = {} if count == 3 else {"C": f"on y = {way * int(rng.integers(-20, 20))} mm"}
    return "angle-pairs", data | {"pairs": _pairs(rng, way, count)} | line


def slider_pairs(rng: Random, way: int) -> tuple[str, Data]:
    """Three pairs of crank and slider."""
    phi, s = np.cumsum(rng.integers(10, 50, 3)), 120 - np.cumsum(rng.integers(4, 35, 3))
    pairs = [f"{way * int(a)} deg -> {int(b)} mm" for a, b in zip(phi, s, strict=True)]
    return "angle-pairs", {"guide": _level(rng, way), "pairs": pairs, "onto": str(rng.integers(1, 4))}


def function_generator(rng: Random, way: int) -> tuple[str, Data]:
    """Three pairs, or a function."""
    if rng.random() < 0.5:
        return "function-generator", {"AD": "100 mm", "pairs": _pairs(rng, way, 3)}
    phi, psi = rng.integers(0, 300, 2).tolist()
    turn, swing = int(rng.integers(30, 100)), int(rng.choice([-80, -50, 50, 80]))
    data: Data = {"AD": "100 mm", "function": str(rng.choice(["log10(x)", "x^2", "1/x"])), "x": [1, 2]}
    data |= {"phi": [f"{way * phi} deg", f"{way * (phi + turn)} deg"]}
    return "function-generator", data | {"psi": [f"{way * psi} deg", f"{way * (psi + swing)} deg"]}


def stages(rng: Random, way: int) -> tuple[str, Data]:
    """A slider's places give C, and C gives B."""
    rays = {name: [f"{way * int(deg)} deg" for deg in rng.integers(-170, 170, 2)] for name in ("AB", "DC")}
    ends = [place(float(rng.integers(60, 250)), way * float(rng.integers(-60, 60))) for _ in range(2)]
    d = [f"{rng.integers(30, 150)} mm", f"{way * int(rng.integers(-40, 40))} mm"]
    frame = {"A": ["0 mm", "0 mm"], "D": d}
    steps = [{"find": "C", "on": "DC", "from": "E"}, {"find": "B", "on": "AB", "from": "C"}]
    return "stages", {"frame": frame, "rays": rays, "points": {"E": ends}, "stages": steps}


def cognates(rng: Random, way: int) -> tuple[str, Data]:
    """Any four-bar with a point of its coupler."""
    data = {key: f"{rng.integers(25, 100)} mm" for key in ("AB", "BC", "CD", "AD")}
    return "cognates", data | {"E": _spot(rng, way), "phi": f"{way * int(rng.integers(0, 360))} deg"}


TASKS: tuple[Task, ...] = (
    two_positions, three_positions, four_positions, angle_pairs, slider_pairs, function_generator, stages,
)  # fmt: skip


@pytest.mark.parametrize("task", TASKS, ids=lambda task: task.__name__)
@settings(max_examples=often(1, 80), deadline=None)
@given(seed=SEED)
def test_candidates_of_mirrored_data_are_the_mirrored_candidates(task: Task, seed: int) -> None:
    here, there = (_found(*task(np.random.default_rng(seed), way)) for way in (1, -1))
    assert [one.verdict for one in here] == [one.verdict for one in there]
    for mine, its in zip(here, there, strict=True):
        size = max(abs(at) for at in mine.pins.values()) + 1.0
        assert its.pins == {key: pytest.approx(at.conjugate(), abs=WIDE * size) for key, at in mine.pins.items()}
        lengths = [key for key in mine.values if re.fullmatch("[A-Z]{2}", key)]
        assert {key: its.values[key] for key in lengths} == pytest.approx(
            {key: mine.values[key] for key in lengths}, rel=WIDE, abs=WIDE * size
        )


def _found(kind: str, data: Data) -> tuple[Candidate, ...]:
    try:
        return drawn_anyhow(kind, **data)
    except (AssemblyError, DeadPointError):
        return ()


@settings(max_examples=often(4), deadline=None)
@given(seed=SEED)
def test_cognates_of_a_mirrored_linkage_have_the_same_lengths(seed: int) -> None:
    here, there = (_answers(*cognates(np.random.default_rng(seed), way)) for way in (1, -1))
    assert here == pytest.approx(there, rel=WIDE)


@settings(max_examples=often(2, 120), deadline=None)
@given(seed=SEED)
def test_a_mirrored_path_is_as_straight(seed: int) -> None:
    here, there = (_answers(*_path(np.random.default_rng(seed), way)) for way in (1, -1))
    assert here == pytest.approx(there, rel=WIDE, abs=1e-9)


def _path(rng: Random, way: int) -> tuple[str, Data]:
    ab = int(rng.integers(20, 60))
    bc, cd = (int(rng.integers(2 * ab, 4 * ab)) for _ in range(2))
    links = {"AB": ab, "BC": bc, "CD": cd, "AD": int(rng.integers(abs(bc - cd) + ab + 3, bc + cd - ab - 3))}
    low, x, y = (int(rng.integers(0, 300)) for _ in range(3))
    turn = int(rng.integers(10, 200))
    data: Data = {key: f"{value} mm" for key, value in links.items()}
    data |= {"E": [f"{x} mm", f"{way * y} mm"], "side": "left" if way > 0 else "right"}
    return "straight-line", data | {"phi": [f"{way * low} deg", f"{way * (low + turn)} deg"]}


def _answers(kind: str, data: Data) -> dict[str, float]:
    try:
        found = solved(posed(kind, **data))
    except (AssemblyError, DeadPointError, ProblemFileError):
        return {}
    return {key: answer.drawn for key, answer in found.answers.items()}


@settings(max_examples=often(6), deadline=None)
@given(k=st.floats(1.05, 1.8), swing=st.floats(20, 90), x=st.floats(5, 150))
def test_a_on_a_line_on_the_other_side_gives_the_mirrored_crank_rockers(k: float, swing: float, x: float) -> None:
    """C₁ and C₂ lie evenly beside the y axis."""
    data = {"K": f"{k!r}", "CD": "100 mm", "swing": f"{swing!r} deg"}
    here, there = (_found("crank-rocker", data | {"A": f"on x = {way * x!r} mm"}) for way in (1, -1))
    assert sorted(one.verdict for one in here) == sorted(one.verdict for one in there)
    mine, its = (
        sorted((abs(one.pins[a].real), one.pins[a].imag) for one in all_ for a in _pivot(one)) for all_ in (here, there)
    )
    assert np.array(mine) == pytest.approx(np.array(its), abs=1e-6)


def _pivot(one: Candidate) -> list[str]:
    return [key for key in one.pins if key.startswith("A")]
