"""The sentences as a table of marks has them, whose columns tell already what is right."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ...words import Words
from .message import Message
from .named import Told

_IN_TABLE: Mapping[Told, Words] = {
    Told.OK: Words("误差 {e} mm，允许 ±{t} mm", "Error {e} mm, allowed ±{t} mm"),
    Told.OK_RECKONED: Words("误差 {e}，允许 ±{t}", "Error {e}, allowed ±{t}"),
    Told.OK_ROUNDED: Words(
        "误差 {e}；允许 ±{t}，按所写末位放宽到 ±{w}", "Error {e}; allowed ±{t}, and ±{w} with the last digit written"
    ),
    Told.DEMOTED: Words("手工作图散布 ±{t}（{share}%）*", "Drawings scatter by ±{t} ({share} %)*"),
    Told.MANY_DIGITS: Words("{n} 位†", "{n} digits†"),
    Told.RIGHT: Words.same(""),
    Told.BLANK: Words.same(""),
}
SCATTERED = Words(
    "* 此处作图对误差极敏感，不能判得更细；此量宜计算求得。",
    "* Drawings scatter so much here that it can be judged no more finely; it is better computed.",
)

PRECISE = Words(
    "† 有效数字太多：图上量得的长度只有 3 位左右，结果宜取 3 位。",
    "† Too many significant digits: a length read off a drawing has about 3, and so should what comes of it.",
)


def brief(said: Sequence[Message]) -> tuple[Words, ...]:
    """The sentences in short, each once; what the verdict says is left out."""
    found = dict.fromkeys(one.filled(_IN_TABLE[one.id]) if one.id in _IN_TABLE else one.words for one in said)
    return tuple(words for words in found if words.en)


def notes(said: Sequence[Message]) -> tuple[Words, ...]:
    """The sentences below the table that its marks point to, each once."""
    met = {one.id for one in said}
    return tuple(words for told, words in ((Told.DEMOTED, SCATTERED), (Told.MANY_DIGITS, PRECISE)) if told in met)
