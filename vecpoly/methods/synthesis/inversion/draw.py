"""A plan is drawn stage by stage; where a stage has several meetings, each is gone on with."""

from __future__ import annotations

from collections.abc import Iterator
from typing import assert_never

from ....designs.inversion.angle_pairs import AnglePairs
from ....designs.inversion.plan import Assemble, CentrePoints, Find, Limits, Plan, Stage
from ....designs.inversion.positions import Positions
from ....designs.inversion.stages import Stages
from ....words import Words
from ..draft import Draft
from ..registry import design_method
from .centre_points import centre_points
from .find import find
from .finish import finish
from .given import laid_out
from .join import join
from .limits import limits
from .sheet import Sheet

_SOURCE = (
    "机械原理, synthesis by inversion: in the eyes of the link that is kept, the other pin goes round the sought one"
)


@design_method(
    Positions,
    title=Words("按给定的连杆位置设计四杆机构", "Four-bar through given positions of its coupler"),
    source=_SOURCE,
    example="8-6",
)
def draw_positions(draft: Draft, design: Positions) -> None:
    """The pins on the frame by bisectors, those on the body by inversion; of four positions by centre points."""
    _drawn(draft, design.plan())


@design_method(
    AnglePairs,
    title=Words("按给定的两连架杆对应位置设计四杆机构", "Four-bar or slider-crank from corresponding positions"),
    source=_SOURCE,
    example="8-8",
)
def draw_angle_pairs(draft: Draft, design: AnglePairs) -> None:
    """The pin between coupler and output link, or input link, by inversion."""
    _drawn(draft, design.plan())


@design_method(
    Stages,
    title=Words("逐步反转设计多杆机构", "Linkage found pin after pin by inversion"),
    source=_SOURCE,
    example="8-13",
)
def draw_stages(draft: Draft, design: Stages) -> None:
    """Pin after pin, each by what the one before has given."""
    _drawn(draft, design.plan())


def _drawn(draft: Draft, plan: Plan) -> None:
    _go_on(laid_out(draft, plan), plan.stages)


def _go_on(sheet: Sheet, stages: tuple[Stage, ...]) -> None:
    """Every way through the stages that are left."""
    if not stages:
        finish(sheet)
        return
    for after in _after(sheet, stages[0]):
        _go_on(after, stages[1:])


def _after(sheet: Sheet, stage: Stage) -> Iterator[Sheet]:
    match stage:
        case Find():
            yield find(sheet, stage)
        case Assemble():
            yield join(sheet, stage)
        case Limits():
            yield from limits(sheet, stage)
        case CentrePoints():
            yield from centre_points(sheet, stage)
        case _:
            assert_never(stage)
