"""The table of the masses and their products W = m r; the mass of a hole from its size."""

from __future__ import annotations

from math import degrees, pi

from ....algebra.quantity import Product, Quantity, magnitude, number
from ....board.construction import Listing
from ....devices.balancing.asked import LIGHT, Weighing, mass_of, product_of
from ....devices.balancing.mass import RotorMass
from ....devices.balancing.rotor import Rotor
from ....plane import nominal
from ....words import Words
from ..bench import Bench

QUARTER = magnitude("π/4", pi / 4, "")


def products(bench: Bench, rotor: Rotor) -> dict[str, Quantity]:
    """W of every mass, without sign."""
    board, unit = bench.board, rotor.weighing
    board.section(Words("质径积", "Mass–radius products"))
    holes = any(mass.removed for mass in rotor.masses.values())
    told = not holes and all(mass.U is None and not mass.unknown for mass in rotor.masses.values())  # each by its line
    board.step(
        Words(
            f"算出各质量的质径积 $W$ = $m r${'：' if told else '，列表。'}"
            + ("孔、槽处缺少质量，视为负质量，其质径积的方向与孔、槽的方位相反。" * holes),
            f"Compute the product $W$ = $m r$ of every mass{':' if told else '.'}"
            + " At a hole or a keyway mass is missing: it counts as a negative mass, its product points the opposite "
            "way." * holes,
        )
    )
    found = {name: _product(bench, name, mass, unit) for name, mass in rotor.masses.items() if "m" not in mass.unknown}
    if not told:
        board.tabulate(_table(rotor, found))
    return found


def _product(bench: Bench, name: str, mass: RotorMass, unit: Weighing) -> Quantity:
    named = product_of(name, unit)
    if mass.U is not None:
        return magnitude(named.symbol, mass.U.si * unit.products, unit.product)
    assert mass.r is not None
    weight = (
        bench.worked(mass_of(name, unit), _volume(name, mass) * _density(mass, unit))
        if mass.removed
        else magnitude(f"m_{{{name}}}", mass.size * unit.masses, unit.mass)
    )
    return bench.worked(named, weight * radius(f"r_{{{name}}}", mass.r.si, unit))


def radius(symbol: str, metres: float, unit: Weighing) -> Quantity:
    """A radius in the unit that goes with the products: m with kg·m, mm with g·mm."""
    return magnitude(symbol, metres * 1e3, "mm") if unit is LIGHT else magnitude(symbol, metres, "m")


def density(symbol: str, si: float, unit: Weighing) -> Quantity:
    """A density per cubic millimetre, in the unit of the masses."""
    return magnitude(symbol, si * unit.masses * 1e-9, f"{unit.mass}/mm^3")


def _density(mass: RotorMass, unit: Weighing) -> Quantity:
    assert mass.density is not None
    return density("ρ", mass.density.si, unit)


def _volume(name: str, mass: RotorMass) -> Product:
    deep = magnitude("b", mass.high * 1e3, "mm")
    if mass.hole is not None:
        return QUARTER * magnitude(f"d_{{{name}}}", mass.hole.si * 1e3, "mm").squared() * deep
    assert mass.keyway is not None and mass.depth is not None
    wide, into = (magnitude(s, x.si * 1e3, "mm") for s, x in (("w", mass.keyway), ("h", mass.depth)))
    return wide * into * deep


def _table(rotor: Rotor, found: dict[str, Quantity]) -> Listing:
    unit = rotor.weighing
    axial = rotor.length > 0
    head = ["$i$", f"$m$/{unit.mass}", "$r$/mm", "$θ$/°", *(["$z$/mm"] if axial else []), f"$W$/({unit.product})"]
    rows = []
    for name, mass in rotor.masses.items():
        sign = "−" if mass.removed else ""
        known = "" if mass.U is not None else "?" if "m" in mass.unknown else sign + number(mass.size * unit.masses)
        rows.append(
            (
                name,
                known,
                "" if mass.r is None else number(1e3 * mass.r.si),
                "?" if "at" in mass.unknown else number(degrees(mass.at.si), 5),
                *([number(1e3 * mass.place)] if axial else []),
                "?" if name not in found else sign + number(float(nominal(found[name].value)), 5),
            )
        )
    return Listing(head=tuple(Words.same(one) for one in head), rows=tuple(rows))
