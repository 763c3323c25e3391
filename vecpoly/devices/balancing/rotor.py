"""A rotor with unbalanced masses: corrected in one plane (static), in two (dynamic), or by masses that are sought.

data: {masses: {1: {m: 5 kg, r: 200 mm, at: 60 deg}}, correct: {I: {r: 250 mm}}}
data: {masses: {1: {m: 5 kg, r: 200 mm, at: 60 deg, z: 150 mm}}, correct: {I: {z: 0 mm}, II: {z: 800 mm, r: 250 mm}}}
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import ClassVar

from pydantic import Field, model_validator

from ...errors import FaultError
from ...names import Named
from ...words import Words
from ..base import Device, Length, Signed, Speed, Written, as_written
from .asked import CLOSES, Weighing, of_rotor, weighing
from .mass import RotorDisc, RotorMass
from .plane import RotorPlane
from .refused import leaves_couple, outside
from .sought import check_sought, sought_quantities
from .told import planes_told, rotor_task
from .written import Entry, MassSize, Turning, named_well

MOST, PLANES = 12, 2
TAKEN = ("b", "r", "S", "h")  # subscripts that mean something else


class RotorTolerance(Entry):
    """A grade of balance quality: G = e ω, the mass of the rotor, its speed, where its centre of mass lies."""

    G: Speed
    mass: MassSize
    n: Turning
    z: Signed | None = None


class RotorBody(Entry):
    """A drum, a disc, a pulley on the shaft, as it is sketched: from here to there along the axis, with a radius."""

    start: Signed = Field(alias="from")
    end: Signed = Field(alias="to")
    r: Length


class Rotor(Device):
    """Masses by their names; planes of correction by theirs; a grade where one is asked for; what sits on the shaft."""

    kind: ClassVar[str] = "rotor"
    masses: dict[str, RotorMass]
    correct: dict[str, RotorPlane] = Field(default_factory=dict)
    disc: RotorDisc = RotorDisc()
    tolerance: RotorTolerance | None = None
    bodies: tuple[RotorBody, ...] = ()

    @model_validator(mode="after")
    def _possible(self) -> Rotor:
        if not 1 <= len(self.masses) <= MOST:
            raise FaultError(
                Words(
                    f"masses 有 {len(self.masses)} 个质量，应为 1 至 {MOST} 个",
                    f"there are {len(self.masses)} masses; 1 to {MOST} are drawn",
                ),
                code="out-of-range",
                numbers={"masses": len(self.masses)},
                keys=("masses",),
            )
        named_well([*self.masses, *self.correct], Words("质量或平面", "a mass or a plane"), TAKEN)
        object.__setattr__(self, "masses", {name: self._whole(name) for name in self.masses})
        object.__setattr__(self, "correct", {name: one.within(self.disc, name) for name, one in self.correct.items()})
        if any(mass.unknown for mass in self.masses.values()):
            check_sought(self.masses, bool(self.correct or self.tolerance))
        else:
            self._planes_differ()
        return self

    def _whole(self, name: str) -> RotorMass:
        """A mass with what the disc says of holes; FaultError where a hole is deeper than the disc."""
        mass = self.masses[name].within(self.disc, name)
        if mass.hole is not None and mass.b is not None and mass.high > mass.b.si * (1 + 1e-9):
            raise FaultError(
                Words(
                    f"质量 {name}：孔深 {1e3 * mass.high:g} mm 大于盘厚 {mass.b.text}",
                    f"mass {name}: a hole {1e3 * mass.high:g} mm deep in a disc of {mass.b.text}",
                ),
                code="out-of-range",
                numbers={"depth": mass.high, "b": mass.b.si},
                keys=(("masses", name), "disc"),
            )
        return mass

    def _planes_differ(self) -> None:
        """FaultError where there is no plane, a third one, or two that coincide."""
        planes = list(self.correct.values())
        if not 1 <= len(planes) <= PLANES:
            raise FaultError(
                Words(
                    f"校正平面 correct 应为一个（静平衡）或两个（动平衡），这里有 {len(planes)} 个；"
                    "如写 correct: {I: {z: 0 mm}, II: {z: 800 mm}}",
                    f"correct names one plane (static balance) or two (dynamic balance), here {len(planes)}; "
                    "write e.g. correct: {I: {z: 0 mm}, II: {z: 800 mm}}",
                ),
                code="missing",
                numbers={"planes": len(planes)},
                keys=("correct",),
            )
        if len(planes) == PLANES and abs(planes[0].at - planes[1].at) < self.length * 1e-6 + 1e-9:
            (one, first), (other, second) = self.correct.items()
            raise FaultError(
                Words(
                    f"校正平面 {one}（z = {1e3 * first.at:g} mm）与 {other}（z = {1e3 * second.at:g} mm）重合，"
                    "力偶无法平衡；请取相距较远的两个平面",
                    f"the planes {one} (z = {1e3 * first.at:g} mm) and {other} (z = {1e3 * second.at:g} mm) coincide: "
                    "no couple can be balanced in them; take two planes that are apart",
                ),
                code="contradiction",
                numbers={"z_1": first.at, "z_2": second.at},
                keys=(("correct", one), ("correct", other)),
            )
        assert self.parts()  # its refusal

    def noted(self, asked: Collection[str]) -> tuple[Words, ...]:
        """The couple that a correction in one plane leaves."""
        if not self.static:
            return ()
        (plane,) = self.correct.values()
        couple = abs(sum(mass.vector * (mass.place - plane.at) for mass in self.masses.values()))
        whole = sum(mass.product for mass in self.masses.values()) * self.length
        return (leaves_couple(couple),) if couple > CLOSES * whole else ()

    @property
    def weighing(self) -> Weighing:
        """The units in which it is told."""
        return weighing([mass.product for mass in self.masses.values() if "m" not in mass.unknown])

    @property
    def static(self) -> bool:
        """Whether it is corrected in one plane."""
        return len(self.correct) == 1

    @property
    def ends(self) -> tuple[str, ...]:
        """Subscripts of the planes: none where there is one."""
        return ("",) if self.static else tuple(self.correct)

    @property
    def planes(self) -> dict[str, RotorPlane]:
        """The planes by their subscripts."""
        return dict(zip(self.ends, self.correct.values(), strict=True)) if self.correct else {}

    @property
    def sought(self) -> bool:
        """Whether masses, or where they sit, are what is to be found (Dalby)."""
        return any(mass.unknown for mass in self.masses.values())

    @property
    def stations(self) -> tuple[float, ...]:
        """All places along the axis (m)."""
        return (*(mass.place for mass in self.masses.values()), *(plane.at for plane in self.correct.values()))

    @property
    def length(self) -> float:
        """From the first to the last place along the axis (m)."""
        return max(self.stations) - min(self.stations)

    @property
    def shares(self) -> dict[str, dict[str, float]]:
        """Of every plane the part of each mass that it takes by the lever; overhung: one is negative."""
        if self.static:
            return {"": dict.fromkeys(self.masses, 1.0)}
        (one, first), (other, second) = self.correct.items()
        part = {name: (second.at - mass.place) / (second.at - first.at) for name, mass in self.masses.items()}
        return {one: part, other: {name: 1 - share for name, share in part.items()}}

    def permitted(self) -> dict[str, float]:
        """U_per (kg·m) of every plane, by the distance of the centre of mass from the other."""
        assert self.tolerance is not None
        whole = self.tolerance.mass.si * self.tolerance.G.si / self.tolerance.n.si
        return {end: whole * part for end, part in self.parts().items()}

    def parts(self) -> dict[str, float]:
        """The part of the permissible unbalance that each plane may have."""
        if self.static:
            return {"": 1.0}
        (one, first), (other, second) = self.correct.items()
        centre = self.tolerance.z if self.tolerance is not None else None
        part = 0.5 if centre is None else (second.at - centre.si) / (second.at - first.at)
        if not 0 < part < 1:
            raise outside(part, one, other)
        return {one: part, other: 1 - part}

    def task(self, asked: Collection[str]) -> Words:
        """What is out of balance, and where it is corrected."""
        written = [symbol for symbol, _ in self.given()]
        return rotor_task(written, self.ends if self.correct else None, list(self.correct), asked)

    def quantities(self) -> tuple[Named, ...]:
        """Masses of holes, products, shares; of every plane what balances it; what is permitted."""
        if self.sought:
            return sought_quantities(self.masses, self.weighing)
        return tuple(of_rotor(self.masses, self.planes, self.weighing, graded=self.tolerance is not None))

    def told(self) -> tuple[Words, ...]:
        """Where weights may sit, and how holes are drilled."""
        return planes_told(self.correct)

    def given(self) -> tuple[tuple[str, str], ...]:
        """The masses, the planes, the grade, as written."""
        rows: list[tuple[str, Written | None]] = []
        for name, mass in self.masses.items():
            sizes = (("m", mass.m), ("d", mass.hole), ("w", mass.keyway), ("h", mass.depth), ("W", mass.U))
            places = (("r", mass.r), ("θ", mass.at), ("z", mass.z))
            rows += [(f"{symbol}_{{{name}}}", value) for symbol, value in (*sizes, *places)]
            rows += self.disc.unlike(name, mass.thickness, mass.density) if mass.removed else ()
        rows += [("b", self.disc.b), ("ρ", self.disc.density)]
        for end, plane in self.planes.items():
            rows += [(f"z_{{b{end}}}", plane.z), (f"r_{{b{end}}}", plane.r), (f"d_{{b{end}}}", plane.drill)]
            rows += self.disc.unlike(f"b{end}", plane.b, plane.density) if plane.hole is not None else ()
        if (grade := self.tolerance) is not None:
            rows += [("G", grade.G), ("m", grade.mass), ("n", grade.n), ("z_S", grade.z)]
        return as_written(rows)

    @property
    def directions(self) -> frozenset[str]:
        """Those of the corrections: of a rotor in balance there are none."""
        return frozenset(f"theta_{letter}{end}" for letter in "bh" for end in self.planes)

    @property
    def likely(self) -> Mapping[str, float]:
        """All products together, and the mass that would balance them."""
        unit = self.weighing
        whole = sum(mass.product for mass in self.masses.values() if "m" not in mass.unknown)
        radii = [*(mass.r for mass in self.masses.values()), *(plane.r for plane in self.correct.values())]
        heavy = whole / min((radius.si for radius in radii if radius is not None), default=1.0)
        return {unit.product: whole * unit.products, unit.mass: heavy * unit.masses, "mm": 10.0}

    @property
    def size(self) -> float:
        """The length of the shaft, or the largest radius (m)."""
        return max([self.length, *(mass.r.si for mass in self.masses.values() if mass.r is not None)], default=0.1)
