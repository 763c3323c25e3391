"""How a line looks: widths, dashes and hues of a drawing-office sheet, all in mm on paper."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum, StrEnum
from typing import assert_never

from ..board.construction import View
from ..board.marks import Role

LINK, RESULT, GIVEN, THIN = 0.7, 0.5, 0.35, 0.18
SYMBOL = 0.35  # outline of joints, grounds, guides
JOINT_RADIUS, POLE_RADIUS, DOT_RADIUS = 1.25, 0.6, 0.55
HEAD_LENGTH, HEAD_WIDTH = 3.0, 1.0
LETTER, TITLE, NOTE = 4.4, 4.6, 3.2  # em; capitals are two thirds of it high


class Hue(Enum):
    """An ink as red, green, blue from 0 to 1; every one keeps its rank in grey."""

    BLACK = (0.0, 0.0, 0.0)
    VELOCITY = (0.03, 0.17, 0.50)
    ACCELERATION = (0.55, 0.05, 0.09)
    GREY = (0.38, 0.38, 0.38)
    GHOST = (0.78, 0.78, 0.78)  # what is not of the highlighted step
    ALARM = (0.78, 0.0, 0.0)  # what must not be taken for an answer
    WHITE = (1.0, 1.0, 1.0)
    PLATE = (0.91, 0.91, 0.91)
    FORCE = (0.02, 0.33, 0.20)
    VELOCITY_TINT = (0.88, 0.92, 0.98)
    ACCELERATION_TINT = (0.98, 0.90, 0.89)
    FORCE_TINT = (0.88, 0.95, 0.91)

    @property
    def hex(self) -> str:
        """The ink as ``#rrggbb``."""
        return "#" + "".join(f"{round(255 * part):02x}" for part in self.value)

    @property
    def is_tint(self) -> bool:
        """Whether the ink is a background that lettering may stand on."""
        return self in (Hue.WHITE, Hue.PLATE, Hue.VELOCITY_TINT, Hue.ACCELERATION_TINT, Hue.FORCE_TINT)


class Dash(StrEnum):
    """The pattern of a line."""

    FULL = "full"
    DASHED = "dashed"
    SHORT = "short"  # dashes that show on a circle of a few millimetres
    DASH_DOT = "dash-dot"

    @property
    def pattern(self) -> tuple[float, ...]:
        """Stroke and gap lengths in mm, empty for a full line."""
        match self:
            case Dash.FULL:
                return ()
            case Dash.DASHED:
                return (2.4, 1.0)
            case Dash.SHORT:
                return (1.3, 0.7)
            case Dash.DASH_DOT:
                return (6.0, 1.0, 0.5, 1.0)
        assert_never(self)


@dataclass(frozen=True, slots=True, kw_only=True)
class Pen:
    """Width in mm, pattern and ink of a line."""

    width: float
    dash: Dash = Dash.FULL
    hue: Hue = Hue.BLACK


_MOTION = {"v": Hue.VELOCITY, "a": Hue.ACCELERATION, "ω": Hue.BLACK, "α": Hue.BLACK}


def kind_hue(view: View, label: str = "") -> Hue:
    """The hue of a vector: that of its polygon, unless its symbol names another kind of quantity: a force on a mechanism or a lever."""
    forced = label[:1].isupper()
    match view:
        case View.VELOCITY:
            return Hue.FORCE if forced else Hue.VELOCITY
        case View.ACCELERATION:
            return Hue.FORCE if forced else Hue.ACCELERATION
        case View.FORCE | View.BODY:
            return _MOTION.get(label[:1], Hue.FORCE)
        case View.MECHANISM:
            return _MOTION.get(label[:1], Hue.FORCE if forced else Hue.BLACK)
    assert_never(view)


def tint(view: View) -> Hue:
    """The light background of an image in this view."""
    match view:
        case View.VELOCITY:
            return Hue.VELOCITY_TINT
        case View.ACCELERATION:
            return Hue.ACCELERATION_TINT
        case View.FORCE:
            return Hue.FORCE_TINT
        case View.MECHANISM | View.BODY:
            return Hue.PLATE
    assert_never(view)


def pen(role: Role, hue: Hue) -> Pen:
    """The pen for a role; `hue` serves the vectors."""
    match role:
        case Role.LINK:
            return Pen(width=LINK)
        case Role.RESULT:
            return Pen(width=RESULT, hue=hue)
        case Role.GIVEN:
            return Pen(width=GIVEN, hue=hue)
        case Role.DIRECTION | Role.CONSTRUCTION:
            return Pen(width=THIN, hue=Hue.GREY)
        case Role.CENTRE:
            return Pen(width=THIN, dash=Dash.DASH_DOT, hue=Hue.GREY)
        case Role.HIDDEN:
            return Pen(width=THIN, dash=Dash.DASHED)
    assert_never(role)
