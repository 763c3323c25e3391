"""The base of every design: the `data:` of a problem that says `synthesis: NAME`, and what may be asked of it.

A new task of synthesis is one file here (its data), one in `methods/synthesis` (how it is drawn) and one in
`oracle/synthesis` (its solutions in closed form); nothing else is edited. Its `kind` is what a problem file writes
after `synthesis:`.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from functools import cache
from math import degrees, pi
from typing import Annotated, Any, ClassVar

from pydantic import BaseModel, BeforeValidator, ConfigDict, WithJsonSchema

from ..errors import FaultError, UnknownNameError
from ..foundation.plugins import load_modules
from ..names import Named
from ..units.reading import Dim, Quantity, pure, read
from ..words import Words
from .ranged.datum import Datum, of_field

MOST = 9  # solutions of a task, at most


def _advance(text: Any) -> Quantity:
    """K, a pure number not below 1."""
    if isinstance(text, Quantity):
        return text
    if (value := pure(text, "1.4")) < 1:
        raise FaultError(
            Words(
                f"行程速比系数 K = {text}：K 是慢行程与快行程所需时间之比，允许范围 K ≥ 1；若工作行程是快的一个，"
                f"请写其倒数 {1 / value if value > 0 else 1.4:.4g}",
                f"K = {text}: K is the time of the slow stroke over that of the quick one, so that K ≥ 1 is "
                f"admissible; where the quick stroke is meant, write its inverse {1 / value if value > 0 else 1.4:.4g}",
            ),
            code="out-of-range",
            numbers={"K": value},
        )
    return Quantity(value, str(text))


def _quick(text: Any) -> Quantity:
    """K above 1: a linkage that only exists with a quick return."""
    if (quantity := _advance(text)).si == 1:
        raise FaultError(
            Words(
                "K = 1：θ = 0，没有急回，不能由此定出机构；须 K > 1，如 1.5",
                "K = 1 means θ = 0: without quick return the linkage is not determined; K > 1 is needed, e.g. 1.5",
            ),
            code="out-of-range",
        )
    return quantity


def _which(text: Any) -> int:
    """The number of a solution."""
    if isinstance(text, int):
        return text
    if not (str(text).isdigit() and 1 <= int(text) <= MOST):
        raise FaultError(
            Words(
                f"“{text}”不是解的编号；应写 1 至 {MOST} 的整数，如 2",
                f"'{text}' is no number of a solution; write a whole number from 1 to {MOST}, e.g. 2",
            ),
            code="out-of-range",
        )
    return int(text)


Advance = Annotated[Quantity, BeforeValidator(_advance), WithJsonSchema({"type": ["string", "number"]})]
Quick = Annotated[Quantity, BeforeValidator(_quick), WithJsonSchema({"type": ["string", "number"]})]
Omega = Annotated[
    Quantity,
    BeforeValidator(lambda text: text if isinstance(text, Quantity) else read(text, Dim.OMEGA)),
    WithJsonSchema({"type": "string"}),
]
Which = Annotated[int, BeforeValidator(_which), WithJsonSchema({"type": ["string", "integer"]})]


def between_limits(advance: Quantity) -> float:
    """The crank angle between the limit positions, θ = π (K − 1) / (K + 1), rad."""
    return pi * (advance.si - 1) / (advance.si + 1)


class Design(BaseModel):
    """Data of a task of synthesis, frozen; its fields are quantities in SI together with how they were written.

    take: which of the solutions is meant by a quantity without a number. omega: of the crank of what is found, where it
    is to be analysed afterwards; 1 rad/s where nothing is said. ranged: the quantities and lines of which it is told,
    the first first, where they had to lie if no candidate serves.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, defer_build=True)
    kind: ClassVar[str] = ""
    ranged: ClassVar[tuple[Named, ...]] = ()
    take: Which = 1
    omega: Omega | None = None

    def __hash__(self) -> int:
        return hash((type(self), tuple(str(value) for _, value in self)))

    def quantities(self) -> tuple[Named, ...]:
        """All that may be asked of one solution, in the order in which it is found."""
        raise NotImplementedError

    def given(self) -> tuple[tuple[str, str], ...]:
        """Symbol (notation of `formula`) and value as written of everything given, for the line 已知."""
        raise NotImplementedError

    def task(self, asked: Collection[str]) -> Words:
        """What is given and sought, in which letters, from where its angles count: what is told where a problem file
        has no statement; asked: the keys of what is asked."""
        return Words.same("")

    @property
    def is_given(self) -> bool:
        """Whether all lengths of the linkage are given, and only what it does is sought; H is what it does."""
        given = {symbol for symbol, _ in self.given()}
        lengths = [one.key for one in self.quantities() if one.unit == "mm" and one.key != "H"]
        return bool(lengths) and all(f"l_{{{key}}}" in given or key in given for key in lengths)

    def told(self) -> tuple[Words, ...]:
        """What is given in words, where symbols and values do not say it."""
        return ()

    def noted(self, asked: Collection[str]) -> tuple[Words, ...]:
        """What is accepted and told, for it may not be meant; asked: the keys of what is asked."""
        return ()

    def assumed(self, values: Mapping[str, float]) -> Words | None:
        """What is not given, and is taken for the linkage to be moved; None where nothing is."""
        return None

    def built(self, values: Mapping[str, float]) -> dict[str, Any] | None:
        """What a problem file says of the linkage with these lengths (mm); None of a task that finds none."""
        return None

    def driven_last(self, values: Mapping[str, float]) -> dict[str, Any] | None:
        """The same with the other link on the frame for its driver; None of a task whose first link always drives."""
        return None

    def one_of(self, *names: str, never: tuple[str, ...] = (), example: str = "70 mm") -> None:
        """Raise FaultError unless just one of these data is given, and none that has no place beside them.

        example: how the first of them is written.
        """
        more = [name for name in (*names, *never) if getattr(self, name) is not None]
        if len(more) != 1 or more[0] in never:
            raise FaultError(
                Words(
                    f"还须且只须给定 {'、'.join(names)} 之一，此处有：{'、'.join(more) or '无'}；如写 "
                    f"{names[0]}: {example}",
                    f"just one of {', '.join(names)} is needed beside, and here are: {', '.join(more) or 'none'}; "
                    f"write e.g. {names[0]}: {example}",
                ),
                code="contradiction",
            )

    def varied(self) -> Iterator[Datum[Design]]:
        """The numbers of which it is told where they had to lie if no candidate serves, the first first."""
        return filter(None, (of_field(self, named) for named in self.ranged))

    def is_length(self, key: str) -> bool:
        """Whether a quantity is a length that is to be found."""
        return any(named.key == key and named.unit == "mm" for named in self.quantities())

    def settled(self) -> Mapping[str, float]:
        """What the data alone tell of all that may be asked, whatever linkages there are: lengths in mm, angles in
        deg."""
        given = {named.key: (named.unit, getattr(self, named.key, None)) for named in self.quantities()}
        return {key: _in(unit, value) for key, (unit, value) in given.items() if isinstance(value, Quantity | float)}

    @property
    def size(self) -> float:
        """A length typical of its drawing (m), from which a scale is guessed before it is fitted."""
        raise NotImplementedError

    def askable(self) -> tuple[Named, ...]:
        """What may be asked: of the solution that is taken, and of each by its number (AB_2)."""
        one = self.quantities()
        return (*one, *(numbered(named, n) for n in range(1, MOST + 1) for named in one))


def _in(unit: str, value: Quantity | float) -> float:
    """A datum (SI) in the unit in which it is asked."""
    si = value.si if isinstance(value, Quantity) else value
    return degrees(si) if unit == "deg" else 1e3 * si if unit == "mm" else si


def numbered(named: Named, number: int) -> Named:
    """The quantity of one of several solutions: AB_2, l_{AB} with (2) above."""
    return Named(f"{named.key}_{number}", f"{named.symbol}^{{({number})}}", named.unit, solution=number)


@cache
def kinds() -> dict[str, type[Design]]:
    """Every task of synthesis on file, by the name that a problem file uses."""
    load_modules("vecpoly.designs")
    return {sub.kind: sub for sub in sorted(_below(Design), key=lambda s: s.kind)}


def _below(base: type[Design]) -> Iterator[type[Design]]:
    """The tasks on file that are of this sort: classes with a kind of their own, at any depth."""
    for sub in base.__subclasses__():
        if "kind" in vars(sub):
            yield sub
        yield from _below(sub)


def kind_of(name: str) -> type[Design]:
    """The class of this task; raises UnknownNameError."""
    if name not in kinds():
        known = ", ".join(kinds())
        raise UnknownNameError(
            Words(f"没有综合题型“{name}”；已有：{known}", f"no synthesis '{name}'; known: {known}"), code="unknown-name"
        )
    return kinds()[name]
