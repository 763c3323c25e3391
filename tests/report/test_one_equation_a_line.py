"""Each equation of a step has a line of its own, and those that follow each other stand by their equality signs."""

from __future__ import annotations

from typing import Any

import pytest

from tests.drawn_library import IDS, drawn
from tests.each import each
from tests.laws import few
from vecpoly.algebra.formula import Row, Sym, Txt, plain
from vecpoly.report.answers.alike import lines_of_twins
from vecpoly.report.content import Objects
from vecpoly.report.flow.base import Tightness
from vecpoly.report.flow.formula import Formula, in_columns, lines
from vecpoly.report.flow.para import Para
from vecpoly.report.flow.results.abreast import Abreast, abreast
from vecpoly.report.flow.style import BODY
from vecpoly.report.steps.lines import chained, displayed, measured_once, together
from vecpoly.report.steps.sections import sections
from vecpoly.typeset.box import MM
from vecpoly.typeset.layout import SIGNS, layout, segments

ROOM = 170.0 * MM


def formulas(*texts: str) -> list[Formula]:
    """Formulas that follow each other, each told as left side and right side."""
    made = [Formula(Row((Sym(*text.split("|")[0].split("_")), Txt(text.split("|")[1])))) for text in texts]
    in_columns(made)
    for one in made:
        one.wrap(ROOM, 1e4)
    return made


def relations(made: list[Formula]) -> list[float]:
    """Where the relation of each begins, in mm."""
    return [one._left + sides.left for one in made if (sides := one.sides()) is not None]


@each(few(IDS, 6))
def test_a_step_sets_each_of_its_equations_by_itself(name: str) -> None:
    solution, objects = drawn(name).solution, Objects()
    told = [step for section in sections(solution, "zh", objects) for step in section["steps"]]
    counts = {step["n"]: sum(len(_set_in(objects.named[ref])) for ref in step["formulas"]) for step in told}
    twins = lines_of_twins(solution, "zh")
    lines_of = {
        step.number: [twins.get(id(one), one) for one in displayed(step, solution)]
        for step in solution.construction.steps
    }
    shown = {n: len([*together([*chained([*measured_once(some)])])]) for n, some in lines_of.items()}
    assert counts == {number: shown[number] if counts[number] else 0 for number in counts}
    assert all(counts[number] or number in _runs(told, objects) for number in counts if shown[number])
    assert not any(",\u2003" in plain(line) for step in solution.construction.steps for line in step.formulas)


def _runs(told: list[dict[str, Any]], objects: Objects) -> set[int]:
    """The numbers of the steps that open a table of like steps."""
    return {step["n"] for step in told if step["table"] and not step["formulas"] and not step["equation"]}


def _set_in(made: object) -> tuple[object, ...]:
    """The equations of one block."""
    return made.nodes if isinstance(made, Abreast) else (made,)


def test_places_stand_abreast_before_what_is_worked_out_and_short_results_in_a_row() -> None:
    told = Txt(" = (1.0, −2.5) mm")
    places = [Row((Sym("P", name), told)) for name in ("12", "13", "23", "14")]
    endless = Row((Sym("P", "34", "∞"), Txt(" (∠90.0°)")))
    worked = Row((Sym("δ"), Txt(" = 0.001 × 69.9 = 0.0699 m")))
    first, *others = abreast([*places[:2], worked, *places[2:], endless])
    assert isinstance(first, Abreast) and first.nodes == (*places, endless) and others == [worked]
    first.wrap(ROOM, 1e4)
    assert first.height < 2 * 20.0, "two rows"
    angles = [Row((Sym("γ", str(n)), Txt(" = 36.2°"))) for n in range(3)]
    (row,) = abreast(angles)
    assert isinstance(row, Abreast) and abreast(angles[:2]) == angles[:2]


def test_equations_that_follow_each_other_have_their_equality_signs_under_each_other() -> None:
    made = formulas("v_B2| = 0.6 × 0.05 = 3.000 m/s", "a_B3B2123| = 1 m", "P_23| → ∞")
    assert relations(made) == pytest.approx([relations(made)[0]] * 3)
    assert made[0].spaceAfter == made[1].spaceBefore < made[0].spaceBefore


def test_an_equation_that_stands_alone_is_in_the_middle() -> None:
    alone = formulas("v_B2| = 3 m/s")[0]
    wide = max(x + box.width for x, box in alone._lines)
    assert alone._left == pytest.approx((ROOM / MM - wide) / 2)
    story = [alone, Para("and", lang="en"), formulas("a_B3B2123| = 1")[0]]
    in_columns(story)
    assert not alone._run, "a sentence between two parts them"


def test_equations_set_tightly_do_not_touch() -> None:
    made = formulas("v_B2| = 3 m/s", "v_B3| = 4 m/s")
    made[0].tighten(Tightness(white=0.1))
    assert made[0].spaceAfter > 2.0


def test_a_sum_that_is_too_wide_breaks_before_a_sign_outside_brackets_and_keeps_its_size() -> None:
    terms = " + ".join(f"R_{n} (y − z) sin (φ + θ)" for n in range(8))
    found = lines(Txt(f"{terms} = 0"), BODY.em, 120.0)
    assert len(found) > 1 and all(x + box.width <= 120.0 for x, box in found)
    whole = layout(Txt(f"{terms} = 0"), BODY.em).width
    assert sum(box.width for _, box in found) > 0.95 * whole, "no smaller than it was"
    parts = segments(Txt(f"{terms} = 0"), BODY.em, before=True, at=SIGNS)
    assert len(parts) == 8 + 1, "eight terms and the right side"
