"""The table of verification of a synthesis."""

from __future__ import annotations

import re
from functools import cache

import pytest

import vecpoly
from tests.flat_positions import FLAT
from tests.laws import few
from vecpoly.check.grashof import grashof
from vecpoly.printed.digits import drawn_number
from vecpoly.report.answers.order import arranged, broken
from vecpoly.report.content import conclusions
from vecpoly.report.verification.heads import MARGIN
from vecpoly.report.verification.table import as_moved, verification_table
from vecpoly.words import Lang


@cache
def table(name: str) -> dict[str, tuple[str, ...]]:
    """Item by item what is said of the solutions, one after another."""
    found = verification_table(vecpoly.load(name).solve(by="drafting", seed=1), "en")
    assert found is not None
    return dict(zip(found.header, zip(*found.rows, strict=True), strict=True))


def test_both_solutions_of_8_4_stand_beside_their_exact_values() -> None:
    found = table("8-4")
    assert all(text.endswith("(1.500)") and abs(float(text.split()[0]) - 1.5) < 0.01 for text in found["$K$"])
    assert [text.partition("(")[2] for text in found["Swing /°"]] == ["40.74)", "105.8)"]
    assert found["Type"] == ("crank-rocker", "crank-rocker")
    assert all(float(text) > 0 for text in found[f"{MARGIN.en} /mm"])
    assert found["Driver $AB$ rotates fully"] == ("yes", "yes")


@pytest.mark.parametrize("name", few(["8-4", "8-8", "8-13", "8-18", "three-positions"], 2))
def test_the_bars_of_a_solution_have_one_length_in_all_its_positions(name: str) -> None:
    differ = table(name).get("Length error /mm", ())  # none told: none to the last digit
    assert all(float(text.split()[0]) < 0.5 for text in differ)


def test_no_angle_of_a_linkage_that_was_read_off_is_told_finer_than_to_its_hundredths() -> None:
    """The transmission angle of a triple rocker was 6.595°."""
    (told,) = next(said for item, said in table("four-positions-b").items() if "between positions" in item)
    assert re.fullmatch(r"\d\.\d\d", told), told


def test_three_positions_are_passed_in_their_order_and_two_have_none() -> None:
    assert table("8-8")["Order"] == ("1 → 2 → 3",)
    assert "Order" not in table("8-13")


def test_what_a_solution_has_not_leaves_no_line() -> None:
    assert not any("Swing" in item or "Stroke" in item for item in table("8-13"))
    assert verification_table(vecpoly.load("3-9").solve(), "en") is None


def test_a_solution_that_cannot_move_has_its_line_and_no_solution_is_left_out() -> None:
    found = table(FLAT)
    assert found["No."] == ("1", "2", "3")
    assert found["Driver $DC$ rotates fully"] == ("no", "no", "does not move") and found["Order"][2] == "—"


@pytest.mark.parametrize("lang", few(["zh", "en"], 2))
def test_a_solution_that_cannot_move_is_headed_as_of_no_use_in_the_words_of_a_reader(lang: Lang) -> None:
    solution = vecpoly.load(FLAT).solve(by="drafting", seed=1)
    heads = [part.heading(lang, broken(solution)) for part in arranged(solution.answers.values())]
    assert (
        heads
        == {
            "zh": ["解 1", "解 2", "解 3（不能使用）"],
            "en": ["Solution 1", "Solution 2", "Solution 3 (cannot be used)"],
        }[lang]
    )
    (told,) = conclusions(solution, lang)
    assert " deg" not in told and ".." not in told
    assert re.search(r"91\.\d+°(～| to )171\.\d+°", told)
    assert {"zh": "不能使用", "en": "cannot be used"}[lang] in told


def test_every_length_of_every_solution_is_asked() -> None:
    """Each of the three has its four bars in the box of answers."""
    parts = arranged(vecpoly.load(FLAT).solve(by="drafting", seed=1).answers.values())
    assert [[one.key.partition("_")[0] for one in part.answers] for part in parts] == 3 * [["AB", "BC", "CD", "AD"]]


def test_a_crank_rocker_driven_by_its_rocker_says_which_is_the_crank_and_which_does_not_turn() -> None:
    assert table("8-8")["Type"] == ("crank-rocker ($CD$ the crank)",)
    assert table("8-8")["Driver $AB$ rotates fully"] == ("no",)
    assert "曲柄摇杆机构" in grashof(30.0, 55.55, 22.2, 60.0)[0].zh


def test_a_given_link_that_need_not_be_a_crank_is_called_a_link() -> None:
    problem = vecpoly.load("8-8")
    assert problem.statement is not None and "曲柄" not in problem.statement.zh
    first = problem.solve(by="exact").construction.steps[0].words
    assert (
        "构件 $AB$ 的各位置、标线 $DE$" in first.zh and "of the link $AB$, the positions of the line $DE$" in first.en
    )


@pytest.mark.parametrize(
    ("lang", "said"), few([("zh", "原动件 $AB$ 能整周转动"), ("en", "the driver $AB$ rotates fully")], 2)
)
def test_what_a_single_solution_does_is_said_in_a_sentence_and_of_several_in_a_table(lang: Lang, said: str) -> None:
    solutions = [vecpoly.load(name).solve() for name in ("8-5", "8-4", "3-9")]
    one, several, _ = (verification_table(solution, lang) for solution in solutions)
    assert one is not None and several is not None and len(several.rows) > 1
    (no_table, sentence), *others = (as_moved(solution, lang) for solution in solutions)
    assert said in sentence and no_table is None
    (table, common), nothing = others
    assert nothing == (None, "") and table is not None and said in common
    assert set(table.header) < set(several.header), "what all have in common is no column"
    shared = [cells for cells in zip(*table.rows, strict=True) if len(set(cells)) == 1]
    assert all("." in cells[0] for cells in shared)
    numbers = [number for cell in one.rows[0][1:] for number in re.findall(r"\d+\.\d+", cell)]
    assert numbers and all(number in sentence for number in numbers)


@pytest.mark.parametrize("name", ["8-11", "three-positions"])
def test_the_margin_of_grashofs_condition_is_that_of_the_lengths_as_they_are_printed(name: str) -> None:
    """44.7 + 50.0 − 22.3 − 62.2 = 10.2 mm: it was 10.1."""
    solution = vecpoly.load(name).solve(by="drafting")
    found, said = as_moved(solution, "en")
    told = re.search(r"the longest is (−?[\d.]+) mm", said)
    head = f"{MARGIN.en} /mm"
    margins = [told[1]] if told else [] if found is None else [row[found.header.index(head)] for row in found.rows]
    assert margins
    for number, margin in enumerate(margins, 1):
        keys = [key if number == 1 else f"{key}_{number}" for key in ("AB", "BC", "CD", "AD")]
        lengths = sorted(float(drawn_number(solution.answers[key])) for key in keys)
        least, one, other, most = lengths
        assert margin == f"{one + other - least - most:.1f}".replace("-", "−"), lengths
