"""What the moments of a screw jack are called."""

from __future__ import annotations

import pytest

from vecpoly import load
from vecpoly.algebra.formula import plain
from vecpoly.report.statement.meant import meant_by
from vecpoly.solution import solve


@pytest.mark.parametrize(("varied", "key", "other"), [("p", "M2_over_Q", "M1_over_Q"), ("D", "M1_over_Q", "M2_over_Q")])
def test_the_moments_of_a_screw_jack_are_called_after_what_they_depend_on(varied: str, key: str, other: str) -> None:
    """M_1, of the ring, was called that of the thread, and M_2 that of the ring."""
    jack = load("5-5")
    changed = jack.vary(**{varied: "5 mm" if varied == "p" else "36 mm"})
    values = [solve(one, repeats=0, precise=True).answers for one in (jack, changed)]
    moved = {one: abs(values[0][one].exact - values[1][one].exact) > 1e-9 for one in (key, other)}
    assert moved == {key: True, other: False}
    words = meant_by(jack.subject, key, "M")
    assert words is not None and ("thread" if varied == "p" else "ring") in words.en


def test_the_load_of_a_screw_jack_has_one_number_in_all_its_moments() -> None:
    """In kN it was 10.289 in one line and 10.29 in the next."""
    lines = [
        plain(one).replace("\u2009", " ").split(" = ")
        for step in solve(load("5-5")).construction.steps
        for one in step.formulas
    ]
    (newtons,) = (parts[-1].removesuffix(" N") for parts in lines if parts[0] == "Q")
    loads = {parts[2].partition(" × ")[0] for parts in lines if len(parts) == 4 and parts[1].startswith("Q (M")}
    assert loads == {f"{float(newtons) / 1e3:g}"}
