"""The box for one's own answers: what the page needs to tell right, close or wrong, and why, without anything solved.

The right values, with T and those of every slip, stand in the page in base 64: nobody reads them by accident.
"""

from __future__ import annotations

import json
from base64 import b64encode
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from ..algebra.quantity import number
from ..grading.compare.band import target_of
from ..grading.derive.keyed import answer_key
from ..grading.key import AnswerKey, Graded, Kind
from ..grading.marking.causes import FAR
from ..grading.marking.solutions import other_keys
from ..grading.reading.direction import WIND, WINDS
from ..grading.rules import USUAL_RULES
from ..grading.slips.mutants import Mutant, mutants
from ..grading.slips.single import POWERS, mistaken_for
from ..grading.slips.whole import LONE, MARGIN, mutated
from ..grading.told.catalogue import SENTENCES
from ..grading.told.message import Message, message
from ..grading.told.named import Told
from ..grading.told.slip import told_of
from ..names import written_unit
from ..printed.units import printed_unit
from ..problem.problem import Problem
from ..tagging.speech import spoken
from ..tagging.units_said import unit_said
from ..words import Words
from .figures import LANGS
from .following import Following, followings
from .setting.type import Faces, html, words_html

KINDS = (Kind.VECTOR, Kind.SIGNED, Kind.SCALAR)
ALWAYS = (
    Told.RIGHT, Told.NEARLY, Told.NOT_RIGHT, Told.SENSE, Told.SENSE_MISSING, Told.SIGN, Told.POW10, Told.TURNS,
    Told.PER_MINUTE, Told.DEGREES, Told.TWO_SLIPS, Told.ZERO, Told.REVERSED, Told.DIRECTION, Told.OTHER_SOLUTION,
)  # fmt: skip
UNREAD = Words("请写一个数", "write a number")
OWN = Words(*(SENTENCES[Told.OK_OWN].of(lang).replace("${src}$", "{src}") for lang in LANGS))  # the script has symbols


@dataclass(frozen=True, slots=True, kw_only=True)
class Question:
    """One quantity that may be answered: its symbol and unit as they are printed; said: as they are read out; turns: it
    has a sense; points: a direction."""

    key: str
    symbol: str
    unit: str
    said: Words
    turns: bool
    points: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class Box:
    """questions: in the order of the sheet. sentences: name → what may be told; data: of the script, in base 64."""

    questions: tuple[Question, ...]
    sentences: tuple[tuple[str, Words], ...]
    data: str


def box(problem: Problem, faces: Faces) -> Box:
    """The box of a problem. Raises what `answer_key` raises."""
    key = answer_key(problem)
    asked = [one for one in key.quantities if one.asked and one.kind in KINDS]
    slips = mutants(problem, key)
    said = {name.value: html(SENTENCES[name], faces) for name in ALWAYS} | {"unread": html(UNREAD, faces)}
    said |= {Told.OK_OWN.value: html(OWN, faces)}
    follows = followings(problem, key, asked)
    rows = [_Row(one, key, slips, said, faces).data(its) for one, its in zip(asked, follows, strict=True)]
    allowance = key.allowance
    rule = {
        "lone": LONE, "margin": MARGIN, "far": FAR, "k": allowance.k, "wrong": allowance.wrong,
        "turned": allowance.direction, "short": allowance.short, "reach": USUAL_RULES.reach, "rows": rows,
        "solutions": [[n, _valued(other, asked)] for n, other in other_keys(problem, key)],
        "wind": WIND.pattern, "winds": [[one.degrees, one.reach] for one in WINDS],
    }  # fmt: skip
    data = b64encode(json.dumps(rule, separators=(",", ":")).encode()).decode()
    return Box(questions=tuple(_question(one, faces) for one in asked), sentences=tuple(said.items()), data=data)


def _valued(key: AnswerKey, asked: Sequence[Graded]) -> list[dict[str, float]]:
    """What another solution makes of the rows, in the units in which they are asked."""
    pairs = ((key[one.key], printed_unit(one.unit)[0]) for one in asked)
    return [
        {"x": times * one.exact, "t": times * one.allowed, "near": one.allowed / abs(one.exact) if one.exact else 1.0}
        for one, times in pairs
    ]


def _question(one: Graded, faces: Faces) -> Question:
    unit = written_unit(printed_unit(one.unit)[1])
    said = Words(*(f"{spoken(one.symbol, lang)}, {unit_said(unit, lang) or ''}".rstrip(", ") for lang in LANGS))
    return Question(
        key=one.key, symbol=words_html(f"${one.symbol}$", faces), unit=words_html(unit, faces), said=said,
        turns=one.kind is Kind.SIGNED, points=one.degrees is not None,
    )  # fmt: skip


def _following(one: Following | None) -> dict[str, Any] | None:
    if one is None:
        return None
    factors = [[float(f"{part:.6g}") for part in (each.real, each.imag)] for each in one.factors]
    return {"from": one.sources, "terms": one.terms, "factors": factors, "share": one.share, "sizes": one.sizes}


class _Row:
    """What the script knows of one quantity, in the unit in which it is asked."""

    def __init__(
        self, one: Graded, key: AnswerKey, slips: Sequence[Mutant], said: dict[str, Words], faces: Faces
    ) -> None:
        self.one, self.key, self.slips, self.said, self.faces = one, key, slips, said, faces
        self.times = printed_unit(one.unit)[0]

    def data(self, follows: Following | None) -> dict[str, Any]:
        one = self.one
        return {
            "kind": one.kind.name[:2].lower(), "x": self._size(one.exact), "t": self._size(one.allowed),
            "near": one.allowed / abs(one.exact) if one.exact else 1.0, "unit": one.unit,
            "powers": POWERS.get(one.unit, ()),
            "size": one.unsigned, "deg": one.degrees, "mm": one.mm, "scatter": one.turned,
            "follows": _following(follows), "slips": list(self._slips()), "others": list(self._others()),
            "shown": f"{number(self.times * one.exact, 4)} ± {number(self.times * one.allowed, 2)}",
        }  # fmt: skip

    def _slips(self) -> Iterator[tuple[float, float, str, bool]]:
        for mutant in self.slips:
            if self.one.key in mutant.values:
                target = mutated(self.one, mutant, self.key.allowance)
                yield (
                    self._size(target.value),
                    self._size(target.allowed),
                    self._name(told_of(mutant.slip, mutant.also)),
                    mutant.slip.key == self.one.key,
                )

    def _others(self) -> Iterator[tuple[float, float, str]]:
        for other in mistaken_for(self.one, self.key):
            said = message(Told.SWAPPED, other=other.symbol)
            yield self._size(target_of(other).value), self._size(other.allowed / 2), self._name(said)

    def _name(self, said: Message) -> str:
        """The name under which the page holds a sentence, each once."""
        words = html(said.words, self.faces)
        known = next((name for name, one in self.said.items() if one == words), None)
        name = known or f"s{len(self.said)}"
        self.said[name] = words
        return name

    def _size(self, value: float) -> float:
        return float(f"{self.times * value:.6g}")
