"""Everything by one factor is one mistake and nobody's of the catalogue; two values exchanged may have two causes."""

from __future__ import annotations

import pytest

from tests.grading.cases import key_of, marked, mutants_of
from vecpoly.grading.compare.outcome import Basis
from vecpoly.grading.key import Kind
from vecpoly.grading.marking.marked import Marked
from vecpoly.grading.told.catalogue import Told
from vecpoly.grading.told.veiled import veiled

NUMBERS = (Kind.READING, Kind.VECTOR, Kind.SIGNED, Kind.SCALAR)


def written(name: str, factor: float, but: float | None = None) -> dict[str, str]:
    """All that is asked and read, by a factor; places as they are. but: of the first asked number another one."""
    cells, key = dict[str, str](), key_of(name)
    first = next(one.key for one in key.quantities if one.asked and one.kind in NUMBERS)
    for one in key.quantities:
        if (one.asked or one.kind is Kind.READING) and one.kind in NUMBERS:
            sense = {1: " ccw", -1: " cw"}[1 if one.exact > 0 else -1] if one.kind is Kind.SIGNED else ""
            size = (but if but and one.key == first else factor) * (abs(one.exact) if sense else one.exact)
            cells[one.key] = f"{size:.4g}{sense}"
    return cells


@pytest.mark.parametrize("name", ["8-9", "boom-thrust", "A-27-c"])
@pytest.mark.parametrize("factor", [1.45, 0.7])
def test_everything_by_one_factor_is_told_as_that_and_costs_once(name: str, factor: float) -> None:
    sheet = marked(name, written(name, factor))
    said = [one.id for finding in sheet.findings for one in finding.messages]
    assert not sheet.slips and len(sheet.roots) == 1 and said.count(Told.EVERYTHING) == 1
    assert all(one.is_right for one in sheet.findings if one.written.raw and one.key != sheet.roots[0])
    root = sheet[sheet.roots[0]]
    assert root.earned.total < sheet.key[root.key].points.total


def test_one_value_by_another_factor_is_no_factor_of_everything() -> None:
    sheet = marked("A-27-c", written("A-27-c", 1.45, but=0.5))
    assert Told.EVERYTHING not in {one.id for finding in sheet.findings for one in finding.messages}


def test_a_power_of_ten_on_everything_is_one_of_units() -> None:
    sheet = marked("A-27-c", written("A-27-c", 100.0))
    (root,) = sheet.roots
    assert Told.POW10 in {said.id for said in sheet[root].messages} and not sheet.slips


def exchanged(name: str) -> Marked:
    key = key_of(name)
    return marked(name, {"alpha": f"{key['gamma'].exact:.4g}", "gamma": f"{key['alpha'].exact:.4g}"})


@pytest.mark.parametrize("name", ["8-2a", "8-2d"])
def test_what_exchanged_names_and_a_mistake_both_give_is_told_by_both_and_costs_once(name: str) -> None:
    """v_C turned by 90° gives just α and γ exchanged; only the names were told of."""
    sheet, mutants = exchanged(name), mutants_of(name)
    (said,) = (one for finding in sheet.findings for one in finding.messages if one.id is Told.EXCHANGED)
    assert said.numbers["slip"] in {str(one.slip) for one in mutants} and "turned by 90°" in said.words.en
    assert "转过了 90°" in said.words.zh and "names" in said.words.en
    assert not sheet.slips  # neither is sure
    assert [one.basis for one in sheet.findings] == [Basis.EXACT, Basis.SLIP]
    assert said not in veiled(sheet["alpha"].messages)


def test_an_exchange_that_no_mistake_gives_is_one_of_names_alone() -> None:
    key = key_of("3-9")
    cells = {one.key: f"{one.exact:.4g}" for one in key.quantities if one.kind is Kind.VECTOR}
    cells |= {"v_D": cells["v_E"], "v_E": cells["v_D"]}
    sheet = marked("3-9", cells)
    said = [each.id for name in ("v_D", "v_E") for each in sheet[name].messages]
    assert said.count(Told.SWAPPED) == 2 and Told.EXCHANGED not in said
