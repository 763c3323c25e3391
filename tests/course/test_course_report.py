"""The course report: its formulas compute what they print, and the document is one that a student could hand in."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from math import pi
from pathlib import Path
from typing import cast

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pypdf import PdfReader
from pypdf.generic import DictionaryObject
from pypdfium2 import PdfDocument, PdfPage

from tests.each import Later, each
from tests.laws import few
from tests.studies import course_report, course_words, stations, studied
from vecpoly import oracle
from vecpoly.algebra.formula import plain
from vecpoly.analytic.expr import ONE, ZERO, Const, Num, Sum, Var
from vecpoly.analytic.functions import cos, sin
from vecpoly.errors import NotAskedError
from vecpoly.findings.conditioning import conditioning
from vecpoly.findings.study.study import Study
from vecpoly.mechanism.groups.assur import decompose
from vecpoly.mechanism.model import Mechanism
from vecpoly.names import At
from vecpoly.problem.library import library
from vecpoly.problem.load import load
from vecpoly.report.course.results.positions import at_position
from vecpoly.report.document import write_report
from vecpoly.report.flow.listing import Listing
from vecpoly.report.flow.table import DataTable
from vecpoly.solution import solve
from vecpoly.words import Lang

CLOSED = {"RRR", "RRP", "RPR", "PRP", "RPP", "RRG", "gear"}


@cache
def closed() -> tuple[str, ...]:
    """The mechanisms of the first chapters and of the homework whose groups are solved in closed form."""
    some = (entry.id for entry in library() if entry.path.parent.name in ("ch3", "ch4", "homework"))
    made = ((name, load(name).subject) for name in some)
    of_links = ((name, one) for name, one in made if isinstance(one, Mechanism))
    return tuple(name for name, one in of_links if {group.kind for group in decompose(one)} <= CLOSED)


def test_the_library_has_every_kind_of_dyad_and_a_held_gear() -> None:
    assert {group.kind for name in closed() for group in decompose(load(name).mechanism)} == CLOSED


@each(Later(lambda: few(closed(), 4)))
def test_the_printed_formulas_give_the_oracle_s_motion(name: str) -> None:
    """Places, angles, velocities, accelerations of every letter and link, at forty random positions;
    away from dead points."""
    it = studied(name)
    share = np.random.default_rng(1).uniform(0.01, 0.99, 40)
    phi = it.whole.low + share * (it.whole.high - it.whole.low)
    phi = phi[well_conditioned(it, phi)]
    env, exact, told = it.model.values(phi), oracle.solve(it.mech, phi), 0
    for link in it.mech.links:
        for letter in (letter for letter in link.points if letter not in it.mech.frame):
            for names, there in (
                ((f"x_{{{letter}}}", f"y_{{{letter}}}"), exact.position(At(letter))),
                ((f"v_{{{letter}x}}", f"v_{{{letter}y}}"), exact.velocity(At(letter))),
                ((f"a_{{{letter}x}}", f"a_{{{letter}y}}"), exact.acceleration(At(letter))),
            ):
                found = env[names[0]] + 1j * np.asarray(env[names[1]])
                assert np.max(np.abs(found - there)) < 1e-9 * max(it.mech.scale, float(np.abs(there).max())), names
                told += 1
        told += sum(
            same(env, f"{stem}_{{{it.model_name(link.name)}}}", value)
            for stem, value in (("ω", exact.omega(link.name)), ("α", exact.alpha(link.name)))
        )
        if (symbol := f"φ_{{{it.model_name(link.name)}}}") in env:
            assert np.max(np.abs(np.exp(1j * np.asarray(env[symbol])) - np.exp(1j * exact.angle(link.name)))) < 1e-9
    assert told >= len(it.mech.links) and len(phi) > 20
    assert all(float(np.max(gap)) < 1e-8 * max(1.0, it.mech.drive.rate**2) for _, gap in it.model.gaps(phi))


def same(env: Mapping[str, object], symbol: str, value: np.ndarray) -> bool:
    """Whether the formulas tell it, and then rightly; what they leave out is zero."""
    found = np.asarray(env.get(symbol, 0.0), np.float64)
    assert np.max(np.abs(found - value)) < 1e-8 * max(1.0, float(np.abs(value).max())), symbol
    return symbol in env


def well_conditioned(it: Study, phi: np.ndarray) -> np.ndarray:
    """Where every group's determinant is more than a fiftieth of its largest."""
    env = it.model.values(phi)
    shares = [
        np.abs(one.group.determinant.value(env)) / one.largest
        for one in conditioning(it)
        if one.group.determinant is not None
    ]
    return np.asarray(
        np.logical_and.reduce([np.ones(phi.shape, bool), *(np.broadcast_to(s > 0.02, phi.shape) for s in shares)])
    )


def test_the_other_sign_of_the_assembly_is_another_assembly() -> None:
    """The sign that is printed matters: with σ turned round, C is not where the oracle has it."""
    it = studied("A-27")
    equations = [e for g in it.model.groups for e in g.equations]
    signs = {c for g in it.model.groups for c in g.constants if c.symbol == "σ"}
    assert signs == {Const("σ", -1.0, "")}
    angle = next(e for e in equations if plain(e.left.node) == "φ_2" and e.gives)
    env = dict(it.model.values(np.array([1.0])))
    other = 2 * np.arctan2(
        env["B_0"] + np.sqrt(env["A_0"] ** 2 + env["B_0"] ** 2 - env["C_0"] ** 2), env["A_0"] + env["C_0"]
    )
    assert abs(np.exp(1j * other) - np.exp(1j * angle.right.value(env)))[0] > 0.1


def test_formulas_are_printed_in_textbook_notation_without_what_vanishes() -> None:
    printed = [plain(e.node) for g in studied("A-27").model.groups for e in g.equations]
    for text in (
        "x_B = l_AB\u2009cos\u2009φ_1",
        "v_Bx = −ω_1\u2009y_B",
        "A_0 = −2\u2009l_BC\u2009x_B",
        "ω_5 = (v_Fy\u2009cos\u2009φ_5 − v_Fx\u2009sin\u2009φ_5)/(s_45)",
    ):
        assert text in printed, printed


@given(turn=st.floats(-3, 3), quarters=st.integers(-4, 4))
def test_right_angles_are_folded_into_cos_and_sin(turn: float, quarters: int) -> None:
    angle = Var("φ_1") + Const("γ_1", quarters * pi / 2, "rad")
    for made, function in ((cos(angle), np.cos), (sin(angle), np.sin)):
        assert made.value({"φ_1": turn}) == pytest.approx(function(turn + quarters * pi / 2), abs=1e-12)
        assert "γ" not in plain(made.node)


def test_sums_and_products_leave_out_zeros_and_ones() -> None:
    x = Var("x_B")
    assert (x - ZERO, x + Const("x_A", 0.0), x * ONE, x * ZERO) == (x, x, x, ZERO)
    assert plain((ZERO - x).node) == "−x_B"
    assert plain((Num(2.0) * (x - Var("x_C")) * -x).node) == "−2\u2009x_B\u2009(x_B − x_C)"
    assert isinstance(x - (Var("y_B") - Var("y_C")), Sum)
    assert plain((x - (Var("y_B") - Var("y_C"))).node) == "x_B − y_B + y_C"


@pytest.mark.parametrize("name", ["A-27", "3-11", "3-12", "4-3a", "six-bar-dynamic"])
def test_a_problem_at_another_position_is_assembled_as_on_the_way_there(name: str) -> None:
    it = studied(name)
    for share in np.linspace(0.05, 0.95, 7):
        phi = float(it.whole.low + share * (it.whole.high - it.whole.low))
        moved, way = at_position(it, phi).mechanism, oracle.solve(it.mech, np.array([phi]))
        own = oracle.solve(moved)
        for letter in (letter for link in moved.links for letter in link.points):
            assert abs(complex(own.position(At(letter))) - complex(way.position(At(letter))[0])) < 1e-9 * it.mech.scale


def test_drawings_over_the_cycle_agree_with_the_exact_values() -> None:
    it = studied("A-27")
    found = stations("A-27")
    assert len(found.stations) == 24 and not found.refused
    assert 1e-6 < found.worst(it) < 0.02  # drawn, not copied
    exact = oracle.solve(it.mech, np.array([s.phi for s in found.stations])).alpha("5")
    assert np.allclose([s.exact["alpha_5"] for s in found.stations], exact)


def test_the_worst_conditioned_position_of_a_slotted_link_is_its_shortest_arm() -> None:
    it = studied("A-27")
    slotted = conditioning(it)[-1]
    motion = oracle.solve(it.mech, np.radians(np.arange(0.0, 360.0, 0.5)))
    arm = np.abs(motion.position("F") - motion.position("G"))
    assert (
        slotted.ratio == pytest.approx(arm.min() / arm.max(), rel=1e-4)
        and slotted.least <= arm.min()
        and slotted.largest >= arm.max() * (1 - 1e-12)
    )
    assert np.degrees(slotted.phi) == pytest.approx(0.5 * int(np.argmin(arm)), abs=0.5)
    assert slotted.phi % np.radians(0.5) > 1e-4  # between two positions of the grid


@pytest.fixture(scope="module", params=few(["zh", "en"], 2))
def report(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("course") / f"A-27.{request.param}.pdf"
    path.write_bytes(course_report("A-27", request.param))
    return path


@dataclass(frozen=True, slots=True)
class Read:
    """A page: its size, its text, and the boxes of its letters (left, bottom, right, top; from the lower left)."""

    size: tuple[float, float]
    text: str
    boxes: tuple[tuple[float, float, float, float], ...]


@cache
def pages(path: Path) -> tuple[Read, ...]:
    """The pages, read once."""
    with PdfDocument(path) as document:
        return tuple(_read(page) for page in document)


def _read(page: PdfPage) -> Read:
    told = page.get_textpage()
    boxes = tuple(told.get_charbox(n, loose=True) for n in range(told.count_chars()))
    return Read(page.get_size(), told.get_text_range(), boxes)


@cache
def texts(path: Path) -> tuple[str, ...]:
    """The text of every page, without blanks."""
    return tuple(re.sub(r"\s", "", page.text) for page in pages(path))


def test_the_report_of_a_27_has_fifteen_to_thirty_pages_none_nearly_empty(report: Path) -> None:
    assert 15 <= len(pages(report)) <= 30
    for number, page in enumerate(pages(report), 1):
        assert len({round(bottom) for _, bottom, _, _ in page.boxes}) >= 8, number


def test_nothing_of_the_report_lies_outside_its_pages(report: Path) -> None:
    for page in pages(report):
        wide, high = page.size
        assert page.boxes
        for left, bottom, right, top in page.boxes:
            assert left >= 0 and right <= wide and top <= high and bottom >= 0


def test_every_font_of_the_report_is_embedded(report: Path) -> None:
    for page in PdfReader(report).pages:
        for font in cast("DictionaryObject", page["/Resources"]).get("/Font", {}).values():
            descriptor = font.get_object().get("/FontDescriptor")
            assert descriptor is not None and "/FontFile2" in descriptor.get_object()


def test_the_contents_name_the_page_on_which_each_chapter_begins(report: Path) -> None:
    lines = pages(report)[1].text.splitlines()
    pairs = ((head.strip(), page) for head, page in pairwise(lines) if page.isdigit())
    entries = [(head, page) for head, page in pairs if not head.isdigit() and not head.endswith("/")]
    assert len(entries) >= 18
    for head, page in entries:
        assert re.sub(r"\s", "", head) in texts(report)[int(page) - 1], (head, page)


@pytest.mark.parametrize("lang", ["zh", "en"])
def test_no_problem_file_is_printed(lang: Lang) -> None:
    text, objects = course_words("A-27", lang)
    assert not any(f'ref="{name}"' in text for name, one in objects.named.items() if isinstance(one, Listing))


def test_the_report_says_where_the_largest_acceleration_is(report: Path) -> None:
    text = "".join(texts(report))
    assert "736.2rad/s" in text and "101.4°" in text


def test_the_same_course_report_is_the_same_bytes(tmp_path: Path) -> None:
    again = write_report([solve(load("3-1a"), repeats=0)], tmp_path / "r.pdf", lang="zh", style="course")
    assert again.read_bytes() == course_report("3-1a", "zh")


def test_a_loaded_mechanism_adds_its_reactions_and_balancing_moment() -> None:
    text, objects = course_words("4-3a", "en")
    heads = {head for one in objects.named.values() if isinstance(one, DataTable) for head in one.header}
    assert "The balancing load and the reactions" in text and "$M$ /(N·m)" in heads, heads


def test_a_device_is_refused_with_the_remedy(tmp_path: Path) -> None:
    with pytest.raises(NotAskedError, match=r"5-1 is about a device.*--style solution"):
        write_report([solve(load("5-1"))], tmp_path / "r.pdf", style="course")
    assert not list(tmp_path.iterdir())


def test_a_course_report_is_about_one_problem(tmp_path: Path) -> None:
    two = [solve(load(name), repeats=0) for name in ("3-9", "3-11")]
    with pytest.raises(NotAskedError, match="about one problem, and 2 are given"):
        write_report(two, tmp_path / "r.pdf", style="course")
