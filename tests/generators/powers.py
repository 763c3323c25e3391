"""The balancing load asked for alone, where gears roll, groups are above class II or a cylinder floats:
judged by the sum of all powers."""

from __future__ import annotations

import re

import numpy as np

from vecpoly import loads
from vecpoly.errors import VecpolyError
from vecpoly.mechanism.model import Mechanism
from vecpoly.solution import Solution

from .class_iii import class_iii
from .drives import inside
from .equilibrium import _power, in_equilibrium
from .family import families, family
from .moving import STEP, Moving, slack_of


def no_power_is_left(solution: Solution) -> str:
    """Σ P = 0 by central differences of positions."""
    mech, acting = solution.problem.mechanism, solution.problem.loads
    assert acting is not None
    try:
        both = Moving.of(mech), Moving.of(mech, 2 * STEP)
    except VecpolyError:
        return ""  # too near the end of the range
    return _power(both, acting, solution.as_json()["forces"], slack_of(*both, acting))


def every_reaction(solution: Solution) -> str:
    """Equilibrium of every body, whose reactions were all asked for and drawn."""
    if not any(key.startswith("R_") for key in solution.as_json()["forces"]):
        return "no reaction is drawn"
    return in_equilibrium(solution)


def held(mech: Mechanism, link: str) -> list[str]:
    """The points of a link on which something may act: not the centre of curvature of a cam's profile."""
    return [letter for letter in mech.link(link).points if letter not in {one.centre for one in mech.cams}]


def loaded(rng: np.random.Generator, text: str, free: str = "", bodies: tuple[str, ...] = (), find: str = "X_b") -> str:
    """The problem with one to three loads on these links, or any,
    and one of the driver's that balances, in the place of what it finds."""
    mech = loads(text).mechanism
    names = [name for name in bodies or mech.numbered if mech.link(name).points]
    told = ""
    for i in range(int(rng.integers(1, 4))):
        link = str(rng.choice(names))
        point = str(rng.choice(held(mech, link)))
        told += (
            f"  M_q{i}: {{on: {link}, size: {rng.integers(-30, 30)} N*m}}\n"
            if rng.random() < 0.4
            else (
                f"  F_q{i}: {{on: {link}, at: {point}, size: {rng.integers(20, 900)} N, direction: "
                f"{rng.integers(-179, 180)} deg}}\n"
            )
        )
    bare = re.sub(
        r"^find:.*\n",
        f"find: [{find}]\n" if find else "",
        text if text.endswith("\n") else text + "\n",
        flags=re.MULTILINE,
    )
    return f"{bare}loads:\n{told}{free or _free(mech)}"


def _free(mech: Mechanism) -> str:
    link = mech.drive.link
    way = f", at: {next(iter(mech.link(link).points))}, direction: 35 deg" if mech.drive.slide else ""
    return f'  X_b: {{on: {link}{way}, size: "?"}}\n'


@family("forces-alone-gears", also=no_power_is_left, often=1, first=3)
def of_gears(rng: np.random.Generator) -> str:
    """Any of the mechanisms with gears and racks."""
    made = [one for one in families() if one.name.startswith("gears-")]
    return loaded(rng, made[int(rng.integers(len(made)))].make(rng))


@family("forces-alone-class-iii", often=1, also=no_power_is_left)
def of_class_iii(rng: np.random.Generator) -> str:
    """A central link on three legs."""
    return loaded(rng, class_iii(rng))


@family("forces-floating-cylinder", also=every_reaction, often=1)
def of_cylinders(rng: np.random.Generator) -> str:
    """A cylinder between two links of a four-bar whose thrust balances, with every reaction."""
    text = inside(rng)
    while "piston" not in text:
        text = inside(rng)
    mech = loads(text).mechanism
    pair = "-".join(sorted(mech.drive.pair))
    return loaded(rng, text, f'  X_b: {{cylinder: {pair}, size: "?"}}\n', bodies=("1", "2", "3"), find="")
