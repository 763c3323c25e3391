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
Hue.GHOST = Hue("ghost", (0.78, 0.78, 0.78))
Hue.ALARM = Hue("alarm", (0.78, 0.0, 0.0))
Hue.WHITE = Hue("white", (1.0, 1.0, 1.0), is_tint=True)
Hue.PLATE = Hue("plate", (0.91, 0.91, 0.91), is_tint=True)
Hue.HATCH = Hue("hatch", (0.72, 0.72, 0.72), is_tint=True)
PLAIN = (Hue.BLACK, Hue.GREY, Hue.GHOST, Hue.ALARM, Hue.WHITE, Hue.PLATE, Hue.HATCH)  # those of no kind of figure
