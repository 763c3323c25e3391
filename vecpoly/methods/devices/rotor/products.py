"""The table of the masses and their products W = m r; the mass of a hole from its size."""

from __future__ import annotations

from math import degrees, pi

from ....algebra.columns import column, decimals, headed
from ....algebra.quantity import Product, Quantity, magnitude
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
    board = bench.board
    board.section(Words("质径积", "Mass–radius products"))
    holes = any(mass.removed for mass in rotor.masses.values())
    told = not holes and all(mass.U is None and not mass.unknown for mass in rotor.masses.values())  # each by its line
    board.step(
        Words(
            f"算出各质量的质径积 $W$ = $m r${'：' if told else '，列表。'}"
            + ("孔、槽处缺少质量，视为负质量，其质径积的方向与孔、槽的方位相反。" * holes),
            f"Compute the product $W$ = $m r$ of every mass{':' if told else '.'}"
            + " At a hole or a keyway mass is missing: it counts as a negative mass, and its product points "
            "the opposite way." * holes,
        )
    )
    found = {name: _product(bench, name, mass, rotor) for name, mass in rotor.masses.items() if "m" not in mass.unknown}
    if not told:
        board.tabulate(_table(rotor, found))
    return found


def _product(bench: Bench, name: str, mass: RotorMass, rotor: Rotor) -> Quantity:
    unit, symbols = rotor.weighing, mass.symbols(name, rotor.disc)
    named = product_of(name, unit)
    if mass.U is not None:
        return magnitude(named.symbol, mass.U.si * unit.products, unit.product)
    assert mass.r is not None
    weight = (
        bench.worked(mass_of(name, unit), _volume(name, mass, symbols[0]) * _density(symbols[1], mass, unit))
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


def _density(symbol: str, mass: RotorMass, unit: Weighing) -> Quantity:
    assert mass.density is not None
    return density(symbol, mass.density.si, unit)


def _volume(name: str, mass: RotorMass, along: str) -> Product:
    deep = magnitude(along, mass.high * 1e3, "mm")
    if mass.hole is not None:
        return QUARTER * magnitude(f"d_{{{name}}}", mass.hole.si * 1e3, "mm").squared() * deep
    assert mass.keyway is not None and mass.depth is not None
    wide, into = (magnitude(f"{s}_{{{name}}}", x.si * 1e3, "mm") for s, x in (("w", mass.keyway), ("h", mass.depth)))
    return wide * into * deep


def _table(rotor: Rotor, found: dict[str, Quantity]) -> Listing:
    """Each column with one count of decimals; none of what is given of no mass."""
    unit, masses = rotor.weighing, rotor.masses
    every: list[tuple[str, list[float | str]]] = [
        (headed("$m$", unit.mass), [_known_mass(mass, unit) for mass in masses.values()]),
        ("$r$ /mm", ["" if mass.r is None else 1e3 * mass.r.si for mass in masses.values()]),
        ("$θ$ /°", ["?" if "at" in mass.unknown else degrees(mass.at.si) for mass in masses.values()]),
        ("$z$ /mm", [1e3 * mass.place if rotor.length > 0 else "" for mass in masses.values()]),
        (headed("$W$", unit.product), [_known_product(name, mass, found) for name, mass in masses.items()]),
    ]
    kept = [(head, _even(cells)) for head, cells in every if any(cell != "" for cell in cells)]
    rows = zip(masses, *(cells for _, cells in kept), strict=True)
    return Listing(head=tuple(map(Words.same, ("$i$", *(head for head, _ in kept)))), rows=tuple(rows))


def _known_mass(mass: RotorMass, unit: Weighing) -> float | str:
    if mass.U is not None:
        return ""
    return "?" if "m" in mass.unknown else (-1 if mass.removed else 1) * mass.size * unit.masses


def _known_product(name: str, mass: RotorMass, found: dict[str, Quantity]) -> float | str:
    return "?" if name not in found else (-1 if mass.removed else 1) * float(nominal(found[name].value))


def _even(cells: list[float | str]) -> list[str]:
    """The numbers of a column with one count of decimals, of five figures."""
    numbers = [cell for cell in cells if not isinstance(cell, str)]
    told = iter(column(numbers, decimals(numbers, 5)))
    return [cell if isinstance(cell, str) else next(told) for cell in cells]
