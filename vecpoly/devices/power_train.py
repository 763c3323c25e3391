"""Machines in series, in parallel and mixed: a train is a row of transmissions that ends in a load or parts into
branches.

train: [belt: 0.95, gear: 0.97, {conveyor: 0.92, F: 5500 N, v: 1.2 m/s}]
train:
  - belt: 0.92
  - parallel:
      - [gear: 0.97, {machine: 0.8, name: A, P: 5 kW}]
      - [gear: 0.97, {machine: 0.5, name: B, P: 1 kW}]
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import ClassVar

from pydantic import BaseModel, ConfigDict, Field, model_validator

from ..errors import FaultError
from ..names import Named
from ..units.reading import Quantity
from ..words import Words
from .base import Device, Efficiency, ForceSize, Power, Speed

KINDS = ("belt", "chain", "gear", "worm", "bearing", "coupling", "screw", "conveyor", "winch", "pump", "machine")

Train = tuple["Part", ...]


class Part(BaseModel):
    """One transmission with its efficiency, or the place where the train parts into branches.

    The last part of every branch says what it delivers: a power P, or a force F at a speed v.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, revalidate_instances="always")

    belt: Efficiency | None = None
    chain: Efficiency | None = None
    gear: Efficiency | None = None
    worm: Efficiency | None = None
    bearing: Efficiency | None = None
    coupling: Efficiency | None = None
    screw: Efficiency | None = None
    conveyor: Efficiency | None = None
    winch: Efficiency | None = None
    pump: Efficiency | None = None
    machine: Efficiency | None = None
    parallel: tuple[tuple[Part, ...], ...] | None = None
    name: str = Field(default="", pattern="^[A-Z]?$")
    P: Power | None = None
    F: ForceSize | None = None
    v: Speed | None = None

    @property
    def kind(self) -> str:
        """belt, gear, machine ...; empty where the train parts."""
        return next((kind for kind in KINDS if getattr(self, kind) is not None), "")

    @property
    def eta(self) -> float:
        """Its efficiency."""
        written: Quantity = getattr(self, self.kind)
        return written.si

    @property
    def loaded(self) -> bool:
        """Whether it says what it delivers."""
        return self.P is not None or self.F is not None

    @model_validator(mode="after")
    def _is_one_thing(self) -> Part:
        kinds = [kind for kind in KINDS if getattr(self, kind) is not None] + ["parallel"] * (self.parallel is not None)
        if len(kinds) != 1:
            raise FaultError(
                Words(
                    f"传动系统的每一级为 {', '.join(KINDS)} 之一及其效率，或为 parallel；"
                    f"这里写的是 {' 和 '.join(kinds) or '空'}；如写 gear: 0.97",
                    f"a part of a train is one of {', '.join(KINDS)} with its efficiency, or parallel: here "
                    f"stand {' and '.join(kinds) or 'none of them'}; write e.g. gear: 0.97",
                ),
                code="spelling",
            )
        if (self.F is None) != (self.v is None):
            raise FaultError(
                Words(
                    "有力 F 就须有克服它的速度 v；请同时写 F 和 v，或只写 P",
                    "a force needs the speed at which it is overcome: write both F and v, or P alone",
                ),
                code="spelling",
            )
        if self.P is not None and self.F is not None:
            raise FaultError(
                Words(
                    "输出功率重复给出；请写 P，或写 F 和 v", "what is delivered stands there twice: write P, or F and v"
                ),
                code="contradiction",
            )
        if self.parallel is None:
            return self
        if self.loaded or self.name:
            raise FaultError(
                Words(
                    "分流处没有功率输出；P、F、v 和 name 应写在各支路的末端",
                    "where the train parts nothing is delivered: write P, F, v and name at the ends of its branches",
                ),
                code="spelling",
            )
        if len(self.parallel) < 2:
            raise FaultError(
                Words(
                    "parallel 至少要有两条支路；只有一条时直接写成串联的一级",
                    "parallel needs two branches or more; write a single one as part of the train itself",
                ),
                code="missing",
            )
        for branch in self.parallel:
            _check(branch)
        return self


def _check(train: Train) -> None:
    """Power is delivered at the end of a train, and nowhere else."""
    if not train:
        raise FaultError(
            Words(
                "传动系统没有任何一级；如写 [gear: 0.97, {machine: 0.8, P: 5 kW}]",
                "a train without parts; write e.g. [gear: 0.97, {machine: 0.8, P: 5 kW}]",
            ),
            code="spelling",
        )
    for part in train[:-1]:
        if part.parallel is not None:
            raise FaultError(
                Words(
                    "parallel 之后功率已经分流；其后的各级应写入各支路",
                    "after parallel the power is divided: put the parts that follow it into its branches",
                )
            )
        if part.loaded:
            raise FaultError(
                Words(
                    f"功率由系统的最后一级输出，不能由中间的 {part.kind} 输出；请将 P 或 F、v 写在末级，"
                    "或在该处用 parallel 分流",
                    f"power is delivered by the last part of a train, not by its {part.kind}: put P, or F and "
                    "v, at the end, or let the train part there with parallel",
                )
            )
    if train[-1].parallel is None and not train[-1].loaded:
        raise FaultError(
            Words(
                f"最后一级的输出没有给出；如写 {{{train[-1].kind}: {train[-1].eta:g}, P: 5 kW}}",
                f"nothing says what the last part of a train delivers; write e.g. {{{train[-1].kind}: "
                f"{train[-1].eta:g}, P: 5 kW}}",
            ),
            code="spelling",
        )


class PowerTrain(Device):
    """A motor drives a train of machines; sought are the efficiency of the whole and the motor's power."""

    kind: ClassVar[str] = "power-train"
    train: tuple[Part, ...]

    @model_validator(mode="after")
    def _is_complete(self) -> PowerTrain:
        _check(self.train)
        names = [part.name for part in ends(self.train) if part.name]
        twice = sorted({name for name in names if names.count(name) > 1})
        if twice:
            raise FaultError(
                Words(
                    f"系统有两个末端都叫 {twice[0]}；请各取一个字母",
                    f"two ends of the train are named {twice[0]}; give each its own letter",
                ),
                code="contradiction",
            )
        return self

    def quantities(self) -> tuple[Named, ...]:
        """η of each parallel part from the outermost, of the whole; the motor's power, and its share for each end
        (kW)."""
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
        """η with a letter for the kind, or with the machine's own; numbered where parts of a kind differ: η_g, η_{g2},
        η_A."""
        if part.loaded and part.kind == "machine" and len(self.letters) > 1:
            return (
                f"η_{next(letter for letter, end in zip(self.letters, ends(self.train), strict=True) if end is part)}"
            )
        stem = _SUBSCRIPT.get(part.kind, part.kind[0])
        values = list(dict.fromkeys(other.eta for other in parts(self.train) if other.kind == part.kind))
        return f"η_{stem}" if len(values) == 1 else f"η_{{{stem}{values.index(part.eta) + 1}}}"


def parts(train: Train) -> Iterator[Part]:
    """All parts, in the order in which the power runs, branch after branch."""
    for part in train:
        yield part
        for branch in part.parallel or ():
            yield from parts(branch)


def ends(train: Train) -> tuple[Part, ...]:
    """The parts that deliver power."""
    return tuple(part for part in parts(train) if part.loaded)


def partings(train: Train) -> tuple[Part, ...]:
    """The places where the train parts, the outermost first."""
    return tuple(part for part in parts(train) if part.parallel is not None)


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
