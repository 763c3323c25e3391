"""How a line looks: widths, dashes and hues of a drawing-office sheet, all in mm on paper."""

from __future__ import annotations

from enum import StrEnum
from typing import assert_never

from ..board.construction import View
from ..board.paper.marks import Role
from ..figures.hue import Hue as Hue  # an ink is a part of how a line looks
from ..foundation.slotted import dataclass

LINK, RESULT, GIVEN, THIN = 0.7, 0.5, 0.35, 0.25  # wide, two between, fine (GB/T 17450: 0.13 to 2 in steps of √2)
HATCHING = 0.18  # close lines in light ink, which together look as dark as a fine one; lines of help
FOUND = 0.7  # a vector found, on a polygon: twice as wide as one that is known (GB/T 17450)
SYMBOL = 0.35  # outline of joints, grounds, guides
JOINT_RADIUS, POLE_RADIUS, DOT_RADIUS, POINT_RADIUS = 1.25, 0.6, 0.55, 0.85  # the last on the line of a link
MULTIPLE_RADIUS, INNER_RADIUS, MASS_RADIUS = 1.7, 0.8, 1.3  # both circles of a compound hinge; a centre of mass
HEAD_LENGTH, HEAD_WIDTH = 3.0, 1.25
LETTER, TITLE, NOTE = 4.4, 4.6, 3.2  # em; capitals are two thirds of it high


class Dash(StrEnum):
    """The pattern of a line."""

    FULL = "full"
    DASHED = "dashed"
    SHORT = "short"  # dashes that show on a circle of a few millimetres
    DASH_DOT = "dash-dot"
    TWO_DOTS = "dash-two-dots"

    @property
    def pattern(self) -> tuple[float, ...]:
        """Stroke and gap lengths in mm, empty for a full line."""
        match self:
            case Dash.FULL:
                return ()
            case Dash.DASHED:
                return (3.0, 0.9)
            case Dash.SHORT:
                return (1.3, 0.7)
            case Dash.DASH_DOT:
                return (6.0, 0.9, 0.4, 0.9)
            case Dash.TWO_DOTS:
                return (6.0, 0.8, 0.4, 0.8, 0.4, 0.8)
        assert_never(self)


@dataclass(frozen=True, slots=True, kw_only=True)
class Pen:
    """Width in mm, pattern and ink of a line."""

    width: float
    dash: Dash = Dash.FULL
    hue: Hue = Hue.BLACK


_MOTION = {"v": View.VELOCITY.ink, "a": View.ACCELERATION.ink, "ω": Hue.BLACK, "α": Hue.BLACK}


def kind_hue(view: View, label: str = "") -> Hue:
    """The hue of a vector: that of its figure, unless its symbol names another quantity: a force on a lever."""
    if view.images:
        return View.FORCE.ink if label[:1].isupper() else view.ink
    return _MOTION.get(label[:1], View.FORCE.ink if label[:1].isupper() and view.bodies else view.ink)


def pen(role: Role, hue: Hue) -> Pen:
    """The pen for a role; `hue` serves vectors and centrodes."""
    match role:
        case Role.LINK:
            return Pen(width=LINK)
        case Role.RESULT:
            return Pen(width=RESULT, hue=hue)
        case Role.GIVEN:
            return Pen(width=GIVEN, hue=hue)
        case Role.DIRECTION:
            return Pen(width=THIN, hue=Hue.GREY)
        case Role.CONSTRUCTION:
            return Pen(width=HATCHING, hue=Hue.GREY)
        case Role.PLACE:
            return Pen(width=HATCHING, hue=Hue.FAINT)
        case Role.CENTRE:
            return Pen(width=THIN, dash=Dash.DASH_DOT, hue=Hue.GREY)
        case Role.IDEAL:
            return Pen(width=THIN, dash=Dash.DASHED, hue=Hue.GREY)
        case Role.OTHER:
            return Pen(width=GIVEN, dash=Dash.DASHED)
        case Role.SECOND:
            return Pen(width=GIVEN, dash=Dash.TWO_DOTS)
        case Role.LOCUS:
            return Pen(width=RESULT, hue=hue)
        case Role.CARRIED:
            return Pen(width=RESULT, dash=Dash.DASHED, hue=hue)
        case Role.HIDDEN:
            return Pen(width=THIN, dash=Dash.DASHED)
    assert_never(role)
