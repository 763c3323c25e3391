"""What is measured under a curve is what stands on paper: its outline is ink, and the curve encloses so much."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

from tests.cam_cases import device
from tests.cam_cases import drawn as paper
from tests.drawn_library import IDS, drawn
from tests.each import Later, each
from tests.laws import few
from vecpoly.board.acts import Area
from vecpoly.board.construction import Construction, Figure, Pane
from vecpoly.board.paper.marks import Curve, Segment, Vector
from vecpoly.devices.base import Device
from vecpoly.devices.dynamics.run_up import RunUp
from vecpoly.figures.characteristic import SPEED
from vecpoly.methods.devices.run_up.course import courses

Outline = npt.NDArray[np.complex128]
ONE = 1e-6  # mm: what is the same point
NEAR = 0.05  # mm: what lies on a line
LINE = [["0 rad/s", "100 N*m"], ["50 rad/s", "160 N*m"], ["80 rad/s", "0 N*m"]]
STEEP = {"M_k": "300 N*m", "s_k": "0.06", "n_s": "1000 r/min"}
RUNS: tuple[dict[str, Any], ...] = (
    {"load": ["4 N*m", "0.05 N*m*s"], "brake": "65 N*m", "start": "600 r/min"},
    {"load": ["0 N*m", "1 N*m*s"], "start": "900 r/min", "to": "20 r/min"},
    {"motor": ["240 N*m", "1.5 N*m*s"], "load": "60 N*m", "at": "1 s"},
    {"motor": STEEP, "load": ["20 N*m", "0 N*m*s", "0.001 N*m*s^2"]},
    {"motor": LINE, "load": ["10 N*m", "0.2 N*m*s"]},
)


def _figure(construction: Construction, act: Area) -> Figure:
    place = act.head.place
    view, name = (place.view, place.name) if isinstance(place, Pane) else (place, "")
    (found,) = (one for one in construction.figures if one.name == name and one.view is view)
    return found


def _lines(figure: Figure) -> list[Outline]:
    """The lines of a figure as they are drawn: a curve by the points that make it look round."""
    curves = [np.array(mark.points) for mark in figure.marks if isinstance(mark, Curve)]
    return [*curves, *(np.array([mark.a, mark.b]) for mark in figure.marks if isinstance(mark, Segment | Vector))]


def _led(corners: tuple[complex, ...], lines: list[Outline]) -> Outline:
    """The outline, along a curve wherever it runs from one of its points to another."""
    found: list[complex] = []
    for p, q in pairwise((*corners, corners[0])):
        found.append(p)
        for line in lines:
            i, k = (int(np.argmin(np.abs(line - at))) for at in (p, q))
            if abs(line[i] - p) < ONE and abs(line[k] - q) < ONE:
                found += [*(line[i:k] if i < k else line[k + 1 : i + 1][::-1])]
                break
    return np.array(found)


def _size(outline: Outline) -> float:
    return float(abs(np.sum((outline.conj() * np.roll(outline, -1)).imag)) / 2)


def _far(at: complex, line: Outline) -> float:
    a, b = line[:-1], line[1:]
    share = np.clip(((at - a) * (b - a).conj()).real / np.maximum(np.abs(b - a) ** 2, 1e-12), 0.0, 1.0)
    return float(np.min(np.abs(at - a - share * (b - a))))


def _stands(construction: Construction, act: Area) -> None:
    lines = _lines(_figure(construction, act))
    outline = _led(act.outline, lines)
    assert _size(outline) == pytest.approx(act.mm2, rel=2e-4, abs=0.02), act.head.key
    middles = (outline + np.roll(outline, -1)) / 2
    assert all(min(_far(complex(at), line) for line in lines) < NEAR for at in middles), act.head.key


def _areas(construction: Construction) -> list[Area]:
    return [act for act in construction.acts if isinstance(act, Area)]


@each(Later(lambda: [name for name in IDS if _areas(drawn(name).construction)]))
def test_an_area_that_is_read_is_the_one_that_the_lines_on_paper_enclose(name: str) -> None:
    for act in _areas(drawn(name).construction):
        _stands(drawn(name).construction, act)


def _run(data: dict[str, Any]) -> Device:
    return device("run-up", J="2 kg*m^2", **data)


@each(few(RUNS, 1))
def test_both_areas_of_every_run_are_those_under_the_curves_as_drawn(data: dict[str, Any]) -> None:
    construction = paper(_run(data))
    assert len(_areas(construction)) >= 2
    for act in _areas(construction):
        _stands(construction, act)


@each(RUNS)
def test_the_speed_is_drawn_at_every_time_as_it_is_then(data: dict[str, Any]) -> None:
    run = _run(data)
    assert isinstance(run, RunUp)
    figures = [one for one in paper(run).figures if one.view is SPEED]
    for course, figure in zip(courses(run), figures, strict=True):
        (line,) = (np.array(mark.points) for mark in figure.marks if isinstance(mark, Curve))
        speeds = np.linspace(course.low, course.high, 4001)
        slow = np.abs(course.driving(speeds) - course.resisting(speeds))
        times = np.concatenate([[0.0], np.cumsum((1 / slow[1:] + 1 / slow[:-1]) / 2 * np.diff(speeds))]) * run.J.si
        if course.goal < course.start:
            times = times[-1] - times
        assert figure.scale is not None and figure.scale.right is not None
        exact = times / figure.scale.right.value + 1j * speeds / figure.scale.value
        assert max(_far(complex(at), exact) for at in line) < NEAR
        assert max(_far(complex(at), line) for at in exact[::100]) < NEAR
