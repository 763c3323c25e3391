"""Claims about every sentence in the code, met by a test or not:
Chinese stands first, English second; each for its readers."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

import pytest

from tests.sources import nodes, sources, text

_EXAMPLE = re.compile(r"'[^']*'")  # between quotes: what the reader may write, in either language
FULL_WIDTH = re.compile("[\u3000-\u303f\uff00-\uffef]")
_HAN, _WORD = re.compile("[\u4e00-\u9fff]"), re.compile(r"\b[a-z]{4,}\b")


def literal(node: ast.expr) -> str:
    """What is written out of a text, with a blank for all that is filled in."""
    match node:
        case ast.Constant(value=str(text)):
            return text
        case ast.JoinedStr(values=parts):
            return " ".join(literal(part) for part in parts)
        case ast.FormattedValue(value=ast.IfExp() as chosen) if not by_language(chosen):
            return literal(chosen)
        case ast.IfExp(body=one, orelse=two) | ast.BinOp(left=one, right=two):
            return f"{literal(one)} {literal(two)}"
        case _:
            return " "


def by_language(node: ast.IfExp) -> str:
    """ "zh" where the body is for Chinese, "en" where it is for English,
    "" where the choice is not one of languages."""
    match node.test:
        case ast.Compare(
            left=ast.Name(id="lang") | ast.Attribute(attr="lang"),
            ops=[ast.Eq() | ast.NotEq() as op],
            comparators=[ast.Constant(value=str(which))],
        ):
            return which if isinstance(op, ast.Eq) else {"zh": "en", "en": "zh"}[which]
        case _:
            return ""


def chosen_wrongly(source: str) -> Iterator[tuple[int, str]]:
    """(line, text) of every choice by language that gives Chinese to English readers, or none to Chinese ones."""
    for node in nodes(source):
        if isinstance(node, ast.IfExp) and (which := by_language(node)):
            zh, en = (
                literal(part) for part in ((node.body, node.orelse) if which == "zh" else (node.orelse, node.body))
            )
            if (
                _HAN.search(en)
                or (FULL_WIDTH.search(en) and not FULL_WIDTH.search(zh))
                or (_WORD.search(zh) and not _HAN.search(zh) and en.strip())
            ):
                yield node.lineno, f"{zh} | {en}"


def misplaced(source: str) -> Iterator[tuple[int, str]]:
    """(line, text) of every sentence of which the English has a Chinese letter,
    or the Chinese has none and the English has words."""
    for node in nodes(source):
        if (
            isinstance(node, ast.Call)
            and isinstance(node.func, ast.Name)
            and node.func.id == "Words"
            and len(node.args) == 2
        ):
            zh, en = (_EXAMPLE.sub(" ", literal(arg)) for arg in node.args)
            if _HAN.search(en) or (_WORD.search(re.sub(r"\$[^$]*\$", " ", en)) and zh.strip() and not _HAN.search(zh)):
                yield node.lineno, f"{zh} | {en}"


def told_apart(source: str) -> Iterator[tuple[int, str]]:
    """(line, numbers) of every sentence that works a number out otherwise in one language than in the other; a language
    that chooses between two ways to say it may tell more."""
    for node in nodes(source):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "Words":
            told = [set(_numbers(arg)) for arg in node.args]
            chosen = any(isinstance(arg, ast.IfExp) for arg in node.args)
            if len(told) == 2 and told[0] != told[1] and not (chosen and (told[0] <= told[1] or told[1] <= told[0])):
                yield node.lineno, " | ".join(sorted(told[0] ^ told[1]))


def _numbers(sentence: ast.expr) -> Iterator[str]:
    """What is written with so many digits: `{1e3 * x:.4g}`."""
    for part in ast.walk(sentence):
        if isinstance(part, ast.FormattedValue) and part.format_spec is not None:
            digits = ast.unparse(part.format_spec)[2:-1]
            if digits.endswith(("g", "f", "e", "d")):
                yield f"{ast.unparse(part.value)}:{digits}"


@pytest.mark.parametrize(
    "text", ["Words('the link', '构件')", "Words(f'no link {x}', f'没有构件 {x}')", "Words('link', 'the link')"]
)
def test_languages_swapped_are_seen(text: str) -> None:
    assert (
        list(misplaced(text))
        and not list(misplaced("Words(f'没有构件 {x}', f'no link {x}')"))
        and not list(misplaced("Words(zh, en)"))
    )


@pytest.mark.parametrize(
    "text",
    [
        "Words('if' if a else 'when', '若' if a else '当')",
        'Words(f\'{"one" if a else "many"}\', f\'{"一" if a else "多"}\')',
        "Words('one' + x, '一' + x)",
    ],
)
def test_languages_swapped_are_seen_in_what_is_chosen_and_joined(text: str) -> None:
    assert list(misplaced(text))


@pytest.mark.parametrize(
    "text",
    [
        "'from' if lang == 'zh' else '自'",
        "'自' if lang != 'zh' else 'from'",
        "'自' if self.lang == 'en' else 'from'",
        "', ' if lang == 'zh' else '，'",
    ],
)
def test_a_language_chosen_wrongly_is_seen(text: str) -> None:
    assert (
        list(chosen_wrongly(text))
        and not list(chosen_wrongly("'自' if lang == 'zh' else 'from'"))
        and not list(chosen_wrongly("'自' if far else 'from'"))
    )


def test_who_reads_chinese_is_given_chinese_and_who_reads_english_english() -> None:
    choices = [node for file in sources() for node in nodes(text(file)) if isinstance(node, ast.IfExp)]
    assert sum(map(bool, map(by_language, choices))) > 30
    found = {f"{file}:{line}": said for file in sources() for line, said in chosen_wrongly(text(file))}
    assert not found, found


@pytest.mark.parametrize("text", ["Words(f'差 {1e3 * x:.4g}', f'off by {x:.4g}')", "Words(f'{x:.3g}', f'{x:.4g}')"])
def test_a_number_that_is_another_in_the_other_language_is_seen(text: str) -> None:
    assert list(told_apart(text))
    assert not list(told_apart("Words(f'差 {x:g}', f'{x:g} over' if x > 0 else f'{-x:g} under')"))


def test_every_number_is_worked_out_in_english_as_in_chinese() -> None:
    found = {f"{file}:{line}": said for file in sources() for line, said in told_apart(text(file))}
    assert not found, found


def test_chinese_stands_first_in_every_sentence_of_the_code() -> None:
    found = {f"{file}:{line}": said for file in sources() for line, said in misplaced(text(file))}
    assert not found, found
