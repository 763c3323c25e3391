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

from collections.abc import Collection, Iterable
from typing import ClassVar

from pydantic import model_validator

from ..errors import FaultError
from ..names import Named
from ..words import Words, joined
from .base import Device
from .defined import defined, sentence
from .train import Part, Train, check_train, ends, partings, parts


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

    def task(self, asked: Collection[str]) -> Words:
        """What drives what, with the efficiency of each, and what the ends deliver."""
        row = self._row(self.train)
        driven = Words(f"电动机依次经{row.zh}输出功率", f"a motor delivers its power through {row.en}")
        return sentence(driven, _ETAS, *defined((symbol for symbol, _ in self.given()), _LOADS))

    def _row(self, train: Train) -> Words:
        """带传动（$η_b$）、齿轮副（$η_g$）; where it parts, each branch with the letters of its ends."""
        told = []
        for part in train:
            if part.parallel is not None:
                ways = [self._row(branch) for branch in part.parallel]
                zh = "、".join(f"【{way.zh}】" for way in ways)
                en = joined([Words.same(f"[{way.en}]") for way in ways]).en
                told.append(Words(f"并联的{zh}", f"the parallel branches {en}"))
                continue
            name = _CALLED[part.kind]
            letter = next((f" ${one}$" for one, end in self._ends if end is part and len(self.letters) > 1), "")
            told.append(
                Words(f"{name.zh}{letter}（${self.symbol(part)}$）", f"{name.en}{letter} (${self.symbol(part)}$)")
            )
        return Words("、".join(one.zh for one in told), ", ".join(one.en for one in told))

    @property
    def _ends(self) -> Iterable[tuple[str, Part]]:
        return zip(self.letters, ends(self.train), strict=True)

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
            sub, power = ("", "P_r") if one else (f"_{letter}", f"P_{letter}")
            loads += [(power, end.P.text)] if end.P else []
            loads += [(f"{s}{sub}", q.text) for s, q in (("F", end.F), ("v", end.v)) if q]
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


_CALLED = {
    "belt": Words("带传动", "a belt"),
    "chain": Words("链传动", "a chain"),
    "gear": Words("齿轮副", "a pair of gears"),
    "worm": Words("蜗杆传动", "a worm drive"),
    "bearing": Words("轴承", "a bearing"),
    "coupling": Words("联轴器", "a coupling"),
    "screw": Words("螺旋", "a screw"),
    "conveyor": Words("输送机", "a conveyor"),
    "winch": Words("卷筒", "a winch"),
    "pump": Words("泵", "a pump"),
    "machine": Words("工作机", "a machine"),
}
_ETAS = Words("括号内的符号 $η$ 为该级的效率", "in brackets stand the efficiencies $η$")
_LOADS = {
    r"P_\w": Words("输出功率", "power delivered at an end"),
    r"F(_\w)?": Words("输出端克服的阻力", "force overcome at an end"),
    r"v(_\w)?": Words("输出端的速度", "speed at an end"),
}
