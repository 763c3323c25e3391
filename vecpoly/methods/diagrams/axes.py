"""The axes of a diagram, with round numbers along both."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from math import ceil, degrees, floor, log10

from ...algebra.rounding import braced
from ...board.board import Board
from ...board.construction import Place
from ...board.paper.marks import Dot, Role
from ...words import Words

BEYOND, TICK = 9.0, 1.5  # mm: how far the axes run on; half a tick
STEPS = (1, 2, 5, 10, 15, 30, 45, 60, 90, 120, 180, 360)  # deg from tick to tick
MOST = 8  # ticks
ROUNDING = 1e-6  # of a step
LEVELS = 4  # round numbers, about, along the axis that goes up


@dataclass(frozen=True, slots=True, kw_only=True)
class Axes:
    """How far something is set out (mm): to the right, and from the lowest to the highest; the letters at the ends."""

    wide: float
    low: float
    high: float
    across: str
    up: str


def draw_axes(board: Board, place: Place, axes: Axes, ticks: Iterable[tuple[float, str]]) -> None:
    """Both axes with their letters; ticks: how far to the right (mm), and what is written there: below the axis, or
    above it where the curve lies mostly below. Where there are some, the upright axis has round numbers too; numbers
    without a unit have it behind the letter of their axis."""
    right, top = axes.wide + BEYOND + 0j, 1j * (axes.high + BEYOND)
    bottom = 1j * (axes.low - BEYOND / 2) if axes.low < 0 else 0j
    board.arrow(place, 0j, right, Role.DIRECTION)
    board.arrow(place, bottom, top, Role.DIRECTION)
    ticks, scale = [*ticks], board.scale_of(place)
    along = scale.right.unit if ticks and ticks[0][1][-1].isdigit() else ""
    board.plot(place, right, f"{axes.across}/{braced(along)}" if along else axes.across, Dot.NONE)
    board.plot(place, top, f"{axes.up}/{braced(scale.unit)}" if ticks and scale.unit else axes.up, Dot.NONE)
    for level, text in _levels(axes, scale.value) if ticks else ():
        board.join(place, level * 1j - TICK, level * 1j + TICK, Role.CONSTRUCTION)
        board.note(place, level * 1j - TICK, Words.same(text), -1 + 0j)
    side = -1j if axes.high >= -axes.low else 1j
    for at, written in ticks:
        board.join(place, at - TICK * 1j, at + TICK * 1j, Role.CONSTRUCTION)
        board.note(place, at + TICK * side, Words.same(written), side)


def divisions(low: float, high: float, parts: float) -> list[float]:
    """Round numbers from end to end, at about so many equal steps: of 1, 2, 5 times a power of ten."""
    rough = (high - low) / parts
    power = 10.0 ** floor(log10(rough))
    step = next(power * n for n in (1, 2, 5, 10) if power * n >= 0.999 * rough)
    first, last = ceil(low / step - 1e-9), floor(high / step + 1e-9)
    return [n * step for n in range(first, last + 1)]


def _levels(axes: Axes, scale: float) -> Iterator[tuple[float, str]]:
    """How high a number stands on the upright axis (mm), and the number."""
    low, high = min(axes.low, 0.0) * scale, max(axes.high, 0.0) * scale
    values = divisions(low, high, LEVELS) if high > low else []
    for value, text in zip(values, numbers(values), strict=True):
        if abs(value) > 1e-9 * (high - low):
            yield value / scale, text


def numbers(values: Sequence[float]) -> list[str]:
    """Round numbers along one axis, each with as many decimals as the one that has most; zero has none."""
    short = [f"{value:.6g}" for value in values]
    most = max((len(text.partition(".")[2]) for text in short), default=0)
    long = (text if "e" in text or not float(text) else f"{float(text):.{most}f}" for text in short)
    return [text.replace("-", "−") for text in long]


def angle_ticks(
    board: Board, place: Place, period: float, corners: Sequence[float] = ()
) -> Iterable[tuple[float, str]]:
    """Round angles up to the end of a period (rad), and its end; those among them, if that can be, at which a curve has
    its corners (rad)."""
    whole = degrees(period)
    step = angle_steps(whole, [*map(degrees, corners)])
    inner = [step * i for i in range(1, int(whole / step) + 1) if step * i < whole - step / 3]
    for angle in (*inner, whole):
        yield period * angle / whole / board.scale_of(place).right.value, f"{angle:.6g}°"


def angle_steps(whole: float, corners: Sequence[float]) -> int:
    """From tick to tick (deg): the least that makes few ticks, if there is one among which all corners are."""
    steps = [one for one in STEPS if whole / one <= MOST] or [STEPS[-1]]
    at_corners = (one for one in steps if all(abs(at / one - round(at / one)) < ROUNDING for at in corners))
    return next(at_corners, steps[0])
