"""Masses that are sought so that a shaft is in balance (Dalby): which unknowns can be found, and under which names."""

from __future__ import annotations

from collections.abc import Mapping

from ...errors import EquilibriumError, FaultError
from ...names import Named
from ...words import Words
from .asked import Weighing
from .mass import RotorMass
from .several import of_solution

SCALARS = 2  # that one couple polygon finds


def reference(masses: Mapping[str, RotorMass]) -> str:
    """The first mass of which all is unknown: its plane is the reference plane."""
    return next(name for name, mass in masses.items() if len(mass.unknown) == SCALARS)


def unknowns(masses: Mapping[str, RotorMass]) -> tuple[tuple[str, str], ...]:
    """The two that the couple polygon finds: name of the mass, m or at."""
    first = reference(masses)
    return tuple((name, key) for name, mass in masses.items() if name != first for key in mass.unknown)


def ambiguous(masses: Mapping[str, RotorMass]) -> bool:
    """Whether an arc is swung: then there are two answers."""
    found = unknowns(masses)
    return len({name for name, _ in found}) == SCALARS and any(key == "at" for _, key in found)


def check_sought(masses: Mapping[str, RotorMass], corrected: bool) -> None:
    """FaultError where the masses sought cannot be found by a couple polygon and a force polygon."""
    if corrected:
        raise FaultError(
            Words(
                "有待求质量（?）时，平衡由它们实现，不再写 correct 和 tolerance",
                "masses that are sought (?) do the balancing themselves: leave out correct and tolerance",
            ),
            code="contradiction",
            keys=("correct", "tolerance"),
        )
    whole = [name for name, mass in masses.items() if len(mass.unknown) == SCALARS]
    rest = sum(len(mass.unknown) for mass in masses.values()) - SCALARS
    if not whole or rest != SCALARS:
        raise FaultError(
            Words(
                "达尔比法求四个未知量：一个质量的 m 和 at 都写 ?（其平面为参考平面），其余质量中再有两个 ?；"
                f"这里全未知的质量有 {len(whole)} 个，其余未知量 {rest if whole else rest + SCALARS} 个",
                "Dalby's polygons find four unknowns: m and at of one mass (its plane is the reference plane), and two "
                f"among the others; here {len(whole)} masses are wholly unknown, with "
                f"{rest if whole else rest + SCALARS} unknowns beside",
            ),
            code="missing",
            numbers={"whole": len(whole), "others": rest},
            keys=("masses",),
        )
    here = masses[whole[0]].place
    flat = [name for name, mass in masses.items() if name != whole[0] and mass.unknown and mass.place == here]
    if flat:
        raise FaultError(
            Words(
                f"质量 {flat[0]} 在参考平面（质量 {whole[0]} 的平面，z = {1e3 * here:g} mm）内，对它没有力臂，"
                "力偶多边形不能确定它",
                f"mass {flat[0]} lies in the reference plane, that of mass {whole[0]} (z = {1e3 * here:g} mm): without "
                "an arm it is not in the couple polygon and cannot be found",
            ),
            code="contradiction",
            numbers={"z": here},
            keys=(("masses", flat[0]), ("masses", whole[0])),
        )


def no_polygon(gap: float, largest: float, others: float) -> EquilibriumError:
    """What is said of couples that form no polygon."""
    return EquilibriumError(
        Words(
            f"力偶多边形不能闭合：最大的力偶 {largest:.4g} kg·m² 大于其余各力偶之和 {others:.4g} kg·m²，"
            f"相差 {gap:.4g} kg·m²，两弧不相交，任何角度都不能平衡；请减小该质量、其半径或力臂，或增大其他质量",
            f"the couples form no polygon: the largest, {largest:.4g} kg·m², exceeds the sum of the others, "
            f"{others:.4g} kg·m², by {gap:.4g} kg·m²; the arcs do not meet and no angles give balance: lower that "
            "mass, its radius or its arm, or raise the others",
        ),
        code="no-polygon",
        numbers={"gap": gap, "largest": largest, "others": others},
    )


def parallel_couples(one: float, other: float) -> EquilibriumError:
    """Two masses of unknown size in one line."""
    return EquilibriumError(
        Words(
            f"两个待求质量的方位 {one:g}° 和 {other:g}° 在同一直线上，力偶多边形不能确定它们；请改变其一",
            f"the two masses whose sizes are sought lie in one line, at {one:g}° and {other:g}°: the couple polygon "
            "does "
            "not determine them; change one direction",
        ),
        code="parallel",
        numbers={"at_1": one, "at_2": other},
    )


def couple_of(name: str) -> Named:
    """C_B: the couple W z of a mass about the reference plane (kg·m²), without sign."""
    return Named(f"C_{name}", f"C_{{{name}}}", "kg·m^2")


def found_mass(name: str, which: str, unit: Weighing) -> Named:
    """m_A, or m_A_1 where there are two answers."""
    return of_solution("m", "m", name, which, unit.mass)


def found_bearing(name: str, which: str) -> Named:
    """theta_A, or theta_A_1."""
    return of_solution("theta", "θ", name, which, "deg")


def answers_of(masses: Mapping[str, RotorMass]) -> tuple[str, ...]:
    """The endings of the answers: one without, or two."""
    return ("_1", "_2") if ambiguous(masses) else ("",)


def sought_quantities(masses: Mapping[str, RotorMass], unit: Weighing) -> tuple[Named, ...]:
    """The known couples, then of every answer what is found."""
    first = reference(masses)
    couples = [couple_of(name) for name, mass in masses.items() if name != first and "m" not in mass.unknown]
    found: list[Named] = []
    for which in answers_of(masses):
        for name, key in (*unknowns(masses), (first, "m"), (first, "at")):
            found.append(found_mass(name, which, unit) if key == "m" else found_bearing(name, which))
    return (*couples, *found)
