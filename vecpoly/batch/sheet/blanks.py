"""Frames, and rows of boxes in which answers are written."""

from __future__ import annotations

from math import ceil
from typing import Any

from ...names import written_unit
from ...typeset.box import MM
from ...words import Lang, Words
from .layout import Blank, Frame, Spot
from .marks import PALE, SMALL, box, line, write

TICK = 10.0  # mm between the ticks of a frame
CELL = 6.0  # mm, side of a box for one figure
ROW = 9.5  # mm between rows
_PAPER, _VALUE, _WAY, _SENSE = 17.0, 62.0, 106.0, 142.0  # mm from the left, of the parts of a row
_AXES = 42.0  # mm from one coordinate to the other
_FROM = Words("（自 {} 起，向右、向上为正）", "(from {}, right and up)")
_FROM_AXES = Words("（按题给坐标系）", "(in the given axes)")
_SCALE = Words("比例尺", "Scale")


def draw_frame(canvas: Any, frame: Frame, title: str, scale: str, lang: Lang) -> None:
    """A frame in pale blue with ticks and a pole; title and scale stand above it."""
    (x, y), (wide, high) = frame.at, frame.size
    write(canvas, title, (x, y + high + 2.0), SMALL, bold=True)
    write(canvas, f"{_SCALE.of(lang)} {scale}", (x + wide / 2, y + high + 2.0), SMALL)
    canvas.saveState()
    canvas.setStrokeColorRGB(*PALE)
    canvas.setLineWidth(0.25 * MM)
    box(canvas, frame.at, wide, high)
    for i in range(1, ceil(wide / TICK)):
        line(canvas, (x + i * TICK, y), (x + i * TICK, y + 2.0))
        line(canvas, (x + i * TICK, y + high), (x + i * TICK, y + high - 2.0))
    for i in range(1, ceil(high / TICK)):
        line(canvas, (x, y + i * TICK), (x + 2.0, y + i * TICK))
        line(canvas, (x + wide, y + i * TICK), (x + wide - 2.0, y + i * TICK))
    if frame.pole is not None:
        _pole(canvas, frame.pole, frame.letter)
    canvas.restoreState()


def _pole(canvas: Any, at: Spot, letter: str) -> None:
    line(canvas, (at[0] - 2.5, at[1]), (at[0] + 2.5, at[1]))
    line(canvas, (at[0], at[1] - 2.5), (at[0], at[1] + 2.5))
    canvas.setFillColorRGB(*PALE)
    write(canvas, f"${letter}$", (at[0] - 4.5, at[1] - 4.0), SMALL)
    canvas.setFillColorRGB(0, 0, 0)


def draw_blank(canvas: Any, blank: Blank, lang: Lang) -> None:
    """Symbol; □□□.□ mm on paper; the value with its unit; its direction □□□.□°, or the boxes ↻ ↺; of a place both
    coordinates, and from where."""
    x, y = blank.at
    canvas.setStrokeColorRGB(0, 0, 0)
    canvas.setLineWidth(0.18 * MM)
    write(canvas, f"${blank.symbol}$", (x, y), SMALL * 1.1)
    if blank.length:
        end = _figures(canvas, (x + _PAPER, y - 1.6))
        write(canvas, "mm", (end + 1.2, y), SMALL)
    if blank.place:
        _coordinates(canvas, blank, lang)
        return
    value = x + (_PAPER + 5.0 if blank.plain else _VALUE)
    write(canvas, "=", (value - 5.0, y), SMALL)
    line(canvas, (value, y - 1.4), (value + 24.0, y - 1.4))
    write(canvas, written_unit(blank.unit), (value + 25.5, y), SMALL)
    if blank.direction:
        end = _figures(canvas, (x + _WAY, y - 1.6))
        write(canvas, "°", (end + 1.0, y), SMALL)
    if blank.sense:
        _senses(canvas, (x + _SENSE - 36.0, y))


def _coordinates(canvas: Any, blank: Blank, lang: Lang) -> None:
    """x = ____ mm, y = ____ mm, from A to the right and up."""
    x, y = blank.at
    for i, axis in enumerate("xy"):
        left = x + _PAPER + i * _AXES
        write(canvas, f"${axis}$ =", (left, y), SMALL)
        line(canvas, (left + 7.0, y - 1.4), (left + 29.0, y - 1.4))
        write(canvas, blank.unit, (left + 30.5, y), SMALL)
    origin = _FROM.of(lang).format(f"${blank.origin}$") if blank.origin else _FROM_AXES.of(lang)
    write(canvas, origin, (x + _PAPER + 2 * _AXES, y), SMALL)


def _figures(canvas: Any, at: Spot) -> float:
    """□□□.□ with the point printed; where it ends."""
    x, y = at
    for i in range(3):
        box(canvas, (x + i * CELL, y), CELL, CELL)
    x += 3 * CELL
    write(canvas, ".", (x + 0.6, y + 0.8), SMALL * 1.4, bold=True)
    box(canvas, (x + 2.2, y), CELL, CELL)
    return x + 2.2 + CELL


def _senses(canvas: Any, at: Spot) -> None:
    x, y = at
    for i, sign in enumerate("↻↺"):
        box(canvas, (x + i * 16.0, y - 0.6), 3.6, 3.6)
        write(canvas, sign, (x + i * 16.0 + 5.0, y), SMALL * 1.2)
