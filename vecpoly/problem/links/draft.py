"""A link while it is being read: its points so far, its guide line, its gear, and its data for 已知."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from ...errors import FaultError
from ...foundation.indices import LETTER
from ...foundation.patterns import pattern
from ...mechanism.assembly.start import Start
from ...mechanism.model import Circle, Link, Placement
from ...words import Words
from ..problem import Datum, Shape
from ..schema.faults import not_on_link
from ..values.seen import Seen

if TYPE_CHECKING:
    from ...devices.cams.cam import Cam  # not at once: pydantic, which checks its data, is slow to load

ONE = pattern(LETTER)
TWO = pattern(rf"({LETTER})({LETTER})")
CENTRE = r"S\d+[a-z'′]?"  # the centre of mass of a link
# the ends of a length to a point that is set out: BE, BS2
PLACED = pattern(rf"({LETTER}|{CENTRE})({LETTER}|{CENTRE})")
ANGLE_FROM = pattern(rf"(.+?) from (line|{LETTER}{LETTER})")


@dataclass(frozen=True, slots=True)
class Line:
    """A guide line on a link, in its coordinates;
    `through` is the letter from which it is set out, `towards` that to which it runs."""

    origin: complex
    direction: float
    through: str
    towards: str = ""


@dataclass(slots=True)
class Draft:
    """A link while it is being read."""

    name: str
    shape: Shape = Shape.BAR
    points: dict[str, complex] = field(default_factory=dict)
    later: frozenset[str] = frozenset()  # letters that are set out further on
    # letters of other links to which rays go: CB, from the pin C of a slot to the pin B of its block
    towards: set[str] = field(default_factory=set)
    placements: list[Placement] = field(default_factory=list)
    line: Line | None = None
    gear: Circle | None = None
    alpha: float | None = None  # the pressure angle of its teeth (rad), where the file gives it
    disc: Circle | None = None  # a round cam, eccentric or tip
    face: Line | None = None  # a flat face
    cam: Cam | None = None  # a plate cam, whose disc is its base circle until the profile is drawn
    rack: Line | None = None  # the pitch line of a rack
    start: Start | None = None  # where it stands, told in the file
    lengths: list[Datum] = field(default_factory=list)

    @property
    def held(self) -> Mapping[str, complex]:
        """The points on which something may act or sit: without the centre of curvature of a cam's profile, which
        wanders over the cam."""
        wandering = self.disc.centre if self.cam is not None and self.disc is not None else ""
        return {letter: at for letter, at in self.points.items() if letter != wandering}

    def link(self) -> Link:
        """The link of the model."""
        return Link(name=self.name, points=self.points, placements=tuple(self.placements))

    def note(self, symbol: str, si: float, text: str, words: Words | None = None) -> None:
        """Remember a length for 已知; words: what it is, where the symbol does not say so."""
        self.lengths.append(Datum(symbol=symbol, si=si, text=text, words=words))

    def say(self, words: Words, seen: Seen | None = None) -> None:
        """Remember a given fact that has no symbol; seen: as a sketch shows it."""
        self.lengths.append(Datum(words=words, seen=seen))


def letters_of(word: str) -> tuple[str, str]:
    """'BC' to ('B', 'C'); raises FaultError otherwise."""
    m = TWO.fullmatch(word)
    if m is None:
        raise FaultError(
            Words(f"“{word}”不是 BC 之类的两个字母", f"'{word}' is not two letters such as BC"), code="spelling"
        )
    return m[1], m[2]


def ends_of(word: str) -> tuple[str, str]:
    """'BE' to ('B', 'E'), 'BS2' to ('B', 'S2'); raises FaultError otherwise."""
    m = PLACED.fullmatch(word)
    if m is None:
        raise FaultError(Words(f"“{word}” 不是 BE 这样的两个字母", f"'{word}' is not two letters such as BE"))
    return m[1], m[2]


def ray(draft: Draft, word: str) -> tuple[tuple[str, ...], complex, complex]:
    """Base letters, start and unit vector of a ray: 'BC', or along the link's guide line 'B' or 'line'."""
    line = draft.line or (
        Line(0j, 0.0, next(iter(draft.points))) if len(draft.points) == 1 or draft.shape is Shape.BLOCK else None
    )
    first, second = (word, "") if ONE.fullmatch(word) or word == "line" else letters_of(word)
    if word == "line":
        first = line.through if line else ""
    if first and first not in draft.points:
        raise not_on_link(first, draft.name, draft.points)
    if second in draft.points and draft.points[second] != draft.points[first]:
        return (
            (first, second),
            draft.points[first],
            cmath.exp(1j * cmath.phase(draft.points[second] - draft.points[first])),
        )
    lined = draft.line is not None or draft.shape in (Shape.BLOCK, Shape.PISTON)
    if line is None or first != line.through or not lined or second in draft.later:
        raise FaultError(
            Words(
                f"“{word}”不是构件 {draft.name} 上的射线；其上的点有 {', '.join(draft.held)}",
                f"'{word}' is no ray of link {draft.name}, whose points are {', '.join(draft.held)}",
            ),
            code="spelling",
        )
    draft.towards |= {second} - {""}
    return (first,), draft.points[first], cmath.exp(1j * line.direction)


def refuse_frame(draft: Draft, frame: Mapping[str, complex]) -> None:
    """A bar whose points are all fixed is the frame, which has no entry."""
    if draft.shape is Shape.BAR and len(draft.points) > 1 and set(draft.points) <= set(frame):
        letters = "、".join(draft.points)
        raise FaultError(
            Words(
                f"{letters} 都是机架上的点，构件 {draft.name} 就是机架；请去掉此项（机架的点只写在 frame 中）",
                f"{' and '.join(draft.points)} are points of the frame, so link {draft.name} is the frame "
                "itself; leave it out (the frame's points stand under 'frame' alone)",
            ),
            code="frame-as-link",
        )
