"""Round bars whose moment of inertia is a thin rod's: of thick ones it is said what that leaves out."""

from __future__ import annotations

from math import pi

import pytest

from vecpoly.problem.load import loads
from vecpoly.solution import solve


def told_of(diameter: str) -> list[str]:
    """What the steps say of the crank of this diameter, 115 mm long, as no slender rod."""
    rod = f"masses: {{1: {{rod: {{diameter: {diameter}, density: 7800 kg/m^3}}}}}}"
    steps = solve(loads(f"id: thick\nextends: C-inertia\n{rod}\n"), repeats=0).construction.steps
    return [step.words.en for step in steps if "no slender rod" in step.words.en]


def test_a_thick_bar_is_told_to_have_the_moment_of_inertia_of_a_cylinder() -> None:
    (told,) = told_of("100 mm")
    mass = 7800 * pi * 0.1**2 / 4 * 0.115
    assert told.startswith("Link 1,") and f"{mass * (3 * 0.05**2 + 0.115**2) / 12:.3g} kg" in told
    assert "turns uniformly" in told


@pytest.mark.parametrize(("diameter", "thick"), [("25 mm", False), ("29 mm", False), ("30 mm", True)])
def test_a_bar_is_thick_where_a_thin_rod_leaves_out_more_than_a_twentieth(diameter: str, thick: bool) -> None:
    assert bool(told_of(diameter)) is thick
