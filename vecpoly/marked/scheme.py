"""The lecturer's rules and points: those of the assignment, and what a YAML file of their own changes."""

from __future__ import annotations

from pathlib import Path

from ..batch.register import Register
from ..grading.scheme import Scheme, scheme_of
from ..problem.marking import marking_of
from ..problem.text.source import read


def read_scheme(path: Path | None, register: Register) -> Scheme:
    """The scheme of the class, changed by a file where there is one. Raises ProblemFileError, with every line, for
    what is not known, or other totals."""
    if path is None:
        return register.scheme
    keys = {part.problem: part.key for part in register.sheets[0].parts} if register.sheets else {}
    return scheme_of(marking_of(read(path)), keys, register.scheme)
