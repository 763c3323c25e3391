"""The whole mechanism turned in the plane, or mirrored: its answers turn and are mirrored with it."""

from __future__ import annotations

import cmath
import re
from collections.abc import Callable
from dataclasses import dataclass, field
from math import radians

import numpy as np

from vecpoly import oracle
from vecpoly.mechanism.model import Mechanism
from vecpoly.solution import Solution

from ..family import family
from ..library import Data, data_of
from .original import Change, compared, original, solved, text_of, told

_SWAP = {"left": "right", "right": "left", "ccw": "cw", "cw": "ccw"}
_NUMBER = r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?"
_LETTER = r"[A-Z][a-z]?"


@dataclass(slots=True)
class Isometry:
    """z → e^{iθ} z, or e^{iθ} z̄ where it mirrors; θ in degrees. `pivots`:
    letters of guides that were told by a coordinate."""

    theta: float
    mirrors: bool
    pivots: dict[str, complex] = field(default_factory=dict)
    rolling: bool = False  # whether the sentence being read speaks of a gear on a rack

    @property
    def sign(self) -> int:
        return -1 if self.mirrors else 1

    def vector(self, z: complex) -> complex:
        """A vector, or a place (its origin stays)."""
        return cmath.rect(1.0, radians(self.theta)) * (z.conjugate() if self.mirrors else z)

    def place(self, pair: list[str]) -> list[str]:
        """[x, y] of the file, in mm."""
        z = self.vector(complex(*(float(text.removesuffix(" mm")) for text in pair)))
        return [f"{z.real!r} mm", f"{z.imag!r} mm"]

    def absolute(self, text: str) -> str:
        """An angle from the x axis; one from a line keeps its size."""
        return self.relative(text) if " from " in text else self._angle(text, self.theta)

    def relative(self, text: str) -> str:
        """An angle from another line."""
        return self._angle(text, 0.0)

    def _angle(self, text: str, more: float) -> str:
        number, _, rest = text.partition(" ")
        return f"{self.sign * float(number) + more!r} {rest}"

    def turning(self, text: str) -> str:
        """ω, α, a moment."""
        if not self.mirrors:
            return text
        if re.search(r"\bc?cw\b", text):
            return self.sided(text)
        return text.removeprefix("-") if text.startswith("-") else text if text == "?" else f"-{text}"

    def sided(self, text: str) -> str:
        """Left and right, ccw and cw change places."""
        return re.sub(r"\b(left|right|c?cw)\b", lambda m: _SWAP[m[1]], text) if self.mirrors else text

    def entries(self, entries: Data) -> Data:
        """A point, a slot, a rack, a centre of mass: offsets and angles."""
        turned: dict[str, Callable[[str], str]] = {"angle": self.absolute, "side": self.sided}
        return {
            _SWAP.get(key, key) if self.mirrors else key: turned[key](value) if key in turned else value
            for key, value in entries.items()
        }

    def link(self, link: Data) -> Data:
        moved = {key: self.entries(value) if isinstance(value, dict) else value for key, value in link.items()}
        return moved | ({"phi": self.absolute(link["phi"])} if "phi" in link else {})

    def joint(self, text: str) -> str:
        text = re.sub(rf"\b(on|along|above|below|left of|right of) ([xy]) = ({_NUMBER}) mm", self._guide, text)
        text = re.sub(rf"(line through {_LETTER} at )({_NUMBER} deg)", lambda m: m[1] + self.absolute(m[2]), text)
        text = re.sub(rf"turned ({_NUMBER} deg)", lambda m: f"turned {self.relative(m[1])}", text)
        return self.sided(
            re.sub(
                r" rolls (above|below) (\d)",
                lambda m: f" rolls {'left' if m[1] == 'above' else 'right'} of {m[2]}",
                text,
            )
        )

    def _guide(self, m: re.Match[str]) -> str:
        """y = 30 mm becomes a line through a new letter; above it is left of it."""
        letter = f"Z{chr(ord('n') + len(self.pivots))}"
        self.pivots[letter] = complex(0, float(m[3])) if m[2] == "y" else complex(float(m[3]), 0)
        way = {"above": "left of", "below": "right of", "on": "left of" if self.rolling else "on"}.get(m[1], m[1])
        return f"{way} line through {letter} at {0.0 if m[2] == 'y' else 90.0} deg"


def isometry(rng: np.random.Generator, data: Data) -> Isometry:
    """Any; but gravity stays where it is."""
    mirrors = bool(rng.random() < 0.6)
    if data.get("weight") == "yes":
        return Isometry(180.0, True)
    return Isometry(float(rng.choice([0.0, 90.0, 180.0, -37.0, rng.uniform(-180, 180)])), mirrors)


def moved(data: Data, by: Isometry, places: dict[str, complex]) -> Data:
    """The problem after the isometry; the places of moving points are rough places,
    where a statement speaks of up and down."""
    new = dict(data)
    new["joints"] = [_joint(by, text) for text in data.get("joints") or []]
    new["frame"] = {letter: by.place(pair) for letter, pair in data["frame"].items()}
    new["frame"] |= {letter: by.place([f"{z.real!r} mm", f"{z.imag!r} mm"]) for letter, z in by.pivots.items()}
    new["links"] = {name: by.link(link) for name, link in data["links"].items()}
    new["branch"] = [
        by.sided(text)
        for text in data.get("branch") or []
        if re.search(rf"(left|right) of {_LETTER}{_LETTER}\b|parallelogram", text)
    ]
    if "guesses" in data or len(new["branch"]) < len(data.get("branch") or []):
        near = {letter: [f"{1e3 * z.real:.3f} mm", f"{1e3 * z.imag:.3f} mm"] for letter, z in places.items()}
        new["guesses"] = {letter: by.place(pair) for letter, pair in (near | data.get("guesses", {})).items()}
    new["input"] = _input(by, data["input"])
    if "loads" in data:
        new["loads"] = {name: _load(by, load) for name, load in data["loads"].items()}
    if "masses" in data:
        new["masses"] = {
            name: {key: by.entries(value) if isinstance(value, dict) else value for key, value in mass.items()}
            for name, mass in data["masses"].items()
        }
    return new


def _joint(by: Isometry, text: str) -> str:
    by.rolling = " rolls " in text
    return by.joint(text)


def _input(by: Isometry, given: Data) -> Data:
    turned: dict[str, Callable[[str], str]] = {
        "phi": by.relative if "on" in given else by.absolute,
        "omega": by.turning,
        "alpha": by.turning,
    }
    return {key: turned[key](value) if key in turned else value for key, value in given.items()}


def _load(by: Isometry, load: Data) -> Data:
    if "cylinder" in load:
        return load  # a thrust, which is the same in a mirror
    turned = {"direction": by.absolute} if "direction" in load else {"size": by.turning}
    return {key: turned[key](value) if key in turned else value for key, value in load.items()}


def moving(mark: str, seed: int) -> tuple[Data, Isometry]:
    """The original's data moved, and how; the same for the same seed."""
    text = text_of(mark)
    data = data_of(text)
    by, mech = isometry(np.random.default_rng(seed), data), solved(text).problem.subject
    assert isinstance(mech, Mechanism)
    letters = {p for name in mech.bodies for p in mech.link(name).points} - set(data["frame"])
    motion = oracle.solve(mech, order=0)
    return moved(data, by, {p: complex(motion.position(p)) for p in sorted(letters)}), by


def moved_with_it(solution: Solution) -> str:
    """The answers are the original's, turned and mirrored."""
    mark, _, seed = str(solution.problem.title.en).rpartition(" ")
    by = moving(mark, int(seed))[1]
    return compared(solution, Change(vector=by.vector, turn=by.sign), mark)


@family("retold-moved", also=moved_with_it, often=1)
def elsewhere_in_the_plane(rng: np.random.Generator) -> str:
    """Any member of the other families, turned, or mirrored and turned."""
    mark, _ = original(rng)
    seed = int(rng.integers(10**6))
    return told(moving(mark, seed)[0], f"{mark} {seed}")
