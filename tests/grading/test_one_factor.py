"""Everything by one factor is one mistake and nobody's of the catalogue; two values exchanged may have two causes."""

from __future__ import annotations

import pytest

from tests.grading.cases import key_of, marked, mutants_of
from vecpoly.grading.compare.outcome import Basis
from vecpoly.grading.key import Kind
from vecpoly.grading.marking.marked import Marked
from vecpoly.grading.told.named import Told
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
    """But an angle or a ratio, which has no size: it is wrong by itself."""
    sheet = marked(name, written(name, factor))
    said = [one.id for finding in sheet.findings for one in finding.messages]
    sized = [one for one in sheet.roots if sheet.key[one].unit not in ("deg", "")]
    assert not sheet.slips and len(sized) == 1 and said.count(Told.EVERYTHING) == len(sheet.roots)
    assert all(one.is_right for one in sheet.findings if one.written.raw and one.key not in sheet.roots)
    root = sheet[sized[0]]
    assert root.earned.total < sheet.key[root.key].points.total


def test_a_ratio_by_the_factor_of_all_sizes_is_wrong_by_itself() -> None:
    """An efficiency of 1.58 was right, for everything else was twice as large, too."""
    sheet = marked("4-3a", written("4-3a", 2.0))
    assert not sheet["eta"].is_right and sheet["eta"].earned.accuracy == 0 and len(sheet.roots) == 2
    own = marked("4-3a", written("4-3a", 2.0) | {"eta": f"{key_of('4-3a')['eta'].exact:.4g}"})
    assert own["eta"].is_right and len(own.roots) == 1


def test_what_follows_from_one_misread_length_is_no_factor_of_everything() -> None:
    cells, key = written("4-3a", 1.0), key_of("4-3a")
    length = key["R_41"].line
    for name in (length, "R_41", "R_12", "R_32", "M"):
        sense = " ccw" if key[name].exact > 0 else " cw"
        cells[name] = f"{1.4 * abs(key[name].exact):.4g}{sense if key[name].kind is Kind.SIGNED else ''}"
    cells["eta"] = f"{1.4 * key['eta'].exact:.4g}"
    sheet = marked("4-3a", cells)
    assert sheet.roots == (length,) and Told.EVERYTHING not in {one.id for one in sheet[length].messages}


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
