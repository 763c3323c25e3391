"""Which files a problem file may name: those in its own folder and below it, and the library; others only where the user says so."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from ..data import data_dir
from ..errors import ProblemFileError
from ..words import Words

_PROBLEM = re.compile(r"""^[\s{"']*(?:id|title|extends|device|problems|frame|links|find)["']?\s*[:：]""", re.M)


@dataclass(frozen=True, slots=True)
class Reach:
    """The folder of the file that the user named (None: a text, which has none), or anywhere."""

    folder: Path | None = None
    anywhere: bool = False

    def allows(self, path: Path) -> bool:
        """Whether a file may be read, links in its path followed."""
        homes = [data_dir("problems").resolve(), *([self.folder.resolve()] if self.folder else [])]
        return self.anywhere or any(path.resolve().is_relative_to(home) for home in homes)

    def refuse_outside(self, path: Path) -> None:
        """Raise ProblemFileError for a file that may not be read, whether it exists or not."""
        if not self.allows(path):
            where = Words(f"题目文件所在的文件夹 {self.folder}", f"the problem file's folder {self.folder}") if self.folder else Words("题库", "the library")
            raise ProblemFileError(
                Words(f"{path} 在{where.zh}之外，不予读取；请把文件放到该文件夹内，或加 --allow-outside",
                      f"{path} lies outside {where.en} and is not read; move it there, or give --allow-outside"), code="outside")


def refuse_foreign(text: str, path: Path) -> None:
    """Raise ProblemFileError for a file that is no problem at all: of its text nothing is told."""
    if not _PROBLEM.search(text):
        raise ProblemFileError(Words(f"{path} 不是题目文件", f"{path} is no problem file"), code="no problem file")
