"""What a column of a table may hold: an angle, ω, α, a point's speed, a component; and its exact values over all positions."""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from ..errors import UnknownNameError
from ..mechanism.model import Mechanism
from ..names import At, Kind, Rel, parse_rel
from ..oracle import Motion

Reals = NDArray[np.float64]


class Part(StrEnum):
    """Which number of a quantity: its value, its magnitude, or a component."""

    VALUE = "value"
    SIZE = "size"
    X = "x"
    Y = "y"


@dataclass(frozen=True, slots=True, kw_only=True)
class Target:
    """One quantity: `link` alone is an angle φ (rad), else `rel` and which number of it; all SI."""

    rel: Rel | None = None
    link: str = ""
    part: Part = Part.VALUE

    @property
    def is_angle(self) -> bool:
        """Whether whole turns do not matter."""
        return self.rel is None

    @property
    def is_place(self) -> bool:
        """Whether it tells where the links are, and not how they move."""
        return self.rel is None or self.rel.kind is Kind.P

    @property
    def of_link(self) -> str:
        """The link whose φ, ω or α it is; empty for a point's quantity."""
        return self.link or (self.rel.to.link if self.rel and not self.rel.is_vector else "")

    def on(self, link: str) -> Target:
        """The same of another link."""
        return Target(link=link) if self.rel is None else Target(rel=Rel(self.rel.kind, At("", link)), part=self.part)

    @property
    def key(self) -> str:
        """phi_5, omega_5, v_E, vx_E, x_E."""
        if self.rel is None:
            return f"phi_{self.link}"
        stem, _, body = self.rel.key.partition("_")
        if self.part in (Part.VALUE, Part.SIZE):
            return f"l_{self.rel.ref}{self.rel.to}" if self.rel.kind is Kind.P else self.rel.key
        return f"{self.part}_{body}" if self.rel.kind is Kind.P else f"{stem}{self.part}_{body}"

    @property
    def symbol(self) -> str:
        """The same in the notation of `formula`."""
        if self.rel is None:
            return f"φ_{{{self.link}}}"
        if self.part in (Part.VALUE, Part.SIZE):
            return f"l_{{{self.rel.ref}{self.rel.to}}}" if self.rel.kind is Kind.P else self.rel.symbol
        body = self.rel.symbol.partition("_")[2].strip("{}")
        return f"{self.part}_{{{body}}}" if self.rel.kind is Kind.P else f"{self.rel.kind.stem}_{{{body}{self.part}}}"

    @property
    def unit(self) -> str:
        """SI unit."""
        return "rad" if self.rel is None else self.rel.unit

    def of(self, motion: Motion) -> Reals:
        """Its values at all positions of this motion."""
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


_GREEK = str.maketrans({"φ": "phi", "ϕ": "phi", "θ": "theta", "ψ": "psi", "ω": "omega", "α": "alpha", "ε": "eps",
                        "$": "", "{": "", "}": "", "^": "", "₀": "0", "₁": "1", "₂": "2", "₃": "3", "₄": "4", "₅": "5",
                        "₆": "6", "₇": "7", "₈": "8", "₉": "9", " ": ""})  # fmt: skip
_LINK = r"_?(\d+[a-z']?)"
_LETTER = r"_?([A-Z][a-z']?\d*)"
_ANGLE = re.compile(rf"(?:phi|theta|psi|angle|th|fi|f){_LINK}", re.I)
_OMEGA = re.compile(rf"(?:omega|om|w){_LINK}", re.I)
_ALPHA = re.compile(rf"(?:alpha|alfa|eps|epsilon|e|a){_LINK}", re.I)
_COMPONENT = re.compile(rf"([vas]?)_?([xy]){_LETTER}|([vas])?_?([A-Z][a-z']?\d*)_?([xy])")
_SIZE = re.compile(rf"([va]){_LETTER}")
_LENGTH = re.compile(r"[ls]_?([A-Z])([A-Z])")
_DRIVE = ("phi", "theta", "angle", "crankangle", "crank_angle", "position", "s", "曲柄转角", "转角", "角度", "位置")
_KINDS = {"v": Kind.V, "a": Kind.A, "s": Kind.P, "": Kind.P}
STEMS = ("phi", "theta", "omega", "alpha", "x", "y", "vx", "vy", "ax", "ay", "v", "a")


def is_drive(name: str) -> bool:
    """Whether a name without a link means the position of the drive: phi, s, 曲柄转角."""
    return name.translate(_GREEK).lower() in _DRIVE


def read_target(name: str) -> Target | None:
    """phi5, θ5, omega_5, w5, α5, a5, xE, vxE, v_Ex, vE, a_E, l_AB, or a key such as ak_B3B2; None where it is no quantity."""
    text = name.translate(_GREEK)
    if m := _OMEGA.fullmatch(text):
        return Target(rel=Rel(Kind.OMEGA, At("", m[1])))
    if m := _ALPHA.fullmatch(text):
        return Target(rel=Rel(Kind.ALPHA, At("", m[1])))
    if m := _ANGLE.fullmatch(text):
        return Target(link=m[1])
    if m := _COMPONENT.fullmatch(text):
        kind, axis, letter = (m[1], m[2], m[3]) if m[3] else (m[4] or "", m[6], m[5])
        return Target(rel=Rel(_KINDS[kind], At(letter)), part=Part(axis))
    if m := _SIZE.fullmatch(text):
        return Target(rel=Rel(_KINDS[m[1]], At(m[2])), part=Part.SIZE)
    if m := _LENGTH.fullmatch(text):
        return Target(rel=Rel(Kind.P, At(m[2]), At(m[1])), part=Part.SIZE)
    try:
        return Target(rel=parse_rel(text), part=Part.SIZE)
    except UnknownNameError:
        return None


def others(mech: Mechanism, of: Target) -> list[tuple[Target, Target | None]]:
    """Quantities of the same kind with which a column may have been mixed up; with a second one, their difference."""
    bodies = mech.bodies
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
        same += [Target(rel=Rel(of.rel.kind, of.rel.to, At(letter)), part=Part.SIZE) for letter in letters if letter != of.rel.to.point]
    return [(one, None) for one in same if one != of]
