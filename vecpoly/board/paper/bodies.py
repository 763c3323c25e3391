"""Marks of links and joints: the symbols of GB/T 4460, in mm on the figure."""

from __future__ import annotations

from ...foundation.slotted import dataclass
from .known import Ink


@dataclass(frozen=True, slots=True, kw_only=True)
class Plate(Ink):
    """A rigid link with three or more points, drawn as one body (GB/T 4460)."""

    points: tuple[complex, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Ground(Ink):
    """A fixed pivot: triangle on hatched ground, the hatching on the side `down` (unit complex number)."""

    at: complex
    down: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class FixedGuide(Ink):
    """A hatched fixed guide line from a to b; the hatching lies to the right of a -> b.

    about: the place on paper of the block or rack that it leads; None: it stands for itself. Where a picture is
    reduced the guide stays as far from that as it is, for the block keeps its size; to_scale: a guide as long as its
    rack, reduced with it.
    """

    a: complex
    b: complex
    about: complex | None = None
    to_scale: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Block(Ink):
    """A slider block (rectangle) centred at `at`, its long side along `along` (unit complex number).

    `on_rod` True: a sleeve through which a rod passes; False: a block in a slot or on a guide. `length` in mm.
    """

    at: complex
    along: complex
    on_rod: bool = False
    length: float = 9.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Slot(Ink):
    """A slot in a link: two parallel lines with round ends along a -> b."""

    a: complex
    b: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class GearMark(Ink):
    """A gear: pitch circle (dash-dot) and its centre."""

    centre: complex
    radius: float


@dataclass(frozen=True, slots=True, kw_only=True)
class RackMark(Ink):
    """A rack's pitch line from a to b with its body (hatched where fixed) to the right of a -> b."""

    a: complex
    b: complex
    fixed: bool = True


@dataclass(frozen=True, slots=True, kw_only=True)
class Passing(Ink):
    """The joining half of a bar that runs on past the pin at `at` (GB/T 4460): half a ring about the pin, to the left
    of `along` (unit complex number); the link that ends at the pin lies to the right."""

    at: complex
    along: complex


@dataclass(frozen=True, slots=True, kw_only=True)
class Weld(Ink):
    """The filled corner that shows two parts to be one rigid link (GB/T 4460): at `at`, or `off` mm from it, between
    the directions u and v (unit complex numbers)."""

    at: complex
    u: complex
    v: complex
    off: complex = 0j


Body = Plate | Ground | FixedGuide | Block | Slot | GearMark | RackMark | Passing | Weld
