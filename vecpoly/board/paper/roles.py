"""Why a line is on the paper, and how a point is drawn."""

from __future__ import annotations

from enum import StrEnum


class Role(StrEnum):
    """Why a line is there; the drawing decides width, dash and hue."""

    LINK = "link"  # 0.7 mm
    RESULT = "result"  # 0.5 mm: vectors asked for; 0.7 mm on a polygon
    GIVEN = "given"  # 0.35 mm: known vectors; on a polygon with an open head
    DIRECTION = "direction"  # 0.25 mm: direction lines of a polygon, run a little past their meeting point
    CONSTRUCTION = "construction"  # 0.25 mm: arcs, helping lines in the kinematic diagram
    PLACE = "place"  # 0.18 mm light: one of many places of a line, of which only what they leave is looked at
    CENTRE = "centre"  # 0.25 mm dash-dot: centre lines, pitch circles
    IDEAL = "ideal"  # 0.25 mm dashed grey: the construction without friction, beside that with it
    OTHER = "other"  # 0.35 mm dashed: a link in another position than the one that is drawn thick
    SECOND = "second"  # 0.35 mm dash and two dots: a linkage beside the one that is drawn thick, as another solution
    LOCUS = "locus"  # 0.5 mm in an ink of its own: a curve that is the answer, the fixed centrode
    CARRIED = "carried"  # 0.5 mm dashed: such a curve that moves with a link
    HIDDEN = "hidden"  # 0.25 mm dashed: the expanded link (扩大构件), what is only thought


class Dot(StrEnum):
    """How a point is drawn."""

    POLE = "pole"  # small open circle
    POINT = "point"  # small filled dot (tip of a vector, point of a link)
    JOINT = "joint"  # open circle 2.5 mm across
    MULTIPLE = "multiple"  # two circles, one in the other: a compound hinge of three links or more
    MASS = "mass"  # a circle of which two opposite quarters are filled: a centre of mass
    NONE = "none"  # only its letter


class Lump(StrEnum):
    """What a disc is a mass of."""

    NONE = "none"  # a body by its shape: a cam, an eccentric, a wheel
    OWN = "own"  # a mass that a rotor has, or one that is put for others
    TRIAL = "trial"  # put on for one run
    COUNTERWEIGHT = "counterweight"
