"""Dalby's method 力偶多边形, for masses that are sought: couples about the plane of one of them, then products."""

from __future__ import annotations

from collections.abc import Mapping
from math import degrees

import numpy as np

from ....algebra.quantity import Quantity, magnitude, number
from ....board.construction import Pane
from ....devices.balancing.rotor import Rotor
from ....devices.balancing.sought import answers_of, couple_of, found_bearing, found_mass, reference
from ....names import Named
from ....plane import Points, Reals, nominal
from ....words import Words
from ..bench import Bench, with_sign
from .couples import Solution, close_couples
from .polygon import Laid, chain, read_closing, stated_bearing
from .products import radius
from .scales import COUPLES, arm_letter, polygon_view
from .views.ends import solved_from_its_end


def dalby(bench: Bench, rotor: Rotor, sizes: Mapping[str, Quantity]) -> None:
    """ΣW l = 0 about the reference plane finds two unknowns; ΣW = 0 the mass in that plane."""
    couples = _couples(bench, rotor, sizes)
    first = reference(rotor.masses)
    place = bench.board.open_pane(COUPLES, "", COUPLES.title)
    bench.board.section(Words("力偶多边形", "Couple polygon"))
    solutions = close_couples(bench, rotor, place, couples)
    for which, solution in zip(answers_of(rotor.masses), solutions, strict=True):
        _told(bench, rotor, place, which, solution)
        _products(bench, rotor, sizes, first, which, solution)
        solved_from_its_end(bench, rotor, which)


def _couples(bench: Bench, rotor: Rotor, sizes: Mapping[str, Quantity]) -> dict[str, Quantity]:
    """C = W |l| of every mass whose product is known; without sign."""
    board, first = bench.board, reference(rotor.masses)
    here = rotor.masses[first].place
    letter = arm_letter(here)
    board.section(Words("力偶", "Couples"))
    board.step(
        Words(
            f"取质量 {first} 所在平面（$z$ = {number(1e3 * here)} mm）为参考平面：{first} 对它没有力偶。其余各质量的"
            "力偶 "
            f"$C$ = $W {letter}$（${letter}$ 为到参考平面的距离）：",
            f"The plane of mass {first}, at $z$ = {number(1e3 * here)} mm, is the reference plane: {first} has no "
            "couple "
            f"about it. Those of the others are $C$ = $W {letter}$, with their distances ${letter}$ from it:",
        )
    )
    factor = rotor.weighing.products
    found = {}
    for name, size in sizes.items():
        if name == first:
            continue
        arm = magnitude(f"{arm_letter(here)}_{{{name}}}", abs(rotor.masses[name].place - here), "m")
        product = magnitude(f"W_{{{name}}}", size.value / factor, "kg·m")
        found[name] = bench.worked(couple_of(name), product * arm)
    return found


def _told(bench: Bench, rotor: Rotor, place: Pane, which: str, solution: Solution) -> None:
    """What the couple polygon gives: directions by protractor, masses by length."""
    board, here = bench.board, rotor.masses[reference(rotor.masses)].place
    title = Words(f"解 {which[1:]}：", f"Solution {which[1:]}. ") if which else Words("", "")
    board.step(title + Words("由力偶多边形量得：", "Read from the couple polygon:"), place)
    for name, vector in solution.vectors.items():
        mass = rotor.masses[name]
        arm = mass.place - here
        if not mass.unknown:
            continue
        way = vector if arm > 0 else -vector
        if "at" in mass.unknown:
            stated_bearing(bench, found_bearing(name, which), way, 0.0)
        if "m" in mass.unknown:
            _mass(bench, rotor, place, which, name, solution, way)


def _mass(bench: Bench, rotor: Rotor, place: Pane, which: str, name: str, solution: Solution, way: Points) -> None:
    """m = C / (l r), negative where the couple came out against the direction that was given."""
    board, mass, unit = bench.board, rotor.masses[name], rotor.weighing
    here = rotor.masses[reference(rotor.masses)].place
    start, end = solution.ends[name]
    on_paper = board.measure(start, end, solution.letters[name])
    sign = 1.0
    if "at" not in mass.unknown:
        sign = 1.0 if float(nominal((way * np.exp(-1j * mass.at.si)).real)) >= 0 else -1.0
    couple = board.compute(f"C_{{{name}}}", with_sign(board.mu(place) * on_paper, sign), "kg·m^2")
    assert mass.r is not None
    arm = magnitude(f"{arm_letter(here)}_{{{name}}}", abs(mass.place - here), "m")
    turned = magnitude(f"r_{{{name}}}", mass.r.si / unit.masses, "m")
    bench.worked(found_mass(name, which, unit), couple / (arm * turned))


def _products(
    bench: Bench, rotor: Rotor, sizes: Mapping[str, Quantity], first: str, which: str, solution: Solution
) -> None:
    """ΣW = 0: the closing side is the product of the reference mass."""
    board, unit, view = bench.board, rotor.weighing, polygon_view(rotor)
    board.section(Words("质径积多边形", "Mass–radius polygon"))
    tail = f"（解 {which[1:]}）" if which else ""
    place = board.open_pane(view, which[1:], view.title + Words(tail, f", solution {which[1:]}" if which else ""))
    board.step(
        Words(
            f"各质径积的方向现均已知，按 ${view.mu.symbol}$ 首尾相接，封闭边即参考平面内质量 {first} 的质径积：",
            f"All directions are known now. Lay the products off head to tail to the scale ${view.mu.symbol}$; the "
            f"closing side is the product of mass {first} in the reference plane:",
        ),
        place,
        again=Words(
            f"同样由解 {which[1:]} 作质径积多边形，得质量 {first}：",
            f"In the same way the mass–radius polygon of solution {which[1:]} gives mass {first}:",
        ),
    )
    laid = [_laid(bench, rotor, name, sizes, which, solution) for name in rotor.masses if name != first]
    closing = _closing(first, which, rotor)
    polygon = chain(bench, place, laid, closing)
    size = read_closing(bench, polygon, closing, found_bearing(first, which))
    mass = rotor.masses[first]
    assert mass.r is not None
    bench.worked(found_mass(first, which, unit), size / radius(f"r_{{{first}}}", mass.r.si, unit))


def _closing(first: str, which: str, rotor: Rotor) -> Named:
    """W_A, or of two solutions W_A,1."""
    own = f"{first},{which[1:]}" if which else first
    return Named(f"W_{first}{which}", f"W_{{{own}}}", rotor.weighing.product, True)


def _laid(bench: Bench, rotor: Rotor, name: str, sizes: Mapping[str, Quantity], which: str, solution: Solution) -> Laid:
    """A product with what the couple polygon found of it."""
    mass, unit, found = rotor.masses[name], rotor.weighing, bench.board.found
    named = Named(f"W_{name}", f"W_{{{name}}}", unit.product)
    sign = -1.0 if mass.removed else 1.0
    turn: Reals = degrees(mass.at.si)
    if "at" in mass.unknown:
        turn = found[found_bearing(name, which).key]
    if "m" in mass.unknown:
        assert mass.r is not None
        value = found[found_mass(name, which, unit).key] * mass.r.si * unit.products / unit.masses
        return Laid(named=named, size=value, degrees=turn)
    return Laid(named=named, size=sign * sizes[name].value, degrees=turn)
