"""GeoGebra files, read by a second reader: letters and answers are those of `solve`, wherever the slider stands."""

from __future__ import annotations

import cmath
from collections import defaultdict
from dataclasses import replace
from functools import cache
from math import degrees
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from tests.ggb_reader import construction, evaluated
from tests.laws import few, often
from vecpoly import load, solve
from vecpoly.board.acts import Locate, Swing
from vecpoly.board.construction import View
from vecpoly.board.place import Pane, view_of
from vecpoly.cli.app import app
from vecpoly.errors import NoMethodError
from vecpoly.export.geogebra.document import to_ggb
from vecpoly.export.recording import record
from vecpoly.problem.problem import Problem, Scales
from vecpoly.solution import Solution

SEVERAL = (
    "3-5",
    "3-7a",
    "3-8",
    "3-9",
    "3-10",
    "3-11",
    "3-12",
    "3-13",
    "3-14",
    "A-27",
    "A-30",
    "whitworth-quick-return",
    "jansen-leg",
    "geared-five-bar",
    "cam-roller",
    "hypocycloid-drive",
    "oldham-coupling",
    "elliptic-trammel",
    "8-2a",
    "8-2b",
)
STEM = {"omega": "ω", "alpha": "α", "gamma": "γ"}
END = {View.MECHANISM: "", View.VELOCITY: "v", View.ACCELERATION: "a"}


@cache
def exported(problem: str) -> bytes:
    return to_ggb(record(load(problem)))


@cache
def given_scales(problem: str) -> Scales:
    """Those of the sheet in the given position: the file keeps them."""
    figures = {
        f.view: f.scale.value for f in solve(load(problem), by="exact", repeats=0, precise=False).construction.figures
    }
    return Scales({view.mu.key: value for view, value in figures.items()})


def moved(problem: Problem, by: float) -> Problem:
    """The same with its input elsewhere, by rad, or by so many times 30 mm."""
    drive = problem.mechanism.drive
    step = 0.03 * by if drive.slide else by
    return replace(
        problem,
        scales=given_scales(problem.id),
        subject=replace(problem.mechanism, drives=(replace(drive, position=drive.position + step),)),
    )


def slider(problem: Problem) -> float:
    drive = problem.mechanism.drive
    return 1e3 * drive.position if drive.slide else degrees(drive.position - drive.lead)


def letters(solution: Solution) -> dict[str, tuple[View, complex]]:
    """The labels of all lettered points, and where they lie on their figure."""
    found: dict[str, tuple[View, complex]] = {}
    for act in solution.construction.acts:
        if isinstance(act, Locate) and act.head.place is not None and not isinstance(act.head.place, Pane):
            view = view_of(act.head.place)
            rest = act.key[1:].replace("'", "") + END[view]
            found.setdefault(act.key[0] + (f"_{{{rest}}}" if rest else ""), (view, act.at))
    return found


def same_letters(solution: Solution, known: dict[str, Any]) -> int:
    """The lettered points compared, mm on paper."""
    anchor = {View.MECHANISM: known["O_{m}"], View.VELOCITY: known.get("p_{v}"), View.ACCELERATION: known.get("p_{a}")}
    for label, (view, at) in letters(solution).items():
        assert known[label] - anchor[view] == pytest.approx(at, rel=1e-9, abs=1e-9), label
    return len(letters(solution))


def same_answers(solution: Solution, known: dict[str, Any]) -> int:
    """The answers compared, SI."""
    for key, answer in solution.answers.items():
        stem, _, index = key.partition("_")
        if answer.drawn_vector is None:
            label = STEM[stem] + (f"_{{{index}}}" if index else "")
            assert known[label] == pytest.approx(answer.drawn, rel=1e-9, abs=1e-9), key
        else:
            found = complex(known[f"{stem}_{{{index}x}}"], known[f"{stem}_{{{index}y}}"])
            assert found == pytest.approx(answer.drawn_vector, rel=1e-9, abs=1e-9 * max(1.0, abs(answer.exact))), key
    return len(solution.answers)


@pytest.mark.parametrize("problem", few(SEVERAL, 14))
@pytest.mark.parametrize("by", [1.1, 0.0, -0.27][: often(1)])
def test_wherever_the_slider_stands_letters_and_answers_are_those_of_solve(problem: str, by: float) -> None:
    there = moved(load(problem), by)
    solution = solve(there, by="exact", repeats=0, precise=False)
    known = evaluated(exported(problem), slider(there))
    assert same_letters(solution, known) >= 4
    assert same_answers(solution, known) >= 1


@pytest.mark.parametrize("problem", few(["3-5", "jansen-leg"], 2))
def test_every_arc_swung_on_the_sheet_is_an_arc_about_its_centre_counter_clockwise_from_end_to_end(
    problem: str,
) -> None:
    given = load(problem)
    known = evaluated(exported(problem), slider(given))
    at = known["O_{m}"]
    made = [one.find("output") for one in construction(exported(problem)) if one.get("name") == "CircleArc"]
    arcs = [one.get("a0", "") for one in made if one is not None]
    drawn = [(centre - at, first - centre, last - centre) for centre, first, last in (known[arc] for arc in arcs)]
    acts = solve(replace(given, scales=given_scales(problem)), by="exact", repeats=0, precise=False).construction.acts
    swung = [
        (act.centre, *(cmath.rect(act.radius, angle) for angle in sorted((act.start, act.start + act.sweep))))
        for act in acts
        if isinstance(act, Swing)
    ]
    assert swung
    for one in swung:
        assert any(other == pytest.approx(one, rel=1e-9, abs=1e-9) for other in drawn), one


@pytest.mark.parametrize("problem", few(SEVERAL, 9))
def test_the_slider_stands_where_the_problem_puts_it_and_stays_within_its_range(problem: str) -> None:
    one = next(e for e in construction(exported(problem)) if e.find("slider") is not None)
    held, bounds = one.find("value"), one.find("slider")
    assert held is not None and bounds is not None
    value, low, high = float(held.get("val", "")), float(bounds.get("min", "")), float(bounds.get("max", ""))
    off = value - slider(load(problem))
    assert low <= value <= high
    assert off == pytest.approx(0.0, abs=1e-9) or (
        high - low == pytest.approx(360.0) and off % 360 == pytest.approx(0.0, abs=1e-9)
    )
    assert next(iter(one)) is held  # a value that comes after the sign that it is shown would be clipped to −5 … 5


def test_vectors_run_from_letter_to_letter() -> None:
    data = exported("3-9")
    known = evaluated(data)
    ends = [
        [known[label], known[other]] for label, other in (("p_{v}", "b_{v}"), ("p_{v}", "e_{v}"), ("p_{a}", "e_{a}"))
    ]
    drawn = [
        known[label] for one in construction(data) if one.get("type") == "vector" for label in [one.get("label", "")]
    ]
    assert all(end in drawn for end in ends)


def test_a_pole_that_is_dragged_takes_its_polygon_with_it_and_changes_no_answer() -> None:
    data = exported("3-12")
    known, answers = (
        evaluated(data),
        [label for label in evaluated(data) if label.startswith(("v_", "a_", "ω_", "α_", "m_"))],
    )
    root = construction(data)
    pole = next(one for one in root if one.get("label") == "p_{v}").find("coords")
    assert pole is not None
    dragged = data_with(data, pole.attrib["x"], "777.0")
    other = evaluated(dragged)
    assert other["b_{v}"] - other["p_{v}"] == pytest.approx(known["b_{v}"] - known["p_{v}"])
    assert other["b_{v}"] != known["b_{v}"]
    assert len(answers) > 10 and all(other[label] == pytest.approx(known[label]) for label in answers)


def data_with(data: bytes, old: str, new: str) -> bytes:
    """The file with the pole of the velocity polygon elsewhere."""
    import io
    import zipfile

    with zipfile.ZipFile(io.BytesIO(data)) as folder:
        text = folder.read("geogebra.xml").decode()
    assert f'<coords x="{old}"' in text  # the pole is written before what coincides with it
    into = io.BytesIO()
    with zipfile.ZipFile(into, "w") as folder:
        folder.writestr("geogebra.xml", text.replace(f'<coords x="{old}"', f'<coords x="{new}"', 1))
    return into.getvalue()


def test_points_are_made_of_points_not_of_numbers() -> None:
    made = [
        one.get("exp", "") for one in construction(exported("3-9")) if one.get("type") == "point" and one.get("exp")
    ]
    assert sum("x(" in text or "t_{" in text for text in made) >= 10


def test_labels_are_given_once_and_before_they_are_used() -> None:
    for problem in few(SEVERAL, 9):
        labels = [one.get("label") for one in construction(exported(problem)) if one.tag == "element"]
        assert len(labels) == len(set(labels))


def test_letters_at_one_place_are_written_on_different_sides_of_it() -> None:
    known, sides = evaluated(exported("3-9")), defaultdict(list)
    for one in construction(exported("3-9")).iterfind("element[@type='point']"):
        if one.find("show[@label='true']") is not None:
            off, at = one.find("labelOffset"), known[one.get("label", "")]
            sides[round(at.real, 6), round(at.imag, 6)].append(None if off is None else (off.get("x"), off.get("y")))
    several = [some for some in sides.values() if len(some) > 1]
    assert several and all(len(set(some)) == len(some) for some in several)


def test_equal_drawings_are_equal_files() -> None:
    assert to_ggb(record(load("3-14"))) == exported("3-14")


@pytest.mark.parametrize(
    ("problem", "code"), [("class-iii", "export-trial"), ("5-2", "export-device"), ("tipper", "export-drive")]
)
def test_what_does_not_follow_an_input_is_refused(problem: str, code: str) -> None:
    with pytest.raises(NoMethodError) as refused:
        record(load(problem))
    assert refused.value.code == code


def test_what_would_not_follow_is_left_out_and_said(tmp_path: Path) -> None:
    out = tmp_path / "x.ggb"
    done = CliRunner().invoke(app, ["export", "3-2", "--lang", "en", "-o", str(out)])
    assert done.exit_code == 0 and "P_12" in done.output and "left out" in done.output
    assert not any(label.startswith("P_{12") for label in evaluated(out.read_bytes()))


def test_the_command_writes_the_file_whole_or_not_at_all(tmp_path: Path) -> None:
    out = tmp_path / "new" / "3-9.ggb"
    assert CliRunner().invoke(app, ["export", "3-9", "-o", str(out)]).exit_code == 0
    assert out.read_bytes() == exported("3-9")
    assert CliRunner().invoke(app, ["export", "5-2", "-o", str(tmp_path / "y.ggb")]).exit_code == 2
    assert CliRunner().invoke(app, ["export", "3-9", "-o", str(tmp_path / "y.dxf")]).exit_code == 2
    assert [path.name for path in tmp_path.iterdir()] == ["new"]


def test_the_help_is_in_both_languages() -> None:
    assert "滑动条" in CliRunner().invoke(app, ["--lang", "zh", "export", "--help"]).output
    assert "slider" in CliRunner().invoke(app, ["export", "--help"]).output


def test_an_ordinary_sheet_records_nothing() -> None:
    from vecpoly.plane.derived import moves

    acts = solve(load("3-9"), by="exact", repeats=0, precise=False).construction.acts
    assert not any(moves(act.at) for act in acts if isinstance(act, Locate))
