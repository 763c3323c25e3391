"""Chapter 7, drawn beside exact over the cycle: the same drawing by the same hand every 15°, at the same scales where
the figures go on a sheet."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....board.paper.sizes import unfit
from ....errors import VecpolyError
from ....findings.study.study import Study
from ....foundation.slotted import replace
from ....printed.digits import is_hopeless
from ....problem.problem import Problem
from ....solution import Answer, scales_of
from ....words import Words
from ..analysis.force_words import refusals
from ..numbering import SMALL, Press
from ..results.plots import WIDE
from ..results.positions import at_position, read_there
from .refused import cause
from .three_digits import figures

STATIONS = 24
FLAT, MARGIN = 0.35, 0.25  # of the frame that drawn values take at least; of what they take, beyond them
_HEADER = {
    "zh": ["量", "单位", "最大值", "最大偏差 /%", "位置", "均方根偏差 /%", "手工误差 3σ /%"],
    "en": ["Quantity", "Unit", "Largest value", "Largest deviation /%", "Place", "rms deviation /%", "3σ by hand /%"],
}


@dataclass(frozen=True)
class Station:
    """Drawn and exact values by key at one position."""

    phi: float
    drawn: dict[str, float]
    exact: dict[str, float]
    gap: dict[str, float]  # |drawn − exact|, of vectors as vectors


@dataclass(frozen=True)
class Compared:
    """All stations, and the positions that cannot be drawn."""

    stations: tuple[Station, ...]
    refused: tuple[tuple[float, Words], ...]  # each with the reason
    keys: tuple[str, ...]

    def worst(self, study: Study) -> float:
        """The largest deviation of all, as a share of the quantity's largest value."""
        return max(
            (gaps.max() / size for key in self.keys if (size := study_size(study, key)) for gaps in [self.gaps(key)]),
            default=0.0,
        )

    def gaps(self, key: str) -> NDArray[np.float64]:
        return np.array([station.gap[key] for station in self.stations])


def study_size(study: Study, key: str) -> float:
    """The largest value of a quantity over the cycle (SI), as the table of extremes has it; of one that runs away at an
    end, the largest of the table of values."""
    found = study.extremes(key)
    spots = [abs(spot.value) for spot in (found.highest, found.lowest) if spot is not None]
    if spots and np.isfinite(spots).all():
        return max(spots)
    values = np.abs(study.turn.real(key))
    return float(np.nanmax(values)) if np.isfinite(values).any() else 0.0


def compared(study: Study) -> Compared:
    """Draw at every station; positions at which no drawing exists are told."""
    stations: list[Station] = []
    refused: list[tuple[float, Words]] = []
    unknown = (study.problem.loads.unknown.name,) if study.problem.loads else ()
    keys = (*study.outputs, *(key for key in unknown if key in study.solution.answers and key in study.forces))
    wanted = tuple(ask for ask in study.problem.asks if ask.rel.key in keys)
    for phi in _phis(study) if study.drawn else ():
        try:
            answers = _drawn(study, replace(at_position(study, phi), asks=wanted))
        except VecpolyError as error:
            refused.append((phi, cause(error)))
            continue
        told = {key: answers[key] for key in keys if key in answers}
        gap = {
            k: abs((a.drawn_vector or 0j) - a.exact_vector) if a.exact_vector is not None else abs(a.deviation)
            for k, a in told.items()
        }
        stations.append(Station(phi, {k: a.drawn for k, a in told.items()}, {k: a.exact for k, a in told.items()}, gap))
    return Compared(tuple(stations), tuple(refused), keys if stations else ())


def _drawn(study: Study, there: Problem) -> Mapping[str, Answer]:
    """What is read off the drawing at another position; at its own scales where those of the given one make a figure
    too small or too large for a sheet."""
    given = study.solution.construction
    held, drawn = read_there(replace(there, scales=scales_of(given)), given.hand)
    if not unfit(drawn.figures, {one.view for one in drawn.figures}):
        return held
    return read_there(there, given.hand)[0]


def _phis(study: Study) -> list[float]:
    count = STATIONS if study.model.closed else STATIONS // 2
    if study.whole.whole:
        return [float(q) for q in study.whole.low + 2 * np.pi * np.arange(count) / count]
    edge = (study.whole.high - study.whole.low) / (2 * count)
    return [float(q) for q in np.linspace(study.whole.low + edge, study.whole.high - edge, count)]


def chapter(study: Study, press: Press, found: Compared) -> dict[str, Any]:
    """Table of deviations, chart with the drawn values as dots on the exact lines."""
    press.chapter = "7"
    refused = refusals(study, found.refused).of(press.lang)
    table = _table(study, press, found) if found.keys else ""
    figures = _chart(study, press, found) if found.stations and found.keys else []
    alone = _alone(study, found) if found.stations and len(found.keys) == 1 else (Words("", ""),) * 2
    return {
        "table": table,
        "alone": [w.of(press.lang) for w in alone if w.zh],
        "figures": figures,
        "shown": press.shown([], figures),
        "farthest": f"${study.whole.info(_farthest(study, found)).symbol}$" if figures else "",
        "count": len(found.stations),
        "all": len(found.stations) + len(found.refused),
        "refused": refused,
        "by_hand": any(_by_hand(study, key)[0] != "—" for key in found.keys),
        "worst": f"{100 * found.worst(study):.2f} %",
    }


def _table(study: Study, press: Press, found: Compared) -> str:
    """One line a quantity, in per cent of its largest value; of a single one nothing, for a sentence tells it."""
    rows = [_shares(study, found, key) for key in (found.keys if found.stations else ())]
    title = Words("图解值与精确值的偏差", "Deviations of the drawn values from the exact ones")
    return press.table(title, _HEADER[press.lang], rows, "lcddddd", style=SMALL) if len(rows) > 1 else ""


def _shares(study: Study, found: Compared, key: str) -> tuple[str, ...]:
    symbol, unit, largest, _, share, at, _, _, by_hand = _row(study, found, key)
    gaps, size = found.gaps(key), study_size(study, key)
    usual = f"{100 * float(np.sqrt(np.mean(gaps**2))) / size:.2f}" if size else "—"
    return symbol, unit, largest, share.removesuffix(" %"), at, usual, by_hand.removesuffix(" %")


def _row(study: Study, found: Compared, key: str) -> tuple[str, ...]:
    info, gaps, size = study.whole.info(key), found.gaps(key), study_size(study, key)
    k = int(np.argmax(gaps))
    return (
        f"${info.symbol}$",
        info.shown_unit.replace("^2", "²"),
        figures(info.factor * size),
        figures(info.factor * gaps[k]),
        f"{100 * gaps[k] / size:.2f} %" if size else "—",
        study.where(found.stations[k].phi).split(" = ")[1],
        figures(info.factor * float(np.sqrt(np.mean(gaps**2)))),
        *_by_hand(study, key),
    )


def _alone(study: Study, found: Compared) -> tuple[Words, Words]:
    """The deviations of the only quantity that is compared, and those of a hand, in a sentence each."""
    symbol, unit, size, gap, _, at, usual, hand, share = _row(study, found, found.keys[0])
    told = Words(
        f"{symbol} 的最大值为 {size} {unit}，最大偏差为 {gap} {unit}（{at}），均方根偏差为 {usual} {unit}。",
        f"{symbol}, at most {size} {unit}, deviates by up to {gap} {unit} (at {at}), {usual} {unit} rms. ",
    )
    of = ("", "") if share == "—" else (f"，占该处精确值的 {share}", f", {share} of the exact value there")
    by_hand = Words(
        f"手工作图还有画平行线、画弧等误差：在题设位置，其三倍标准差（3σ，即 6.2 的预期误差）为 {hand} {unit}{of[0]}。",
        f"Drawing by hand is less accurate: at the given position its three standard deviations (3σ, the expected "
        f"error of 6.2) are {hand} {unit}{of[1]}.",
    )
    return told, Words("", "") if hand == "—" else by_hand


def _by_hand(study: Study, key: str) -> tuple[str, str]:
    """Three standard deviations of the drawings by an unsteady hand at the given position,
    and their share of the value there."""
    answer = study.solution.answers.get(key)
    if answer is None or not answer.expected_error:
        return "—", "—"
    told = abs(answer.exact) > answer.expected_error and not is_hopeless(answer)
    share = f"{100 * answer.expected_error / abs(answer.exact):.2f} %" if told else "—"
    return figures(study.whole.info(key).factor * answer.expected_error), share


def _chart(study: Study, press: Press, found: Compared) -> list[str]:
    """The exact line of what deviates most, with the drawn values as dots: all others lie closer to theirs."""
    from ....curves import curves, style

    key = _farthest(study, found)
    info, (width, panel) = study.turn.info(key), WIDE
    plot = curves(study.turn, (key,), press.lang, width=width, panel=panel, marks=False)
    symbol = f"$|{info.symbol}|$" if info.is_vector else f"${info.symbol}$"  # as on the axis
    x = [study.turn.drive.told(station.phi) for station in found.stations]
    told = np.array([info.factor * station.drawn[key] for station in found.stations])
    cut = spread(plot.figure.axes[0], told)
    style.dots(plot.figure.axes[0], x, told, style.PENS[0].hue, 1.5, hollow=True)
    title = Words(f"{symbol} 的精确值（线）与图解值（圈）", f"{symbol}: exact (line) and drawn (circles)")
    return press.figures([(plot.scene, title + cut)])


def _farthest(study: Study, found: Compared) -> str:
    """The quantity that deviates most, as a share of its largest value; the last of several."""
    shares = {key: found.gaps(key).max() / size if (size := study_size(study, key)) else 0.0 for key in found.keys}
    return max(reversed(found.keys), key=shares.__getitem__)


def spread(at: Any, told: NDArray[np.float64]) -> Words:
    """Where a line that runs away at its end leaves the drawn values flat on an axis, the frame holds these alone;
    gives what the title adds."""
    low, high = float(told.min()), float(told.max())
    bottom, top = at.get_ylim()
    if high - low > FLAT * (top - bottom) or high == low:
        return Words.same("")
    at.set_ylim(low - MARGIN * (high - low), high + MARGIN * (high - low))
    return Words("；线在框外继续", "; the line runs on beyond the frame")
