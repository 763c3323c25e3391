"""Where a problem asks for counterweights, its course report tells what they do, and takes no others for them."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np
import pytest

from tests.laws import few
from tests.studies import machine, studied
from vecpoly.algebra.quantity import number
from vecpoly.curves import peaks
from vecpoly.cycle import Column, extremes
from vecpoly.cycle.shaking import FORCE, MOMENT
from vecpoly.findings.conditioning import conditioning, determinant
from vecpoly.findings.machine import shaking
from vecpoly.findings.machine.shaking import Shaking
from vecpoly.foundation.slotted import replace
from vecpoly.mechanism.counterweights import Counterweights
from vecpoly.mechanism.model import Mechanism
from vecpoly.oracle.machine.balance import Hung, counterweights
from vecpoly.report.content import Objects
from vecpoly.report.course.machine.balance import conclusion, sections
from vecpoly.report.course.modelling.example import section
from vecpoly.report.course.numbering import Press
from vecpoly.report.course.results.plots import curve
from vecpoly.report.course.symbol_rows import curvatures
from vecpoly.report.flow.table import DataTable

NAMES = ("balance-four-bar", "balance-slider-crank", "balance-shaper")


def shaken(name: str) -> Shaking:
    found = machine(name).balance
    assert isinstance(found, Shaking)
    return found


def told(name: str, found: Shaking) -> str:
    """The words of the chapter on balancing, in English."""
    parts = sections(studied(name), Press("en", Objects(), "9"), found)
    return " ".join(text for part in parts for text in part["words"])


@pytest.mark.parametrize("name", few(NAMES[:2], 2))
def test_the_product_of_a_counterweight_is_no_inflection_pole(name: str) -> None:
    assert any(key.startswith("W_c") for key in studied(name).solution.answers)
    assert not [*curvatures(studied(name))]


def test_an_inflection_pole_is_one_still() -> None:
    assert any(words.en == "inflection pole" for _, words, _ in curvatures(studied("curv-4")))


@pytest.mark.parametrize("name", few(NAMES, 3))
def test_the_counterweights_asked_for_leave_no_force_and_the_chapter_and_the_conclusion_say_so(name: str) -> None:
    found = shaken(name)
    (said,) = conclusion(studied(name), found)
    for text in (told(name, found), said.en):
        assert "the force is zero in every position" in text and "W_{c" in text
    assert "惯性力完全平衡" in said.zh and "未加配重" in said.zh
    assert found.best is None or number(found.best.product, 4) not in said.en


def test_counterweights_that_leave_a_force_are_not_said_to_balance_it(monkeypatch: pytest.MonkeyPatch) -> None:
    def halved(mech: Mechanism, asked: Counterweights) -> tuple[Hung, ...]:
        return tuple(replace(one, w=one.w / 2) for one in counterweights(mech, asked))

    monkeypatch.setattr(shaking, "counterweights", halved)
    found = shaking.shaking(studied(NAMES[0]))
    assert isinstance(found, Shaking) and found.designed
    (said,) = conclusion(studied(NAMES[0]), found)
    for text in (told(NAMES[0], found), said.en):
        assert f"the force is {number(found.designed, 4)} N at most" in text and "is zero" not in text


@pytest.mark.parametrize("name", few([*NAMES, "C-inertia"], 4))
def test_other_counterweights_are_said_to_be_others_where_any_are_asked_for_and_nowhere_else(name: str) -> None:
    text, found = told(name, shaken(name)), shaken(name)
    others = bool(found.weights or found.best)
    assert ("are other measures, for comparison" in text) == (name in NAMES and others)
    assert ("the counterweights asked for are not among them" in text) == (name in NAMES)


@pytest.mark.parametrize("name", few([*NAMES, "C-inertia", "slider-crank-dynamic"], 5))
def test_what_is_left_comes_from_links_that_the_mechanism_has(name: str) -> None:
    """A four-bar linkage had "links that slide or move in general"."""
    it, found = studied(name), shaken(name)
    text = told(name, found)
    fixed = {one.link for one in found.weights}
    assert fixed.isdisjoint(found.rest)
    assert ("in translation" in text) <= any(type(joint).__name__ == "Prismatic" for joint in it.mech.joints)
    for numbers in re.findall(r"comes from links? (\d)", text):
        assert numbers in {it.mech.number(link) for link in found.rest}
    assert name != "balance-four-bar" or "comes from link 2, in general plane motion." in text


@pytest.mark.parametrize("name", few([*NAMES, "C-inertia", "slider-crank-dynamic"], 5))
def test_moments_of_inertia_that_are_taken_as_nothing_are_named(name: str) -> None:
    it = studied(name)
    loads = it.problem.acting
    assert loads is not None
    given = {datum.symbol for datum in it.problem.given.data}
    none = any(not one.inertia and one.inertia_symbol not in given for one in loads.masses)
    text = told(name, shaken(name))
    assert ("$J_{Si}$ = 0 is taken" in text) <= none
    assert name != "balance-four-bar" or "is given of links 1, 2 and 3: $J_{Si}$ = 0 is taken" in text


@pytest.mark.parametrize("name", few([*NAMES, "press-flywheel"], 4))
def test_the_curves_of_force_and_moment_mark_the_extremes_of_their_table(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """2.390 N stood on the curve, read off its samples, and 2.387 in the table."""
    it, marked, said = studied(name), list[float](), peaks.told

    def heard(alike: Sequence[peaks.Spot], drive: Column, of: str) -> str:
        marked.extend(value for _, value in alike)
        return said(alike, drive, of)

    monkeypatch.setattr(peaks, "told", heard)
    for key in (FORCE.key, *([MOMENT.key] if it.varies(MOMENT.key) else [])):
        marked.clear()
        curve(it, "en", [key], it.turn.once)
        found = extremes(it.whole, key)
        assert found.highest is not None and found.lowest is not None and marked
        true, size = (found.highest.value, found.lowest.value), abs(found.highest.value)
        assert all(min(abs(value - one) for one in true) <= 1e-6 * size for value in marked)


@pytest.mark.parametrize("name", few(["balance-four-bar", "3-9", "A-26"], 3))
def test_a_determinant_is_told_with_all_its_equal_extremes(name: str) -> None:
    """|G_1| was "largest at 112.6°" and as large at 247.4°."""
    it = studied(name)
    for one in conditioning(it):
        for at, size in ((one.lows, one.least), (one.tops, one.largest)):
            values = determinant(it, one.group, np.array(at))
            assert np.allclose(values, size, rtol=0.0, atol=2e-6 * one.largest)
        if name == "balance-four-bar":  # symmetric about its line of fixed pivots
            assert len(one.tops) == 2 and sum(one.tops) == pytest.approx(2 * np.pi, abs=1e-3)


def test_the_values_at_the_given_position_have_five_figures_and_no_zeros_at_the_end() -> None:
    it, objects = studied("balance-four-bar"), Objects()
    section(it, Press("en", objects, "4"))
    (table,) = (one for one in objects.named.values() if isinstance(one, DataTable))
    cells = [row[j] for row in table.rows for j in range(1, len(row), 4) if row[j]]
    assert cells and not [cell for cell in cells if re.fullmatch(r"−?\d+\.\d*0", cell)]
