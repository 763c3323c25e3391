"""Curves over the drive's position: quantities of one unit in one pair of axes, panels below each other."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from ..cycle import Column, Cycle
from ..cycle.facts.transmission_range import USUAL
from ..drawing.style import THIN, Dash, Hue
from ..errors import NotAskedError
from ..foundation.slotted import replace
from ..typeset import layout_words
from ..words import Lang, Words
from . import style
from .called import title_of
from .peaks import SIZE, Known, exact, label_peaks, lowest
from .place import Placer, Points
from .plot import Plot
from .record import MM
from .turning import turning

_PART = 0.35  # mm: a part of a vector
_BARE, _TOLD = 0.06, 0.15  # of the range: white above and below curves, where their peaks are told in numbers
_NONE: Mapping[str, Hue] = {}
_PLACES = 25  # along the usual bound, where its name may stand
Pens = tuple[style.Pen, ...]
_SAMPLE, _AFTER, _GAP, _LINE = 8.5, 1.2, 3.5, 5.0  # of the legend, mm


def curves(
    cycle: Cycle,
    keys: tuple[str, ...],
    lang: Lang = "zh",
    *,
    width: float = style.WIDTH,
    panel: float = style.PANEL,
    marks: bool = True,
    inks: Mapping[str, Hue] = _NONE,
    known: Known | None = None,
) -> Plot:
    """The columns over the drive's position; each unit has a panel of its own.

    A vector is drawn by its magnitude. width, panel: mm. marks: a dot at the greatest and the least value of each
    curve, with its number; none where that would stand on a curve. inks: of vectors that have one wherever they appear,
    by key; curves of one ink differ by their dashes. known: the exact extremes of a column, told in place of those
    of the samples.
    Raises UnknownNameError, and NotAskedError for nothing to draw or more than six curves in one panel.
    """
    groups = _grouped(cycle, keys)
    height = panel * len(groups)
    figure = style.sheet(width, height)
    limits = [_limits(cycle, group, _TOLD if marks else _BARE) for group in groups]
    left = style.left_edge(limits)
    labels = [style.axis_label(_common(group), group[0].shown_unit) for group in groups]
    beside = all(
        _legend_width(group) + layout_words(label, style.LABEL).width + 6.0 <= width - style.RIGHT
        for group, label in zip(groups, labels, strict=True)
    )
    room = panel - style.FOOT - style.TOP - (0.0 if beside else _LINE)
    for i, (group, limit, label) in enumerate(zip(groups, limits, labels, strict=True)):
        foot = height - panel * (i + 1) + style.FOOT
        at = style.axes(figure, left, foot, width - left - style.RIGHT, room)
        _panel(cycle, at, group, limit, marks, (pens := pens_of(group, inks)), known)
        top = foot + room + 2.2
        style.text(at, 1.0, top + (0.0 if beside else _LINE), label)
        middle = (left + width - style.RIGHT) / 2
        style.text(at, middle, foot - style.FOOT + style.UNDER, drive_label(cycle.drive, lang), ha="center")
        _legend(at, width - style.RIGHT, top, group, pens)
    return Plot(figure, title_of(cycle.drive, groups), lang)


def pens_of(group: list[Column], inks: Mapping[str, Hue]) -> Pens:
    """A pen for each curve: the dashes by their order, the ink of a vector where it has one; its parts finer, black."""
    made = []
    for column, pen in zip(group, style.PENS, strict=False):
        base, _, part = column.key.partition(".")
        ink = inks.get(base)
        if ink is not None:
            pen = replace(pen, hue=Hue.BLACK, width=_PART) if part in ("x", "y") else replace(pen, hue=ink)
        made.append(pen)
    return tuple(made)


def drive_label(drive: Column, lang: Lang) -> str:
    words, symbol = drive.words.of(lang), style.axis_label(drive.symbol, drive.shown_unit)
    return f"{words} {symbol}" if lang == "zh" else f"{words[0].upper()}{words[1:]}, {symbol}"


def _grouped(cycle: Cycle, keys: tuple[str, ...]) -> list[list[Column]]:
    if not keys:
        raise NotAskedError(
            Words(
                "未指定要绘的量；请指明，如 omega_3,alpha_3",
                "no quantity is named: say which curves to draw, such as omega_3,alpha_3",
            )
        )
    groups: dict[str, list[Column]] = {}
    for key in dict.fromkeys(keys):
        info = cycle.info(key)
        groups.setdefault(info.shown_unit, []).append(cycle.info(f"{key}.abs") if info.is_vector else info)
    for group in groups.values():
        if len(group) > len(style.PENS):
            raise NotAskedError(
                Words(
                    f"以 {group[0].shown_unit} 为单位的 {len(group)} 条曲线难以分辨；一次至多绘 {len(style.PENS)} 条",
                    f"{len(group)} curves in {group[0].shown_unit} cannot be told apart; draw at most "
                    f"{len(style.PENS)} at once",
                )
            )
    return list(groups.values())


def _values(cycle: Cycle, column: Column) -> Any:
    values = column.told(cycle.real(column.key))
    return np.minimum(values, 180.0 - values) if column.key.startswith("gamma_") else values  # the acute angle counts


def _limits(cycle: Cycle, group: list[Column], share: float) -> tuple[float, float]:
    values = np.concatenate([_values(cycle, column) for column in group])
    known = np.isfinite(values)
    if not known.any():
        return 0.0, 1.0
    low, high = _clipped(values[known], broken=not known.all())
    if "/s" in group[0].unit or group[0].unit in ("N", "N·m"):
        # a rate of one sign is seen against nothing
        low, high = ((0.0 if 0 < low < 0.6 * high else low), (0.0 if 0.6 * low < high < 0 else high))
    elif group[0].key.startswith("gamma_"):
        low, high = min(low, USUAL), high
    margin = share * (high - low) or 0.1 * abs(high) or 1.0
    flat = low == high
    return low - (margin if low or flat else 0.0), high + (margin if high or flat else 0.0)


def _clipped(values: Any, broken: bool) -> tuple[float, float]:
    """All values; where a few run away (towards a dead point), what 98 % of them need. A curve that breaks off runs
    away over a wider stretch (towards locking): what nine tenths need, thrice."""
    low, high = float(values.min()), float(values.max())
    p, q = (float(x) for x in np.percentile(values, (5, 95) if broken else (1, 99)))
    far = (6 if broken else 20) * (q - p)
    return (max(low, p - (q - p)), min(high, q + (q - p))) if high - low > far > 0 else (low, high)


def _panel(
    cycle: Cycle, at: Any, group: list[Column], limit: tuple[float, float], marks: bool, pens: Pens, known: Known | None
) -> None:
    drive = cycle.drive
    phi = drive.told(cycle.phi)
    at.set_xlim(phi[0], phi[-1])
    at.set_ylim(*limit)
    if drive.unit == "rad":
        style.degrees_ticks(at, phi[0], phi[-1])
    style.zero_line(at, limit)
    peaks, lines = [], []
    for column, pen in zip(group, pens, strict=True):
        values = _values(cycle, column)
        lines.append(phi + 1j * values)
        style.line(at, phi, values, pen, column.key)
        spots = turning(phi, values, cycle.whole and drive.unit == "rad" and not column.turns) if marks else []
        if column.key.startswith("gamma_"):
            spots = lowest(spots)
        spots = [spot for spot in spots if limit[0] <= spot[1] <= limit[1]]
        peaks.append(spots if known is None else exact(spots, known(column.key), drive, column, float(phi[1] - phi[0])))
    if all(column.key.startswith("gamma_") for column in group) and limit[0] < USUAL < limit[1]:
        style.line(at, [phi[0], phi[-1]], [USUAL] * 2, style.Pen(Dash.DASHED, Hue.GREY, THIN))
        lines.append(np.array([complex(x, USUAL) for x in (phi[0], phi[-1])]))
        _bound(at, lines[:-1])
    label_peaks(at, lines, peaks, [pen.hue for pen in pens], drive, group[0].shown_unit)


def _bound(at: Any, lines: list[Points]) -> None:
    """The name of the usual bound over its line, as far to the right as it stands on no curve."""
    words, (low, high), (left, right) = f"[$γ$] = {USUAL:.0f}°", at.get_ylim(), at.get_xlim()
    placer, margin = Placer(at, lines), 0.01 * (right - left)
    wide = layout_words(words, SIZE).width / at.bbox.width * (right - left)
    above = USUAL + 0.02 * (high - low)
    ends = np.linspace(right - margin, left + margin + wide, _PLACES)
    free = (end for end in ends if placer.is_free(complex(end - wide, above), words, SIZE))
    style.text(at, float(next(free, ends[0])), above, words, ha="right", va="bottom", size=SIZE, data=True)


def _common(group: list[Column]) -> str:
    """The symbol of one curve, or the letter that all have in common; of vectors, of which the sizes are drawn, between
    bars."""
    sized = [(column.symbol, column.key.endswith(".abs")) for column in group]
    stems = sized if len(group) == 1 else [(symbol.partition("_")[0], size) for symbol, size in sized]
    return ", ".join(f"|{symbol}|" if size else symbol for symbol, size in dict.fromkeys(stems))


def _legend_width(group: list[Column]) -> float:
    """What the samples and symbols of a group take (mm)."""
    widths = [layout_words(f"${column.symbol}$", style.LABEL).width for column in group]
    return sum(widths) + len(group) * (_SAMPLE + _AFTER) + (len(group) - 1) * _GAP if len(group) > 1 else 0.0


def _legend(at: Any, right: float, top: float, group: list[Column], pens: Pens) -> None:
    """Samples of the pens with their symbols, in one row that ends at the right edge of the axes."""
    x = right - _legend_width(group)
    for column, pen in zip(group, pens, strict=True) if len(group) > 1 else ():
        (drawn,) = at.plot(
            [x, x + _SAMPLE],
            [top + 1.1] * 2,
            transform=None,
            clip_on=False,
            color=pen.hue.value,
            linewidth=pen.width * MM,
            scalex=False,
            scaley=False,
        )
        if pen.dash.pattern:
            drawn.set_linestyle((0, tuple(part / pen.width for part in pen.dash.pattern)))
        style.text(at, x + _SAMPLE + _AFTER, top, f"${column.symbol}$")
        x += _SAMPLE + _AFTER + layout_words(f"${column.symbol}$", style.LABEL).width + _GAP
