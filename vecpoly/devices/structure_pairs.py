"""The kinematic pairs of a structural problem, and how one is written.

    A: R(0, 1) at (0, 0)                                       a hinge; R(2, 3, 4): a compound hinge of three links
    D: P(3, 0) at (110, 0) along (0, 1)                        block 3 slides on the guide of link 0; or: along 90 deg
    K: H(1 about (9, 14), 2 about B) at (32.16, 25.81)         a high pair: its profiles' centres of curvature, a place
    or a letter
    K: H(1 about (9, 14), 2 flat) at (9, 40)                   a profile on a flat face
    M: G(1 about A, 2 about B) at (40, 0)                      two gears about A and B; at: the pitch point

Places are in mm, x to the right, y up; link 0 is the frame.
"""

from __future__ import annotations

import cmath
import math
import re
from dataclasses import dataclass
from enum import StrEnum

from ..errors import FaultError
from ..words import Words

FRAME = "0"


class Form(StrEnum):
    """Hinge, slide, high pair, gears in mesh."""

    R = "R"
    P = "P"
    H = "H"
    G = "G"

    @property
    def is_lower(self) -> bool:
        """Whether it is a lower pair, which takes two freedoms; a high pair takes one."""
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
            return _unit(two - one)
        return _unit(self.at - one) if one is not None else _unit((two or 0j) - self.at)

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

    @property
    def lower(self) -> int:
        """p_L, compound hinges of k links counted k − 1 times."""
        return sum(pair.count for pair in self.pairs if pair.form.is_lower)

    @property
    def higher(self) -> int:
        """p_H."""
        return sum(pair.count for pair in self.pairs if not pair.form.is_lower)


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


FAR = 1e6  # mm: no sketch is larger
_SHAPE = re.compile(r"\s*([A-Z])\s*\((.*)\)\s*at\s*(\([^()]*\))\s*(?:along\s+(.+?))?\s*")
_MEMBER = re.compile(r"([\w/'′]+)(?:\s+(?:about\s+(\([^()]*\)|[A-Z]\w*['′]?)|(flat)))?")
_COMMA = re.compile(r",(?![^()]*\))")
_EXAMPLE = {
    Form.R: "R(1, 2) at (35, 92)",
    Form.P: "P(3, 0) at (110, 0) along (0, 1)",
    Form.H: "H(1 about (9, 14), 2 flat) at (9, 40)",
    Form.G: "G(1 about A, 2 about B) at (40, 0)",
}


def read_pair(text: object) -> Written:
    """A joint from its text; raises ValueError with what is wrong and how to write it."""
    if isinstance(text, Written):
        return text
    shape = _SHAPE.fullmatch(text) if isinstance(text, str) else None
    if shape is None or shape[1] not in Form.__members__:
        raise FaultError(
            Words(
                f"“{text}”不是运动副；如写 {', '.join(_EXAMPLE.values())}",
                f"'{text}' is no joint; write e.g. {', '.join(_EXAMPLE.values())}",
            ),
            code="spelling",
        )
    form = Form(shape[1])
    members = [_member(part.strip(), form) for part in _COMMA.split(shape[2])]
    links = tuple(link for link, _ in members)
    _check_links(form, links)
    if (form is Form.P) != bool(shape[4]):
        raise FaultError(
            Words(
                f"移动副（且只有移动副）要写导路方向；如写 {_EXAMPLE[Form.P]}",
                f"a slide needs the direction of its guide, and only a slide: write e.g. {_EXAMPLE[Form.P]}",
            ),
            code="spelling",
        )
    about = tuple(centre for _, centre in members) if not form.is_lower else ()
    _check_faces(form, about)
    return Written(form, links, _place(shape[3]), _direction(shape[4]) if shape[4] else 0j, about, str(text))


def _check_links(form: Form, links: tuple[str, ...]) -> None:
    if len(set(links)) != len(links):
        raise FaultError(
            Words(
                f"运动副联接不同的构件；这里写的是 {', '.join(links)}",
                f"a joint joins different links; here stands {', '.join(links)}",
            )
        )
    if len(links) < 2 or (len(links) > 2 and form is not Form.R):
        raise FaultError(
            Words(
                f"{form.value} 联接{'两个或两个以上' if form is Form.R else '两个'}构件，这里有 {len(links)} "
                f"个；如写 {_EXAMPLE[form]}",
                f"{form.value} joins {'two links or more' if form is Form.R else 'two links'}, here "
                f"{len(links)}; write e.g. {_EXAMPLE[form]}",
            ),
            code="spelling",
        )


def _check_faces(form: Form, about: tuple[complex | str | None, ...]) -> None:
    if about and None in about and (form is Form.G or about == (None, None)):
        raise FaultError(
            Words(
                f"{'齿轮要有中心' if form is Form.G else '两平面不成高副'}；如写 {_EXAMPLE[form]}",
                f"{'a gear has a centre' if form is Form.G else 'two flat faces do not make a high pair'}; "
                f"write e.g. {_EXAMPLE[form]}",
            ),
            code="spelling",
        )


def _member(text: str, form: Form) -> tuple[str, complex | str | None]:
    member = _MEMBER.fullmatch(text)
    if member is None:
        raise FaultError(
            Words(
                f"“{text}”不是构件；如写 1{' about (9, 14)' if not form.is_lower else ''}",
                f"'{text}' is no link; write e.g. 1{' about (9, 14)' if not form.is_lower else ''}",
            ),
            code="spelling",
        )
    link = FRAME if member[1] == "frame" else member[1]
    if form.is_lower:
        if member[2] or member[3]:
            raise FaultError(
                Words(
                    f"“{text}”：只有高副的轮廓才有曲率中心；如写 {_EXAMPLE[form]}",
                    f"'{text}': only the profiles of a high pair have centres; write e.g. {_EXAMPLE[form]}",
                ),
                code="spelling",
            )
        return link, None
    if not member[2] and not member[3]:
        raise FaultError(
            Words(
                f"“{text}”没有说明其轮廓；如写 {link} about (9, 14)、{link} about B 或 {link} flat",
                f"'{text}' does not say what its profile is; write e.g. {link} about (9, 14), {link} about B, "
                f"or {link} flat",
            ),
            code="spelling",
        )
    if member[3]:
        return link, None
    return link, _place(member[2]) if member[2].startswith("(") else member[2]


def _place(text: str) -> complex:
    """(x, y) in mm to m."""
    try:
        x, y = (float(part) for part in text.strip("()").split(","))
    except ValueError:
        raise FaultError(
            Words(
                f"“{text}”不是位置；请写以 mm 为单位的两个数，如 (35, 92)",
                f"'{text}' is no place; write two numbers in mm, e.g. (35, 92)",
            ),
            code="spelling",
        ) from None
    if not (abs(x) <= FAR and abs(y) <= FAR):
        raise FaultError(
            Words(
                f"“{text}”超出图纸范围；请写以 mm 为单位的两个数，如 (35, 92)",
                f"'{text}' is no place on paper; write two numbers in mm, e.g. (35, 92)",
            ),
            code="spelling",
        )
    return complex(x, y) / 1e3


def _direction(text: str) -> complex:
    """(dx, dy) or an angle in degrees to a unit vector."""
    if text.startswith("("):
        return _unit(_place(text))
    try:
        turn = math.radians(float(text.removesuffix("deg")))
    except ValueError:
        turn = math.nan
    if not math.isfinite(turn):
        raise FaultError(
            Words(f"“{text}”不是方向；如写 (0, 1) 或 90 deg", f"'{text}' is no direction; write e.g. (0, 1) or 90 deg"),
            code="spelling",
        )
    return cmath.rect(1.0, turn)


def _unit(vector: complex) -> complex:
    if vector == 0 or not cmath.isfinite(vector):
        raise FaultError(
            Words(
                "方向不能是 (0, 0)；如写 (0, 1) 或 90 deg", "a direction cannot be (0, 0); write e.g. (0, 1) or 90 deg"
            ),
            code="spelling",
        )
    return vector / abs(vector)
