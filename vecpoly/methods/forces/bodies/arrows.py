"""Where the arrows of a free body stand: on its line of action each force may end or start at its point;
the freest place is taken."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass

import numpy as np

from ....foundation.slotted import replace
from ....names import ascii_key
from ....plane import nominal
from ....words import Words
from ..acting import Acting
from ..state import Statics
from .bars import LEAN, MOST, ON, Bar, is_hidden, past_bars

LENGTH = 20.0  # mm; the longest force; none is drawn shorter than half of it
CLEAR = 6.0  # mm between arrows: more is not better
PULL = 4.0  # mm of clearness that an arrow must gain to be drawn otherwise than it should be
COVERED, HIDDEN = 15.0, 40.0  # mm: the same to lie on another arrow, or on a bar, where it is not seen
REACH = 80.0  # mm: a line of action farther from the body is off the paper
FEW, MANY = 6, 10  # arrows that are tried in all their places together, and those in their places at the point
NEAR = 2  # places at the point; the others are farther out
ROUNDS = 5
GAP = 1.5  # mm between an arrow's point and the pin
LEAST_AWAY, STANDS = 8.0, 4.0  # mm: of an arrow farther out from its point, from all else
ALONG = np.linspace(0.0, 1.0, 9)  # places of an arrow


@dataclass(frozen=True, slots=True)
class Arrow:
    """A force on the sheet."""

    start: complex
    end: complex
    symbol: str
    far: bool = False  # not at its point but farther out on the line
    presses: bool = False  # ends at its point, or on the line before it
    amiss: bool = False  # pulling though a neighbour can only press, or otherwise than on the kinematic diagram
    hidden: bool = False  # on an arrow that stands there, or on a bar of which there is no end to set it past

    @property
    def key(self) -> str:
        """The force's key."""
        return ascii_key(self.symbol)


def place_arrows(
    forces: Sequence[Acting],
    points: Sequence[complex],
    pressing: Collection[str] = (),
    pulling: Collection[str] = (),
    *,
    bars: Sequence[Bar] = (),
    standing: Sequence[Bar] = (),
) -> list[Arrow]:
    """All arrows of one body, as far from each other, from those that stand there and from the body as their lines
    allow, and on none of its bars; `pressing`: those that rather end at their point; `pulling`: those that rather
    begin there."""
    shown = [f for f in forces if abs(nominal(f.vector)) > 1e-9 and not is_far(f, points)]
    if not shown:
        return []
    largest = max(abs(complex(nominal(f.vector))) for f in shown)
    options = [
        [_off_bars(one, bars, standing) for one in _options(f, largest, _rather(f.named.symbol, pressing, pulling))]
        for f in shown
    ]
    body = np.array(
        [points[0]]
        if len(points) == 1
        else [a + (b - a) * t for a in points for b in points for t in (0.0, 0.25, 0.5, 0.75, 1.0)]
    )
    body = np.concatenate([body, *(a + (b - a) * ALONG[1:] for a, b in standing)])
    freest, places = _freest(options, body), [complex(nominal(f.at)) for f in shown]
    for i, at in enumerate(places):
        if freest[i].far:
            freest[i] = _closer(
                freest[i], at, [one for k, one in enumerate(freest) if k != i], body, [*bars, *standing]
            )
    return freest


def _closer(arrow: Arrow, at: complex, others: Sequence[Arrow], body: np.ndarray, bars: Sequence[Bar] = ()) -> Arrow:
    """One that stands farther out on its line as near to its point as the others and the body leave it free, and past
    the bars still."""
    near = min(arrow.start, arrow.end, key=lambda z: abs(z - at))
    away, out = abs(near - at), (near - at) / abs(near - at)
    taken = np.concatenate([body, *(one.start + (one.end - one.start) * ALONG for one in others)])
    shaft = (arrow.start + (arrow.end - arrow.start) * ALONG)[:, None]
    free = min(STANDS, float(np.abs(shaft - taken).min()))
    for less in np.arange(away - LEAST_AWAY, 0.0, -1.0):
        start, end = arrow.start - less * out, arrow.end - less * out
        if np.abs(shaft - less * out - taken).min() >= free - 1e-9 and not is_hidden(start, end, bars):
            return replace(arrow, start=start, end=end)
    return arrow


def is_far(force: Acting, points: Sequence[complex]) -> bool:
    """Whether the force acts too far from all points of its body to be drawn there."""
    return min(abs(complex(nominal(force.at)) - p) for p in points) > REACH


def say_far(st: Statics, forces: Sequence[Acting], points: Sequence[complex]) -> None:
    """Name the forces that are not drawn because their lines are off the paper."""
    for force in forces:
        if abs(nominal(force.vector)) > 1e-9 and is_far(force, points):
            away = min(abs(complex(nominal(force.at)) - p) for p in points)
            st.board.remark(
                Words(
                    f"${force.named.symbol}$ 的作用线远在 {away:.0f} mm 之外，图上不画。",
                    f" The line of ${force.named.symbol}$ is {away:.0f} mm away and is not drawn.",
                )
            )


def _rather(symbol: str, pressing: Collection[str], pulling: Collection[str]) -> bool | None:
    """Whether an arrow rather ends at its point; None: either way."""
    return True if symbol in pressing else False if symbol in pulling else None


def _options(force: Acting, largest: float, presses: bool | None) -> tuple[Arrow, ...]:
    """Pulling away from the point, or pressing towards it;
    or the same farther out on the line, where another force stands already."""
    vector, at = complex(nominal(force.vector)), complex(nominal(force.at))
    u = vector / abs(vector)
    length = LENGTH * max(0.5, abs(vector) / largest)
    out, symbol = u * (LENGTH + 4.0), force.named.symbol
    near = (
        Arrow(at, at + u * length, symbol, amiss=presses is True),
        Arrow(at - u * (length + GAP), at - u * GAP, symbol, presses=True, amiss=presses is False),
    )
    return (
        *near,
        *(
            replace(a, start=a.start + side * out, end=a.end + side * out, far=True)
            for a, side in zip(near, (1, -1), strict=True)
        ),
    )


def _off_bars(arrow: Arrow, bars: Sequence[Bar], standing: Sequence[Bar]) -> Arrow:
    """The same farther out, past the bar on which it lies: one that ends at its point the way it comes from."""
    if is_hidden(arrow.start, arrow.end, standing):
        return replace(arrow, hidden=True)
    way = (arrow.end - arrow.start) / abs(arrow.end - arrow.start)
    out = -way if arrow.presses else way
    if not is_hidden(arrow.start, arrow.end, bars):
        return arrow
    by = past_bars(arrow.start, arrow.end, out, bars)
    if not by:
        return replace(arrow, hidden=True)
    return replace(arrow, start=arrow.start + by * out, end=arrow.end + by * out, far=True)


def _freest(options: Sequence[Sequence[Arrow]], body: np.ndarray) -> list[Arrow]:
    """One option of each force, so that the middles and far ends of the arrows are as free as can be, and none lies
    on another."""
    flat = [arrow for pair in options for arrow in pair]
    places = np.array([((a.start + a.end) / 2, a.start, a.end) for a in flat]).T
    middle, *ends = np.abs(places[..., None] - body).min(axis=2)  # mm to the body
    far = np.where(ends[0] >= ends[1], places[1], places[2])
    alone = 0.7 * np.minimum(middle, np.maximum(*ends))
    # of each arrow's middle to the middle and far end of another
    apart = np.abs(places[0, :, None, None] - np.stack([places[0], far])).min(axis=1)
    np.fill_diagonal(apart, np.inf)
    cost = np.array([CLEAR * one.far + PULL * one.amiss + HIDDEN * one.hidden for one in flat])
    covers = _covers(places[1], places[2])

    def freedom(choices: np.ndarray) -> np.ndarray:
        pairs = choices[:, :, None], choices[:, None, :]
        clear = np.minimum(np.minimum(apart[pairs].min(axis=2), alone[choices]), CLEAR)
        return np.asarray((clear - cost[choices] - COVERED * covers[pairs].any(axis=2)).sum(axis=1))

    counts = [len(pair) for pair in options]
    starts = np.cumsum([0, *counts[:-1]])
    best = starts
    if len(counts) <= MANY:
        tried = counts if len(counts) <= FEW else [NEAR] * len(counts)
        choices = starts + np.indices(tried).reshape(len(counts), -1).T
        best = choices[int(np.argmax(freedom(choices)))]
    if len(counts) > FEW:
        best = _one_by_one(best, starts, counts, freedom)
    return [flat[i] for i in best]


def _covers(start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Which arrows lie on which others, for a good part of their length."""
    way = (end - start) / np.abs(end - start)
    shaft = start[:, None] + (end - start)[:, None] * ALONG
    on = (shaft[:, None, :] - start[None, :, None]) / way[None, :, None]
    share = ((on.real > 0.0) & (on.real < np.abs(end - start)[None, :, None]) & (np.abs(on.imag) < ON)).mean(axis=2)
    lies = (share > MOST) & (np.abs((way[:, None] / way).imag) < LEAN)
    found = lies | lies.T
    np.fill_diagonal(found, False)
    return np.asarray(found)


def _one_by_one(
    best: np.ndarray, starts: np.ndarray, counts: Sequence[int], freedom: Callable[[np.ndarray], np.ndarray]
) -> np.ndarray:
    """Of too many arrows to try all together each is turned in its turn, as long as that frees them."""
    for _ in range(ROUNDS):
        before = best.copy()
        for i, count in enumerate(counts):
            tried = np.repeat(best[None], count, axis=0)
            tried[:, i] = starts[i] + np.arange(count)
            best = tried[int(np.argmax(freedom(tried)))]
        if (best == before).all():
            break
    return best
