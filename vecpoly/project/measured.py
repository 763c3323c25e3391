"""What a part gives to later parts and to the demands: its answers, and of a mechanism the facts of its cycle."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from math import nan

from ..answer import Answer
from ..units.reckoning import Amount
from .part import Part


@dataclass(frozen=True, slots=True)
class Measured:
    """A quantity that a part gives: as drawn, and exactly; the same twice where nothing is drawn."""

    symbol: str
    unit: str
    drawn: Amount
    exact: Amount


def measured(part: Part) -> Mapping[str, Measured]:
    """By key: AB, alpha_max, omega_H; of a mechanism also K, theta, stroke or swing, gamma_min, M_max, M_mean, P."""
    found = {key: _read(answer) for key, answer in part.solution.answers.items()}
    if part.moves:
        found |= {key: _known(symbol, value, unit) for key, symbol, value, unit in _facts(part)}
    return found


def known(parts: Iterable[Part], *, exact: bool) -> dict[str, Amount]:
    """What these parts gave, as `part.key`: drawn, or exact."""
    return {
        f"{part.name}.{key}": one.exact if exact else one.drawn for part in parts for key, one in measured(part).items()
    }


def _read(answer: Answer) -> Measured:
    unit = answer.reading.unit
    if unit == "yes/no":
        unit = ""
    drawn, exact = (Amount.of(value, unit) for value in (answer.drawn, answer.exact))
    return Measured(answer.reading.symbol, unit, drawn, exact)


def _known(symbol: str, value: float, unit: str) -> Measured:
    amount = Amount.of(value, unit)
    return Measured(symbol, unit, amount, amount)


Fact = tuple[str, str, float, str]


def _facts(part: Part) -> Iterator[Fact]:
    drive = part.problem.mechanism.drive
    if not drive.slide:
        yield f"omega_{drive.link}", f"ω_{{{drive.link}}}", drive.rate, "rad/s"
    yield from _strokes(part)
    least = min((t.least.value for t in part.facts.transmissions), default=nan)
    yield "gamma_min", "γ_{min}", least, "rad"
    if part.problem.loads is not None and (even := part.balance) is not None:
        yield "M_max", "M_{d,max}", even.highest.value, "N*m"
        yield "M_mean", "M_m", even.mean, "N*m"
        yield "P", "P", even.power, "W"
        if even.inertia is not None:
            yield "J_F", "J_F", even.inertia, "kg*m**2"


def _strokes(part: Part) -> Iterator[Fact]:
    """Of the last link that goes to and fro."""
    last = (part.facts.strokes or (None,))[-1]
    if last is None:
        return
    angle = last.key.startswith("phi")
    yield "K", "K", last.ratio, ""
    yield "theta", "θ", last.theta, "rad"
    yield ("swing", "ψ", last.swing, "rad") if angle else ("stroke", "H", last.swing, "m")
