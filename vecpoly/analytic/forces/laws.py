"""Springs and dampers in the equations of equilibrium: their lengths, how fast these grow, what they do."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ...mechanism.asked.forces import load_symbol
from ...mechanism.laws.springs import Coil, Elastic, Spring
from ...mechanism.model import FRAME
from ..equations import Equation
from ..expr import ZERO, Const, Expr, Var, total
from ..functions import SquareRoot, square
from .pairs import Frame, Pair


@dataclass(frozen=True, slots=True)
class Act:
    """A force at a letter of a link, or a couple."""

    link: str
    at: Pair | None
    force: Pair
    couple: Expr = ZERO


def spring_equations(frame: Frame, spring: Elastic, every: Sequence[Elastic]) -> tuple[Equation, ...]:
    """l, dl/dt and the force of a spring; the moment of a torsion spring. every: it and the others."""
    rates = _rates_index(spring, every)
    if isinstance(spring, Coil):
        return (Equation(Var(load_symbol(spring.name)), _moment(frame, spring, rates)),)
    return tuple(_of_length(frame, spring, rates))


def spring_acts(frame: Frame, spring: Elastic) -> Iterator[Act]:
    """What it does to each of its links that moves."""
    size = Var(load_symbol(spring.name))
    if isinstance(spring, Coil):
        for link, couple in ((spring.link, size), (spring.against, -size)):
            if link != FRAME:
                yield Act(link, None, (ZERO, ZERO), couple)
        return
    gap, length = _gap(frame, spring), _length(spring)
    pull = (size * gap[0] / length, size * gap[1] / length)
    yield Act(spring.link, frame.xy(spring.point), (-pull[0], -pull[1]))
    if spring.against != FRAME:
        yield Act(spring.against, frame.xy(spring.foot), pull)


def _of_length(frame: Frame, spring: Spring, rates: str) -> Iterator[Equation]:
    gap, length, name = _gap(frame, spring), _length(spring), _tail(spring)
    yield Equation(length, SquareRoot(square(gap[0]) + square(gap[1])))
    terms: list[tuple[Expr, int]] = []
    if spring.preload:
        terms.append((Const(f"F_{{0{name}}}", spring.preload, "N"), 1))
    if spring.stiffness:
        stretch = length - Const(f"l_{{0{name}}}", spring.free)
        terms.append((Const(f"k_{{{rates}}}", spring.stiffness, "N/m") * stretch, 1))
    if spring.damping:
        rate, grows = Var(f"v_{{{name}}}"), _gap_rate(frame, spring)
        yield Equation(rate, (gap[0] * grows[0] + gap[1] * grows[1]) / length)
        terms.append((Const(f"c_{{{rates}}}", spring.damping, "N·s/m") * rate, 1))
    yield Equation(Var(load_symbol(spring.name)), total(*terms))


def _moment(frame: Frame, coil: Coil, rates: str) -> Expr:
    """-(M_0 + k (φ - φ_0) + c (ω - ω')); the angle within half a turn of φ_0."""
    name = _tail(coil)
    terms: list[tuple[Expr, int]] = []
    if coil.preload:
        terms.append((Const(f"M_{{0{name}}}", coil.preload, "N·m"), -1))
    if coil.stiffness:
        other = ZERO if coil.against == FRAME else frame.angle(coil.against, 0.0)
        twist = frame.angle(coil.link, 0.0) - other - Const(f"φ_{{0{name}}}", coil.free, "rad")
        terms.append((Const(f"k_{{{rates}}}", coil.stiffness, "N·m/rad") * twist, -1))
    if coil.damping:
        spin = frame.rate(coil.link) - (ZERO if coil.against == FRAME else frame.rate(coil.against))
        terms.append((Const(f"c_{{{rates}}}", coil.damping, "N·m·s") * spin, -1))
    return total(*terms)


def _length(spring: Spring) -> Var:
    return Var(f"l_{{{_tail(spring)}}}")


def _tail(spring: Elastic) -> str:
    """What tells its symbols from those of another: s of F_s; its whole name where that has no tail."""
    return spring.name.partition("_")[2] or spring.name


def _rates_index(spring: Elastic, every: Sequence[Elastic]) -> str:
    """The index of k and c: s of F_s; where there is an M_s too, Fs and Ms."""
    tail = _tail(spring)
    alike = sum(_tail(other) == tail for other in every)
    return tail if alike == 1 else spring.name.replace("_", "")


def _gap(frame: Frame, spring: Spring) -> Pair:
    (x, y), (a, b) = frame.xy(spring.point), frame.xy(spring.foot)
    return x - a, y - b


def _gap_rate(frame: Frame, spring: Spring) -> Pair:
    (x, y), (a, b) = frame.velocity(spring.point), frame.velocity(spring.foot)
    return x - a, y - b
