"""Machines in series, in parallel and mixed:
a train is a row of transmissions that ends in a load or parts into branches.

train: [belt: 0.95, gear: 0.97, {conveyor: 0.92, F: 5500 N, v: 1.2 m/s}]
train:
  - belt: 0.92
  - parallel:
      - [gear: 0.97, {machine: 0.8, name: A, P: 5 kW}]
      - [gear: 0.97, {machine: 0.5, name: B, P: 1 kW}]
"""

from __future__ import annotations

from typing import ClassVar

from pydantic import model_validator

from ..errors import FaultError
from ..names import Named
from ..words import Words
from .base import Device
from .train import Part, check_train, ends, partings, parts


class PowerTrain(Device):
    """A motor drives a train of machines; sought are the efficiency of the whole and the motor's power."""

    kind: ClassVar[str] = "power-train"
    train: tuple[Part, ...]

    @model_validator(mode="after")
    def _is_complete(self) -> PowerTrain:
        check_train(self.train)
        names = [part.name for part in ends(self.train) if part.name]
        twice = sorted({name for name in names if names.count(name) > 1})
        if twice:
            raise FaultError(
                Words(
                    f"系统有两个末端都叫 {twice[0]}；请各取一个字母",
                    f"two ends of the train are named {twice[0]}; give each its own letter",
                ),
                code="contradiction",
                keys=("train",),
            )
        return self

    def quantities(self) -> tuple[Named, ...]:
        """η of each parallel part from the outermost, of the whole;
        the motor's power, and its share for each end (kW)."""
        letters = self.letters
        if len(letters) == 1:
            return (POWER_OUT, ETA, POWER)
        count = len(partings(self.train))
        powers = [named for letter in letters for named in (out(letter), share(letter))]
        return (*powers, POWER_OUT, *(eta_prime(i, count) for i in range(count)), ETA, POWER)

    def given(self) -> tuple[tuple[str, str], ...]:
        """The efficiencies in order, then what is delivered."""
        one = len(self.letters) == 1
        etas = tuple(
            dict.fromkeys((self.symbol(part), getattr(part, part.kind).text) for part in parts(self.train) if part.kind)
        )
        loads: list[tuple[str, str]] = []
        for letter, end in zip(self.letters, ends(self.train), strict=True):
            sub = "" if one else f"_{letter}"
            loads += [(f"{s}{sub}", q.text) for s, q in (("P", end.P), ("F", end.F), ("v", end.v)) if q]
        return (*etas, *loads)

    @property
    def letters(self) -> tuple[str, ...]:
        """A letter for each end of the train: its name, else the next one that is free."""
        named = [part.name for part in ends(self.train)]
        free = (letter for letter in "ABCDEFGHIJKLMNOPQRSTUVWXYZ" if letter not in named)
        return tuple(name or next(free) for name in named)

    def symbol(self, part: Part) -> str:
        """η with a letter for the kind, or with the machine's own;
        numbered where parts of a kind differ: η_g, η_{g2}, η_A."""
        if part.loaded and part.kind == "machine" and len(self.letters) > 1:
            return (
                f"η_{next(letter for letter, end in zip(self.letters, ends(self.train), strict=True) if end is part)}"
            )
        stem = _SUBSCRIPT.get(part.kind, part.kind[0])
        values = list(dict.fromkeys(other.eta for other in parts(self.train) if other.kind == part.kind))
        return f"η_{stem}" if len(values) == 1 else f"η_{{{stem}{values.index(part.eta) + 1}}}"


_SUBSCRIPT = {"chain": "h", "conveyor": "c", "coupling": "k", "winch": "t", "bearing": "r", "pump": "q"}
ETA = Named("eta", "η", "")
POWER = Named("P", "P", "kW")
POWER_OUT = Named("P_out", "P_r", "kW")


def out(letter: str) -> Named:
    """P_A: what the end A delivers."""
    return Named(f"P_{letter}", f"P_{letter}", "kW")


def share(letter: str) -> Named:
    """P_A_in: the motor's power that end A takes, with all losses on its way."""
    return Named(f"P_{letter}_in", f"P_{{{letter}d}}", "kW")


def eta_prime(index: int, count: int) -> Named:
    """η′: what the branches deliver over what they take, the outermost first."""
    return Named("eta_prime", "η′", "") if count == 1 else Named(f"eta_prime_{index + 1}", f"η′_{index + 1}", "")
