"""A label that has found its place."""

from __future__ import annotations

from ...foundation.slotted import dataclass
from ..labels.spots import SHORT
from ..labels.want import Piece, Want
from ..scene import Item, Layer, Rect, Stroke, TextBox
from ..style import THIN, Hue

BAD = 38.0  # a label that costs more than this by where it stands is on something


@dataclass(frozen=True, slots=True)
class Placed:
    """A label at its place, with its leader line if it has one."""

    want: Want
    centre: complex
    cost: float  # what it stands on, beyond mere preference
    foot: complex | None = None

    @property
    def rect(self) -> Rect:
        """The rectangle it covers."""
        w, h, c = self.want.width / 2, self.want.height / 2, self.centre
        return Rect(c.real - w, c.imag - h, c.real + w, c.imag + h)

    def items(self) -> tuple[Item, ...]:
        """Its type and leader line."""
        rect = self.rect
        baseline = rect.y1 - self.want.ascent
        text = tuple(_text(piece, rect.x0, baseline) for piece in self.want.pieces)
        if self.foot is None:
            return text
        step = min(piece.step for piece in self.want.pieces)
        end = _nearest(self.foot, rect.grown(SHORT))
        return (Stroke(points=(self.foot, end), width=THIN, hue=Hue.GREY, layer=Layer.TEXT, step=step), *text)


def _text(piece: Piece, x: float, y: float) -> TextBox:
    return TextBox(box=piece.box, x=x + piece.dx, y=y, hue=piece.hue, step=piece.step)


def _nearest(point: complex, rect: Rect) -> complex:
    return complex(min(max(point.real, rect.x0), rect.x1), min(max(point.imag, rect.y0), rect.y1))
