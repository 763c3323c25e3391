"""What a hand does at a board: a closed list of acts, each done at once and remembered for ever.

An act knows its number on the sheet, the step that it belongs to, the acts that it needed (`inputs`), the figure it was
done on (`place`), what it stands for (`key`: a letter, the letters of a measured length, or the key of a quantity) and
whose it is (`owner`: a link, a joint).
Points, directions and lengths are those of the nominal sheet, in mm on the figure (x right, y up).
"""

from __future__ import annotations

from .base import Done, Head
from .inkless import (
    Answer,
    Area,
    Compute,
    Follow,
    Gauge,
    Image,
    Invert,
    Judge,
    LayOff,
    Locate,
    Measure,
    Meet,
    Parallel,
    Ray,
    Touch,
    Transfer,
    Turn,
    Way,
)
from .leaving import Angle, Annotate, Arrow, Corner, Curve, CurvedArrow, Depict, Hatch, Join, Plot, Rule, Swing, Tint

__all__ = [
    "Act",
    "Angle",
    "Annotate",
    "Answer",
    "Area",
    "Arrow",
    "Compute",
    "Corner",
    "Curve",
    "CurvedArrow",
    "Depict",
    "Done",
    "Follow",
    "Gauge",
    "Hatch",
    "Head",
    "Image",
    "Inkless",
    "Invert",
    "Join",
    "Judge",
    "LayOff",
    "Leaving",
    "Locate",
    "Measure",
    "Meet",
    "Parallel",
    "Plot",
    "Ray",
    "Rule",
    "Swing",
    "Tint",
    "Touch",
    "Transfer",
    "Turn",
    "Way",
]

Leaving = Plot | Join | Arrow | Rule | Swing | Curve | Corner | Angle | CurvedArrow | Annotate | Tint | Hatch | Depict
Found = Locate | Meet | Touch | Image | Measure | Area | Judge | Gauge | Compute | Answer
Inkless = Found | Invert | Turn | Parallel | Ray | LayOff | Follow | Transfer
Act = Leaving | Inkless
