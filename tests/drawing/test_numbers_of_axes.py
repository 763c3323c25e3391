"""The numbers under an axis stand on one line: only what is in the way there, on a leader, stands elsewhere."""

from __future__ import annotations

from collections import defaultdict

import pytest

from tests.drawn_library import DRAFTED, drawn
from tests.each import Later, each
from vecpoly.board.paper.marks import Note
from vecpoly.drawing.figure import drawing
from vecpoly.methods.diagrams.axes import divisions, numbers

LEVEL = 0.05  # mm
UNDER = -1j


def numbered() -> list[str]:
    """Of a third of the library, and of the cams, the problems with numbers under an axis."""
    names = dict.fromkeys((*DRAFTED, "cam-flat-arm", "cam-rocker", "cam-undercut", "cam-heart", "7-5"))
    return [name for name in names if any(map(is_under, _marks(name)))]


def _marks(name: str) -> list[object]:
    return [mark for figure in drawn(name).construction.figures for mark in figure.marks]


def is_under(mark: object) -> bool:
    return isinstance(mark, Note) and mark.side == UNDER


@each(Later(numbered))
def test_the_numbers_under_an_axis_stand_on_one_line(name: str) -> None:
    for figure in drawn(name).construction.figures:
        if not any(map(is_under, figure.marks)):
            continue
        # by the height of the axis and the side of it where the middles of labels stand: there may be no room under it
        rows: dict[tuple[float, bool], set[float]] = defaultdict(set)
        for label in drawing(figure).labels:
            if label.want.level and label.foot is None and label.want.normals[0] == UNDER:
                height = label.want.feet[0].imag
                rows[round(height, 3), label.centre.imag > height].add(label.centre.imag)
        assert all(max(row) - min(row) < LEVEL for row in rows.values()), rows


@each(("cam-heart", "cam-flat-arm", "cam-flat-face", "cam-rocker", "cam-roller-offset", "cam-undercut"))
def test_no_number_of_a_cams_axis_is_moved_off_to_a_leader_by_a_tick(name: str) -> None:
    figures = [figure for figure in drawn(name).construction.figures if any(map(is_under, figure.marks))]
    labels = [label for figure in figures for label in drawing(figure).labels if label.want.level]
    assert labels and all(label.foot is None for label in labels)


@pytest.mark.parametrize(
    ("low", "high", "written"),
    [
        (0.0, 0.15, ["0", "0.05", "0.10", "0.15"]),
        (-0.1, 0.1, ["−0.10", "−0.05", "0", "0.05", "0.10"]),
        (0.0, 40.0, ["0", "10", "20", "30", "40"]),
        (0.0, 2.0, ["0", "0.5", "1.0", "1.5", "2.0"]),
        (0.0, 4e6, ["0", "1e+06", "2e+06", "3e+06", "4e+06"]),
    ],
)
def test_numbers_along_an_axis_have_one_count_of_decimals(low: float, high: float, written: list[str]) -> None:
    assert numbers(divisions(low, high, 4)) == written


@pytest.mark.parametrize("name", ["straight-hoecken", "press-flywheel", "function-log"])
def test_numbers_beside_an_axis_that_goes_up_have_one_count_of_decimals(name: str) -> None:
    """Of 0.05, 0.1, 0.15 the middle one is 0.10."""
    for figure in drawn(name).construction.figures:
        beside = [mark.words.zh for mark in figure.marks if isinstance(mark, Note) and mark.side == -1]
        assert len({len(text.partition(".")[2]) for text in beside if text[-1].isdigit() and text != "0"}) <= 1


@pytest.mark.parametrize("name", ["7-4", "7-5", "cam-heart"])
def test_the_angles_along_an_axis_go_up_by_one_step_from_nothing_to_the_end(name: str) -> None:
    axes = 0
    for figure in drawn(name).construction.figures:
        told = {mark.at.real: mark.words.en for mark in figure.marks if isinstance(mark, Note)}
        angles = [float(text.removesuffix("°")) for _, text in sorted(told.items()) if text.endswith("°")]
        if angles:
            step, axes = angles[0], axes + 1
            assert (
                angles[:-1] == [step * n for n in range(1, len(angles))] and 0 < angles[-1] - angles[-2] <= 1.4 * step
            )
            assert len(angles) >= 2
    assert axes
