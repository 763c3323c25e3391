"""One error root; every error also refines the built-in error a Python user would expect.

What is refused is data first: a code, a text in Chinese and in English, the numbers that disagree. `str(error)` is
the English text; `error.words.of("zh")` the Chinese one.
"""

from __future__ import annotations

from collections.abc import Mapping

from .words import Words


def bilingual(text: Words | str) -> Words:
    """The text in both languages; a plain string is the same in both."""
    return text if isinstance(text, Words) else Words.same(text)


class VecpolyError(Exception):
    """Anything that vecpoly refuses to do; its text names the culprit, the numbers and the remedy.

    words: the text in both languages. code: what kind of refusal it is, for programs. numbers: symbol -> value as written.
    """

    def __init__(self, text: Words | str = "", *, code: str = "", numbers: Mapping[str, str | float] | None = None) -> None:
        super().__init__(text)
        self.words, self.code, self.numbers = bilingual(text), code, dict(numbers or {})

    def __str__(self) -> str:
        return self.words.en


class ProblemFileError(VecpolyError, ValueError):
    """A problem file that cannot be read as written: file, line, YAML path, cause, remedy."""


class UnknownNameError(VecpolyError, KeyError):
    """A letter, link, symbol, method or problem id that does not exist."""


class AssemblyError(VecpolyError, ValueError):
    """Links that cannot be joined in this position: the joint, the gap, the input range that does assemble."""


class DeadPointError(AssemblyError):
    """A dead point or change point: velocities have no unique value here."""


class MobilityError(VecpolyError, ValueError):
    """Degrees of freedom and number of inputs disagree."""


class EquationError(VecpolyError, ValueError):
    """A vector equation whose chain is broken or whose unknowns are not exactly two."""


class NoMethodError(VecpolyError, NotImplementedError):
    """No graphical method on file covers this group or quantity."""


class NotAskedError(VecpolyError, LookupError):
    """The construction holds no such reading."""


class TableError(VecpolyError, ValueError):
    """A printed table that cannot be read: file, line, column, cause, remedy."""


class ArgumentError(VecpolyError, ValueError):
    """An argument that no function of ours takes: what it is, and what it may be."""


class ReportTemplateError(VecpolyError, ValueError):
    """A report template that cannot be filled: file, line, cause."""


class FaultError(Exception):
    """One thing wrong in a file, at a path below the one being read; the reader collects these into one ProblemFileError."""

    def __init__(self, text: Words | str, *path: str | int) -> None:
        super().__init__(text)
        self.words, self.path = bilingual(text), path

    @property
    def text(self) -> str:
        """The English text."""
        return self.words.en


class EquilibriumError(VecpolyError, ValueError):
    """Loads that no equilibrium answers: too many or too few unknowns, an unknown without a lever arm."""


class LockedError(EquilibriumError):
    """Self-locking: with this friction the driving load cannot move the mechanism, however large it is."""


class NoSlipSenseError(EquilibriumError):
    """A joint with friction whose links do not move relative to each other here: friction has no sense."""
