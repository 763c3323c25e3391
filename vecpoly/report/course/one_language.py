"""A problem file with the sentences of one language: of {zh: ..., en: ...} that of the report."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...words import Lang

_OTHER: dict[Lang, Lang] = {"zh": "en", "en": "zh"}
_QUOTED = r"\"(?:[^\"\\]|\\.)*\"|'(?:[^']|'')*'"
_VALUE = rf"(?:{_QUOTED}|[^,{{}}\"'](?:[^,{{}}]|,(?!\s*(?:zh|en):))*)"


def in_one_language(text: str, lang: Lang) -> str:
    """What is written in both languages in that one only, without the lines of comment; all else as it stands."""
    text = re.sub(r"^ *#.*\n", "", text, flags=re.M)
    flow = re.compile(rf"\{{\s*(zh|en):\s*({_VALUE})\s*,\s*(zh|en):\s*({_VALUE})\s*\}}")
    return "".join(_blocks(flow.sub(lambda found: _chosen(found, lang), text).splitlines(keepends=True), lang))


def _chosen(found: re.Match[str], lang: Lang) -> str:
    one, said, other, also = found.groups()
    if one == other:
        return found[0]
    return f"{{{lang}: {(said if one == lang else also).strip()}}}"


def _blocks(lines: list[str], lang: Lang) -> Iterator[str]:
    """The lines without those of the other language, where both stand under each other."""
    bare = [re.sub(r"^( *)- ", r"\1  ", line) for line in lines]  # an entry of a list begins a mapping
    skipped, dashed = -1, False
    for n, (line, text) in enumerate(zip(lines, bare, strict=True)):
        depth = _depth(text)
        if skipped >= 0 and (not text.strip() or depth > skipped):
            continue
        skipped = -1
        if text.lstrip(" ").startswith(f"{_OTHER[lang]}:") and _beside(bare, n, f"{lang}:"):
            skipped, dashed = depth, line != text
            continue
        yield f"{text[: depth - 2]}- {text[depth:]}" if dashed else line
        dashed = False


def _depth(line: str) -> int:
    return len(line) - len(line.lstrip(" "))


def _beside(lines: list[str], n: int, key: str) -> bool:
    """Whether the same mapping has this key, too."""
    depth = _depth(lines[n])
    for way in (lines[n + 1 :], lines[n - 1 :: -1] if n else []):
        for line in way:
            if line.strip() and _depth(line) < depth:
                break
            if _depth(line) == depth and line.lstrip(" ").startswith(key):
                return True
    return False
