"""Geometry in mm on paper: points are complex numbers, or complex arrays for many hands at once; all elementwise."""

from .geometry import (
    Line,
    Points,
    Reals,
    around,
    circles_meet,
    cross,
    distance,
    dot,
    foot,
    inclined,
    line_circle_meet,
    lines_meet,
    nominal,
    shoelace,
    similar,
    unit,
)

__all__ = [
    "Line",
    "Points",
    "Reals",
    "around",
    "circles_meet",
    "cross",
    "distance",
    "dot",
    "foot",
    "inclined",
    "line_circle_meet",
    "lines_meet",
    "nominal",
    "shoelace",
    "similar",
    "unit",
]
