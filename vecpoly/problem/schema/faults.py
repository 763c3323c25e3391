"""Faults of a problem file, collected with their YAML path and told together, first line first."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from difflib import get_close_matches

from ...errors import Fault, FaultError, Path, Place, ProblemFileError, VecpolyError, dotted
from ...words import Words

__all__ = ["Faults", "Path", "Place", "dotted", "meant"]

OF_THE_BOOK = ("printed", "errata", "tables")  # what a problem has of its book, whose values are others


@dataclass(slots=True)
class Faults:
    """The list of what is wrong with one file."""

    file: str
    places: Mapping[Path, Place] = field(default_factory=dict)
    found: list[Fault] = field(default_factory=list)

    @contextmanager
    def at(self, *path: str | int) -> Iterator[None]:
        """Note any fault raised inside, as one at this path, and go on."""
        try:
            yield
        except FaultError as fault:
            self.note(fault.under(*path))
        except VecpolyError as error:
            self.note(FaultError(error.words, *path, code=error.code, numbers=error.numbers))

    def note(self, fault: FaultError) -> None:
        """Keep a fault, with the place of the nearest key that is written; of several keys the first in the file."""
        path, *others = self._keys(fault) or [fault.path]
        cut = next((path[:n] for n in range(len(path), 0, -1) if path[:n] in self.places), ())
        place = self.places.get(cut, Place(self.file, 1, 1) if self.places else Place(self.file))
        said = fault.words + _leave_out(path, place.file != self.file)
        beside = tuple((other, self.places[other]) for other in others)
        new = Fault(said=said, code=fault.code, place=place, path=path, numbers=fault.numbers, beside=beside)
        if new not in self.found:
            self.found.append(new)

    def _keys(self, fault: FaultError) -> list[Path]:
        """The keys that a fault is about, as far as they are written: first those of this file, in its order."""
        paths = [(*fault.path, *((key,) if isinstance(key, str) else key)) for key in fault.keys]
        there = [path for path in paths if path in self.places]
        spots = {path: self.places[path] for path in there}
        return sorted(spots, key=lambda key: (spots[key].file != self.file, spots[key].line, spots[key].column))

    def settle(self) -> None:
        """Raise one ProblemFileError with all that was found, if anything was."""
        if self.found:
            raise ProblemFileError.of(*sorted(self.found, key=_order))


def _leave_out(path: Sequence[str | int], inherited: bool) -> Words:
    """What to do about a printed value of the problem that this one builds on, which does not fit it any more."""
    if not inherited or not path or path[0] not in OF_THE_BOOK:
        return Words("", "")
    return Words(
        f"；此项来自所引的题目，写 {path[0]}: null 即可去掉",
        f"; it stands in the problem that this one builds on: `{path[0]}: null` leaves it out",
    )


def _order(fault: Fault) -> tuple[int, int, str]:
    place = fault.place or Place("")
    return place.line, place.column, fault.words.en


def meant(word: str, known: Iterable[str]) -> Words:
    """'; did you mean ...?', or the list of what exists."""
    names = sorted(set(known))
    close = get_close_matches(word, names, n=1, cutoff=0.6) or get_close_matches(word.lower(), names, n=1)
    if close:
        return Words(f"；是否指“{close[0]}”？", f"; did you mean '{close[0]}'?")
    plain = [name for name in names if name.rpartition("_")[0] not in names]  # not AB_1 to AB_9 beside AB
    there = ", ".join(plain)
    return Words(f"；已有：{there}", f"; known: {there}") if 0 < len(plain) <= 30 else Words.same("")


def not_on_link(letter: str, link: str, points: Iterable[str], *path: str) -> FaultError:
    """A letter that the link has not, written under this key."""
    return FaultError(
        Words(f"点“{letter}”不在构件 {link} 上", f"point '{letter}' is not on link {link}") + meant(letter, points),
        *path,
        code="unknown-name",
    )


def not_on_frame(letter: str, points: Iterable[str]) -> FaultError:
    """A letter that the frame has not."""
    return FaultError(
        Words(f"点“{letter}”不在机架上", f"point '{letter}' is not on the frame") + meant(letter, points),
        code="unknown-name",
    )
