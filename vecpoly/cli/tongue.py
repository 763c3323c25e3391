"""The language of what a command tells on the terminal: --lang or VECPOLY_LANG where one is said, English else.

A report has a language of its own (Chinese, where nothing is said); what is told about writing it has this one.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from contextvars import ContextVar

from ..words import Lang, Words

_TONGUE: ContextVar[Lang] = ContextVar("tongue", default="en")  # for the length of one command


def tongue() -> Lang:
    """The language of the command that is running."""
    return _TONGUE.get()


def speak(args: Sequence[str]) -> None:
    """Take the language from a command's words, or from the environment."""
    said = [
        word.partition("=")[2] or following
        for word, following in zip(args, [*args[1:], ""], strict=False)
        if word.partition("=")[0] == "--lang"
    ]
    _TONGUE.set("zh" if (said or [os.environ.get("VECPOLY_LANG", "")])[-1] == "zh" else "en")


def told_in(words: Words) -> str:
    """The words in the language of the command."""
    return words.of(tongue())
