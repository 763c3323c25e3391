"""A kind of figure is a value in one file, a task comes in by one door: shown with an M–φ diagram."""

from __future__ import annotations

import pickle
import subprocess
import sys
from collections.abc import Iterator
from copy import deepcopy
from dataclasses import dataclass, replace
from pathlib import Path
from typing import ClassVar

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pytest import MonkeyPatch

from tests.kinds.press import Press, PressDrawing, PressTruth, problem
from vecpoly.board.construction import Construction
from vecpoly.board.paper.extent import extent
from vecpoly.check.truth import knows, truth_of
from vecpoly.cli.commands.draw import placed
from vecpoly.drawing.backends.svg import to_svg
from vecpoly.drawing.figure import scale_box
from vecpoly.drawing.sheets.sheet import sheets
from vecpoly.errors import NoMethodError, NotAskedError, UnknownNameError
from vecpoly.figures import View, kind, register, scales, view_named, views
from vecpoly.methods.drawing import drawing_of, draws
from vecpoly.player.page import player
from vecpoly.problem.load import load, loads
from vecpoly.problem.problem import Problem
from vecpoly.record import from_json, to_json
from vecpoly.solution import Solution, solve
from vecpoly.task import task_of

ROOT = Path(__file__).resolve().parents[2]
MOMENTS = ((0.0, 0.0), (1.013, 907.0), (2.511, 893.0), (4.017, 151.0), (6.001, 0.0))
GIVEN = {"mu_M": 20.0, "mu_phi": 0.05}


@pytest.fixture(scope="module", autouse=True)
def work() -> Iterator[View]:
    """The new kind, on file while these claims are weighed."""
    with MonkeyPatch.context() as patch:
        patch.setattr(kind, "_VIEWS", dict(kind._VIEWS))
        from tests.kinds.work import WORK

        kind._VIEWS.setdefault(WORK.name, WORK)
        yield WORK


def drawn(by: str = "exact", **given: float) -> Solution:
    return solve(problem(*MOMENTS, scales=given or GIVEN), by=by)


def test_an_area_measured_with_both_scales_is_the_work() -> None:
    answer = drawn().answers["W"]
    assert answer.drawn == pytest.approx(answer.exact, rel=1e-9) and answer.exact == pytest.approx(
        0.5 * (1.013 * 907 + 1.498 * 1800 + 1.506 * 1044 + 1.984 * 151)
    )


@pytest.mark.parametrize("by", ["drafting", "pencil"])
def test_an_unsteady_hand_stays_within_its_expected_error(by: str) -> None:
    solution = drawn(by)
    answer = solution.answers["W"]
    assert not solution.suspect and 0 < abs(answer.drawn - answer.exact) <= answer.expected_error


def test_each_scale_is_of_one_direction_and_the_area_is_the_same_at_any() -> None:
    usual, wide, low = drawn(), drawn(mu_M=20.0, mu_phi=0.025), drawn(mu_M=40.0, mu_phi=0.05)
    size, wider, lower = (extent(one.construction.figures[0].marks) for one in (usual, wide, low))
    assert wider == pytest.approx((2 * size[0], size[1])) and lower == pytest.approx((size[0], size[1] / 2))
    assert usual.answers["W"].drawn == pytest.approx(wide.answers["W"].drawn) == pytest.approx(low.answers["W"].drawn)


@given(
    st.lists(st.tuples(st.floats(0.1, 1.0), st.floats(0.0, 1000.0)), min_size=3, max_size=6),
    st.floats(5.0, 50.0),
    st.floats(0.02, 0.1),
)
def test_any_diagram_of_moments_has_the_integral_for_its_area(
    steps: list[tuple[float, float]], mu: float, across: float
) -> None:
    moments = [(sum(wide for wide, _ in steps[:i]), moment) for i, (_, moment) in enumerate(steps)]
    found = solve(
        problem(*moments, scales={"mu_M": mu, "mu_phi": across}), by="exact", repeats=0, precise=False
    ).answers["W"]
    assert found.drawn == pytest.approx(found.exact, rel=1e-9, abs=1e-9)


def test_the_new_kind_stands_on_a_sheet_in_its_own_ink_with_both_scales_under_it(work: View) -> None:
    (sheet,) = sheets(drawn().construction)
    assert [one.view for one in sheet.figures] == [work] and work.ink.hex in to_svg(sheet.scene, "work")
    scale = drawn().construction.figures[0].scale
    assert (scale.per_mm, scale.right.symbol, scale.right.per_mm) == ("N·m/mm", "μ_{φ}", "rad/mm")
    assert scale_box(scale).width > scale_box(replace(scale, across=None)).width + 20


def test_the_player_and_the_command_line_know_the_new_kind(work: View) -> None:
    page = player(drawn()).html
    assert (
        f"--work:{work.ink.hex}" in page
        and placed("work") is work
        and placed("work:2") is not None
        and placed("play") is None
    )


def test_scales_that_nobody_gives_are_chosen_for_the_page(work: View) -> None:
    found = solve(problem(*MOMENTS, scales={}), by="drafting")
    wide, high = extent(found.construction.figures[0].marks)
    assert 40 < wide < 190 and 40 < high < 260 and not found.warnings


def test_a_scale_that_makes_a_speck_of_the_new_kind_is_told() -> None:
    (told,) = drawn(mu_M=200.0, mu_phi=2.0).warnings
    assert "too small" in told.en and "μ_M" in told.zh


def test_a_kind_is_one_value_after_pickle_copy_and_json(work: View) -> None:
    assert all(pickle.loads(pickle.dumps(view)) is deepcopy(view) is view for view in views()) and work in views()
    construction = drawn().construction
    assert from_json(to_json(construction), Construction).figures == construction.figures


def test_two_kinds_have_neither_one_name_nor_one_place(work: View) -> None:
    for twin in (replace(work, name="toil"), replace(work, order=70)):
        with pytest.raises(ValueError, match="two kinds of figure"):
            register(twin)
    with pytest.raises(UnknownNameError, match=r"'toil'; known: .*mechanism, velocity"):
        view_named("toil")


def test_a_sheet_of_the_house_is_in_the_order_of_the_textbook() -> None:
    assert [view.name for view in views()] == [
        *("displacement", "swing", "loop"),
        *("mechanism", "velocity", "acceleration", "body", "force", "radii", "turns", "work"),
        *("end-view", "couples", "products", "unbalances", "vibration", "vibration-speed", "hodograph"),
        *("torque", "inertia", "energy", "energy-mass", "indicator", "characteristic", "inverse", "speed"),
    ]
    assert list(scales()) == [
        *("mu_s", "mu_phi", "mu_psi", "mu_l", "mu_v", "mu_a", "mu_F", "mu_omega", "mu_M"),
        *("mu_r", "mu_Wl", "mu_W", "mu_U", "mu_A", "mu_V", "mu_P"),
        *("mu_J", "mu_E", "mu_y", "mu_t"),
    ]


def test_a_file_that_adds_a_kind_adds_its_scales_to_problem_files() -> None:
    """In a process of its own: the schema is made once, of the kinds on file."""
    text = (
        "from pathlib import Path; import vecpoly.figures as f; f.__path__.append(str(Path('tests/kinds')))\n"
        "import importlib; importlib.import_module('vecpoly.figures.work')\n"
        "from vecpoly.problem.load import loads\n"
        "text = Path('problems/ch3/3-9.yaml').read_text(encoding='utf-8')\n"
        "one = loads(text.replace('scales: {', 'scales: {mu_M: 5 N*m/mm, mu_phi: 2 deg/mm, ', 1))\n"
        "print(one.scales.given['mu_M'], one.scales.given['mu_phi'])\n"
    )
    done = subprocess.run([sys.executable, "-c", text], cwd=ROOT, capture_output=True, text=True, check=False)
    assert [float(value) for value in done.stdout.split()] == pytest.approx([5.0, 0.0349066], rel=1e-5), done.stderr


def test_all_sorts_of_problems_come_through_one_door() -> None:
    for name, asked in (("3-9", "v_D"), ("5-3", "eta")):
        task = task_of(load(name))
        assert asked in task.asked and set(task.truth.values) == set(task.asked)
    task = task_of(problem(*MOMENTS, scales=GIVEN))
    assert isinstance(task.drawing, PressDrawing) and isinstance(task.truth, PressTruth) and list(task.asked) == ["W"]
    assert [view.name for view in task.given(())] == ["work"]


@dataclass(frozen=True)
class Unheard:
    """A subject that nobody draws or checks."""

    kind: ClassVar[str] = "unheard"

    def quantities(self) -> tuple[()]:
        return ()

    def given(self) -> tuple[()]:
        return ()


def test_a_problem_of_a_sort_that_nobody_knows_is_refused_in_words() -> None:
    stranger: Problem = replace(problem(*MOMENTS, scales={}), subject=Unheard(), asks=())
    with pytest.raises(NoMethodError, match="no drawing on file solves a problem about a Unheard"):
        drawing_of(stranger)
    with pytest.raises(NotAskedError, match="nothing on file checks"):
        truth_of(stranger)


def test_what_is_drawn_or_known_of_one_sort_is_on_file_once() -> None:
    with pytest.raises(ValueError, match="two drawings"):
        draws(Press)(PressDrawing)
    with pytest.raises(ValueError, match="two truths"):
        knows(Press)(PressTruth)


def test_a_scale_to_the_right_that_many_figures_have_is_of_one_that_is_drawn() -> None:
    own = {view.mu.key for view in views()}
    across = [view for view in views() if view.across is not None and view.across.key not in own]
    assert len({view.across for view in across}) < len(across)
    for view in across:
        assert view.across is not None
        task = task_of(problem(*MOMENTS, scales={view.across.key: 0.05}))
        assert task.given({view}) == (view,), view.name


def test_of_a_machine_moments_have_a_sense_and_the_extremes_of_its_speed_none() -> None:
    task = task_of(loads(load("press-flywheel").text.replace("phi_max", "omega_max")))
    assert "omega_max" in task.asked and {key for key, rel in task.asked.items() if task.turns(rel)} == {"M_e", "M_d"}
