"""The problem library: which problems there are, read from the heads of their files."""

from __future__ import annotations

import re
from pathlib import Path

from ..errors import ProblemFileError
from ..foundation.data import data_dir
from ..foundation.patterns import pattern
from ..foundation.slotted import dataclass
from ..words import Words

_ID = pattern(r"^id:\s*['\"]?([\w.\-]+)", re.M)
_KIND = pattern(r"^(problems|parts|search):", re.M)
_COMMAND = {"problems": "report", "parts": "design", "search": "search"}
_TITLE = pattern(r"^title:\s*(?:\{\s*zh:\s*(?P<zh>.+?),\s*en:\s*(?P<en>.+?)\s*\}|(?P<one>.+?))\s*$", re.M)


@dataclass(frozen=True, slots=True)
class Entry:
    """One problem of the library."""

    id: str
    title: Words
    path: Path


def library(folder: Path | None = None) -> tuple[Entry, ...]:
    """All problems, by chapter and number. Raises ProblemFileError where two files have one id."""
    found = sorted(entries(folder), key=lambda entry: (entry.path.parent.name, natural(entry.id)))
    by_id: dict[str, Entry] = {}
    for entry in found:
        first = by_id.setdefault(entry.id, entry)
        if first is not entry:
            raise ProblemFileError(
                Words(
                    f"{entry.path} 第 1 行：id：“{entry.id}”也是 {first.path} 的 id；请更改其一",
                    f"{entry.path}, line 1: id: '{entry.id}' is also the id of {first.path}; change one of them",
                )
            )
    return tuple(found)


def entries(folder: Path | None = None) -> tuple[Entry, ...]:
    """The heads of all files, as they come."""
    root = folder or data_dir("problems")
    return tuple(entry for path in sorted(root.rglob("*.yaml")) if (entry := _head(path)) is not None)


def others() -> tuple[tuple[str, Entry], ...]:
    """The design projects, searches and assignments of the library, each behind the command that takes it."""
    found: list[tuple[str, Entry]] = []
    for path in sorted(data_dir("problems").glob("*.yaml")):
        text = path.read_text(encoding="utf-8")
        if _KIND.search(text) and (title := _titled(text)) is not None:
            found.append((command_for(text), Entry(path.stem, title, path)))
    return tuple(sorted(found, key=lambda one: one[0]))


def command_for(text: str) -> str:
    """The command that takes a file of this text: design for a project, search for a search, report for an assignment;
    solve for a problem."""
    kinds = {found[1] for found in _KIND.finditer(text)}
    return next((command for kind, command in _COMMAND.items() if kind in kinds), "solve")


def find(name: str) -> Path | None:
    """The file of a problem of the library: '3-9' or 'ch3/3-9'."""
    if not re.fullmatch(r"[\w.\-/]+", name) or ".." in name:
        return None
    root = data_dir("problems")
    for path in sorted(root.rglob(f"{Path(name).name}.yaml")):
        if path.with_suffix("").as_posix().endswith(f"/{name}"):
            return path
    return next((entry.path for entry in entries() if entry.id == name), None)


def family(name: str) -> tuple[str, ...]:
    """The parts of an exercise that has several: 3-7 → 3-7a, 3-7b ...; empty where the name has none."""
    part = re.compile(rf"{re.escape(name)}[a-z](-\w+)?")
    return tuple(sorted((e.id for e in entries() if part.fullmatch(e.id)), key=natural))


def natural(text: str) -> tuple[tuple[int, str], ...]:
    """Sort key: 3-9 before 3-10."""
    return tuple((int(part), "") if part.isdigit() else (-1, part) for part in re.split(r"(\d+)", text) if part)


def _head(path: Path) -> Entry | None:
    with path.open(encoding="utf-8", errors="replace") as file:
        head = file.read(2000)
    m = _ID.search(head)
    return None if m is None else Entry(m[1], _titled(head) or Words.same(m[1]), path)


def _titled(head: str) -> Words | None:
    """The title, in one language or in both."""
    if (t := _TITLE.search(head)) is None:
        return None
    if t["zh"]:
        return Words(t["zh"].strip("'\""), t["en"].strip("'\""))
    return Words.same(t["one"].strip("'\""))
