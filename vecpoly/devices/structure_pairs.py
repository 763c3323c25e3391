"""The kinematic pairs of a structural problem, and how one is written.

    A: R(0, 1) at (0, 0)                                       a hinge; R(2, 3, 4): a multiple joint of three links
    D: P(3, 0) at (110, 0) along (0, 1)                        block 3 slides on the guide of link 0; or: along 90 deg
    K: H(1 about (9, 14), 2 about B) at (32.16, 25.81)         a higher pair: its centres of curvature, a place
    or a letter
    K: H(1 about (9, 14), 2 flat) at (9, 40)                   a profile on a flat face
    M: G(1 about A, 2 about B) at (40, 0)                      two gears about A and B; at: the pitch point

Places are in mm, x to the right, y up; link 0 is the frame.
"""

from __future__ import annotations

import cmath
import re
from dataclasses import dataclass
from enum import StrEnum

from ..errors import FaultError
from ..foundation.slotted import replace
from ..words import Words

FRAME = "0"


class Form(StrEnum):
    """Hinge, slide, higher pair, gears in mesh."""

    R = "R"
    P = "P"
    H = "H"
    G = "G"

    @property
    def is_lower(self) -> bool:
        """Whether it is a lower pair, which takes two freedoms; a higher pair takes one."""
        return self in (Form.R, Form.P)


@dataclass(frozen=True, slots=True, kw_only=True)
class Pair:
    """One joint. Places in m.

    links: of R all links pinned there; of P the block, then its guide; of H and G the two that touch. along: unit
    vector of a guide.
    about: for each of the two that touch the centre of curvature (of a gear: its centre), None for a flat face.
    """

    letter: str
    form: Form
    links: tuple[str, ...]
    at: complex
    along: complex = 0j
    about: tuple[complex | None, ...] = ()

    @property
    def count(self) -> int:
        """How many pairs it is: a hinge of k links is k − 1 pairs."""
        return len(self.links) - 1

    @property
    def normal(self) -> complex:
        """Unit vector of the common normal of H, from the first profile's centre towards the second's."""
        one, two = self.about
        if one is not None and two is not None:
            return unit_vector(two - one)
        return unit_vector(self.at - one) if one is not None else unit_vector((two or 0j) - self.at)

    @property
    def hinged(self) -> bool:
        """Whether it is a hinge."""
        return self.form is Form.R

    @property
    def slides(self) -> bool:
        """Whether it is a slide."""
        return self.form is Form.P

    @property
    def meshes(self) -> bool:
        """Whether it is the mesh of two gears."""
        return self.form is Form.G

    def touches(self, links: tuple[str, ...]) -> bool:
        """Whether it joins any of these links."""
        return any(link in links for link in self.links)

    def other(self, link: str) -> str:
        """The link at the other end of a pair of two."""
        return self.links[1 - self.links.index(link)]


@dataclass(frozen=True, slots=True)
class Chain:
    """Moving links and the pairs between them and the frame."""

    links: tuple[str, ...]
    pairs: tuple[Pair, ...]

    def at(self, link: str) -> tuple[Pair, ...]:
        """The pairs of a link."""
        return tuple(pair for pair in self.pairs if link in pair.links)

    def without(self, gone: tuple[str, ...]) -> Chain:
        """The chain after these links are taken out, with the pairs that end on them."""
        kept = (_shrunk(pair, gone) for pair in self.pairs)
        return Chain(
            tuple(link for link in self.links if link not in gone), tuple(pair for pair in kept if pair is not None)
        )

    def times(self, scale: float) -> Chain:
        """The same chain at another size: on paper (mm), with so many mm for a metre."""
        return Chain(self.links, tuple(_times(pair, scale) for pair in self.pairs))

    @property
    def lower(self) -> int:
        """p_L, multiple joints of k links counted k − 1 times."""
        return sum(pair.count for pair in self.pairs if pair.form.is_lower)

    @property
    def higher(self) -> int:
        """p_H."""
        return sum(pair.count for pair in self.pairs if not pair.form.is_lower)


def _times(pair: Pair, scale: float) -> Pair:
    about = tuple(None if centre is None else scale * centre for centre in pair.about)
    return replace(pair, at=scale * pair.at, about=about)


def _shrunk(pair: Pair, gone: tuple[str, ...]) -> Pair | None:
    """The pair without these links; None where it joins nothing any more."""
    links = tuple(link for link in pair.links if link not in gone)
    if len(links) == len(pair.links):
        return pair
    if pair.form is not Form.R or len(links) < 2:
        return None
    return Pair(letter=pair.letter, form=pair.form, links=links, at=pair.at)


def natural(link: str) -> tuple[int, str]:
    """Order of links: by the number they begin with, then by name."""
    digits = re.match(r"\d+", link)
    return (int(digits[0]) if digits else 10**6, link)


@dataclass(frozen=True, slots=True)
class Written:
    """A joint as written: centres may still be letters of other joints."""

    form: Form
    links: tuple[str, ...]
    at: complex
    along: complex
    about: tuple[complex | str | None, ...]
    text: str


def unit_vector(vector: complex) -> complex:
    """The direction of a vector; raises FaultError where it has none."""
    if vector == 0 or not cmath.isfinite(vector):
        raise FaultError(
            Words(
                "方向不能是 (0, 0)；如写 (0, 1) 或 90 deg", "a direction cannot be (0, 0); write e.g. (0, 1) or 90 deg"
            ),
            code="spelling",
        )
    return vector / abs(vector)
