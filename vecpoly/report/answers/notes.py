"""The notes at the foot of the box of answers: what was concluded, and what could hardly be read; each is said once, of
all the quantities of which it holds."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from ...board.said.short import TOO_SHORT
from ...printed.digits import coarse, is_hopeless, on_paper
from ...solution import Answer
from ...words import Lang, Words
from ..values import is_worded, value

# keys of conditions whose yes says all: their reason is in the steps
PLAIN = frozenset({"determined", "v_allowed", "static", "dynamic"})
PLAIN_NO = frozenset({"undercut"})  # and those of which a no does
UNREADABLE = Words(
    "误差达读数的一半以上，按本图的比例尺读不准", "not to be read at this scale, with an error of half of it or more"
)
INSTEAD = Words("应放大比例尺或用计算求得", "draw it larger, or compute it")
COARSE = Words("读数误差可达", "reading error up to")


def notes_of(answers: Sequence[Answer], lang: Lang) -> tuple[str, ...]:
    """The notes of these answers, a line each."""
    return (*_remarks(answers, lang), *_hardly(answers, lang))


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


def _remarks(answers: Iterable[Answer], lang: Lang) -> Iterator[str]:
    found = dict[str, list[str]]()
    for one in answers:
        if (text := remark_of(one, lang)) and not stands_still(one):
            found.setdefault(text, []).append(_symbol(one))
    for text, symbols in found.items():
        named = _listed(filter(None, symbols), lang)
        yield f"{named}{_COLON[lang]}{text}" if named else text[:1].upper() + text[1:]


def _symbol(answer: Answer) -> str:
    """What a remark is about; nothing where it says so itself."""
    return "" if is_worded(answer.key, answer.reading.unit) else f"${answer.reading.symbol}$"


def _hardly(answers: Sequence[Answer], lang: Lang) -> Iterator[str]:
    """What is too short on paper, or not to be read at all; the verdict of the check names what is read coarsely."""
    short = [f"${one.reading.symbol}$ {on_paper(one)} mm" for one in answers if one.short]
    lost = [_computed(one, lang) for one in answers if is_hopeless(one)]
    heads = (Words(f"图上{TOO_SHORT.zh}", f"{TOO_SHORT.en} on paper").of(lang), UNREADABLE.of(lang))
    for head, symbols in zip(heads, (short, lost), strict=True):
        if symbols:
            yield f"{head[0].upper()}{head[1:]}{_COLON[lang]}{_listed(symbols, lang)}"


def _computed(answer: Answer, lang: Lang) -> str:
    """What cannot be read, with its computed value."""
    told = value(answer.exact, answer.reading.unit, lang, answer.key)
    return Words(f"${answer.reading.symbol}$ 的计算值 {told}", f"${answer.reading.symbol}$, computed: {told}").of(lang)


_COLON: dict[Lang, str] = {"zh": "：", "en": ": "}


def _listed(symbols: Iterable[str], lang: Lang) -> str:
    return Words("、", ", ").of(lang).join(symbols)
