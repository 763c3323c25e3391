"""The layers of a drawing: what a line is for tells its width, its pattern and the ink of most of what lies there."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, assert_never

from ...board.paper.marks import (
    AngleMark,
    Block,
    Cell,
    Disc,
    FixedGuide,
    FrictionCircle,
    GearMark,
    Ground,
    Hatched,
    ImageOf,
    LinkNumber,
    Mark,
    Note,
    Outline,
    Passing,
    Plate,
    Point,
    RackMark,
    RightAngle,
    Role,
    Slot,
    Trace,
    TurnArrow,
    Weld,
)
from ...drawing.style import GIVEN, THIN, Dash, Hue, Pen, pen

if TYPE_CHECKING:
    from ezdxf.document import Drawing

SHEET, TEXT, POINT, DIMENSION, FRAME, TINT = "sheet", "text", "point", "dimension", "frame", "tint"
_PENS: Mapping[str, Pen] = {
    **{role.value: pen(role, Hue.BLACK) for role in Role},
    FRAME: Pen(width=GIVEN),
    POINT: Pen(width=GIVEN),
    DIMENSION: Pen(width=THIN),
    TEXT: Pen(width=THIN),
    TINT: Pen(width=THIN, hue=Hue.PLATE),
    SHEET: Pen(width=GIVEN),
}
_ACI = {
    Role.LINK.value: 7,
    Role.RESULT.value: 1,
    Role.GIVEN.value: 3,
    Role.DIRECTION.value: 8,
    Role.CONSTRUCTION.value: 9,
    Role.PLACE.value: 253,
    Role.CENTRE.value: 4,
    Role.IDEAL.value: 8,
    Role.OTHER.value: 5,
    Role.SECOND.value: 5,
    Role.LOCUS.value: 7,
    Role.CARRIED.value: 5,
    Role.HIDDEN.value: 2,
    DIMENSION: 6,
    FRAME: 7,
    TEXT: 7,
    POINT: 7,
    TINT: 254,
    SHEET: 7,
}


def set_up(doc: Drawing) -> None:
    """Layers and line patterns, lengths in mm."""
    for dash in Dash:
        if dash.pattern:
            signed = [part if i % 2 == 0 else -part for i, part in enumerate(dash.pattern)]
            doc.linetypes.add(pattern_of(dash), pattern=[sum(dash.pattern), *signed])
    for name, look in _PENS.items():
        doc.layers.add(name, color=_ACI[name], linetype=pattern_of(look.dash), lineweight=weight(look.width))


def pattern_of(dash: Dash) -> str:
    """The name of a line pattern."""
    return "CONTINUOUS" if dash is Dash.FULL else f"VECPOLY_{dash.name}"


def weight(width: float) -> int:
    """A width in mm as one of those that DXF knows, in hundredths of a mm."""
    from ezdxf.lldxf.const import VALID_DXF_LINEWEIGHTS

    return min(VALID_DXF_LINEWEIGHTS, key=lambda known: abs(known - 100 * width))


def layer_of(mark: Mark) -> str:
    """The layer on which a mark lies."""
    if isinstance(mark, Trace):
        return mark.role.value
    match mark:
        case Plate() | Block() | Slot() | Passing() | Weld() | Disc() | Outline() | Cell():
            return Role.LINK.value
        case GearMark() | RackMark():
            return Role.CENTRE.value
        case FrictionCircle():
            return Role.HIDDEN.value
        case Ground() | FixedGuide():
            return FRAME
        case Point():
            return POINT
        case RightAngle() | AngleMark() | TurnArrow():
            return DIMENSION
        case ImageOf() | Hatched():
            return TINT
        case LinkNumber() | Note():
            return TEXT
    assert_never(mark)
