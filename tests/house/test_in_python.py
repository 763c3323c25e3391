"""The Python surface: the examples of docs/python.md, problems and mechanisms as data, resolvers, cycles as arrays."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import vecpoly
from tests.laws import few
from vecpoly import build_mechanism, load, load_assignment, loads, problem
from vecpoly.check.table.whole import check_table
from vecpoly.errors import (
    ArgumentError,
    MissingPackageError,
    MobilityError,
    ProblemFileError,
    UnknownNameError,
    VecpolyError,
)
from vecpoly.problem.text.held import Held

DOCS = Path(__file__).resolve().parents[2] / "docs"
FOUR_BAR: dict[Any, Any] = {
    "id": "t",
    "title": "t",
    "frame": {"A": (0, 0), "D": (0.08, 0)},
    "links": {1: {"AB": 0.03}, 2: {"BC": 0.07}, 3: {"DC": 0.06}},
    "input": {"link": 1, "phi": "60 deg", "omega": 10},
    "branch": ["C left of BD"],
    "find": ["v_C"],
}
TEXT = (
    "id: t\ntitle: t\nframe: {A: [0 mm, 0 mm], D: [80 mm, 0 mm]}\n"
    "links: {1: {AB: 30 mm}, 2: {BC: 70 mm}, 3: {DC: 60 mm}}\n"
    "input: {link: 1, phi: 60 deg, omega: 10 rad/s}\nbranch: [C left of BD]\nfind: [v_C]\n"
)


@pytest.mark.parametrize("page", few(["python.md", "python.zh.md"], 2))
def test_the_examples_of_the_page_run(page: str) -> None:
    blocks = re.findall(r"```python\n(.*?)```", (DOCS / page).read_text("utf-8"), re.S)
    assert len(blocks) == 9
    exec("\n".join(blocks), {"__name__": "page"})


def test_both_pages_have_the_same_code() -> None:
    english, chinese = (
        re.findall(r"`[^`\n]+`", (DOCS / page).read_text("utf-8")) for page in ("python.md", "python.zh.md")
    )
    assert {one for one in english if "_" in one} == {one for one in chinese if "_" in one}


def test_numbers_in_si_are_the_quantities_of_a_file() -> None:
    assert (
        problem(FOUR_BAR).mechanism
        == loads(TEXT).mechanism
        == build_mechanism(**{key: FOUR_BAR[key] for key in ("frame", "links", "input", "branch")})
    )
    assert loads(problem(FOUR_BAR).text).mechanism == loads(TEXT).mechanism


def test_the_package_is_the_function_too() -> None:
    assert vecpoly.problem(FOUR_BAR) == problem(FOUR_BAR)
    assert callable(sys.modules["vecpoly.problem"])


@pytest.mark.parametrize(
    ("change", "error", "said"),
    [
        (
            {"links": {1: {"AB": -0.03}}},
            ProblemFileError,
            r"<data>: links\.1\.AB: '-0\.03 m' must be greater than zero",
        ),
        ({"links": {1: {"AB": "30"}}}, ProblemFileError, r"has no unit"),
        ({"frmae": {}}, ProblemFileError, r"did you mean 'frame'"),
        ({"find": ["v_Z"]}, ProblemFileError, r"find\[0\]"),
        ({"title": object()}, ArgumentError, r"texts, numbers, lists and dictionaries, not object"),
        ({"frame": {"A": 3}}, ArgumentError, r"two coordinates"),
        ({"title": "a\u202eb"}, ProblemFileError, r"U\+202E"),
        (
            {"input": [{"link": 1, "phi": 1.0, "omega": 1.0}, {"link": 3, "phi": 1.0, "omega": 1.0}]},
            MobilityError,
            r"2 drives are given",
        ),
    ],
)
def test_data_pass_the_checks_of_a_file(change: dict[str, Any], error: type[VecpolyError], said: str) -> None:
    with pytest.raises(error, match=said):
        problem(FOUR_BAR | change)


def test_data_that_hold_themselves_are_refused() -> None:
    endless: dict[str, Any] = dict(FOUR_BAR)
    endless["links"] = endless
    with pytest.raises(ArgumentError, match="nested too deeply"):
        problem(endless)
    turning: list[Any] = []
    turning.append(turning)
    with pytest.raises(ArgumentError, match="nested too deeply"):
        problem(FOUR_BAR | {"find": turning})
    with pytest.raises(ArgumentError, match="a dictionary"):
        problem("id: t")  # type: ignore[arg-type]


def test_a_resolver_gives_what_is_extended_and_may_extend_again() -> None:
    held = {"a": "id: a\ntitle: a\nextends: b\n", "b": "id: b\ntitle: b\nextends: D-1\nlinks: {1: {AB: 31 mm}}\n"}
    found = load("a", resolver=held.get)
    assert (found.id, found.parameters["AB"], found.path) == ("a", "31 mm", None)
    assert (
        loads(held["a"], resolver=held.get).mechanism
        == problem({"id": "c", "title": "c", "extends": "b"}, resolver=held.get).mechanism
        == found.mechanism
    )


def test_a_resolver_is_asked_before_the_library_and_passes_on_what_it_has_not() -> None:
    asked: list[str] = []
    assert load("D-1", resolver=asked.append).id == "D-1"
    assert asked == ["D-1"]
    assert load("D-1", resolver={"D-1": TEXT}.get).id == "t"


@pytest.mark.parametrize(
    ("held", "said"),
    [
        ({"a": "id: a\ntitle: a\nextends: a\n"}, "in a circle"),
        ({"a": "id: a\ntitle: a\nextends: b\n", "b": "id: b\ntitle: b\nextends: a\n"}, "in a circle"),
        ({"a": "id: a\ntitle: a\nextends: nowhere.yaml\n"}, "lies outside the library"),
        ({"a": b"\xff\xfe"}, "not UTF-8"),
        ({"a": 3}, "must give a text or None"),
    ],
)
def test_what_a_resolver_gives_passes_the_checks_of_a_file(held: dict[str, Any], said: str) -> None:
    with pytest.raises(ProblemFileError, match=said):
        load("a", resolver=held.get)


def test_an_assignment_and_its_problems_are_loaded_from_memory() -> None:
    held = {
        "sheet.yaml": "title: t\nproblems: [one.yaml, {problem: one.yaml, id: two, links: {1: {AB: 31 mm}}}, D-1]\n",
        "one.yaml": TEXT,
    }
    assert [one.id for one in load_assignment("sheet.yaml", resolver=held.get).problems] == ["t", "two", "D-1"]


def test_a_table_is_checked_from_memory() -> None:
    original = load("A-16")
    table = original.tables[0]
    assert isinstance(table, Path)
    held: dict[str, str | bytes] = {
        "mine.yaml": "id: mine\ntitle: mine\nextends: A-16\ntables: [mine.csv]\n",
        "mine.csv": table.read_bytes(),
    }
    mine = load("mine.yaml", resolver=held.get)
    assert mine.tables == (Held("mine.csv", held["mine.csv"]),) and mine.files == mine.read  # type: ignore[arg-type]
    assert check_table(mine, mine.tables[0]).whole == check_table(original, table).whole


def test_a_cycle_is_arrays_and_a_data_frame() -> None:
    turn = load("D-1").cycle(n=37)
    found = turn.arrays("omega_3", "v_C")
    assert (
        list(found) == ["phi_1", "omega_3", "v_C"]
        and found["v_C"].dtype == np.complex128
        and all(len(values) == 37 for values in found.values())
    )
    assert set(turn.arrays()) == {turn.drive.key, *(column.key for column in turn.columns)}
    pandas = pytest.importorskip("pandas")
    frame = turn.to_frame("omega_3", "v_C")
    assert (
        isinstance(frame, pandas.DataFrame)
        and list(frame) == ["omega_3", "v_C.x", "v_C.y"]
        and frame.index.name == "phi_1"
    )
    assert np.array_equal(frame["v_C.x"], found["v_C"].real) and np.array_equal(frame.index, found["phi_1"])


def test_without_pandas_a_frame_is_refused_with_what_to_do(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(MissingPackageError, match="pip install pandas"):
        load("D-1").cycle(n=3).to_frame()


def test_a_device_has_no_cycle_and_unknown_ids_are_refused() -> None:
    with pytest.raises(MobilityError):
        load("5-1").cycle()
    with pytest.raises(UnknownNameError):
        load("nothing", resolver=lambda name: None)


@pytest.mark.parametrize("teeth", [20, 20.0, np.int64(20)])
def test_whole_numbers_of_a_program_are_teeth_drivers_and_firing_orders(teeth: Any) -> None:
    data = {"sun": teeth, "planet": 22, "ring": 64, "m": "1 mm", "omega_1": "10 rad/s ccw", "omega_3": "0 rad/s"}
    train = problem({"id": "t", "title": "t", "device": "epicyclic", "data": data})
    assert train.data["data"]["sun"] == "20" and train.vary(sun=24, planet=20.0).parameters["planet"] == "20"
    engine = load("engine-four")
    order = [int(number) for number in engine.data["data"]["order"]]
    assert problem(engine.data | {"data": engine.data["data"] | {"order": order}}).subject == engine.subject


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"links": {"1": {"AB": "x" * 5000}}}, "links.1.AB: 5000 characters where at most 200"),
        ({"statement": {"zh": "文" * 5000, "en": "text"}}, "statement.zh: 5000 characters where at most 4000"),
        ({"links": {"x" * 5000: {"AB": 1}}}, "links: 5000 characters where at most 200"),
        ({"find": ["v_B"] * 300}, "find: 300 entries where at most 200"),
        ({"frame": {f"P{n}": (n, 0) for n in range(300)}}, "frame: 300 entries where at most 200"),
    ],
)
def test_data_are_no_longer_than_a_file_may_be(change: dict[str, object], said: str) -> None:
    """A message repeated whatever was handed in, all of it."""
    with pytest.raises(ArgumentError, match=re.escape(said)) as refused:
        problem(FOUR_BAR | change)
    assert "最多" in refused.value.words.zh and len(str(refused.value)) < 120
