"""What a column of a table may hold: an angle, ω, α, a point's speed, a component, what a cycle's table has besides;
and its exact values."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from ...cycle.columns import Column as CycleColumn
from ...cycle.columns import column_of
from ...cycle.facts.transmission import folded
from ...cycle.sample import Sample, reader
from ...errors import UnknownNameError, VecpolyError
from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from ...names import At, Kind, Rel, parse_rel
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
    """One quantity: `link` alone is an angle φ (rad), `other` a key that the cycle knows, else `rel` and which number
    of it; all SI."""

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
_REACTION = re.compile(r"[RF]_?(\d\d)[._]?(x|y)?")
_LENGTH = re.compile(r"[ls]_?([A-Z])([A-Z])")
_DRIVE = (
    "phi",
    "曲柄角",
    "主动件转角",
    "原动件转角",
    "曲柄角度",
    "theta",
    "angle",
    "crankangle",
    "crank_angle",
    "position",
    "s",
    "曲柄转角",
    "转角",
    "角度",
    "位置",
)
_KINDS = {"v": Kind.V, "a": Kind.A, "s": Kind.P, "": Kind.P}
STEMS = ("phi", "theta", "omega", "alpha", "gamma", "x", "y", "vx", "vy", "ax", "ay", "v", "a")


_WORDS = (
    (r"(?:构件|杆|link)?(\d+)的?(角位移|转角|角度|方位角|angle)", r"phi\1"),
    (r"(?:构件|杆|link)?(\d+)的?(角速度)", r"omega\1"),
    (r"(?:构件|杆|link)?(\d+)的?(角加速度)", r"alpha\1"),
    (r"(?:点)?([A-Z])点?的?([xyXY])(?:坐标|位移)", r"\2\1"),
    (r"(?:点)?([A-Z])点?的?([xyXY])?(?:方向|向)?的?(?:分)?速度", r"v\2\1"),
    (r"(?:点)?([A-Z])点?的?([xyXY])?(?:方向|向)?的?(?:分)?加速度", r"a\2\1"),
    (r"(?:曲柄|原动件|主动件)?(?:转角|角位移|角度)([φθϕ]_?\d+)", r"\1"),
    (r"(?:角速度|角加速度|转角|角位移|速度|加速度|坐标)([a-zA-Zφθϕωαε]_?\w+)", r"\1"),
)


def plain_name(name: str) -> str:
    """The symbol that a header in words stands for: 构件5的角速度 → omega5, D点加速度 → aD, \\omega_5 → omega_5."""
    text = re.sub(r"\\(?:var)?([a-z]+)", r"\1", name.strip().replace(" ", "")) if "\\" in name else name.strip()
    for pattern, symbol in _WORDS:
        if m := re.fullmatch(pattern, text):
            return m.expand(symbol).replace("X", "x").replace("Y", "y")
    return text


def is_drive(name: str) -> bool:
    """Whether a name without a link means the position of the drive: phi, s, 曲柄转角."""
    return plain_name(name).translate(_GREEK).lower() in _DRIVE


def read_other(name: str, mech: Mechanism, loads: Loads | None) -> Target | None:
    """A key of the cycle's own columns: s_45, v_45, a_45, gamma_23, M_1, R_12.x, R12x, R12 (its magnitude); None where
    it is none."""
    text = name.translate(_GREEK)
    if m := _REACTION.fullmatch(text):
        text = f"R_{m[1]}.{m[2] or 'abs'}"
    for key in (text, re.sub(r"^([A-Za-z]+?)_?(\d+)$", r"\1_\2", text)):
        try:
            column = column_of(mech, loads, key)
        except VecpolyError:
            continue
        if (
            not column.is_vector
            and re.match(r"(s|v|a|gamma|d|M|F|R|eta|h|Q)(_|$)", key)
            and (column.symbol[0] not in "ωα")
        ):
            return Target(other=Other(column=column, loads=loads))
    return None


def read_target(name: str) -> Target | None:
    """phi5, θ5, omega_5, w5, α5, a5, xE, vxE, v_Ex, vE, a_E, l_AB, or a key such as ak_B3B2; None where it is no
    quantity."""
    text = re.sub(
        r"^(p|v|a)_(.+)\.([xy])$", lambda m: f"{m[1].replace('p', '')}{m[3]}_{m[2]}", plain_name(name).translate(_GREEK)
    )
    if text.endswith(".abs"):
        text = text.removesuffix(".abs")
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
