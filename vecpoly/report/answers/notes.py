"""The notes at the foot of the box of answers: what was concluded, and what could hardly be read; each is said once, of
all the quantities of which it holds."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from ...algebra.quantity import number
from ...board.said.short import TOO_SHORT
from ...printed.digits import coarse, is_hopeless, on_paper
from ...solution import Answer, Solution
from ...words import Lang, Words, stopped
from ..values import is_worded
from .placed import clean

# keys of conditions whose yes says all: their reason is in the steps
PLAIN = frozenset({"determined", "v_allowed", "static", "dynamic"})
PLAIN_NO = frozenset({"undercut"})  # and those of which a no does
UNREADABLE = Words(
    "误差达读数的一半以上，按本图的比例尺读不准", "not to be read at this scale, with an error of half of it or more"
)
INSTEAD = Words("取精确值", "take the exact value")
_READ_BY = Words("图上量取所用比例尺：", "Read off with ")
COARSE = Words("读数误差可达", "reading error up to")


def notes_of(answers: Sequence[Answer], lang: Lang) -> tuple[str, ...]:
    """The notes of these answers, a line each; what is read coarsely, or not at all, is marked in their table."""
    return (*_remarks(answers, lang), *_short(answers, lang))


def scales_of(answers: Iterable[Answer], solution: Solution, lang: Lang) -> tuple[str, ...]:
    """By which scales lengths on paper became answers; nothing where none did."""
    used = {one.reading.scale for one in answers if one.reading.mm is not None and not one.computed}
    every = [scale for one in solution.construction.figures for scale in (one.scale, one.scale.right)]
    scales = {scale.symbol: scale.told for scale in every if scale.symbol in used}
    told = [f"${symbol}$ = {number(scale.value)} {scale.per_mm}" for symbol, scale in scales.items() if symbol]
    return (f"{_READ_BY.of(lang)}{_listed(told, lang)}",) if told else ()


def remark_of(answer: Answer, lang: Lang) -> str:
    """The conclusion that the construction came to, with no full stop; nothing of most."""
    remark = answer.reading.remark
    if remark is None or answer.key in (PLAIN if answer.drawn else PLAIN_NO):
        return ""
    return remark.of(lang).strip().rstrip("。.")


def stands_still(answer: Answer) -> bool:
    """Whether it is the ω or α of a link that only translates, or a Coriolis term that does not exist, beside whose 0
    that is said."""
    turns = answer.reading.unit.startswith("rad/s") or answer.key.startswith("ak_")
    return answer.reading.remark is not None and turns and not answer.drawn


def error_of(answer: Answer) -> str:
    """By how much a coarse reading may be off, of its value: ±17 %; nothing where that need not be told."""
    share = coarse(answer)
    return "" if share is None or is_hopeless(answer) else f"±{100 * share:.0f} %"


def unread_words(answers: Iterable[Answer], lang: Lang) -> str:
    """Which of them could not be read, in a sentence; nothing where all could."""
    named = [f"${one.reading.symbol}$" for one in answers if is_hopeless(one) and clean(one)]
    if not named:
        return ""
    return Words(
        f"{'、'.join(named)} 的{UNREADABLE.zh}，不计偏差。",
        f"{' and '.join(named)}: {UNREADABLE.en}; no deviation is told.",
    ).of(lang)


def _remarks(answers: Iterable[Answer], lang: Lang) -> Iterator[str]:
    found = dict[str, list[str]]()
    for one in answers:
        if (text := remark_of(one, lang)) and not stands_still(one):
            found.setdefault(text, []).append(_symbol(one))
    for text, symbols in found.items():
        named = _listed(filter(None, symbols), lang)
        yield f"{named}{_COLON[lang]}{text}" if named else stopped(text[:1].upper() + text[1:], lang)


def _symbol(answer: Answer) -> str:
    """What a remark is about; nothing where it says so itself."""
    return "" if is_worded(answer.key, answer.reading.unit) else f"${answer.reading.symbol}$"


def _short(answers: Sequence[Answer], lang: Lang) -> Iterator[str]:
    """What is too short on paper."""
    short = [f"${one.reading.symbol}$ {on_paper(one)} mm" for one in answers if one.short]
    if short:
        head = Words(f"图上{TOO_SHORT.zh}", f"{TOO_SHORT.en} on paper").of(lang)
        yield f"{head[0].upper()}{head[1:]}{_COLON[lang]}{_listed(short, lang)}"


_COLON: dict[Lang, str] = {"zh": "：", "en": ": "}


def _listed(symbols: Iterable[str], lang: Lang) -> str:
    return Words("、", ", ").of(lang).join(symbols)
