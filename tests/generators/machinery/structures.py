"""Schemes of mechanisms grown group by group, so that freedom, groups and class are known without counting.

Cranks on the frame, then dyads of hinges and slides and triads on three known links, rollers and high pairs: each adds
no freedom. The answers are compared with what was grown.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from vecpoly.solution import Solution

from ..family import family
from .statics import Random


@dataclass(slots=True)
class Scheme:
    """What has been grown: joints as written, and the places of each link."""

    rng: Random
    joints: list[str] = field(default_factory=list)
    links: dict[str, list[complex]] = field(default_factory=lambda: {"0": [0j]})
    pairs: int = 0

    def new(self) -> str:
        name = str(len(self.links))
        self.links[name] = []
        return name

    def place(self) -> complex:
        return complex(self.rng.integers(-200, 201), self.rng.integers(-200, 201))

    def join(self, kind: str, one: str, two: str, at: complex) -> None:
        letter = "ABCDEFGHIJ"[len(self.joints) // 10] + str(len(self.joints) % 10)
        where = f"({at.real:g}, {at.imag:g})"
        along = f" along {self.rng.integers(0, 180)} deg" if kind == "P" else ""
        self.joints.append(f"{letter}: {kind}({one}, {two}) at {where}{along}")
        self.pairs += 1
        for link in (one, two):
            self.links[link].append(at)

    def known(self, count: int) -> list[str]:
        """Links that stand already, the frame among them."""
        names = list(self.links)
        return [str(x) for x in self.rng.choice(names, count, replace=count > len(names))]


def dyad(s: Scheme) -> None:
    """RRR, RRP, RPR or PRP on two known links."""
    one, two = s.known(2)
    j, k = s.new(), s.new()
    kinds = [("R", "R", "R"), ("R", "R", "P"), ("R", "P", "R"), ("P", "R", "P")][int(s.rng.integers(4))]
    for kind, (a, b) in zip(kinds, ((one, j), (j, k), (k, two)), strict=True):
        s.join(kind, a, b, s.place())


def triad(s: Scheme) -> None:
    """A central link on three legs."""
    parents = s.known(3)
    plate, legs = s.new(), [s.new() for _ in range(3)]
    for leg, parent in zip(legs, parents, strict=True):
        s.join("R", plate, leg, s.place())
        s.join("R", leg, parent, s.place())


def written(s: Scheme, drivers: str, find: str, source: str) -> str:
    """The file; source: what the answers must be."""
    joints = "\n".join(f"    {joint}" for joint in s.joints)
    data = f"data:\n  joints:\n{joints}\n  drivers: [{drivers}]\n"
    return f"id: x\ntitle: x\ndevice: structure\n{data}find: [{find}]\nsource: {source}\n"


def as_grown(solution: Solution) -> str:
    """n, p_l, p_h, F and the class as they were grown."""
    assert solution.problem.source is not None
    told = dict(part.split("=") for part in str(solution.problem.source.en).split())
    for key, value in told.items():
        if key in solution.answers and solution.answers[key].exact != float(value):
            return f"{key} = {solution.answers[key].exact}, but {value} was grown"
    return ""


@family("device-structure", also=as_grown, often=2)
def structure(rng: Random) -> str:
    """One or two cranks, then one to four groups."""
    s = Scheme(rng)
    cranks = 1 if rng.random() < 0.8 else 2
    for _ in range(cranks):
        s.join("R", "0", s.new(), s.place())
    for _ in range(int(rng.integers(1, 5))):
        (dyad if rng.random() < 0.8 else triad)(s)
    told = {"n": len(s.links) - 1, "p_l": s.pairs, "p_h": 0, "F": cranks}
    drivers = "1" if cranks == 1 else "1+2"
    source = " ".join(f"{key}={value}" for key, value in told.items())
    return written(s, drivers, "n, p_l, p_h, F, determined", source)


@family("device-structure-classes", also=as_grown, often=2)
def classes(rng: Random) -> str:
    """A crank and dyads, each on the frame and the last link: class II by this crank."""
    s = Scheme(rng)
    s.join("R", "0", s.new(), s.place())
    count = int(rng.integers(1, 4))
    for _ in range(count):
        last = str(len(s.links) - 1)
        j, k = s.new(), s.new()
        kinds = [("R", "R", "R"), ("R", "R", "P"), ("R", "P", "R")][int(rng.integers(3))]
        for kind, (a, b) in zip(kinds, ((last, j), (j, k), (k, "0")), strict=True):
            s.join(kind, a, b, s.place())
    source = f"n={len(s.links) - 1} p_l={s.pairs} F=1 groups_1={count} class_1=2"
    return written(s, "1", "n, p_l, F, determined, groups_1, class_1", source)
