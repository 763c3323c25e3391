"""The profiles of a higher pair: a gear's pitch circle, a disc, a hollow arc, a flat face; of the frame hatched."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import Protocol

from ..board.paper.marks import Arc, Disc, GearMark, Mark, Outline, Role
from ..board.paper.symbols import Symbol
from ..mechanism.joints import FRAME
from .owners import link

FACE, DEEP = 11.0, 4.0  # mm: half a flat face or a concave arc; thickness of a fixed profile


class Touching(Protocol):
    """Two links that touch, on paper (mm): where, and about which centres their profiles are round."""

    @property
    def links(self) -> tuple[str, ...]: ...

    @property
    def at(self) -> complex: ...

    @property
    def about(self) -> tuple[complex | None, ...]: ...

    @property
    def normal(self) -> complex: ...

    @property
    def meshes(self) -> bool: ...


def profile(pair: Touching, name: str) -> Iterator[Mark]:
    """The profile of one of the two links."""
    centre, radius = round_of(pair, name)
    if pair.meshes:
        assert centre is not None
        yield GearMark(centre=centre, radius=radius)
    elif name == FRAME:
        yield Outline(points=_fixed(pair, centre, radius), fixed=True)
    elif centre is None:
        return  # a flat face is drawn with its link
    elif is_hollow(pair, name):
        half, middle = min(FACE / radius, math.pi / 3), cmath.phase(pair.at - centre)
        yield Arc(centre=centre, radius=radius, start=middle - half, sweep=2 * half, role=Role.LINK)
    else:
        yield Disc(centre=centre, radius=radius)


def profile_drawn(pair: Touching, name: str) -> Symbol:
    """The profile by itself."""
    return Symbol.of(link(name), profile(pair, name))


def round_of(pair: Touching, name: str) -> tuple[complex | None, float]:
    """Centre and radius of a profile; no centre where it is flat."""
    centre = pair.about[pair.links.index(name)]
    return (None, 0.0) if centre is None else (centre, abs(pair.at - centre))


def is_hollow(pair: Touching, name: str) -> bool:
    """Whether the profile is the outer one of two that curve the same way."""
    mine, its = (pair.about[i] for i in (pair.links.index(name), 1 - pair.links.index(name)))
    if mine is None or its is None:
        return False
    same = ((mine - pair.at).conjugate() * (its - pair.at)).real > 0
    return same and abs(mine - pair.at) > abs(its - pair.at)


def _fixed(pair: Touching, centre: complex | None, radius: float) -> tuple[complex, ...]:
    """A strip of a fixed profile about the contact."""
    at = pair.at
    if centre is None:
        side = 1 if pair.links.index(FRAME) == 1 else -1
        t, back = 1j * pair.normal * FACE, side * pair.normal * DEEP
        return at - t, at + t, at + t + back, at - t + back
    inward = -1.0 if not is_hollow(pair, FRAME) else 1.0
    half = min(1.6 * FACE / radius, math.pi / 3)
    turns = [cmath.rect(1.0, cmath.phase(at - centre) + half * (i / 8 - 1)) for i in range(17)]
    return (*(centre + radius * t for t in turns), *(centre + (radius + inward * DEEP) * t for t in reversed(turns)))
