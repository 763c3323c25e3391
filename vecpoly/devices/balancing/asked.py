"""What is asked of a rotor, by key. Heavy rotors are told in kg·m and kg, light ones in g·mm and g."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from ...foundation.slotted import dataclass
from ...names import Named
from .mass import RotorMass
from .plane import RotorPlane

LIGHT_BELOW = 0.01  # kg·m: products of rotors that are told in g·mm
CLOSES = 0.005  # of the sum of all products: a closing side so short is none, on paper half a millimetre of a hundred


@dataclass(frozen=True, slots=True, kw_only=True)
class Weighing:
    """Units of masses and of products, and how many of them are a kilogram, a kg·m."""

    mass: str
    product: str
    masses: float
    products: float


HEAVY = Weighing(mass="kg", product="kg·m", masses=1.0, products=1.0)
LIGHT = Weighing(mass="g", product="g·mm", masses=1e3, products=1e6)


def weighing(products: list[float]) -> Weighing:
    """The units that suit these products (kg·m)."""
    return LIGHT if max(products, default=1.0) < LIGHT_BELOW else HEAVY


def mass_of(name: str, unit: Weighing) -> Named:
    """m_2: of a hole, or of what is sought."""
    return Named(f"m_{name}", f"m_{{{name}}}", unit.mass)


def product_of(name: str, unit: Weighing, plane: str = "") -> Named:
    """W_2, or its share W_2I in a plane."""
    return Named(f"W_{name}{plane}", f"W_{{{name}{plane}}}", unit.product)


def correction(plane: str, unit: Weighing) -> Named:
    """W_bI: the product that balances a plane."""
    return Named(f"W_b{plane}", f"W_{{b{plane}}}", unit.product, True)


def bearing(plane: str) -> Named:
    """theta_bI: its direction, 0 to 360°."""
    return Named(f"theta_b{plane}", f"θ_{{b{plane}}}", "deg")


def weight(plane: str, unit: Weighing) -> Named:
    """m_bI: the weight that is added, or the mass that is drilled out."""
    return Named(f"m_b{plane}", f"m_{{b{plane}}}", unit.mass)


def hole_bearing(plane: str) -> Named:
    """theta_hI: where the hole is drilled, or the middle between two."""
    return Named(f"theta_h{plane}", f"θ_{{h{plane}}}", "deg")


def hole_size(plane: str, through: bool) -> Named:
    """d_bI, the diameter of a hole through the disc; h_bI, the depth of one that is not (mm)."""
    letter = "d" if through else "h"
    return Named(f"{letter}_b{plane}", f"{letter}_{{b{plane}}}", "mm")


def share_bearing(plane: str, which: int) -> Named:
    """theta_bI_1: the first of the two places that are used."""
    return Named(f"theta_b{plane}_{which}", f"θ_{{b{plane},{which}}}", "deg")


def share(plane: str, which: int, unit: Weighing) -> Named:
    """W_bI_1: what the first of the two places takes; negative: mass is removed there."""
    return Named(f"W_b{plane}_{which}", f"W_{{b{plane},{which}}}", unit.product)


def share_weight(plane: str, which: int, unit: Weighing) -> Named:
    """m_bI_1: the same as a weight."""
    return Named(f"m_b{plane}_{which}", f"m_{{b{plane},{which}}}", unit.mass)


def residual(plane: str, unit: Weighing) -> Named:
    """W_rI: what unbalance the weights there are leave."""
    return Named(f"W_r{plane}", f"W_{{r{plane}}}", unit.product, True)


def static_unbalance(unit: Weighing) -> Named:
    """W_S: the sum of all products."""
    return Named("W_S", "W_S", unit.product, True)


STATIC, DYNAMIC = Named("static", "ΣW = 0", "yes/no"), Named("dynamic", "ΣW l = 0", "yes/no")
PER_RADIUS = Named("e_per", "e_{per}", "μm")


def permitted(plane: str, unit: Weighing) -> Named:
    """U_perI: the permissible unbalance of a plane."""
    return Named(f"U_per{plane}", f"U_{{per{plane}}}", unit.product)


def within(plane: str) -> Named:
    """within_I: whether what unbalance there is lies inside its circle."""
    tail = f"_{plane}" if plane else ""
    side = f"W_{{r{plane}}} ≤ U_{{per{plane}}}"
    return Named(f"within{tail}", side, "yes/no")


def of_rotor(
    masses: Mapping[str, RotorMass], planes: Mapping[str, RotorPlane], unit: Weighing, *, graded: bool
) -> Iterator[Named]:
    """All that is asked of a rotor whose masses are known; planes: by their subscripts."""
    for name, mass in masses.items():
        if mass.removed:
            yield mass_of(name, unit)
        if mass.U is None:
            yield product_of(name, unit)
    if len(planes) > 1:
        yield from (product_of(name, unit, end) for end in planes for name in masses)
        yield from (static_unbalance(unit), STATIC, DYNAMIC)
    for end, plane in planes.items():
        yield from (correction(end, unit), bearing(end))
        yield from _placed(end, plane, unit)
    if graded:
        yield PER_RADIUS
        yield from (permitted(end, unit) for end in dict.fromkeys(("", *planes)))
        yield from (within(end) for end in planes)


def _placed(end: str, plane: RotorPlane, unit: Weighing) -> Iterator[Named]:
    """What is added or taken away in a plane."""
    if plane.hole is not None:
        yield from (weight(end, unit), hole_size(end, plane.through), hole_bearing(end))
    elif plane.places is not None:
        for which in (1, 2):
            yield from (share_bearing(end, which), share(end, which, unit), share_weight(end, which, unit))
    elif plane.r is not None:
        yield weight(end, unit)
    if plane.step is not None:
        yield residual(end, unit)
