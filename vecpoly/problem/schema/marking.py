"""What a file may say of marking: the models behind `rules`, `rubric`, `points` and `totals`."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

Share = Annotated[float, Field(ge=0.0, le=1.0)]
Worth = Annotated[float, Field(ge=0.0, le=1e4)]


class _Said(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, defer_build=True)


class RulesSpec(_Said):
    """What may be said of the rules; see `grading.rules.Rules`."""

    close: Share | None = None
    own: Share | None = None
    slip: Share | None = None
    turned: Share | None = None
    unit: Worth | None = None
    printed: bool | None = None
    independent: tuple[str, ...] | None = None
    first: tuple[str, ...] | None = None
    reach: Annotated[float, Field(gt=1.0)] | None = None
    following: bool | None = None
    drawing: Literal["told", "given", "required"] | None = None
    open: bool | None = None
    compensatory: bool | None = None


class BlockSpec(_Said):
    """Points of one part of a solution; what is not said is nothing."""

    scale: Worth = 0.0
    drawn: Worth = 0.0
    values: Worth = 0.0
    rates: Worth = 0.0
    equation: Worth = 0.0


class RubricSpec(_Said):
    """Points by part, shared out over what is asked there."""

    diagram: BlockSpec | None = None
    velocity: BlockSpec | None = None
    acceleration: BlockSpec | None = None
    force: BlockSpec | None = None
    other: BlockSpec | None = None


class PointsSpec(_Said):
    """Points of one quantity."""

    method: Worth = 0.0
    accuracy: Worth = 0.0
    sense: Worth = 0.0


class MarkingSpec(_Said):
    """Rules; points by part, and by problem and quantity; totals that must come out."""

    rules: RulesSpec = RulesSpec()
    rubric: RubricSpec = RubricSpec()
    points: dict[str, dict[str, PointsSpec]] = {}
    totals: dict[str, Worth] = {}


KEYS = tuple(MarkingSpec.model_fields)
