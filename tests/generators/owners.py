"""Multiple joints with the pin in any of their links, without friction and with it: the owner of a pin changes no
group, and no load is refused for it."""

from __future__ import annotations

import numpy as np

from vecpoly import loads
from vecpoly.solution import Solution, solve

from .equilibrium import in_equilibrium
from .family import family
from .forces import free, friction, numbered, renumbering, simple, some, template
from .loaded import Chain
from .slots import slotted


def owned(c: Chain) -> str:
    """`pins` for some of the letters on three links or more, any of these."""
    text = ""
    for letter in sorted({p for letters in c.links.values() for p in letters}):
        names = [name for name, letters in c.links.items() if letter in letters] + (
            ["frame"] if letter in c.frame else []
        )
        if len(names) > 2 and c.rng.random() < 0.8:
            text += f"  {letter}: @{c.rng.choice(names)}\n"
    return f"pins:\n{text}" if text else ""


def _text(c: Chain, rubbing: bool) -> str:
    further = friction(c) if rubbing else ""
    return numbered(c, template(c, some(c, 2) + free(c, "L0"), further + owned(c)), renumbering(c.rng, c))


def _same_balance(solution: Solution) -> str:
    """Equilibrium; and without friction the balancing load does not know whose the pins are."""
    wrong, problem = in_equilibrium(solution), solution.problem
    if wrong or "pins:" not in problem.text:
        return wrong
    head, _, tail = problem.text.partition("pins:")
    rest = [line for line in tail.splitlines()[1:] if not line.startswith("  ")]
    plain = solve(loads("\n".join([head, *rest])), by="exact", repeats=0).answers["X_b"].drawn
    own = solution.answers["X_b"].drawn
    return (
        ""
        if abs(plain - own) <= 1e-8 * max(abs(plain), 1.0)
        else f"X_b = {own} with these owners of the pins, {plain} without"
    )


@family("forces-owners", also=_same_balance)
def owners(rng: np.random.Generator) -> str:
    """Any groups."""
    return _text(simple(rng), rubbing=False)


@family("forces-owners-friction", also=in_equilibrium)
def rubbing(rng: np.random.Generator) -> str:
    """With friction it is another machine for every owner."""
    return _text(simple(rng), rubbing=True)


@family("forces-owners-slots", also=_same_balance)
def in_slots(rng: np.random.Generator) -> str:
    """Pins in slots among them."""
    return _text(slotted(rng), rubbing=False)
