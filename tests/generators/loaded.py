"""The geometry of random loaded mechanisms:
places of pins first, lengths from them, so that every one can be assembled.

A crank and one to three class II groups of any kind, hung on pins that are there already,
so that multiple joints arise.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable
from dataclasses import dataclass, field
from math import degrees

import numpy as np

LETTERS = "BCEGHJKLMNQTUVWXYZ"
FIXED = "ADFIOPRS"


@dataclass(slots=True)
class Chain:
    """What has been put together: places of letters (mm), which letters each link carries, and the text of it."""

    rng: np.random.Generator
    at: dict[str, complex] = field(default_factory=dict)
    links: dict[str, list[str]] = field(default_factory=dict)  # own name → letters
    text: dict[str, str] = field(default_factory=dict)
    guides: dict[str, complex] = field(default_factory=dict)  # links that only slide on the frame, with their direction
    frame: list[str] = field(default_factory=list)
    joints: list[str] = field(default_factory=list)
    branches: list[str] = field(default_factory=list)
    slides: list[tuple[str, str]] = field(default_factory=list)
    contacts: list[str] = field(default_factory=list)

    def fixed(self, place: complex) -> str:
        """A new letter of the frame."""
        letter = next(c for c in FIXED if c not in self.at)
        self.at[letter] = complex(round(place.real, 2), round(place.imag, 2))
        self.frame.append(letter)
        return letter

    def letter(self, place: complex) -> str:
        """A new letter of a moving point."""
        letter = next(c for c in LETTERS if c not in self.at)
        self.at[letter] = place
        return letter

    def add(self, letters: list[str], text: str) -> str:
        """A new link."""
        name = f"L{len(self.links)}"
        self.links[name], self.text[name] = letters, text
        return name

    def bar(self, p: str, q: str) -> str:
        """A bar between two letters, sometimes with a further point."""
        text, letters = f"{p}{q}: {abs(self.at[q] - self.at[p]):.4f} mm", [p, q]
        if self.rng.random() < 0.4:
            along, left = self.rng.integers(-20, 160), self.rng.integers(-50, 50)
            u = (self.at[q] - self.at[p]) / abs(self.at[q] - self.at[p])
            e = self.letter(self.at[p] + u * (int(along) + 1j * int(left)))
            text, letters = f"{text}, {e}: {{along: {p}{q}, at: {along} mm, left: {left} mm}}", [p, q, e]
        return self.add(letters, text)

    def anchor(self) -> str:
        """A moving letter to hang a group on: often one that is a pin already."""
        moving = [c for letters in self.links.values() for c in letters if c not in self.frame]
        return str(self.rng.choice(moving))

    def other(self, than: str) -> str:
        """A second place to hang on: a moving letter of another link, or a pin of the frame, old or new."""
        mates = {c for letters in self.links.values() if than in letters for c in letters}
        apart = [c for letters in self.links.values() for c in letters if c not in mates and c not in self.frame]
        if apart and self.rng.random() < 0.35:
            return str(self.rng.choice(apart))
        old = [c for c in self.frame if c not in mates]
        if old and self.rng.random() < 0.25:
            return str(self.rng.choice(old))
        return self.fixed(self.at[than] + self.polar(60, 260))

    def polar(self, low: float, high: float) -> complex:
        """A random vector (mm)."""
        return cmath.rect(float(self.rng.uniform(low, high)), float(self.rng.uniform(-np.pi, np.pi)))

    def apex(self, p: str, q: str) -> complex:
        """A place that makes a sound triangle on two others."""
        a, b = self.at[p], self.at[q]
        half = abs(b - a) / 2
        t, s = self.rng.uniform(-0.8, 0.8), self.rng.choice([-1, 1]) * self.rng.uniform(0.5, 1.5)
        return (a + b) / 2 + (b - a) / (2 * half) * complex(t * half, s * max(half, 40.0))

    def side(self, at: complex, p: str, q: str) -> str:
        """left of PQ, or right."""
        return "left" if ((self.at[q] - self.at[p]).conjugate() * (at - self.at[p])).imag > 0 else "right"


Grow = Callable[[Chain], None]


def rrr(c: Chain) -> None:
    """Two bars."""
    p = c.anchor()
    q = c.other(p)
    place = c.apex(p, q)
    branch = f" {c.side(place, p, q)} of {p}{q}"
    x = c.letter(place)
    c.bar(p, x)
    c.bar(q, x)
    c.branches.append(x + branch)


def rrp(c: Chain) -> None:
    """A bar and a block on a fixed guide, K of the guide near the foot of the bar's pin,
    so that left of PK tells the two apart."""
    p = c.anchor()
    angle = int(c.rng.integers(-80, 80))
    u = cmath.rect(1.0, np.radians(angle))
    normal = c.rng.choice([-1, 1]) * c.rng.uniform(10, 150)
    foot = c.at[p] + 1j * u * normal
    k = c.fixed(foot + u * c.rng.uniform(-20, 20))
    along = c.rng.choice([-1, 1]) * c.rng.uniform(60, 200)
    place = c.at[k] + u * along
    branch = f" {c.side(place, p, k)} of {p}{k}"
    x = c.letter(place)
    c.bar(p, x)
    block = c.add([x], f"block: {x}")
    c.joints.append(f"@{block} slides on line through {k} at {angle} deg")
    c.slides.append((block, "frame"))
    c.branches.append(x + branch)


def rpr(c: Chain) -> None:
    """A block on a pin, in a slot or on a rod of a link on another pin."""
    p = c.anchor()
    q = c.other(p)
    block = c.add([p], f"block: {p}")
    u = (c.at[p] - c.at[q]) / abs(c.at[p] - c.at[q])
    along, left = int(c.rng.integers(30, 260)), int(c.rng.integers(-40, 40))
    e = c.letter(c.at[q] + u * (along + 1j * left))
    slot = c.add([q, e], f"slot: {q}, {e}: {{along: {q}, at: {along} mm, left: {left} mm}}")
    c.joints.append(f"@{block} slides in @{slot}")
    c.slides.append((block, slot))


def rpp(c: Chain) -> None:
    """A block on a pin, in the slot of a bar that slides on a fixed guide."""
    p = c.anchor()
    angle, turn = int(c.rng.integers(-80, 80)), int(c.rng.integers(40, 140))
    u = cmath.rect(1.0, np.radians(angle))
    k = c.fixed(c.at[p] + c.polar(30, 150))
    slot_way = u * cmath.rect(1.0, np.radians(turn))
    t = ((c.at[p] - c.at[k]) / slot_way).imag / (u / slot_way).imag  # from K along the guide to where the slot meets it
    x = c.letter(c.at[k] + u * t)
    block, bar = c.add([p], f"block: {p}"), c.add([x], f"slot: {x}")
    c.joints += [f"@{block} slides in @{bar}", f"@{bar} slides on line through {k} at {angle} deg turned {turn} deg"]
    c.slides += [(block, bar), (bar, "frame")]


def prp(c: Chain) -> None:
    """Two blocks on one pin: one on a bar of the mechanism, one on a fixed guide."""
    bars = [
        name
        for name, letters in c.links.items()
        if len(letters) > 1 and c.text[name].startswith(f"{letters[0]}{letters[1]}")
    ]
    bar = str(c.rng.choice(bars))
    a, b = c.links[bar][:2]
    place = c.at[a] + (c.at[b] - c.at[a]) * c.rng.uniform(0.2, 1.5)
    angle = int(c.rng.integers(-80, 80))
    k = c.fixed(place + cmath.rect(float(c.rng.uniform(40, 120)), np.radians(angle)))
    x = c.letter(place)
    one, two = c.add([x], f"block: {x}"), c.add([x], f"block: {x}")
    c.joints += [f"@{one} slides on {a}{b} of @{bar}", f"@{two} slides on line through {k} at {angle} deg"]
    c.slides += [(one, bar), (two, "frame")]


GROUPS: tuple[Grow, ...] = (rrr, rrr, rrp, rpr, rpp, prp)


def chain(rng: np.random.Generator, groups: int, kinds: tuple[Grow, ...] = GROUPS) -> Chain:
    """A crank AB and this many groups."""
    c = Chain(rng)
    c.fixed(0j)
    c.at["B"] = c.polar(40, 90)
    c.bar("A", "B")
    for _ in range(groups):
        kinds[rng.integers(len(kinds))](c)
    return c


def phi(c: Chain) -> float:
    """The crank's angle (deg)."""
    return degrees(cmath.phase(c.at["B"] - c.at["A"]))
