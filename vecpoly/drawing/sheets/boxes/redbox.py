"""The red box over a sheet whose readings must not be taken for answers."""

from __future__ import annotations

from ...labels.notes import fitted
from ...scene import Fill, Item, Layer, Rect, Stroke, TextBox
from ...style import LETTER, RESULT, Hue
from ..space import FRAME

HEIGHT, MARGIN = 13.0, 2.0  # mm: of the box; around it and its text
BAND = HEIGHT + 2 * MARGIN  # mm by which a plate is higher for it, on which no white is left over


def red_box(page: Rect, text: str) -> tuple[Item, ...]:
    """The text in red in a red box across the top of the page, and the page's frame in red."""
    frame = page.grown(-FRAME)
    box = Rect(frame.x0 + MARGIN, frame.y1 - MARGIN - HEIGHT, frame.x1 - MARGIN, frame.y1 - MARGIN)
    said = fitted(text, LETTER, box.width - 2 * MARGIN, HEIGHT - 2 * MARGIN)
    at = box.centre - complex(said.width / 2, (said.ascent - said.descent) / 2)
    return (
        Fill(points=box.corners, hue=Hue.WHITE, layer=Layer.JOINT),
        *(
            Stroke(points=one.corners, width=2 * RESULT, hue=Hue.ALARM, closed=True, layer=Layer.JOINT)
            for one in (frame, box)
        ),
        TextBox(box=said, x=at.real, y=at.imag, hue=Hue.ALARM),
    )
