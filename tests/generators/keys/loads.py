"""Motors, dampers, pressures on a piston: their sizes are worked out from the text, by hand, and every body is to be in
equilibrium under them."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np

from vecpoly.mechanism.laws.sizes import Table
from vecpoly.solution import Solution

from ..acting.laws import balanced_by_hand
from ..family import family
from ..forces import free, masses, numbered, renumbering, simple, some, template, written
from ..library import data_of
from ..loaded import Chain


def number(text: str) -> float:
    """The number of a quantity as it is written."""
    return float(text.split()[0])


def as_the_text_says(solution: Solution) -> str:
    """Motors give a − b |ω| in the sense of the rotation, pistons p A; with these all is in equilibrium."""
    data, loads = data_of(solution.problem.text), solution.problem.loads
    assert loads is not None
    for one in loads.all:
        said = data["loads"].get(one.name, {})
        if "motor" in said:
            omega = number(data["input"]["omega"])
            a, b = (number(text) for text in said["motor"])
            wanted = np.sign(omega) * (a - b * abs(omega))
            if one.size is None or abs(one.size - wanted) > 1e-9 * abs(a):
                return f"{one.name} is {one.size}, and a − b ω is {wanted}"
        if isinstance(said.get("size"), dict) and (wrong := _pressed(one.law, said["size"])):
            return f"{one.name}: {wrong}"
    return balanced_by_hand(solution)


def _pressed(law: Any, said: dict[str, Any]) -> str:
    """The sizes of a table of pressures are these times the area of the piston."""
    if not {"area", "bore"} & said.keys():
        return ""
    area = number(said["area"]) * 1e-6 if "area" in said else pi * (number(said["bore"]) * 1e-3) ** 2 / 4
    wanted = [float(p) * 1e6 * area for _, p in said["rows"]]
    table = law.size
    assert isinstance(table, Table)
    return "" if np.allclose(table.sizes, wanted, rtol=1e-12) else f"sizes {table.sizes}, p A is {wanted}"


def damper(c: Chain, name: str) -> str:
    """Between two points, or two links."""
    rng = c.rng
    one, other = (str(x) for x in rng.choice(list(c.links), 2, replace=False))
    if rng.random() < 0.4:
        other = "frame"
    if rng.random() < 0.4:
        return f"  M_{name}: {{damper: @{one}-@{other}, c: {rng.uniform(0.1, 5):.2f} N*m*s}}\n"
    foot = f"{rng.choice(c.links[other])}@{other}" if other != "frame" else str(rng.choice(c.frame))
    return f"  F_{name}: {{damper: {rng.choice(c.links[one])}@{one}-{foot}, c: {rng.integers(5, 300)} N*s/m}}\n"


def piston(c: Chain, name: str, link: str, letter: str) -> str:
    """A force by a table of pressures over the drive's angle."""
    rng = c.rng
    rows = ", ".join(f"[{x}, {rng.uniform(0, 2):.2f}]" for x in range(0, 361, 60))
    size = f"area: {rng.integers(100, 900)} mm^2" if rng.random() < 0.5 else f"bore: {rng.integers(10, 40)} mm"
    told = f"size: {{columns: [phi (deg), p (MPa)], rows: [{rows}], {size}}}, direction: {rng.integers(-179, 180)} deg"
    return f"  {name}: {{on: @{link}, at: {letter}, {told}}}\n"


@family("keys-loads", also=as_the_text_says, often=2)
def loads(rng: np.random.Generator) -> str:
    """Dampers and pistons beside plain loads, balanced on the crank."""
    c = simple(rng)
    told = "".join(damper(c, f"d{i}") for i in range(int(rng.integers(0, 3))))
    if rng.random() < 0.6 or not told:
        link = str(rng.choice(list(c.links)))
        told += piston(c, "P_c", link, str(rng.choice(c.links[link])))
    told += some(c, 1) if rng.random() < 0.5 else ""
    return written(c, told + free(c, "L0"), masses(c) if rng.random() < 0.3 else "")


@family("keys-motor", also=as_the_text_says, often=2)
def motor(rng: np.random.Generator) -> str:
    """A motor on the crank, dampers, and a load that is sought on some link; or nothing sought, and what even motion
    needs asked."""
    c = simple(rng)
    told = f"  M_d: {{on: @L0, motor: [{rng.integers(5, 200)} N*m, {rng.uniform(0.05, 12):.2f} N*m*s]}}\n"
    told += "".join(damper(c, f"d{i}") for i in range(int(rng.integers(0, 2)))) + some(c, 2)
    link = str(rng.choice(list(c.links)))
    sought = free(c, link) if rng.random() < 0.7 else ""
    return numbered(c, template(c, told + sought, masses(c) if rng.random() < 0.3 else ""), renumbering(rng, c))
