"""Numbers that stand in one line and are gone on with in others: printed alike in all of them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from math import isclose, isfinite, log10

from ..algebra.columns import significant
from ..algebra.formula import Node, Row, Sym, Txt, named
from ..algebra.quantity import number
from ..algebra.worked import goes_on, numbers_of, reckoned_again, scale_of, size_of, told_again
from ..answer import YES_NO, Answer
from .digits import MOST, decimals, leads_with_1, places_as_read, rounded
from .lengths import is_length, only_length
from .units import printed_unit

NUMBER = re.compile(r"(−?)\d+(?:\.\d+)?(?:×10\^\{−?\d+\})?")  # as `number` writes it
EQUALS, ABOUT = " = ", " ≈ "
_FINE, _FEW = 5, 3  # figures of a number that is carried on, at most; of one that goes on with an answer, at least
_WHOLE = 100.0  # from there on a number is told to its ones at least
_NEAR = 0.01  # share by which what printed numbers give may differ from what the drawing goes on with


class Told:
    """The numbers of asked quantities as they are printed; of others as the lines need them that go on with them."""

    def __init__(self, answers: Iterable[Answer]) -> None:
        asked = (one for one in answers if not one.is_place and not one.undefined and one.reading.unit != YES_NO)
        self._by_symbol = {named(one.reading.symbol): one for one in asked if isfinite(one.drawn)}
        self._carried: dict[Node, tuple[float, str]] = {}  # of what is not asked: its size, its number
        self._finer: dict[Node, str] = {}  # of what is asked, and gone on with to more figures than it is answered
        self._later: dict[Node, list[tuple[Row, str]]] = {}  # the lines that go on with it, and their ends

    def carry(self, lines: Sequence[tuple[Row, Txt | None]]) -> None:
        """Learn how what is not asked is printed: from the last line to the first, for a number that is told to more
        figures needs more figures of those that it is worked out from. None: the line has its own end."""
        needed: dict[Node, tuple[float, str]] = {}
        for line, end in reversed(lines):
            if line.worked is None:
                continue
            if end is None:
                self._own(line, needed)
            shown = number_at_the_end(self._end(line, end))
            if shown is None:
                continue
            for symbol, value, text in numbers_of(line, shown, self._told):
                self._refine(symbol, value, text)
            for symbol, value, text in numbers_of(line, shown, self._told):
                self._later.setdefault(symbol, []).append((line, shown))
                if isinstance(symbol, Sym) and _figures(text) > _figures(needed.get(symbol, (0.0, ""))[1]):
                    needed[symbol] = abs(value), text
        given = needed.keys() - self._carried.keys() - self._by_symbol.keys()  # no line of the steps works these out
        self._carried |= {symbol: needed[symbol] for symbol in given if _figures(needed[symbol][1]) <= _FINE}

    def _refine(self, symbol: Node, value: float, text: str) -> None:
        """Learn of an answer with which a line goes on with guard figures, that its own line must tell them."""
        answer, told = self._by_symbol.get(symbol), self._told(symbol, value).lstrip("−")
        if answer is None or answer.computed or not told or not _figures(told) < _figures(text) <= _FINE:
            return
        self._finer[symbol] = max(self._finer.get(symbol, ""), text, key=_figures)

    def _own(self, line: Row, needed: dict[Node, tuple[float, str]]) -> None:
        """The number of a line that is not asked: to the scale that it is read to, or as fine as it is gone on with."""
        symbol, shown = line.items[0], number_at_the_end(line.items[-1])
        if shown is None or not isinstance(symbol, Sym) or symbol in self._by_symbol:
            return
        size = size_of(line)
        read = _to_scale(line, size)
        text = read or shown.lstrip("−")
        wanted, finer = needed.get(symbol, (size, text))
        if isclose(wanted, size, rel_tol=1e-9) and _figures(text) < _figures(finer) <= _FINE:
            text = finer
        self._carried[symbol] = size, text
        few = significant(size, _FEW + leads_with_1(size))
        self._fewer(line, symbol, () if read or size >= _WHOLE or _figures(few) >= _figures(text) else (few,))

    def _fewer(self, line: Row, symbol: Node, short: tuple[str, ...]) -> None:
        """A number with the figures of a reading where later lines need no more. One that its line gives only with
        guard figures of an answer, as the answer gives it: an answer has one number, 3.02² × 0.12 = 1.094 and not
        3.025² × 0.12 = 1.098; as it is where later lines need it so."""
        (size, text), users = self._carried[symbol], self._later.get(symbol, [])
        sign = "−" if (number_at_the_end(line.items[-1]) or "").startswith("−") else ""
        reckoned, given = abs(reckoned_again(line, self._told)), goes_on(line, sign + text, self._told)
        near = (number(reckoned),) if not given and isclose(reckoned, size, rel_tol=_NEAR) else ()
        for few in (*short, *near, *(() if given else (number(size, _FEW),))):
            self._carried[symbol] = size, few
            if goes_on(line, sign + few, self._told) and all(goes_on(*one, self._told) for one in users):
                return
        self._carried[symbol] = size, text

    def _end(self, line: Row, end: Txt | None) -> Node:
        """The end of a line: this one, or its own with the number as it is carried on."""
        last = self._guarded(line, end) or line.items[-1]
        carried = self._carried.get(line.items[0]) if end is None else None
        if carried is None or not isinstance(last, Txt) or line.worked is None:
            return last
        size, text = carried
        if not isclose(size, size_of(line), rel_tol=1e-9):
            return last
        return Txt(NUMBER.sub(lambda found: found[1] + text, last.text, count=1))

    def _guarded(self, line: Row, end: Txt | None) -> Txt | None:
        """The end of an answer's line, after the number that later lines go on with: 3.126 rad/s ≈ 3.13 rad/s."""
        finer = self._finer.get(line.items[0])
        if end is None or line.worked is None or finer is None or end.text.count(EQUALS) != 1:
            return end
        if not isclose(abs(self._by_symbol[line.items[0]].drawn), size_of(line), rel_tol=1e-9):
            return end
        result = end.text.removeprefix(EQUALS)
        return Txt(f"{EQUALS}{NUMBER.sub(lambda found: found[1] + finer, result, count=1)}{ABOUT}{result}")

    def line(self, line: Row, end: Txt | None) -> Row:
        """The line with this end, or with its own; what is not worked out, or goes on with nothing asked, as it is."""
        if end is None and line.worked is None:
            return line
        last = self._end(line, end)
        shown = number_at_the_end(last)
        if line.worked is None or not isinstance(last, Txt) or EQUALS not in last.text:
            return Row((*line.items[:-1], last))
        return Row((*line.items[:-1], last)) if shown is None else told_again(line, last, shown, self._told)

    def _told(self, symbol: Node, value: float) -> str:
        """The number as it is printed elsewhere; nothing of another, or of one that is gone on with otherwise."""
        answer = self._by_symbol.get(symbol)
        if answer is not None:
            if not isclose(abs(value), abs(answer.drawn), rel_tol=1e-9):
                return ""
            finer = self._finer.get(symbol)
            return ("−" if value < 0 else "") + finer if finer else number_of(answer, value, 1.0)
        size, text = self._carried.get(symbol, (0.0, ""))
        return ("−" if value < 0 else "") + text if text and isclose(abs(value), size, rel_tol=1e-9) else ""


def number_at_the_end(end: Node) -> str | None:
    """The number with which a line ends; None where it ends with none."""
    if not isinstance(end, Txt) or EQUALS not in end.text:
        return None
    found = NUMBER.match(end.text.split(EQUALS)[1])
    return found[0] if found else None


def number_of(answer: Answer, value: float, scale: float) -> str:
    """A value with the digits of the answer, in a unit of which the SI unit has so many."""
    places, factor = decimals(answer), printed_unit(answer.reading.unit)[0]
    return rounded(value, None if places is None else max(0, places + round(log10(factor / scale))), MOST)


def _to_scale(line: Row, size: float) -> str:
    """What was read on paper, or worked out from one length alone, with its figures; nothing of another line."""
    scale, mm = scale_of(line) if is_length(line) else None, only_length(line)
    length = size / scale if scale else mm or 0.0
    return rounded(size, places_as_read(size, length), MOST) if length and size else ""


def _figures(text: str) -> int:
    """How many significant figures a number has."""
    return len(text.partition("×")[0].replace(".", "").lstrip("0"))
