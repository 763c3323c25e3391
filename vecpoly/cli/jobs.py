"""From what stands on the command line to problems:
what cannot be read is told at the end, and does not stop the others."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from ..errors import NotAskedError
from ..foundation.slotted import dataclass, replace
from ..foundation.stock import FormatName
from ..words import Words
from .errors import Tally

if TYPE_CHECKING:
    from ..problem.problem import Problem


@dataclass(frozen=True, slots=True, kw_only=True)
class Job:
    """One document to write: a problem, or an assignment with its title block."""

    name: str
    problems: tuple[Problem, ...]
    title: Words | None = None
    fields: Mapping[str, str] | None = None
    path: Path | None = None  # of an assignment

    def on(self, paper: FormatName | None) -> Job:
        """The same on paper of this format, where one is chosen."""
        return self if paper is None else replace(self, problems=tuple(one.on(paper) for one in self.problems))

    @property
    def files(self) -> tuple[Path, ...]:
        """All that was read for it."""
        return (*((self.path,) if self.path else ()), *(file for problem in self.problems for file in problem.files))


def problems(
    names: Sequence[str], tally: Tally, outside: bool = False, paper: FormatName | None = None
) -> list[Problem]:
    """All problems named, those of assignments among them, on this paper where one is chosen;
    the tally keeps what cannot be read, and tells it at once where nothing can."""
    return [problem for job in jobs(names, tally, outside) for problem in job.on(paper).problems]


def jobs(names: Sequence[str], tally: Tally, outside: bool = False) -> list[Job]:
    """All documents named: a problem by id or file, an assignment by file."""
    found: list[Job] = []
    for name in _parts(names):
        with tally.job():
            found.append(job(name, outside))
    if not found:
        tally.settle()
    return found


_KINDS = {  # by the key that tells it: the command, and what it is
    "problems": ("report", Words("作业", "an assignment")),
    "parts": ("design", Words("课程设计", "a design project")),
    "search": ("search", Words("搜索", "a search")),
    "id": ("solve", Words("题目", "a problem")),
}


def each(path: Path, name: str, count: int) -> Path:
    """Where the output of one of several problems goes: table-3-9.csv."""
    return path if count < 2 else path.with_name(f"{path.stem}-{name}{path.suffix}")


def _parts(names: Sequence[str]) -> list[str]:
    """Each name once; an exercise with several parts stands for all of them: 3-7 is 3-7a to 3-7e."""
    from ..problem.library import family, find

    parts = [
        part for name in names for part in ([name] if Path(name).is_file() or find(name) else family(name) or [name])
    ]
    return list(dict.fromkeys(parts))


def job(name: str, outside: bool = False) -> Job:
    """The document of a problem or of an assignment file."""
    from ..problem.assignment import is_assignment, load_assignment
    from ..problem.load import load, locate

    path = locate(name)
    refuse_other(path, "solve", "report")
    if not is_assignment(path):
        problem = load(path, allow_outside=outside)
        return Job(name=problem.id, problems=(problem,))
    sheet = load_assignment(path, allow_outside=outside)
    return Job(name=Path(path).stem, problems=sheet.problems, title=sheet.title, fields=sheet.block, path=path)


def refuse_other(path: Path, *wanted: str) -> None:
    """Raise NotAskedError for a file that another command takes: a design project, a search, an assignment, a
    problem."""
    from ..problem.text.source import read

    data = read(path).data
    kinds = (command for key, (command, _) in _KINDS.items() if key in data)
    command = next(kinds, "")
    if not command or command in wanted:
        return
    what = next(what for taken, what in _KINDS.values() if taken == command)
    asked = next(what for taken, what in _KINDS.values() if taken == wanted[0])
    raise NotAskedError(
        Words(
            f"{path} 是{what.zh}，不是{asked.zh}；请用 vecpoly {command} {path}",
            f"{path} is {what.en}, not {asked.en}; the command is: vecpoly {command} {path}",
        ),
        code=command,
    )
