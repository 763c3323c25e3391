"""Which files a problem file may name: those in its own folder and below it, and the library;
others only where the user says so."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

from ..errors import ProblemFileError
from ..foundation.data import data_dir
from ..foundation.patterns import pattern
from ..foundation.slotted import dataclass
from ..words import Words

_PROBLEM = pattern(r"""^[\s{"']*(?:id|title|extends|device|synthesis|problems|frame|links|find)["']?\s*[:：]""", re.M)


# a name as written in a problem -> what stands there; None: look for a file
Resolver = Callable[[str], "str | bytes | None"]


@dataclass(frozen=True, slots=True)
class Reach:
    """The folder of the file that the user named (None: a text, which has none), or anywhere;
    and who knows files that are in memory."""

    folder: Path | None = None
    anywhere: bool = False
    resolver: Resolver | None = None

    def held(self, name: str) -> bytes | None:
        """What the resolver has under this name;
        raises ProblemFileError for what is neither text nor bytes, or too large."""
        found = None if self.resolver is None else self.resolver(name)
        if found is None or isinstance(found, bytes):
            return found
        if not isinstance(found, str):
            raise ProblemFileError(
                Words(
                    f"resolver 对“{name}”应给出文本或 None，而不是 {type(found).__name__}",
                    f"the resolver must give a text or None for '{name}', not {type(found).__name__}",
                ),
                code="no text",
            )
        return found.encode(errors="surrogatepass")

    def allows(self, path: Path) -> bool:
        """Whether a file may be read, links in its path followed."""
        homes = [data_dir("problems").resolve(), *([self.folder.resolve()] if self.folder else [])]
        return self.anywhere or any(path.resolve().is_relative_to(home) for home in homes)

    def refuse_outside(self, path: Path) -> None:
        """Raise ProblemFileError for a file that may not be read, whether it exists or not."""
        if not self.allows(path):
            where = (
                Words(f"题目文件所在的文件夹 {self.folder}", f"the problem file's folder {self.folder}")
                if self.folder
                else Words("题库", "the library")
            )
            raise ProblemFileError(
                Words(
                    f"{path} 在{where.zh}之外，不予读取；请把文件放到该文件夹内，或加 --allow-outside",
                    f"{path} lies outside {where.en} and is not read; move it there, or give --allow-outside",
                ),
                code="outside",
            )


def refuse_foreign(text: str, path: Path) -> None:
    """Raise ProblemFileError for a file that is no problem at all: of its text nothing is told."""
    if not _PROBLEM.search(text):
        raise ProblemFileError(Words(f"{path} 不是题目文件", f"{path} is no problem file"), code="no problem file")
