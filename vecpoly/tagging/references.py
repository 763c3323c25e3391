"""Figures, tables, formulas, chapters and sections by their numbers: as they are called, and where they are named."""

from __future__ import annotations

import re
from collections.abc import Iterator

_FIGURE, _TABLE = r"(?:图 ?|[Ff]igure )(?P<figure>\d+-\d+)", r"(?:表 ?|[Tt]able )(?P<table>[\dA-Z]+-\d+)"
_CALLED = re.compile(
    rf"{_FIGURE}|{_TABLE}|第 ?(?P<zh>\d+) ?章|[Cc]hapter (?P<en>\d+)"
    r"|(?:(?<=见 )|(?<=see ))(?P<see>\d\.\d)(?![\d-])|(?<=of )(?P<of>\d\.\d)(?=,)|(?P<expected>\d\.\d)(?= 的预期)"
    r"|[（(](?P<formula>\d+-\d+)[）)]"
)
_HEADED = re.compile(rf"(?:{_FIGURE}|{_TABLE}|(?P<section>\d+(?:\.\d+)?)(?=[ \u3000])|\((?P<formula>\d+-\d+)\)$)")
_KINDS = {"zh": "section", "en": "section", "see": "section", "of": "section", "expected": "section"}


def goal_of(heading: str) -> str:
    """The name of the place that a heading, a caption or the number of a formula marks; nothing where it has none."""
    match = _HEADED.match(heading)
    return _name(match) if match is not None else ""


def called(text: str) -> Iterator[tuple[str, str]]:
    """The text in pieces, each with the name of the place that it calls, or nothing."""
    end = 0
    for match in _CALLED.finditer(text):
        if match.start() > end:
            yield "", text[end : match.start()]
        yield _name(match), match[0]
        end = match.end()
    if end < len(text):
        yield "", text[end:]


def _name(match: re.Match[str]) -> str:
    kind = match.lastgroup or ""
    return f"{_KINDS.get(kind, kind)} {match[kind]}"
