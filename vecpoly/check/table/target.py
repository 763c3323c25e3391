"""What a column of a table may hold: an angle, ω, α, a point's speed,
a component, what a cycle's table has besides; and its exact values."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from ...cycle.column import Column as CycleColumn
from ...cycle.facts.transmission import folded
from ...cycle.sample import Sample, reader
from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from ...names import At, Kind, Rel
from ...oracle import Motion

Reals = NDArray[np.float64]


class Part(StrEnum):
    """Which number of a quantity: its value, its magnitude, or a component."""

    VALUE = "value"
    SIZE = "size"
    X = "x"
    Y = "y"


@dataclass(frozen=True, slots=True, kw_only=True)
class Other:
    """A column of the cycle's own: travel s_45, transmission angle γ_23, reaction R_12.x, balancing moment M_1."""

    column: CycleColumn
    loads: Loads | None = field(default=None, compare=False, repr=False)

    def of(self, motion: Motion) -> Reals:
        """Its values at all positions of this motion."""
        drive = motion.mech.drive
        positions = np.asarray(motion.angle(drive.link)) if not drive.slide else np.zeros(motion.shape)
        value = reader(motion.mech, self.loads, self.column.key)(Sample(motion.mech, self.loads, positions, motion))
        values = np.broadcast_to(np.real(value), motion.shape).astype(np.float64)
        return folded(values) if self.is_transmission else values

    @property
    def is_transmission(self) -> bool:
        """Whether it is a transmission angle γ, which is told as the acute one."""
        return self.column.key.startswith("gamma_")


@dataclass(frozen=True, slots=True, kw_only=True)
class Target:
    """One quantity: `link` alone is an angle φ (rad), `other` a key that the cycle knows,
    else `rel` and which number of it; all SI."""

    rel: Rel | None = None
    link: str = ""
    part: Part = Part.VALUE
    other: Other | None = None

    @property
    def is_angle(self) -> bool:
        """Whether whole turns do not matter."""
        return self.rel is None and self.other is None

    @property
    def is_place(self) -> bool:
        """Whether it tells where the links are, and not how they move."""
        if self.other is not None:
            return self.other.column.unit in ("rad", "m")
        return self.rel is None or self.rel.kind is Kind.P

    @property
    def of_link(self) -> str:
        """The link whose φ, ω or α it is; empty for a point's quantity."""
        return self.link or (self.rel.to.link if self.rel and not self.rel.is_vector else "")

    def on(self, link: str) -> Target:
        """The same of another link."""
        if self.other is not None:
            return self
        return Target(link=link) if self.rel is None else Target(rel=Rel(self.rel.kind, At("", link)), part=self.part)

    @property
    def key(self) -> str:
        """phi_5, omega_5, v_E, vx_E, x_E, s_45."""
        if self.other is not None:
            return self.other.column.key
        if self.rel is None:
            return f"phi_{self.link}"
        stem, _, body = self.rel.key.partition("_")
        if self.part in (Part.VALUE, Part.SIZE):
            return f"l_{self.rel.ref}{self.rel.to}" if self.rel.kind is Kind.P else self.rel.key
        return f"{self.part}_{body}" if self.rel.kind is Kind.P else f"{stem}{self.part}_{body}"

    @property
    def symbol(self) -> str:
        """The same in the notation of `formula`."""
        if self.other is not None:
            return self.other.column.symbol
        if self.rel is None:
            return f"φ_{{{self.link}}}"
        if self.part in (Part.VALUE, Part.SIZE):
            return f"l_{{{self.rel.ref}{self.rel.to}}}" if self.rel.kind is Kind.P else self.rel.symbol
        body = self.rel.symbol.partition("_")[2].strip("{}")
        return f"{self.part}_{{{body}}}" if self.rel.kind is Kind.P else f"{self.rel.kind.stem}_{{{body}{self.part}}}"

    def named_as_in(self, header: str) -> str:
        """Its symbol with the letter that a header has for an angle: θ_{5}."""
        return self.symbol.replace("φ", "θ") if self.is_angle and re.match("theta|th|θ", header, re.I) else self.symbol

    @property
    def unit(self) -> str:
        """SI unit."""
        if self.other is not None:
            return self.other.column.unit
        return "rad" if self.rel is None else self.rel.unit

    def of(self, motion: Motion) -> Reals:
        """Its values at all positions of this motion."""
        if self.other is not None:
            return self.other.of(motion)
        if self.rel is None:
            value: NDArray[np.float64] | NDArray[np.complex128] = motion.angle(self.link)
        else:
            value = motion.value(self.rel)
        match self.part:
            case Part.SIZE:
                value = np.abs(value)
            case Part.Y:
                value = value.imag
        return np.broadcast_to(value.real, motion.shape).astype(np.float64)


def others(mech: Mechanism, of: Target) -> list[tuple[Target, Target | None]]:
    """Quantities of the same kind with which a column may have been mixed up; with a second one, their difference."""
    bodies = mech.numbered
    if of.other is not None:
        return []
    if of.rel is None:
        angles = [Target(link=link) for link in bodies]
        return [(one, None) for one in angles if one != of] + [(of, one) for one in angles if one != of]
    if not of.rel.is_vector:
        rates = [Target(rel=Rel(of.rel.kind, At("", link))) for link in bodies]
        return [(one, None) for one in rates if one != of] + [(of, one) for one in rates if one != of]
    letters = sorted({letter for link in mech.links for letter in link.points if letter not in mech.frame})
    same = [Target(rel=Rel(of.rel.kind, At(letter)), part=of.part) for letter in letters]
    if of.part in (Part.X, Part.Y):
        same += [Target(rel=of.rel, part=Part.Y if of.part is Part.X else Part.X)]
    elif of.rel.kind is not Kind.P:
        same += [Target(rel=of.rel, part=Part.X), Target(rel=of.rel, part=Part.Y)]
        same += [
            Target(rel=Rel(of.rel.kind, of.rel.to, At(letter)), part=Part.SIZE)
            for letter in letters
            if letter != of.rel.to.point
        ]
    return [(one, None) for one in same if one != of]
