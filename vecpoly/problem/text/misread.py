"""What the YAML reader refuses, in words a lecturer knows,
at the line where the mistake is rather than where it was noticed."""

from __future__ import annotations

import re
from typing import Any

from ...foundation.patterns import pattern
from ...foundation.slotted import dataclass
from ...words import Words

_CLOSER = {"{": "}", "[": "]"}
_KEY_WITHOUT_SPACE = pattern(r"\s*(?:- )?([\w.'-]+):(\S.*)")
_TOP_KEY = pattern(r"[A-Za-z_]\w*\s*:")
_FALLBACK = Words(
    "此处不符合 YAML 语法；请检查缩进、冒号后的空格，以及括号与引号是否成对",
    "this is no valid YAML; check the indentation, the space behind each colon, and that brackets and "
    "quotes come in pairs",
)


@dataclass(frozen=True, slots=True)
class Misread:
    """A mistake in a YAML text, at a line and column counted from 0."""

    words: Words
    line: int
    column: int


def misread(error: Any, text: str) -> Misread:
    """The mistake behind a MarkedYAMLError of the reader."""
    problem, context = str(error.problem or ""), str(error.context or "")
    mark, opened = error.problem_mark or error.context_mark, error.context_mark or error.problem_mark
    lines = re.split(r"\r\n|[\r\n]", text)  # as the reader counts them
    here = Misread(_FALLBACK, mark.line, mark.column)
    if "\\t" in problem:
        return _at(here, Words("此处有制表符；请用空格缩进", "a tab; indent with spaces"))
    if "quoted scalar" in context:
        return _quoted(here, Misread(_FALLBACK, opened.line, opened.column), problem, lines)
    if ("'?'" in problem or "mapping keys are not allowed" in problem) and _sign(here, lines) in ("?", ""):
        return _at(here, Words('问号要加引号：size: "?"', 'a question mark goes between quotes: size: "?"'))
    if "cannot start any token" in problem or "undefined alias" in problem:
        sign = _sign(here, lines)
        return _at(
            here, Words(f"以“{sign}”开头的文本要加引号", f"a text that begins with '{sign}' goes between quotes")
        )
    if "flow" in context and "expected ','" in problem:
        return _bracket(here, Misread(_FALLBACK, opened.line, opened.column), lines)
    if "another document" in problem:
        return _at(
            here, Words("一个文件只写一道题；请去掉“---”行", "a file holds one problem; take the line '---' away")
        )
    if "could not find expected ':'" in problem:
        return _no_colon(Misread(_FALLBACK, opened.line, opened.column), lines)
    return _block(here, problem, lines)


def _sign(at: Misread, lines: list[str]) -> str:
    """The character there; none past the end. A key that begins where none may is called '?' by the reader, too."""
    return lines[at.line][at.column : at.column + 1] if at.line < len(lines) else ""


def _at(where: Misread, words: Words) -> Misread:
    return Misread(words, where.line, where.column)


def _quoted(here: Misread, opened: Misread, problem: str, lines: list[str]) -> Misread:
    sign = lines[opened.line][opened.column : opened.column + 1]
    if "escape" in problem:
        return _at(
            here,
            Words(
                "双引号内的反斜杠引出转义字符；请改用单引号",
                "a backslash between double quotes begins an escape; use single quotes",
            ),
        )
    return _at(opened, Words(f"此处的引号 {sign} 没有闭合", f"the quote {sign} opened here is not closed"))


def _bracket(here: Misread, opened: Misread, lines: list[str]) -> Misread:
    """A bracket left open, or a comma left out."""
    sign = lines[opened.line][opened.column : opened.column + 1]
    found = _sign(here, lines)
    if found in "}]" and found and found != _CLOSER.get(sign):
        return _at(
            here,
            Words(
                f"“{found}”之前缺少“{_CLOSER.get(sign, '')}”",
                f"'{_CLOSER.get(sign, '')}' is missing before this '{found}'",
            ),
        )
    if _is_open(opened, lines):
        return _at(
            opened,
            Words(
                f"此处的“{sign}”没有用“{_CLOSER.get(sign, '')}”闭合",
                f"the '{sign}' opened here is not closed with '{_CLOSER.get(sign, '')}'",
            ),
        )
    return _at(
        here,
        Words(
            "此处之前缺少逗号；含逗号或冒号的文本要加引号",
            "a comma is missing before this; a text with a comma or a colon goes between quotes",
        ),
    )


def _is_open(opened: Misread, lines: list[str]) -> bool:
    """Whether the bracket finds no partner before the next key at the left margin."""
    depth = 0
    for number in range(opened.line, len(lines)):
        line = lines[number]
        if number > opened.line and _TOP_KEY.match(line):
            return True
        bare = re.sub(r"\"[^\"]*\"|'[^']*'|(?:^| )#.*", "", line[opened.column if number == opened.line else 0 :])
        depth += sum(bare.count(sign) for sign in "{[") - sum(bare.count(sign) for sign in "}]")
        if depth <= 0:
            return False
    return True


def _no_colon(opened: Misread, lines: list[str]) -> Misread:
    line = lines[opened.line]
    if found := _KEY_WITHOUT_SPACE.fullmatch(line):
        return _spaced(opened.line, found, line)
    return _at(
        opened,
        Words(
            f"“{line.strip()[:40]}”之后缺少“: ”；应写成“键: 值”，列表各项以“- ”开头",
            f"': ' is missing behind '{line.strip()[:40]}'; write 'key: value', or begin an item of a list with '- '",
        ),
    )


def _spaced(number: int, found: re.Match[str], line: str) -> Misread:
    return Misread(
        Words(
            f"冒号后缺少空格；请写 {found[1]}: {found[2][:40]}",
            f"a space is missing behind the ':'; write {found[1]}: {found[2][:40]}",
        ),
        number,
        line.index(":"),
    )


def _block(here: Misread, problem: str, lines: list[str]) -> Misread:
    """A second colon, a stray bracket, text behind a quote, or an indentation that fits nothing above."""
    line = lines[here.line] if here.line < len(lines) else ""
    found = line[here.column : here.column + 1]
    if found in ("}", "]"):
        return _at(
            here,
            Words(
                f"多余的“{found}”；没有与之对应的左括号",
                f"this '{found}' is one too many; no bracket was opened for it",
            ),
        )
    before = line[: here.column]
    if "mapping values" in problem and re.search(r":\s", before):
        return _at(
            here,
            Words("一行中有第二个冒号；请将文本放在引号内", "a second ':' on this line; put the text between quotes"),
        )
    if before.rstrip().endswith(('"', "'")) and "scalar" in problem:
        return _at(
            here,
            Words(
                "引号之后还有文本；请将全部文本放在引号内",
                "text behind the closing quote; put all of it between quotes",
            ),
        )
    above = next((n for n in range(here.line - 1, -1, -1) if lines[n].strip()), None)
    if above is not None and (spaced := _KEY_WITHOUT_SPACE.fullmatch(lines[above])):
        return _spaced(above, spaced, lines[above])
    if "block" in problem or "mapping values" in problem:
        return _indented(here.line, lines)
    return here


def _indented(number: int, lines: list[str]) -> Misread:
    here, fits = _indent(lines[number]), list[int]()
    for line in reversed(lines[:number]):
        if line.strip() and not line.lstrip().startswith("#") and (not fits or _indent(line) < fits[-1]):
            fits.append(_indent(line))
    if here in fits or not fits:
        return Misread(_FALLBACK, number, here)
    zh, en = " 或 ".join(map(str, reversed(fits))), " or ".join(map(str, reversed(fits)))
    return Misread(
        Words(
            f"此行缩进 {here} 个空格，与上面各行不合；应缩进 {zh} 个空格",
            f"this line is indented by {here} space{'s' * (here != 1)}, which fits none of the lines above; "
            f"indent it by {en}",
        ),
        number,
        here,
    )


def _indent(line: str) -> int:
    return len(line) - len(line.lstrip(" "))
