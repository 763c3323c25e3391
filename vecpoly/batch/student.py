"""Who gets a sheet."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Student:
    """number: unique in a roster, and all that the student's values follow from; team: the class."""

    number: str
    name: str = ""
    team: str = ""
