"""What every page of a report carries at its foot, so that pages that fell apart are sorted again: 3-9 · 7F3K."""

from __future__ import annotations

import json
from collections.abc import Iterable

from .. import __version__
from ..foundation.short import short
from ..problem.problem import Problem
from ..problem.values.written import thawed

_LETTERS = 4
_NAMED = 3  # problems of a report that are all named
_LONGEST = 44  # letters: what stands beside the number of the page
_CUT = "…"


def identity(problems: Iterable[Problem]) -> str:
    """The names of these problems, and a code of what they say and of vecpoly's version.

    The same on every page, in both languages and on every machine; other data give another code.
    """
    every = list(problems)
    return told([one.id for one in every], (_content(one) for one in every))


def told(names: list[str], contents: Iterable[str]) -> str:
    """The same of what has these names and says this."""
    code = short("\x1f".join((__version__, *names, *contents)), _LETTERS)
    called = ", ".join(names) if len(names) <= _NAMED else f"{names[0]} {_CUT} {names[-1]}"
    if len(called) > _LONGEST:
        called = called[: _LONGEST - 1] + _CUT
    return f"{called} · {code}"


def _content(problem: Problem) -> str:
    """What the problem says: the values that it was built from, else its text; and what is printed as given."""
    written = None if problem.written is None else thawed(problem.written.data)
    said = problem.text if written is None else json.dumps(written, sort_keys=True, ensure_ascii=False, default=str)
    given = problem.given
    return repr((problem.title, said, given.lengths, given.motion, given.loads))
