"""What is printed after 已知: every datum as it was written, and how the links look."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import field
from decimal import Decimal
from enum import StrEnum

from ...foundation.frozen import FrozenMap
from ...foundation.patterns import pattern
from ...foundation.slotted import dataclass
from ...words import Lang, Words
from .seen import Seen


class Shape(StrEnum):
    """How a link is drawn."""

    BAR = "bar"  # two or more pins
    SLOT = "slot"  # a slotted link: a block or a pin runs in it
    ROD = "rod"  # a straight rod that passes through a block or sleeve
    BLOCK = "block"  # a sliding block
    GEAR = "gear"
    CYLINDER = "cylinder"  # of a hydraulic drive
    PISTON = "piston"  # with its rod
    PIN = "pin"  # the massless block that stands for a pin in a slot; not drawn


@dataclass(frozen=True, slots=True, kw_only=True)
class GivenTable:
    """A table that is given: heads with symbol and unit, $φ$ /°, and the rows as they are printed."""

    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


def by_table(name: str, size: str, over: str) -> Words:
    """That what is called so is given by a table, and of what over what."""
    return Words(f"{name} 由 {size}–{over} 数据表给出", f"{name} by the table of {size} over {over}")


@dataclass(frozen=True, slots=True, kw_only=True)
class Datum:
    """One given quantity: its symbol (`l_AB`, `φ_1`, `ω_1`), SI value, and the value as written (`30 mm`).

    Where no symbol is usual, the symbol is empty and `words` say it all; a table stands under them.
    Words with a symbol have a gap `{}` for the value. seen: what they say, for a sketch.
    """

    symbol: str = ""
    si: float = 0.0
    text: str = ""
    words: Words | None = None
    table: GivenTable | None = None
    seen: Seen | None = None

    def of(self, lang: Lang) -> str:
        """As printed after 已知: `$l_AB$ = 30 mm`, or the words."""
        told = self.words.of(lang) if self.words else f"${self.printed}$ = {self.text}"
        return as_printed(told.replace("{}", self.text) if self.symbol else told, lang)

    @property
    def printed(self) -> str:
        """Its symbol as it is printed: a speed in r/min is n_1, not ω_1."""
        return f"n{self.symbol[1:]}" if self.symbol.startswith("ω_") and "r/min" in self.text else self.symbol


_EXPONENT = pattern(r"(?<![\w.])(\d+\.?\d*|\.\d+)[eE]([+-]?\d+)(?!\w)")
_PLAIN = (-4, 7)  # powers of ten of the first figure of what is written without an exponent
_LONG = pattern(r"\d+\.\d{4,}")  # more digits than a person writes
_MINUS = pattern(r"(?<![\w$}])-(?=\$?\d)")
_OF_ZERO = pattern(r"(?<![\w$}])-(?=0+(?:\.0*)?(?![\d.]))")  # a minus that says nothing
_SIGNS: dict[Lang, tuple[tuple[str, str], ...]] = {
    "zh": ((" deg", "°"), (" ccw", "（逆时针）"), (" cw", "（顺时针）"), (" from", " 自"), (" at ", "，方向角 ")),
    "en": ((" deg", "°"), (" ccw", " (counter-clockwise)"), (" cw", " (clockwise)")),
}
_TYPESET = {
    lang: (
        (pattern(r"\blog10\((\w)\)"), log),
        (pattern(r"\ba(sin|cos|tan)\("), r"arc\1("),
        (pattern(r"\) ω(²?)"), r") $ω$\1"),  # of a characteristic
        (pattern(r"(?<=[A-Za-z])\*(?=[a-z])"), "·"),
        (pattern(r" -> "), " → "),
        (pattern(r"(?<=[°)]) - (?=[\da-z])"), " − "),
        (pattern(r"(-?\d+(?:\.\d+)?°): (-?[\d.]+(?:e[+-]?\d+)?)"), r"\2 (\1)"),
        (pattern(r" \((-?\d+(?:\.\d+)?°)\)"), at),
        (pattern(r"(?<=°[）)]), "), comma),
    )
    for lang, log, at, comma in (("zh", r"lg $\1$", r"（\1）", "，"), ("en", r"log₁₀ $\1$", r" (\1)", ", "))
}


def _by_powers_of_ten(written: re.Match[str]) -> str:
    """1e-1 is 0.1, 2.5e+2 is 250, 3e-9 is 3×10⁻⁹."""
    value = Decimal(written[0])
    first = value.adjusted()
    if value and not _PLAIN[0] <= first < _PLAIN[1]:
        return f"${value.scaleb(-first).normalize():f}×10^{{{first}}}$".replace("-", "−")
    return f"{value.normalize():f}"


def as_printed(text: str, lang: Lang) -> str:
    """A value as a textbook prints it: 45°, 10 rad/s (clockwise)."""
    text = text.replace(" … ", "～" if lang == "zh" else " to ")
    for written, printed in _SIGNS[lang]:
        text = re.sub(f"{written}(?![a-z])", printed, text)  # deg is a unit, degree a word
    for found, made in _TYPESET[lang]:
        text = found.sub(made, text)
    text = _LONG.sub(lambda m: f"{float(m[0]):.6g}", text)  # which may have an exponent then
    text = _EXPONENT.sub(_by_powers_of_ten, text)
    return _MINUS.sub("−", _OF_ZERO.sub("", text))


@dataclass(frozen=True, slots=True, kw_only=True)
class Given:
    """What is printed after 已知: lengths in order, the input's data,
    what acts (or a device's data), how the links look."""

    lengths: tuple[Datum, ...] = ()
    motion: tuple[Datum, ...] = ()
    loads: tuple[Datum, ...] = ()
    letters: tuple[str, ...] = ()  # frame's letters first, then by link
    shapes: Mapping[str, Shape] = field(default_factory=dict)  # by link name
    bound: frozenset[str] | None = None
    # by the symbol of a drive's place: how far its coordinate is ahead of its datum (rad, or m)
    leads: Mapping[str, float] = field(default_factory=dict)

    @property
    def data(self) -> tuple[Datum, ...]:
        """All of them, in the order in which they are printed."""
        return (*self.lengths, *self.motion, *self.loads)

    def __post_init__(self) -> None:
        for name in ("shapes", "leads"):
            object.__setattr__(self, name, FrozenMap(dict(getattr(self, name))))
