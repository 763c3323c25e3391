"""The paper that drawings are made on and reports are printed on: its format, and which way a sheet lies."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

from ..errors import NotAskedError
from ..words import Words

Way = Literal["portrait", "landscape"]
FormatName = Literal["A4", "letter"]


@dataclass(frozen=True, slots=True)
class Format:
    """A format of paper, upright: width and height in mm."""

    name: FormatName
    width: float
    height: float

    def turned(self, across: bool) -> tuple[float, float]:
        """Width and height of a sheet, upright or across."""
        return (self.height, self.width) if across else (self.width, self.height)


A4 = Format("A4", 210.0, 297.0)  # ISO 216
LETTER = Format("letter", 215.9, 279.4)  # ANSI/ASME Y14.1, size A
FORMATS = (A4, LETTER)


@dataclass(frozen=True, slots=True)
class Paper:
    """Sheets of one format that lie this way, or either way where none is wished."""

    format: Format = A4
    way: Way | None = None

    @property
    def ways(self) -> tuple[bool, ...]:
        """Whether its sheets may lie across: upright first."""
        return (False, True) if self.way is None else (self.way == "landscape",)


ANY_A4 = Paper()


def one_format(papers: Iterable[Paper]) -> Format:
    """The format that all of them have. Raises NotAskedError where they differ: a document is printed on one."""
    formats = tuple(dict.fromkeys(one.format for one in papers))
    if len(formats) > 1:
        names = [one.name for one in formats]
        raise NotAskedError(
            Words(
                f"各题图纸幅面不一（{'、'.join(names)}），不能装订成一册；请用 --paper 统一，或分别输出",
                f"the problems are drawn on paper of several formats ({', '.join(names)}) and cannot be bound "
                "together: choose one with --paper, or write them one by one",
            ),
            code="formats-differ",
        )
    return formats[0] if formats else A4


def paper_of(name: FormatName | None, way: Way | None) -> Paper:
    """Paper as it is named; A4 where no format is."""
    return Paper(next((one for one in FORMATS if one.name == name), A4), way)
