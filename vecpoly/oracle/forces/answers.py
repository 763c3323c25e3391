"""The quantities of `mechanism.quantities` and the lines of action, out of a solved equilibrium."""

from __future__ import annotations

import numpy as np

from ...errors import UnknownNameError
from ...mechanism.asked.forces import given_value
from ...mechanism.laws.springs import Coil
from ...mechanism.loads import Mass
from ...mechanism.model import FRAME
from ...words import Words
from ..state import Points, Reals, cross
from .acting import Acting, inertia
from .laws.period import constant_size
from .laws.stands import couple_here, pull_here, size_here
from .pairs import Wrench
from .solved import Equilibrium
from .system import ROUNDING, Balance


def value(result: Equilibrium, key: str) -> Points | Reals:
    """The quantity with this key; UnknownNameError where there is none."""
    if key not in result.named:
        raise UnknownNameError(
            Words(
                f"此处没有量 {key}；已有：{', '.join(result.named)}",
                f"there is no quantity {key} here; known: {', '.join(result.named)}",
            )
        )
    with np.errstate(invalid="ignore", divide="ignore"):
        found = _value(result, key)
    return result.shaped(found)  # type: ignore[type-var, return-value]


def line(result: Equilibrium, key: str) -> Points:
    """A point of the line of action of this reaction; NaN where there is no force."""
    index, _ = _find(result, key)
    if index is None:
        return result.shaped(np.full(1, complex(np.nan, np.nan)))
    pair, wrench = result.system.pairs[index], result.wet.wrench(result.system.pairs, index)
    along = 1j * wrench.force if pair.along is None else pair.along
    with np.errstate(invalid="ignore", divide="ignore"):
        away = along * (wrench.couple / cross(along, wrench.force))
        return result.shaped(np.where(wrench.force == 0, complex(np.nan, np.nan), pair.at + away))


def couple(result: Equilibrium, key: str) -> Reals:
    """The couple (N·m) that goes with this reaction where a slide passes on a couple and no force; 0 elsewhere."""
    index, sign = _find(result, key)
    wrench = (
        Wrench(np.zeros(1, np.complex128), np.zeros(1))
        if index is None
        else result.wet.wrench(result.system.pairs, index)
    )
    passed = sign * np.where(wrench.force == 0, wrench.couple, 0.0)
    return result.shaped(np.where(np.abs(passed) <= ROUNDING * result.wet.largest * result.system.scale, 0.0, passed))


def _value(result: Equilibrium, key: str) -> Points | Reals:
    free = result.loads.unknown.name
    if key == free:
        return _balancing(result, result.wet.load)
    if key in (f"{free}_0", f"{free}_lever"):
        return _balancing(result, result.dry.load)
    if key == f"{free}_power":
        return _virtual(result)
    if key == "eta":
        return result.power_out / result.power_in
    if key == "h":
        return _arm(result)
    if key.startswith("R_"):
        return _reaction(result, key.removesuffix("_0"), result.dry if key.endswith("_0") else result.wet)
    if result.loads.constant is not None and key == result.loads.constant.name:
        return np.full(1, constant_size(result.mech, result.loads))
    if (data := given_value(result.loads, key)) is not None:
        return np.full(1, data)
    if (size := _by_law(result, key)) is not None:
        return size
    return _inertia(result, key)


def _by_law(result: Equilibrium, key: str) -> Reals | None:
    """The size of a load that depends on the motion, or of a spring; None for every other key."""
    load = next((one for one in result.loads.all if one.name == key and one.law is not None), None)
    if load is not None:
        return size_here(load, result.stands)
    spring = next((one for one in result.loads.springs if one.name == key), None)
    if spring is None:
        return None
    return couple_here(spring, result.stands) if isinstance(spring, Coil) else pull_here(spring, result.stands)


def _balancing(result: Equilibrium, load: Reals) -> Reals:
    """The balancing load; a moment or force that is nothing but rounding is zero."""
    unit = 1.0 if result.system.free.force.any() else result.system.scale
    return np.where(np.abs(load) <= ROUNDING * result.wet.largest * unit, 0.0, load)


def _find(result: Equilibrium, key: str) -> tuple[int | None, int]:
    """The pair of these links, and +1 where it holds the force on its link b;
    None: a hinge's links that are pinned through a third."""
    for index, pair in enumerate(result.system.pairs):
        if key in pair.keys:
            return index, 1 if key == pair.keys[0] else -1
    if key in result.named:
        return None, 1
    raise UnknownNameError(
        Words(
            f"没有 {key}：两构件不直接接触；已有：{', '.join(name for name in result.named if name.startswith('R_'))}",
            f"there is no {key}: the two links do not touch each other; known: "
            f"{', '.join(name for name in result.named if name.startswith('R_'))}",
        )
    )


def _reaction(result: Equilibrium, key: str, balance: Balance) -> Points:
    index, sign = _find(result, key)
    if index is None:
        return np.zeros(1, np.complex128)
    force: Points = sign * balance.wrench(result.system.pairs, index).force
    return force


def _virtual(result: Equilibrium) -> Reals:
    """Virtual power: the balancing load's size from the powers of the other loads alone, Σ F·v + Σ M ω = 0."""
    powers: Reals = sum((act.power(result.rates) for act in result.system.known), np.zeros(1))
    return -powers / result.system.free.power(result.rates)


def _arm(result: Equilibrium) -> Reals:
    """|M| / R: the frame's reaction (any reaction where the link has none)
    and everything else but M make a couple with this arm."""
    link = result.loads.unknown.link
    own = [index for index, pair in enumerate(result.system.pairs) if link in (pair.a, pair.b)]
    held = [index for index in own if FRAME in (result.system.pairs[index].a, result.system.pairs[index].b)]
    wrench: Wrench = result.wet.wrench(result.system.pairs, (held or own)[0])
    return np.abs(result.wet.load) / np.abs(wrench.force)


def _inertia(result: Equilibrium, key: str) -> Points | Reals:
    mass = next(mass for mass in result.loads.masses if key in (f"F_I{mass.link}", f"M_I{mass.link}", f"h_{mass.link}"))
    act = _acting(result, mass)
    if key[0] == "F":
        return act.force
    return act.couple if key[0] == "M" else np.abs(act.couple) / np.abs(act.force)


def _acting(result: Equilibrium, mass: Mass) -> Acting:
    if result.loads.dynamic:
        return inertia(result.mech, mass, result.motion.bodies)
    return Acting(
        name=f"F_I{mass.link}",
        link=mass.link,
        at=np.zeros(1, np.complex128),
        force=np.zeros(1, np.complex128),
        couple=np.zeros(1),
    )
