"""A mechanism thought in one pose, from which its problem file is written: so it can always be assembled.

Places are in mm. A body knows where its letters are in the pose, and has its entries of the file as text.
"""

from __future__ import annotations

import cmath
from dataclasses import dataclass, field
from math import degrees

import numpy as np

LETTERS = (*"ABCDEFGHIJKLMNOPQRTUVWXYZ", *(f"{one}a" for one in "ABCDEFGHIJKLM"))
FRAME = "0"
NEAR = 12.0  # mm: letters of one body are farther apart


class Grazing(Exception):
    """The pose lies at a dead point, or cannot be told in words: try another."""


def mm(length: float) -> str:
    """A length as written."""
    return f"{length:.9g} mm"


def deg(angle: float) -> str:
    """An angle (rad) as written."""
    return f"{degrees(angle):.9g} deg"


def turned(way: complex, back: complex = 1.0) -> float:
    """The angle of a direction against another (rad)."""
    return cmath.phase(way / back)


@dataclass(slots=True)
class Body:
    """A link in the pose.

    way: direction of its line, the one on which others slide or which the file calls "line"; through: the letter by
    which the file knows that line; slot: a place on it, where it is a slot or a rod.
    axis: direction of the link's own x axis.
    """

    name: str
    at: dict[str, complex] = field(default_factory=dict)
    entries: list[str] = field(default_factory=list)
    way: complex = 0j
    through: str = ""
    slot: complex | None = None
    axis: complex = 0j

    def text(self) -> str:
        return f"  {self.name}: {{{', '.join(self.entries)}}}"


@dataclass(slots=True)
class Sketch:
    """The mechanism so far."""

    rng: np.random.Generator
    bodies: dict[str, Body] = field(default_factory=lambda: {FRAME: Body(FRAME)})
    joints: list[str] = field(default_factory=list)
    branches: list[str] = field(default_factory=list)
    finds: list[str] = field(default_factory=list)
    input: str = ""
    letters: int = 0  # taken so far

    @property
    def places(self) -> dict[str, complex]:
        """Every letter's place."""
        return {letter: at for body in self.bodies.values() for letter, at in body.at.items()}

    def letter(self) -> str:
        """A letter not used yet."""
        self.letters += 1
        return str(LETTERS[self.letters - 1])

    def chance(self, share: float) -> bool:
        return bool(self.rng.random() < share)

    def one(self, options: list[str]) -> str:
        return options[int(self.rng.integers(len(options)))]

    def between(self, low: float, high: float) -> float:
        return float(self.rng.uniform(low, high))

    def some_way(self) -> complex:
        """A direction."""
        return cmath.exp(1j * self.between(-cmath.pi, cmath.pi))

    def spot(self, *away: complex) -> complex:
        """A place on the paper, not too near to these."""
        while True:
            at = complex(self.between(-160, 160), self.between(-120, 120))
            if all(abs(at - other) > 2 * NEAR for other in away):
                return at

    def offset(self) -> float:
        """Zero as often as not."""
        return 0.0 if self.chance(0.5) else self.between(-40, 40)

    def parents(self) -> tuple[Body, Body]:
        """Two links of what is known, mostly different."""
        known = list(self.bodies.values())
        a, b = (
            (known[i] for i in self.rng.choice(len(known), 2, replace=False))
            if len(known) > 1
            else (known[0], known[0])
        )
        return a, b

    def add(self, *bodies: Body) -> None:
        self.bodies |= {body.name: body for body in bodies}

    def numbers(self) -> tuple[str, str]:
        """The numbers of the next two links, in either order."""
        n = len(self.bodies)
        return (str(n), str(n + 1)) if self.chance(0.5) else (str(n + 1), str(n))

    def yaml(self) -> str:
        """The problem file."""
        frame, *links = self.bodies.values()
        points = ", ".join(f"{p}: [{mm(z.real)}, {mm(z.imag)}]" for p, z in frame.at.items())
        body = "\n".join(link.text() for link in sorted(links, key=lambda b: int(b.name)))
        return "\n".join(
            (
                "id: linkage",
                "title: linkage",
                f"frame: {{{points}}}",
                "links:",
                body,
                f"joints: [{', '.join(self.joints)}]",
                f"input: {self.input}",
                f"branch: [{', '.join(self.branches)}]",
                f"find: [{', '.join(self.finds)}]",
                "",
            )
        )
