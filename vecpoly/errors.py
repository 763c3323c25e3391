"""One error root; every error also refines the built-in error a Python user would expect.

What is refused is data first (`Fault`: a code, a place, a path, the numbers that disagree), then a text in Chinese and
in English. `str(error)` is the English text; `error.words.of("zh")` the Chinese one.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, ClassVar, Self

from .limits import FAULTS
from .words import Words

Path = tuple[str | int, ...]
Numbers = Mapping[str, str | float]


def bilingual(text: Words | str) -> Words:
    """The text in both languages; a plain string is the same in both."""
    return text if isinstance(text, Words) else Words.same(text)


@dataclass(frozen=True, slots=True)
class Place:
    """Where a key or an item stands, counted from 1; 0 where the line or the column is not known."""

    file: str
    line: int = 0
    column: int = 0

    @property
    def words(self) -> Words:
        """a.yaml, line 5, column 7."""
        zh, en = self.file, self.file
        if self.line:
            zh, en = f"{zh} 第 {self.line} 行", f"{en}, line {self.line}"
        if self.column:
            zh, en = f"{zh}第 {self.column} 列", f"{en}, column {self.column}"
        return Words(zh, en)


@dataclass(frozen=True, slots=True, kw_only=True)
class Fault:
    """One thing that is wrong, as data: what kind (`code`), where in which file, at which path, which numbers disagree.

    said: cause and remedy in both languages, the remedy behind the first semicolon. beside: the other keys that it is
    about, each with its place.
    """

    said: Words
    code: str = "value"
    place: Place | None = None
    path: Path = ()
    numbers: Numbers = field(default_factory=dict)
    beside: tuple[tuple[Path, Place], ...] = ()

    @property
    def words(self) -> Words:
        """File, line, column, path, cause, remedy in one line."""
        text = self._keys + Words("：", ": ") + self.said if self.path else self.said
        return text if self.place is None else self.place.words + Words("：", ": ") + text

    @property
    def _keys(self) -> Words:
        """data.d, data.d1 (line 6): the other keys with their lines where they stand on others."""
        zh = en = dotted(self.path)
        own = self.place or Place("")
        for path, place in self.beside:
            where = Words(f"第 {place.line} 行", f"line {place.line}") if place.file == own.file else place.words
            apart = (place.file, place.line) != (own.file, own.line)
            zh += f"、{dotted(path)}" + (f"（{where.zh}）" if apart else "")
            en += f", {dotted(path)}" + (f" ({where.en})" if apart else "")
        return Words(zh, en)

    @property
    def remedy(self) -> Words:
        """What to do; empty where the cause says it."""
        return Words(self.said.zh.partition("；")[2], self.said.en.partition("; ")[2])

    def as_json(self) -> dict[str, Any]:
        """Plain data for programs."""
        at = self.place or Place("")
        return {
            "code": self.code, "file": at.file or None, "line": at.line or None, "column": at.column or None,
            "path": dotted(self.path) or None, "numbers": dict(self.numbers),
            "beside": [
                {"path": dotted(to), "file": on.file, "line": on.line or None, "column": on.column or None}
                for to, on in self.beside
            ],
            "zh": self.said.zh, "en": self.said.en, "remedy": {"zh": self.remedy.zh, "en": self.remedy.en},
        }  # fmt: skip


def dotted(path: Path) -> str:
    """A path as people write it: links.2.F, joints[0]."""
    text = "".join(f"[{step}]" if isinstance(step, int) else f".{step}" for step in path)
    return text.removeprefix(".")


class VecpolyError(Exception):
    """Anything that vecpoly refuses to do; its text names the culprit, the numbers and the remedy.

    words: the text in both languages. code: what kind of refusal it is, for programs; the name of the class where none
    is given.
    numbers: symbol -> value as written. faults: the same as data, one for each thing that is wrong.
    about: what of a problem file such a refusal is about, the first of these keys that it has.
    """

    about: ClassVar[tuple[str, ...]] = ("data", "find", "input")

    def __init__(
        self, text: Words | str = "", *, code: str = "", numbers: Numbers | None = None, faults: tuple[Fault, ...] = ()
    ) -> None:
        super().__init__(text)
        self.words, self.code, self.numbers = bilingual(text), code or _kebab(type(self).__name__), dict(numbers or {})
        self.faults = faults or (Fault(said=self.words, code=self.code, numbers=self.numbers),)

    def __str__(self) -> str:
        return self.words.en

    def led_by(self, words: Words) -> Self:
        """The same refusal with these words in front: the problem, or the file, that it is about."""
        faults = tuple(fault if fault.place else replace(fault, said=words + fault.said) for fault in self.faults)
        return type(self)(words + self.words, code=self.code, numbers=self.numbers, faults=faults)

    def at(self, place: Place, *path: str | int) -> Self:
        """The same refusal, at a place of a file."""
        fault = Fault(said=self.words, code=self.code, place=place, path=path, numbers=self.numbers)
        return type(self)(fault.words, code=self.code, numbers=self.numbers, faults=(fault,))

    @classmethod
    def of(cls, *faults: Fault) -> Self:
        """One refusal of all these faults, a line each; of very many the first."""
        zh, en = ("\n".join(fault.words.of(lang) for fault in faults[:FAULTS]) for lang in ("zh", "en"))
        if more := len(faults[FAULTS:]):
            zh, en = f"{zh}\n……另有 {more} 处；请先改正以上各处", f"{en}\n... and {more} more; correct these first"
        return cls(Words(zh, en), code=faults[0].code, numbers=faults[0].numbers, faults=faults)


def _kebab(name: str) -> str:
    """DeadPointError → dead-point."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "-", name.removesuffix("Error")).lower()


class ProblemFileError(VecpolyError, ValueError):
    """A problem file that cannot be read as written: file, line, YAML path, cause, remedy."""


class UnknownNameError(VecpolyError, KeyError):
    """A letter, link, symbol, method or problem id that does not exist."""


class AssemblyError(VecpolyError, ValueError):
    """Links that cannot be joined in this position: the joint, the gap, the input range that does assemble."""

    about: ClassVar[tuple[str, ...]] = ("input", "data")


class BranchError(AssemblyError):
    """Which of several assemblies is meant is not told, or cannot be: what tells it."""

    about: ClassVar[tuple[str, ...]] = ("branch", "links", "data")


class DeadPointError(AssemblyError):
    """A dead point or change point: velocities have no unique value here."""


class MobilityError(VecpolyError, ValueError):
    """Degrees of freedom and number of inputs disagree."""

    about: ClassVar[tuple[str, ...]] = ("joints", "links")


class EquationError(VecpolyError, ValueError):
    """A vector equation whose chain is broken or whose unknowns are not exactly two."""

    about: ClassVar[tuple[str, ...]] = ("links", "data")


class NoMethodError(VecpolyError, NotImplementedError):
    """No graphical method on file covers this group or quantity."""


class NotAskedError(VecpolyError, LookupError):
    """The construction holds no such reading."""


class TableError(VecpolyError, ValueError):
    """A printed table that cannot be read: file, line, column, cause, remedy."""


class ArgumentError(VecpolyError, ValueError):
    """An argument that no function of ours takes: what it is, and what it may be."""


class MissingPackageError(VecpolyError, ImportError):
    """What needs a package that is not installed: which, and what goes without it."""


class PluginError(VecpolyError, ImportError):
    """A module that another package registers cannot be loaded."""


class ReportTemplateError(VecpolyError, ValueError):
    """A report template that cannot be filled: file, line, cause."""


class FaultError(ValueError):
    """One thing wrong in a file, at a path below the one being read;
    the reader collects these into one ProblemFileError.

    keys: those below the path (deeper ones as paths) that are wrong together; what is not written is passed over.
    """

    def __init__(
        self,
        text: Words | str,
        *path: str | int,
        code: str = "value",
        numbers: Numbers | None = None,
        keys: Sequence[str | Path] = (),
    ) -> None:
        super().__init__(text)
        self.words, self.path, self.code, self.numbers = bilingual(text), path, code, dict(numbers or {})
        self.keys = tuple(keys)

    def __str__(self) -> str:
        return self.words.en

    def under(self, *path: str | int) -> FaultError:
        """The same fault, seen from further up in the file."""
        return FaultError(self.words, *path, *self.path, code=self.code, numbers=self.numbers, keys=self.keys)


class EquilibriumError(VecpolyError, ValueError):
    """Loads that no equilibrium answers: too many or too few unknowns, an unknown without a lever arm."""

    about: ClassVar[tuple[str, ...]] = ("loads", "input")


class LockedError(EquilibriumError):
    """Self-locking: with this friction the driving load cannot move the mechanism, however large it is."""


class NoSlipSenseError(EquilibriumError):
    """A joint with friction whose links do not move relative to each other here: friction has no sense."""
