"""What an assignment file may hold."""

from __future__ import annotations

from typing import Any

from pydantic import Field

from .fields import ID, Text
from .marking import MarkingSpec


class AssignmentSpec(MarkingSpec):
    """An assignment file: title, title block, problems, and how they are marked."""

    title: Text
    id: str | None = Field(
        None, pattern=ID, description="of the assignment in codes and seeds; the file's name where nothing is said"
    )
    salt: str = Field("", description="another text gives everybody other numbers")
    title_block: dict[str, str] = Field({})
    problems: list[str | dict[str, Any]] = Field(min_length=1)
