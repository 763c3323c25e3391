"""Somebody's answers to one problem, checked at once: right, close, or wrong with a reason."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from ..answer import plain
from ..errors import ArgumentError, UnknownNameError
from ..foundation.arguments import of_kind
from ..foundation.slotted import replace
from ..names import Rel, parse_rel
from ..problem.asked.asks import AskRel
from ..problem.problem import Problem
from ..words import Lang, Words, bare, language
from .compare.outcome import Finding
from .derive.keyed import answer_key
from .equations.mark import EquationMark
from .key import AnswerKey
from .marking.marked import Marked
from .marking.marker import mark
from .reading.symbol import keyed, squeezed
from .sheet import sheet_of
from .slips.mutants import mutants
from .told.alone import alone, has_wrong_unit
from .told.message import Message
from .told.named import Told

_WRONG_UNIT = Words("单位错", "wrong unit")
_EQUALS = re.compile(r"[=＝≈≅:：]")
_SPACED = re.compile(r"([^\W\d][\w^{}′']*)\s+(?=.*\d)(.+)")  # v_E 0.173, ω_3 cw 1.46
_STEM = re.compile(r"(omega|alpha|an|at|ak|ar|v|a|p)(?=[A-Z]|\d)(.+)")


@dataclass(frozen=True, slots=True, kw_only=True)
class Checked:
    """Answers to a problem with a verdict on each."""

    problem: Problem
    marked: Marked

    @property
    def answers(self) -> tuple[Finding, ...]:
        """What was written, each with its outcome and its sentences."""
        return tuple(one for one in self.marked.findings if one.written.raw)

    @property
    def right(self) -> bool:
        """Whether all of it is right."""
        return all(map(is_right, self.answers)) and all(one.outcome.is_right for one in self.ticked)

    @property
    def ticked(self) -> tuple[EquationMark, ...]:
        """The rows of equations that were filled in."""
        return tuple(one for one in self.marked.equations if one.raw.strip())

    def __str__(self) -> str:
        """One line for each answer: symbol, what was written, verdict, reason."""
        rows = ["  ".join(row) for row in self.rows(language())]
        return "\n".join((*rows, *(words.of(language()) for words in self.said)))

    def rows(self, lang: Lang) -> list[tuple[str, str, str, str]]:
        """Symbol, what was written, verdict, reason."""
        return [
            (bare(self.marked.key[one.key].symbol), one.written.raw, _verdict(one).of(lang), _said(one.messages, lang))
            for one in self.answers
        ] + [(one.row.key, one.raw, one.outcome.words.of(lang), _said(one.messages, lang)) for one in self.ticked]

    @property
    def said(self) -> tuple[Words, ...]:
        """What is said of the whole: that its solutions are numbered otherwise, or that another one is answered."""
        whole = (Told.RENUMBERED, Told.OTHER_SOLUTION)
        return tuple(one.words for one in self.marked.messages if one.id in whole)

    def as_json(self) -> dict[str, Any]:
        """Plain data."""
        told = [one for one in self.marked.as_json()["answers"] if one["written"]]
        kept = ("key", "written", "outcome", "basis", "value", "off", "messages")
        data = {
            "id": self.problem.id,
            "right": self.right,
            "answers": [
                {name: one[name] for name in kept} | {"right": is_right(self.marked[one["key"]])} for one in told
            ],
            "equations": [one.as_json() for one in self.ticked],
            **({"said": [{"zh": words.zh, "en": words.en} for words in self.said]} if self.said else {}),
        }
        return {name: plain(value) for name, value in data.items()}


def check_answers(problem: Problem, answers: Mapping[str, str | float] | Iterable[str]) -> Checked:
    """Check answers, ``{"v_D": "0.49", "ω5": "4.72 顺"}`` or ``["v_D=0.49"]``, also of quantities that were not asked
    for.

    Each is held against the exact value within what a drawing may be off by, then against what follows from the other
    answers, then against every slip that can be made. Raises UnknownNameError for a symbol that the problem does not
    have, ArgumentError for what is no answer, and what `solve` raises.
    """
    of_kind(problem, Problem, Words("题目（load 或 loads 的结果）", "a problem, as load and loads give it,"))
    given = _split(answers)
    key, problem = _key_for(problem, tuple(given))
    _refuse_twice(given, [one.key for one in key.quantities])
    sheet = sheet_of(key, given)
    marked = mark(problem, key, lambda: mutants(problem, key), sheet)
    findings = tuple(replace(one, messages=alone(one.messages)) for one in marked.findings)
    return Checked(problem=problem, marked=replace(marked, findings=findings))


def is_right(one: Finding) -> bool:
    """Whether an answer is right by itself: its number, and its unit."""
    return one.is_right and not has_wrong_unit(one.messages)


def _verdict(one: Finding) -> Words:
    return _WRONG_UNIT if one.is_right and not is_right(one) else one.outcome.words


def _split(answers: Mapping[str, str | float] | Iterable[str]) -> dict[str, str | float | None]:
    """Symbol → what was written."""
    if isinstance(answers, Mapping):
        return dict(answers)
    found: dict[str, str | float | None] = {}
    for text in answers:
        symbol, value = parted(text)
        if not symbol or not value:
            raise ArgumentError(
                Words(f"“{text}”不是答案；请写 v_D=0.49", f"'{text}' is no answer; write v_D=0.49"), code="answer"
            )
        if symbol in found:
            raise _twice(symbol)
        found[symbol] = value
    return found


def _refuse_twice(symbols: Iterable[str], keys: list[str]) -> None:
    """ArgumentError where two symbols mean one quantity: ω_3 and w3."""
    met = set[str]()
    for symbol in symbols:
        try:
            meant = keyed(symbol, keys)
        except UnknownNameError:  # a scale, a row of an equation
            meant = squeezed(symbol)
        if meant in met:
            raise _twice(symbol)
        met.add(meant)


def _twice(symbol: str) -> ArgumentError:
    return ArgumentError(
        Words(f"{symbol} 写了两次；请只留一个", f"{symbol} is given twice; leave one of them"), code="twice"
    )


def parted(text: str) -> tuple[str, str]:
    """The symbol and the value of ``v_D=0.49``, also with ≈, a colon or a blank; two blanks where it is no answer."""
    symbol, *value = _EQUALS.split(text, maxsplit=1)
    if not value and (spaced := _SPACED.fullmatch(text.strip())):
        symbol, value = spaced[1], [spaced[2]]
    return (symbol.strip(), value[0].strip()) if value else ("", "")


def _key_for(problem: Problem, symbols: tuple[str, ...]) -> tuple[AnswerKey, Problem]:
    """The key, and the problem with what else is answered asked for too."""
    key = answer_key(problem)
    asked_first = sorted(key.quantities, key=lambda one: not one.asked)
    known = [one.key for one in asked_first] + list(key.scales) + [row.key for row in key.equations]
    more = [rel for symbol in symbols if (rel := _unasked(symbol, known)) is not None]
    if not more:
        return key, problem
    asked = replace(problem, asks=(*problem.asks, *(AskRel(rel=rel) for rel in more)))
    return answer_key(asked), asked


def _unasked(symbol: str, known: list[str]) -> Rel | None:
    """The quantity that a symbol of no key names; raises UnknownNameError, with the nearest, where there is none."""
    try:
        keyed(symbol, known)
    except UnknownNameError as unknown:
        found = _STEM.fullmatch(squeezed(symbol))
        if found is None or unknown.code == "ambiguous-symbol":
            raise
        try:
            return parse_rel(f"{found[1]}_{found[2]}")
        except UnknownNameError:
            raise unknown from None
    return None


def _said(messages: Iterable[Message], lang: Lang) -> str:
    return ("；" if lang == "zh" else "; ").join(bare(said.words.of(lang)) for said in messages)
