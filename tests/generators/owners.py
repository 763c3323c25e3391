"""Multiple joints with the pin in any of their links, without friction and with it: the owner of a pin changes no
group, and no load is refused for it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from vecpoly import loads
from vecpoly.solution import Solution, solve

from .equilibrium import in_equilibrium
from .family import family
from .forces import free, friction, numbered, renumbering, simple, some, template
from .loaded import Chain
from .slots import slotted


def shared(c: Chain) -> dict[str, list[str]]:
    """The letters on three links or more, the frame among them, and these links."""
    letters = sorted({letter for letters in c.links.values() for letter in letters})
    links = {**c.links, "frame": c.frame}
    on = {letter: [name for name, letters in links.items() if letter in letters] for letter in letters}
    return {letter: names for letter, names in on.items() if len(names) > 2}


def multiple(rng: np.random.Generator, make: Callable[[np.random.Generator], Chain]) -> Chain:
    """The first of such chains that has a multiple joint; hardly half of them have one."""
    return next(c for c in iter(lambda: make(rng), None) if shared(c))


def owned(c: Chain) -> str:
    """`pins` for most of the multiple joints, any of their links."""
    found = shared(c)
    told = [letter for letter in found if c.rng.random() < 0.8] or list(found)
    return "pins:\n" + "".join(f"  {letter}: @{c.rng.choice(found[letter])}\n" for letter in told)


def _text(c: Chain, rubbing: bool) -> str:
    further = friction(c) if rubbing else ""
    return numbered(c, template(c, some(c, 2) + free(c, "L0"), further + owned(c)), renumbering(c.rng, c))


def _same_balance(solution: Solution) -> str:
    """Equilibrium; and without friction the balancing load does not know whose the pins are."""
    wrong, problem = in_equilibrium(solution), solution.problem
    if wrong:
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


@family("forces-owners", also=_same_balance, often=1, first=1)
def owners(rng: np.random.Generator) -> str:
    """Any groups."""
    return _text(multiple(rng, simple), rubbing=False)


@family("forces-owners-friction", also=in_equilibrium, often=1)
def rubbing(rng: np.random.Generator) -> str:
    """With friction it is another machine for every owner."""
    return _text(multiple(rng, simple), rubbing=True)


@family("forces-owners-slots", also=_same_balance, often=1)
def in_slots(rng: np.random.Generator) -> str:
    """Pins in slots among them."""
    return _text(multiple(rng, slotted), rubbing=False)
