"""vecpoly check 3-12 v_D=0.49 ω5=4.72: one's own answers to a problem, each with its verdict and its reason."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from ...errors import UnknownNameError
from ...words import Lang, Words, bare
from ..errors import DISAGREES, REFUSED, Tally
from ..files import STDOUT, spared, write_json
from ..jobs import problems
from ..options import JSON
from ..terminal import add, say, show, table, working

if TYPE_CHECKING:
    from ...grading.student import Checked

_CLAIM = re.compile(r"[^\W\d][\w^{}′']*\s*[=≈≅:](?![\\/])")  # v_D≈0.49, and no drive of a path
_SYMBOL = re.compile(r"[^\W\d][\w^{}′']*")
_NUMBER = re.compile(r"[-+−±≈]?\d*[.,]?\d+(?:[eE][-+]?\d+)?(?:\s*[^\W\d].*|\s*[°∠].*)?")  # 0.173 m/s, and no 3-9
_COLUMNS = {"zh": ("量", "所写", "结论", "缘由"), "en": ("quantity", "written", "verdict", "reason")}


def claims_among(names: Sequence[str]) -> list[str]:
    """The answers among the arguments: with an equals sign, or what stands for one behind a symbol, and no file."""
    from ...grading.reading.characters import plain

    return [name for name in names if ("=" in name or _CLAIM.match(plain(name))) and not Path(name).exists()]


def with_equals(names: Sequence[str]) -> list[str]:
    """The arguments as they are meant: an answer without its sign, ``v_E 0.173``, in one argument or in two, has one;
    what is a problem or a file stays as it is. Raises UnknownNameError for a number of nothing."""
    found: list[str] = []
    for name in names:
        symbol, blank, value = name.strip().partition(" ")
        if found and _NUMBER.fullmatch(name) and _is_symbol(found[-1]) and not _is_problem(name):
            found[-1] += f"={name}"
        elif blank and _is_symbol(symbol) and any(map(str.isdigit, value)) and "=" not in name:
            found.append(f"{symbol}={value.strip()}")
        elif _NUMBER.fullmatch(name) and not _is_problem(name):
            raise UnknownNameError(
                Words(
                    f"{name} 是哪个量的值？请写 v_E={name}", f"of which quantity is {name} the value? write v_E={name}"
                )
            )
        else:
            found.append(name)
    return found


def _is_symbol(name: str) -> bool:
    return bool(_SYMBOL.fullmatch(name)) and not _is_problem(name)


def _is_problem(name: str) -> bool:
    from ...problem.library import family, find

    return Path(name).exists() or find(name) is not None or bool(family(name))


def check_claims(
    names: Sequence[str], claims: Sequence[str], tally: Tally, json: Path | None, lang: Lang, outside: bool
) -> None:
    """Check these answers to the one problem that is named; exit code 1 where one is not right."""
    rest = [name for name in names if name not in claims]
    if len(rest) != 1:
        raise UnknownNameError(
            Words(
                f"{'、'.join(claims)} 是哪道题的答案？题目与答案同写时只写一道题，这里有 {len(rest)} 道",
                f"of which problem is {', '.join(claims)} the answer? name one problem beside answers; "
                f"here are {len(rest)}",
            )
        )
    found = problems(rest, tally, outside)
    tally.settle()
    if len(found) != 1:
        raise UnknownNameError(
            Words(
                f"{rest[0]} 有 {len(found)} 道题；答案只与一道题同写",
                f"{rest[0]} has {len(found)} problems; name one of them beside answers",
            )
        )
    spared(json, JSON, found)
    from ...grading.student import check_answers

    with working(Words("核对各答案，逐一试算常见错误", "checking, and trying the usual mistakes")):
        checked = check_answers(found[0], claims)
    if json != STDOUT:
        _print(checked, lang)
    if json is not None:
        write_json(checked.as_json(), json)
    if any(one.outcome.for_a_person for one in checked.answers):
        raise typer.Exit(REFUSED)
    if not checked.right:
        raise typer.Exit(DISAGREES)


def _print(checked: Checked, lang: Lang) -> None:
    from ...grading.student import is_right
    from ...report.values import called

    title = f"{checked.problem.id}  {bare(checked.problem.title.of(lang))}"
    made = table(title, [(name, "left") for name in _COLUMNS[lang]])
    fine = [is_right(one) for one in checked.answers]
    fine += [one.outcome.is_right for one in checked.ticked]
    names = [bare(called(checked.marked.key[one.key].symbol, one.key, lang)) for one in checked.answers]
    names += [one.row.key for one in checked.ticked]
    for name, row, right in zip(names, checked.rows(lang), fine, strict=True):
        add(made, (name, *row[1:]), alarmed=not right)
    show(made)
    for words in checked.said:
        say(words.of(lang))
