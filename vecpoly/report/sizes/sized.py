"""A sketch with the letters of what is given on it."""

from __future__ import annotations

from collections.abc import Iterator

from ...board.construction import Figure
from ...board.paper.marks import Mark
from ...designs.base import Design
from ...devices.balancing.engine import InlineEngine
from ...devices.balancing.field import FieldBalancing
from ...devices.balancing.shaking import ShakingForce
from ...devices.cams.cam import Cam
from ...devices.eccentric_clamp import EccentricClamp
from ...foundation.slotted import replace
from ...mechanism.model import Mechanism
from ...problem.problem import Problem
from .coordinates_of_guides import coordinates_of_guides
from .designs import design
from .machines import cam, clamp, engine, field, shaking
from .offsets import mechanism
from .radii import radii
from .set_off import set_off
from .travels import travels


def sized(problem: Problem, figure: Figure) -> Figure:
    """The reduced figure with its sizes: what the statement and the data name by a letter can be seen on it."""
    return replace(figure, marks=(*figure.marks, *_sizes(problem, figure)))


def _sizes(problem: Problem, figure: Figure) -> Iterator[Mark]:
    match problem.subject:
        case EccentricClamp() as device:
            yield from clamp(device, figure)
        case InlineEngine() as device:
            yield from engine(device, figure)
        case ShakingForce() as device:
            yield from shaking(device, figure)
        case FieldBalancing() as device:
            yield from field(device, figure)
        case Cam() as device:
            yield from cam(device, figure)
        case Mechanism():
            for sizes in (mechanism, radii, coordinates_of_guides, travels, set_off):
                yield from sizes(problem, figure)
        case Design() as device:
            yield from design(device, problem.statement.zh, figure)
