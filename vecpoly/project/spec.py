"""What a project file holds: the task in words, schemes to choose from, parts in order, demands at the end."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import BeforeValidator, Field

from ..problem.schema.fields import ID, Text, YesNo
from ..problem.schema.models import Spec


class SchemeSpec(Spec):
    """One of the mechanisms that come into question."""

    name: Text
    merits: Text
    faults: Text
    chosen: YesNo = False


class DemandSpec(Spec):
    """A demand: what it is called, and what must hold."""

    say: Text
    that: str


def _demand(value: Any) -> Any:
    return {"say": value, "that": value} if isinstance(value, str) else value


Demanded = Annotated[DemandSpec, BeforeValidator(_demand)]


class ProjectSpec(Spec):
    """A project file. id: of its parts' names on sheets; the file's name where nothing is said."""

    id: str | None = Field(None, pattern=ID)
    title: Text
    statement: Text
    source: Text | None = None
    title_block: dict[str, str] = Field({})
    schemes: list[SchemeSpec] = Field([])
    parts: dict[str, dict[str, Any]] = Field(min_length=1)
    demands: list[Demanded] = Field([])


class WorksSpec(Spec):
    """A load that acts only on one stroke of a slider, and there from one share of the stroke to another."""

    load: str
    begins: str = Field("0 %", alias="from")
    ends: str = Field("100 %", alias="to")


class PartSpec(Spec):
    """What a part says beside the problem that it is.

    of: the part whose linkage it takes; round: to what its lengths are rounded; also: further positions that are drawn;
    unevenness: [δ], for which a flywheel is sized.
    """

    of: str | None = None
    round: str | None = None
    also: list[str] = Field([])
    works: WorksSpec | None = None
    unevenness: str | None = None


OWN = tuple(PartSpec.model_fields)  # keys of a part that a problem does not have
