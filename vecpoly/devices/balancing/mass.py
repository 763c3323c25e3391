"""An unbalanced mass of a rotor: a lump, a hole or keyway (a negative mass), or a product that was measured."""

from __future__ import annotations

from cmath import rect
from math import pi

from pydantic import model_validator

from ...errors import FaultError
from ...units.reading import Quantity
from ...words import Words
from ..base import Length, Signed
from .written import Bearing, Density, Entry, MassOrSought, Product, is_sought

HERE = Quantity(0.0, "0 mm")
_KINDS = ("m", "hole", "keyway", "U")


class RotorDisc(Entry):
    """Thickness and density of the disc in which holes are made."""

    b: Length | None = None
    density: Density | None = None

    def unlike(
        self, index: str, b: Length | None, density: Density | None
    ) -> tuple[tuple[str, Length | None], tuple[str, Density | None]]:
        """Another thickness and another density, each under the symbol of its own; None for what is the disc's."""
        thick, dense = None if b == self.b else b, None if density == self.density else density
        return (f"b_{{{index}}}", thick), (f"ρ_{{{index}}}", dense)

    def symbols(self, index: str, b: Length | None, density: Density | None) -> tuple[str, str]:
        """Of this thickness and density: those of the disc have no index."""
        (own_b, thick), (own_rho, dense) = self.unlike(index, b, density)
        return "b" if thick is None else own_b, "ρ" if dense is None else own_rho


class RotorMass(Entry):
    """m: a lump. hole: diameter of a hole, through the thickness b or to a depth. keyway: its width, with its depth.

    U: a product m r that is known as a whole. at: its direction; z: its plane, along the axis.
    """

    m: MassOrSought | None = None
    hole: Length | None = None
    keyway: Length | None = None
    depth: Length | None = None
    U: Product | None = None
    r: Length | None = None
    at: Bearing
    z: Signed | None = None
    b: Length | None = None
    density: Density | None = None

    @model_validator(mode="after")
    def _is_one_thing(self) -> RotorMass:
        there = [kind for kind in _KINDS if getattr(self, kind) is not None]
        if len(there) != 1:
            raise FaultError(
                Words(
                    f"每个质量写 {'、'.join(_KINDS)} 之一，这里有 {'、'.join(there) or '零个'}；如写 m: 5 kg",
                    f"a mass is one of {', '.join(_KINDS)}; here stand {', '.join(there) or 'none'}: write e.g. m: 5 "
                    "kg",
                ),
                code="spelling",
                keys=there,
            )
        self._placed(there[0])
        return self

    def _placed(self, kind: str) -> None:
        """FaultError where the radius, or the depth of a keyway, is missing, or stands there for nothing."""
        if (self.r is None) != (kind == "U"):
            raise FaultError(
                Words(
                    "U 本身已是质径积，不再写 r；m、hole、keyway 则须写回转半径 r，如 r: 120 mm",
                    "U is m r already and has no r; m, hole and keyway need their radius: write e.g. r: 120 mm",
                ),
                code="missing" if self.r is None else "contradiction",
                keys=("r",),
            )
        if kind == "keyway" and self.depth is None:
            raise FaultError(
                Words("键槽须写槽深 depth，如 depth: 6 mm", "a keyway needs its depth: write e.g. depth: 6 mm"),
                code="missing",
                keys=("depth",),
            )
        if kind in ("m", "U") and (self.depth or self.b or self.density):
            raise FaultError(
                Words("depth、b、density 只属于孔和键槽", "depth, b and density belong to holes and keyways only"),
                code="contradiction",
                keys=("depth", "b", "density"),
            )

    @property
    def removed(self) -> bool:
        """Whether it is a mass that is missing."""
        return self.hole is not None or self.keyway is not None

    @property
    def unknown(self) -> tuple[str, ...]:
        """What is sought of it: m, at."""
        return tuple(key for key in ("m", "at") if is_sought(getattr(self, key)))

    @property
    def place(self) -> float:
        """Along the axis (m)."""
        return (self.z or HERE).si

    def within(self, disc: RotorDisc, name: str) -> RotorMass:
        """The same with thickness and density of the disc, where it has none of its own; FaultError for what lacks."""
        if not self.removed:
            return self
        deep = self.b or disc.b
        density = self.density or disc.density
        if density is None or (deep is None and (self.hole is None or self.depth is None)):
            raise FaultError(
                Words(
                    "孔和键槽的质量要用厚度 b 和密度 density 计算；如写 disc: {b: 40 mm, density: 7850 kg/m^3}",
                    "the mass of a hole or keyway follows from the thickness b and the density: write e.g. "
                    "disc: {b: 40 mm, density: 7850 kg/m^3}",
                ),
                "masses",
                name,
                code="missing",
                keys=("hole", "keyway"),
            )
        return self.model_copy(update={"b": deep, "density": density})

    @property
    def size(self) -> float:
        """Its mass (kg), without sign; of a hole that of what is missing."""
        if self.m is not None:
            return self.m.si
        assert self.density is not None
        if self.hole is not None:
            return self.density.si * pi / 4 * self.hole.si**2 * self.high
        assert self.keyway is not None and self.depth is not None
        return self.density.si * self.keyway.si * self.depth.si * self.high

    @property
    def high(self) -> float:
        """Along the axis how long a hole or a keyway is (m)."""
        length = self.depth if self.hole is not None and self.depth is not None else self.b
        assert length is not None
        return length.si

    @property
    def thickness(self) -> Length | None:
        """How thick the disc is at it; None of a blind hole, whose depth says how long it is."""
        return None if self.hole is not None and self.depth is not None else self.b

    def symbols(self, name: str, disc: RotorDisc) -> tuple[str, str]:
        """Of its length along the axis, and of its density."""
        b, rho = disc.symbols(name, self.thickness, self.density)
        return (f"h_{{{name}}}" if self.thickness is None else b), rho

    @property
    def product(self) -> float:
        """W = m r (kg·m), without sign."""
        if self.U is not None:
            return self.U.si
        assert self.r is not None
        return self.size * self.r.si

    @property
    def vector(self) -> complex:
        """W with its direction; of a hole it points away from the hole."""
        return rect(-self.product if self.removed else self.product, self.at.si)
