"""How text is set: sizes in points, indents in em."""

from __future__ import annotations

from ...foundation.slotted import dataclass, replace
from ...typeset.box import MM
from ...words import Lang

Colour = tuple[float, float, float]
BLACK: Colour = (0.0, 0.0, 0.0)
GREY: Colour = (0.35, 0.35, 0.35)
PALE: Colour = (0.80, 0.80, 0.80)  # squares to write on


@dataclass(frozen=True, slots=True, kw_only=True)
class Style:
    """size, leading, before, after in pt; first (line), left (all lines) in em; align: left, centre ..."""

    size: float = 10.5
    leading: float = 17.0
    first: float = 0.0
    left: float = 0.0
    before: float = 0.0
    after: float = 3.0
    bold: bool = False
    align: str = "justify"
    colour: Colour = BLACK

    @property
    def em(self) -> float:
        """The size in mm."""
        return self.size / MM


BODY = Style()
NOTE = Style(size=9.0, leading=14.0, colour=GREY)
CAPTION = Style(size=9.0, leading=13.0, before=2.0, after=6.0, align="centre")
CELL = Style(size=9.5, leading=13.0, after=0.0, align="left")
HEADINGS = (
    Style(size=17.0, leading=25.0, before=0.0, after=9.0, bold=True, align="centre"),
    Style(size=13.0, leading=19.0, before=12.0, after=5.0, bold=True, align="left"),
    Style(size=11.0, leading=17.0, before=8.0, after=3.0, bold=True, align="left"),
    Style(size=10.5, leading=17.0, before=3.0, after=2.0, bold=True, align="left"),
)


def body(lang: Lang) -> Style:
    """Running text: Chinese paragraphs begin two em in."""
    return replace(BODY, first=2.0) if lang == "zh" else replace(BODY, leading=15.0, after=5.0)
