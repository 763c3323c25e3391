"""Printed answers that hang together: is a wrong one what other printed ones give,
or was another link's mass or inertia taken?

m = ρ π d² l / 4 and J = m l² / 12 of a round bar; F_I = m a_S, M_I = J α, h = M_I / F_I. A quantity that is printed
enters as printed (a mistake is followed through), any other with its exact value.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from math import prod

from ...foundation.slotted import replace
from ...mechanism.loads import Loads, Mass
from ...words import Words
from .verdict import GRAPHICAL, Checked, Verdict, last_digit


@dataclass(frozen=True, slots=True, kw_only=True)
class Relation:
    """A quantity as factor × product / divisor, by keys."""

    times: tuple[str, ...]
    over: str = ""
    factor: float = 1.0
    sign: str = ""  # the factor as written

    def instead(self, of: str, by: str) -> Relation:
        """The same with one quantity in the place of another."""
        return replace(self, times=tuple(by if key == of else key for key in self.times))


@dataclass(frozen=True, slots=True, kw_only=True)
class Known:
    """What enters a relation: the value, and how far its last printed digit leaves it open (relative)."""

    value: float
    doubt: float = 0.0


def follow(checked: Sequence[Checked], loads: Loads, exact: Callable[[str], float | None]) -> list[Checked]:
    """The same verdicts, the wrong ones with the slip that follows from other printed values,
    or another link's, where one does."""
    printed = {c.printed.symbol: _as_printed(c) for c in checked}

    def known(key: str) -> Known | None:
        if key in printed:
            return printed[key]
        value = exact(key)
        return None if value is None else Known(value=abs(value))

    return [replace(c, slip=_slip(c, loads, known) or c.slip) if c.verdict is Verdict.WRONG else c for c in checked]


def _as_printed(checked: Checked) -> Known:
    value = abs(checked.printed.value)
    if not value:
        return Known(value=0.0)
    unit = last_digit(checked.printed.text, value)
    return Known(
        value=value,
        doubt=max(
            unit / 2 / value, GRAPHICAL if checked.printed.kind == "graphical" and not checked.printed.paper_mm else 0.0
        ),
    )


def relation(key: str, mass: Mass) -> Relation | None:
    """How the quantity follows from others of its link."""
    link = mass.link
    if key == f"J_{link}" and mass.rod:
        return Relation(times=(f"m_{link}",), factor=mass.rod.inertia(1.0), sign=" l^2/12")
    return {
        f"F_I{link}": Relation(times=(f"m_{link}", f"a_{mass.centre}")),
        f"M_I{link}": Relation(times=(f"J_{link}", f"alpha_{link}")),
        f"h_{link}": Relation(times=(f"M_I{link}",), over=f"F_I{link}"),
    }.get(key)


def _slip(checked: Checked, loads: Loads, known: Callable[[str], Known | None]) -> Words | None:
    key = checked.printed.symbol
    for mass in loads.masses:
        if key == f"m_{mass.link}":
            return _another_bar(mass, checked)
        own = relation(key, mass)
        if own is None:
            continue
        if (value := _value(own, known)) is not None and _meets(checked, value):
            return _follows(own, value.value)
        for wrong, other, taken in _swapped(own, mass, loads):
            if (value := _value(wrong, known)) is not None and _meets(checked, value):
                return _taken(taken, mass.link, other, wrong, value.value)
    return None


def _another_bar(mass: Mass, checked: Checked) -> Words | None:
    """The diameter to which a wrong mass of a round bar belongs."""
    if mass.rod is None or checked.slip is not None:
        return None
    had, right = 1e3 * mass.rod.diameter_of(abs(checked.printed.value)), 1e3 * mass.rod.diameter
    return Words(
        f"这是直径 {had:.3g} mm 的圆杆的质量，而 $d$ = {right:g} mm",
        f"the mass of a bar {had:.3g} mm thick, though $d$ = {right:g} mm",
    )


def _swapped(own: Relation, mass: Mass, loads: Loads) -> Iterator[tuple[Relation, str, str]]:
    """The relation with the mass or the inertia of another link: relation, that link, which of the two."""
    for other in loads.masses:
        for stem in ("m", "J"):
            key = f"{stem}_{mass.link}"
            if other.link != mass.link and key in own.times:
                yield own.instead(key, f"{stem}_{other.link}"), other.link, stem


def _value(relation: Relation, known: Callable[[str], Known | None]) -> Known | None:
    parts = [known(key) for key in relation.times]
    below = known(relation.over) if relation.over else Known(value=1.0)
    if below is None or not below.value or any(part is None for part in parts):
        return None
    found = [part for part in parts if part is not None]
    return Known(
        value=relation.factor * prod(part.value for part in found) / below.value,
        doubt=below.doubt + sum(part.doubt for part in found),
    )


def _meets(checked: Checked, found: Known) -> bool:
    """Whether the printed value is this one, as far as the printed digits tell."""
    value = abs(checked.printed.value)
    open_ = last_digit(checked.printed.text, value) / 2 + found.doubt * found.value
    return abs(value - found.value) <= open_ * (1 + 1e-9)


def _symbols(relation: Relation) -> str:
    times, over = " ".join(map(_symbol, relation.times)), f" / {_symbol(relation.over)}" if relation.over else ""
    return f"{times}{relation.sign}{over}"


def _symbol(key: str) -> str:
    """alpha_2 → α_{2}."""
    stem, _, sub = key.replace("alpha", "α").partition("_")
    return f"{stem}_{{{sub}}}"


def _follows(relation: Relation, value: float) -> Words:
    return Words(
        f"由前面所给的值算出：${_symbols(relation)}$ 得 {value:.3g}",
        f"follows from the values printed before: ${_symbols(relation)}$ gives {value:.3g}",
    )


def _taken(what: str, link: str, other: str, relation: Relation, value: float) -> Words:
    zh, en = {"m": ("质量", "mass"), "J": ("转动惯量", "moment of inertia")}[what]
    return Words(
        f"误用构件 {other} 的{zh}代替构件 {link} 的：${_symbols(relation)}$ 得 {value:.3g}",
        f"the {en} of link {other} was taken for that of link {link}: ${_symbols(relation)}$ gives {value:.3g}",
    )
