"""Faults of a problem file, collected with their YAML path and told together, first line first."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from difflib import get_close_matches

from ..errors import FaultError, ProblemFileError, VecpolyError

Path = tuple[str | int, ...]


@dataclass(frozen=True, slots=True)
class Place:
    """Where a key or an item stands, counted from 1."""

    file: str
    line: int
    column: int


@dataclass(slots=True)
class Faults:
    """The list of what is wrong with one file."""

    file: str
    places: Mapping[Path, Place] = field(default_factory=dict)
    found: list[tuple[Path, str]] = field(default_factory=list)

    @contextmanager
    def at(self, *path: str | int) -> Iterator[None]:
        """Note any fault raised inside, as one at this path, and go on."""
        try:
            yield
        except FaultError as fault:
            self.found.append(((*path, *fault.path), fault.text))
        except VecpolyError as error:
            self.found.append((path, str(error)))

    def settle(self) -> None:
        """Raise one ProblemFileError with all that was found, if anything was."""
        if self.found:
            lines = sorted({self._line(path, text) for path, text in self.found})
            raise ProblemFileError("\n".join(text for _, text in lines))

    def _line(self, path: Path, text: str) -> tuple[tuple[int, int], str]:
        cut = next((path[:n] for n in range(len(path), 0, -1) if path[:n] in self.places), ())
        place = self.places.get(cut, Place(self.file, 1, 1))
        where = f"{place.file}, line {place.line}, column {place.column}"
        return (place.line, place.column), f"{where}: {dotted(path)}: {text}" if path else f"{where}: {text}"


def dotted(path: Path) -> str:
    """A path as people write it: links.2.F, joints[0]."""
    text = "".join(f"[{step}]" if isinstance(step, int) else f".{step}" for step in path)
    return text.removeprefix(".")


def meant(word: str, known: Iterable[str]) -> str:
    """'; did you mean ...?', or the list of what exists."""
    names = sorted(set(known))
    close = get_close_matches(word, names, n=1, cutoff=0.6) or get_close_matches(word.lower(), names, n=1)
    if close:
        return f"; did you mean '{close[0]}'?"
    return f"; known: {', '.join(names)}" if 0 < len(names) <= 30 else ""
