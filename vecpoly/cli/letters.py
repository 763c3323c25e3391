"""A warning for characters that no face of the product has, before they are printed as [U+36C3]."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from ..words import Lang, Words
from .terminal import say
from .tongue import told_in

if TYPE_CHECKING:
    from ..problem.problem import Problem


def warn_of_letters(problems: Iterable[Problem], lang: Lang, beside: Iterable[str] = ()) -> None:
    """Name the characters of these problems' texts, and of what is printed beside them,
    that will not be printed as written."""
    from ..typeset.fonts import missing

    for name, text in [*((problem.id, _texts(problem, lang)) for problem in problems), ("", "".join(beside))]:
        if lost := missing(text):
            signs = [(sign, f"[U+{ord(sign):04X}]") for sign in lost]
            say(
                told_in(
                    Words(f"{name}：" if name else "", f"{name}: " if name else "")
                    + Words(
                        "字体中没有" + "、".join(f"“{sign}”，将印作 {code}" for sign, code in signs) + "；请换用其他字",
                        "no face has "
                        + ", ".join(f"'{sign}', which is printed as {code}" for sign, code in signs)
                        + "; use another character",
                    )
                )
            )


def _texts(problem: Problem, lang: Lang) -> str:
    words = (problem.title, problem.statement, *problem.explain, problem.source, *problem.errata)
    words += tuple(one.note for one in problem.printed)
    return problem.id + "".join(one.of(lang) for one in words if one is not None)
