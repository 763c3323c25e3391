"""An ink as a value: a kind of figure brings its own."""

from __future__ import annotations

from typing import ClassVar

from ..foundation.slotted import dataclass


@dataclass(frozen=True, slots=True)
class Hue:
    """Red, green, blue from 0 to 1; every ink keeps its rank in grey.

    is_tint: a background that lettering may stand on.
    """

    BLACK: ClassVar[Hue]
    GREY: ClassVar[Hue]
    FAINT: ClassVar[Hue]  # of many lines close together, which look as dark as one in grey
    GHOST: ClassVar[Hue]  # what is not of the highlighted step
    ALARM: ClassVar[Hue]  # what must not be taken for an answer
    WHITE: ClassVar[Hue]
    PLATE: ClassVar[Hue]  # a body
    HATCH: ClassVar[Hue]  # an area between lines

    name: str  # in style sheets: velocity, velocity-tint
    value: tuple[float, float, float]
    is_tint: bool = False

    @property
    def hex(self) -> str:
        """The ink as ``#rrggbb``."""
        return "#" + "".join(f"{round(255 * part):02x}" for part in self.value)


Hue.BLACK = Hue("black", (0.0, 0.0, 0.0))
Hue.GREY = Hue("grey", (0.38, 0.38, 0.38))
Hue.FAINT = Hue("faint", (0.6, 0.6, 0.6))
Hue.GHOST = Hue("ghost", (0.78, 0.78, 0.78))
Hue.ALARM = Hue("alarm", (0.78, 0.0, 0.0))
Hue.WHITE = Hue("white", (1.0, 1.0, 1.0), is_tint=True)
Hue.PLATE = Hue("plate", (0.91, 0.91, 0.91), is_tint=True)
Hue.HATCH = Hue("hatch", (0.72, 0.72, 0.72), is_tint=True)
# By which the vectors of a problem are told apart: each has a contrast of 4.6 to 1 on white, and they stay apart for
# eyes that confuse red and green (CIE76 differences of 21 and more, by Machado's matrices); no two are more alike than
# CIEDE2000 = 20 tells: blue, orange, sea green, magenta, olive, brown, indigo, slate.
TONES = tuple(
    Hue(f"tone_{n}", tuple(int(text[i : i + 2], 16) / 255 for i in (0, 2, 4)))  # type: ignore[arg-type]
    for n, text in enumerate(("006bf2", "cc4a12", "005d4b", "d11ba3", "757749", "523000", "3c00bb", "4b4568"), start=1)
)
# those of no kind of figure
PLAIN = (Hue.BLACK, Hue.GREY, Hue.FAINT, Hue.GHOST, Hue.ALARM, Hue.WHITE, Hue.PLATE, Hue.HATCH)
