"""Numbers that stand in one line and are gone on with in others: printed alike in all of them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from math import floor, isclose, isfinite, log10

from ..algebra.columns import significant
from ..algebra.formula import Node, Row, Sym, Txt, named
from ..algebra.quantity import number
from ..algebra.rounding import read_back
from ..algebra.worked import goes_on, numbers_of, reckoned_again, scale_of, size_of, told_again
from ..answer import YES_NO, Answer
from .alike import of_both
from .digits import MOST, decimals, leads_with_1, places_as_read, rounded
from .lengths import is_length, only_length
from .units import printed_unit

NUMBER = re.compile(r"(−?)\d+(?:\.\d+)?(?:×10\^\{−?\d+\})?")  # as `number` writes it
EQUALS, ABOUT = " = ", " ≈ "
_FINE, _FEW = 5, 3  # figures of a number that is carried on, at most; of one that goes on with an answer, at least
_MORE, _FINEST = 4, 6  # figures that it has where those are too few; where five are, for what lies midway
_WHOLE = 100.0  # from there on a number is told to its ones at least
_NEAR = 0.01  # share by which what printed numbers give may differ from what the drawing goes on with


class Told:
    """The numbers of asked quantities as they are printed; of others as the lines need them that go on with them."""

    def __init__(self, answers: Iterable[Answer], names: Mapping[Node, Node]) -> None:
        self._names = names  # of what is another number of the same kind
        asked = (one for one in answers if not one.is_place and not one.undefined and one.reading.unit != YES_NO)
        self._by_symbol = {self._name(named(one.reading.symbol)): one for one in asked if isfinite(one.drawn)}
        self._carried: dict[Node, tuple[float, str]] = {}  # of what is not asked: its size, its number
        self._finer: dict[Node, str] = {}  # of what is asked, and gone on with to more figures than it is answered
        self._later: dict[Node, list[tuple[Row, str]]] = {}  # the lines that go on with it, and their ends
        self.strained: set[Node] = set()  # answers that go on with more figures of what was read than a hand writes

    def carry(self, lines: Sequence[tuple[Row, Txt | None]]) -> None:
        """Learn how what is not asked is printed: from the last line to the first, for a number that is told to more
        figures needs more figures of those that it is worked out from. None: the line has its own end."""
        self._carry(lines)
        if self._finer:  # lines that were settled before the guard figures of an answer were known
            self._carried, self._later = {}, {}
            self._carry(lines)
        for line, end in reversed(lines):
            if end is None and line.worked is not None:
                self._once_more(line)

    def _carry(self, lines: Sequence[tuple[Row, Txt | None]]) -> None:
        """Once from the last line to the first."""
        needed: dict[Node, tuple[float, str]] = {}
        for line, end in reversed(lines):
            if end is None:
                self._own(line, needed)
            if line.worked is None:
                continue
            shown = number_at_the_end(self._end(line, end))
            if shown is None:
                continue
            for symbol, value, text in numbers_of(line, shown, self._told):
                if self._refine(self._name(symbol), value, text) and end is not None:
                    self.strained.add(of_both(line.items[0]))
            for one, value, text in numbers_of(line, shown, self._told):
                symbol = self._name(one)
                self._later.setdefault(symbol, []).append((line, shown))
                if isinstance(symbol, Sym) and _figures(text) > _figures(needed.get(symbol, (0.0, ""))[1]):
                    needed[symbol] = abs(value), text
        given = needed.keys() - self._carried.keys() - self._by_symbol.keys()  # no line of the steps works these out
        self._carried |= {symbol: needed[symbol] for symbol in given if _figures(needed[symbol][1]) <= _FINE}

    def _refine(self, symbol: Node, value: float, text: str) -> bool:
        """Learn of an answer with which a line goes on with guard figures, that its own line must tell them; whether
        they are more than a hand writes of what it read."""
        answer, told = self._by_symbol.get(symbol), self._told(symbol, value).lstrip("−")
        if answer is None or not told or not _figures(told) < _figures(text) <= _FINEST:
            return False
        self._finer[symbol] = max(self._finer.get(symbol, ""), text, key=_figures)
        return _figures(text) > _FINE and not answer.computed

    def _own(self, line: Row, needed: dict[Node, tuple[float, str]]) -> None:
        """The number of a line that is not asked: to the scale that it is read to, or as fine as it is gone on with."""
        symbol, shown = self._name(line.items[0]), number_at_the_end(line.items[-1])
        if shown is None or not isinstance(symbol, Sym) or symbol in self._by_symbol:
            return
        size = _size(line, needed.get(symbol))
        read = _to_scale(line, size)
        text = read or _with_zeros(line, shown.lstrip("−"))
        wanted, finer = needed.get(symbol, (size, text))
        if isclose(wanted, size, rel_tol=1e-9) and _figures(text) < _figures(finer) <= _FINEST:
            text = finer
        self._carried[symbol] = size, text
        if line.worked is None:
            return
        least = _MORE if size >= _WHOLE else _FEW + leads_with_1(size)
        short = (significant(size, figures) for figures in range(least, _MORE + 1))
        self._fewer(line, symbol, () if read else tuple(few for few in short if _figures(few) < _figures(text)))

    def _fewer(self, line: Row, symbol: Node, short: tuple[str, ...]) -> None:
        """A number with the figures of a reading where later lines need no more. One that its line gives only with
        guard figures of an answer, as the answer gives it: an answer has one number, 3.02² × 0.12 = 1.094 and not
        3.025² × 0.12 = 1.098; as it is where later lines need it so."""
        (size, text), users = self._carried[symbol], self._later.get(symbol, [])
        sign = "−" if (number_at_the_end(line.items[-1]) or "").startswith("−") else ""
        reckoned, given = abs(reckoned_again(line, self._told)), goes_on(line, sign + text, self._told)
        near = (number(reckoned),) if not given and isclose(reckoned, size, rel_tol=_NEAR) else ()
        tried = (*short, *near, *(() if given else (number(size, _FEW),)))
        five = number(abs(reckoned_again(line, lambda *_: "", _FINE)))
        guarded = (*short, text, *((five,) if isclose(read_back(five)[0], size, rel_tol=_NEAR) else ()))
        for reached, some in ((self._goes_on, tried), (self._within, guarded)):
            for few in some:
                self._carried[symbol] = size, few
                if reached(line, sign + few) and all(self._goes_on(*one, symbol) for one in users):
                    return
        self._carried[symbol] = size, text

    def _once_more(self, line: Row) -> None:
        """A number with which some later line does not go on, now that all others are known, to as many figures as
        that needs: 0.019463² under ω = 0.01946."""
        symbol = self._name(line.items[0])
        size, text = self._carried.get(symbol, (0.0, ""))
        users = self._later.get(symbol, [])
        if not text or all(self._goes_on(*one, symbol) for one in users):
            return
        sign = "−" if (number_at_the_end(line.items[-1]) or "").startswith("−") else ""
        for finer in (number(size, figures) for figures in range(_figures(text) + 1, _FINEST + 1)):
            self._carried[symbol] = size, finer
            if self._goes_on(line, sign + finer) and all(self._goes_on(*one, symbol) for one in users):
                return
        self._carried[symbol] = size, text

    def _goes_on(self, line: Row, shown: str, symbol: Node | None = None) -> bool:
        """Whether a line goes on with what is told, with this symbol's number too: 31.416² stood under ω = 31.42."""
        return goes_on(line, shown, self._told, lambda one: self._name(one) == symbol)

    def _within(self, line: Row, shown: str) -> bool:
        """Whether the line needs no more than a few guard figures to come to this."""
        return all(_figures(text) <= _FINE for _, _, text in numbers_of(line, shown, self._told))

    def _end(self, line: Row, end: Txt | None) -> Node:
        """The end of a line: this one, or its own with the number as it is carried on."""
        last = self._guarded(line, end) or line.items[-1]
        carried = self._carried.get(self._name(line.items[0])) if end is None else None
        if carried is None or not isinstance(last, Txt):
            return last
        size, text = carried
        if not isclose(size, _size(line, carried), rel_tol=1e-9):
            return last
        return Txt(NUMBER.sub(lambda found: found[1] + text, last.text, count=1))

    def _guarded(self, line: Row, end: Txt | None) -> Txt | None:
        """The end of an answer's line, after the number that later lines go on with: 3.126 rad/s ≈ 3.13 rad/s."""
        symbol = self._name(line.items[0])
        finer = self._finer.get(symbol)
        if end is None or finer is None or EQUALS not in end.text:
            return end
        drawn = abs(self._by_symbol[symbol].drawn)
        if not isclose(drawn, _size(line, (drawn, finer)), rel_tol=1e-9):
            return end
        result, *others = end.text.removeprefix(EQUALS).split(EQUALS)  # 0.02275 m ≈ 22.8 mm
        exact = NUMBER.sub(lambda found: found[1] + finer, result, count=1)
        return Txt(f"{EQUALS}{exact}{ABOUT}{EQUALS.join(others or [result])}")

    def line(self, line: Row, end: Txt | None) -> Row:
        """The line with this end, or with its own; what goes on with nothing asked, as it is."""
        last = self._end(line, end)
        shown = number_at_the_end(last)
        if line.worked is None or not isinstance(last, Txt) or EQUALS not in last.text:
            return Row((*line.items[:-1], last))
        return Row((*line.items[:-1], last)) if shown is None else told_again(line, last, shown, self._told)

    def _name(self, symbol: Node) -> Node:
        """The symbol by which its number is known."""
        symbol = of_both(symbol)
        return self._names.get(symbol, symbol)

    def _told(self, symbol: Node, value: float) -> str:
        """The number as it is printed elsewhere; nothing of another, or of one that is gone on with otherwise."""
        symbol = self._name(symbol)
        answer = self._by_symbol.get(symbol)
        if answer is not None:
            if not isclose(abs(value), abs(answer.drawn), rel_tol=1e-9):
                return ""
            finer = self._finer.get(symbol)
            return ("−" if value < 0 else "") + finer if finer else number_of(answer, value, 1.0)
        size, text = self._carried.get(symbol, (0.0, ""))
        return ("−" if value < 0 else "") + text if text and isclose(abs(value), size, rel_tol=1e-9) else ""


def _size(line: Row, told: tuple[float, str] | None) -> float:
    """What a line comes to; of one that only states its number, what is told of its symbol, if that is the number."""
    if line.worked is not None:
        return size_of(line)
    stated, half = read_back((number_at_the_end(line.items[-1]) or "").lstrip("−") or "0")
    return told[0] if told is not None and abs(told[0] - stated) <= half else stated


def number_at_the_end(end: Node) -> str | None:
    """The number with which a line ends; None where it ends with none."""
    if not isinstance(end, Txt) or EQUALS not in end.text:
        return None
    found = NUMBER.match(end.text.split(EQUALS)[1])
    return found[0] if found else None


def number_of(answer: Answer, value: float, scale: float) -> str:
    """A value with the digits of the answer, in a unit of which the SI unit has so many; what is told whole as it is
    printed has all its figures in the SI unit, too: 71.107 m = 71107 mm."""
    places, finer = decimals(answer), printed_unit(answer.reading.unit)[0] / scale
    before_the_point = floor(log10(abs(value) * finer)) + 1 if value else 0
    most = max(MOST, before_the_point)
    return rounded(value, None if places is None else max(0, places + round(log10(finer))), most)


def _to_scale(line: Row, size: float) -> str:
    """What was read on paper, or worked out from one length alone, with its figures; nothing of another line."""
    scale, mm = scale_of(line) if is_length(line) else None, only_length(line)
    length = size / scale if scale else mm or 0.0
    return rounded(size, places_as_read(size, length), MOST) if length and size else ""


def _with_zeros(line: Row, text: str) -> str:
    """A result that has a unit with three figures, 10 × 0.03 = 0.300 m/s, beside those that are read."""
    worked_out = line.worked is not None and isinstance(line.items[-1], Txt) and " " in line.items[-1].text.strip(" =")
    if not worked_out or "×" in text or not float(text) or _figures(text) >= _FEW:
        return text
    return significant(float(text), _FEW)


def _figures(text: str) -> int:
    """How many significant figures a number has."""
    return len(text.partition("×")[0].replace(".", "").lstrip("0"))
