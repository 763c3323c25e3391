"""The table of verification of a synthesis: what each solution does, as moved with the lengths read, beside exact."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from math import isfinite

from ..algebra.quantity import number
from ..board.candidates import Candidate
from ..check.candidates import exact
from ..check.found import Verified
from ..designs.base import Design
from ..designs.inversion.stages import Stages
from ..solution import Solution
from ..words import Lang, Words, stopped
from .flow.table import DataTable

_NUMBER = Words("解", "No.")
_NONE, _YES, _NO = Words.same("—"), Words("是", "yes"), Words("否", "no")
MARGIN = Words("杆长余量", "Margin")
_ERROR, _CIRCUIT = Words("杆长相差", "Length error"), Words("同回路同分支", "Same circuit and branch")
_GAMMA = Words.same("$γ_{min}$")
_TYPE = Words("机构类型", "Type")
_TYPE_OF, _ALL_TURNS = Words("$ABCD$ 的类型", "Type of $ABCD$"), Words("连同杆组整周转动", "All of it turns fully")
_MEANT = {  # heads that do not say all
    _ERROR: Words(
        "“杆长相差”为同一杆在各给定位置的最大长度之差",
        "“Length error” is the largest difference of one link's length between the given positions",
    ),
    _CIRCUIT: Words(
        "“同回路同分支”指机构不拆开即可依次通过各给定位置",
        "“Same circuit and branch”: the linkage passes through all given positions without being taken apart",
    ),
    MARGIN: Words(
        "“杆长余量”为其余两杆之和减去最短杆与最长杆之和",
        "“Margin” is the sum of the two other links less that of the shortest and the longest",
    ),
    _ALL_TURNS: Words(
        "“连同杆组整周转动”：四杆机构 $ABCD$ 的曲柄即使能转整周，加装的杆组也未必能随之转满一周",
        "“All of it turns fully”: what is added to the four-bar $ABCD$ need not follow a full turn of its crank",
    ),
    _GAMMA: Words("$γ_{min}$ 为最小传动角", "$γ_{min}$ is the least transmission angle"),
}
_ORDER, _SWING, _STROKE = Words("次序", "Order"), Words("摆角", "Swing"), Words("行程", "Stroke")
_BROKEN = Words("不能运动", "does not move")
_SAID = {  # the same of a single solution, in a sentence
    _ERROR: Words("同一杆在各给定位置的长度最多相差 {}", "the length of a link varies by {} at most"),
    _CIRCUIT: Words(
        "机构不拆开即可依次通过各给定位置", "the linkage passes through all given positions without being taken apart"
    ),
    _ORDER: Words("位置次序为 {}", "it takes them in the order {}"),
    _TYPE: Words("机构类型为{}", "its type is {}"),
    _TYPE_OF: Words("$ABCD$ 为{}", "$ABCD$ is of the type {}"),
    MARGIN: Words(
        "其余两杆之和减去最短杆与最长杆之和为 {}", "the two other links less the shortest and the longest are {}"
    ),
    _SWING: Words("摆角为 {}", "the swing is {}"),
    _STROKE: Words("行程为 {}", "the stroke is {}"),
}
_BESIDE = frozenset({"K", "psi", "H", "gamma_min"})  # keys of what is moved and found exactly too
_DRIVER = re.compile(r"(?:原动件|Driver) (\$\w+\$)")
_BARS = (("A", "B"), ("B", "C"), ("C", "D"))


def verification_table(solution: Solution, lang: Lang) -> DataTable | None:
    """One line a solution, one column an item; None where no solution can be moved."""
    moved = solution.verification
    design = solution.problem.subject
    if all(one.broken is not None for one in moved) or not isinstance(design, Design):
        return None
    found = {one.number: one for one in solution.construction.candidates}
    true: dict[int, Mapping[str, float]] = dict(enumerate(exact(design), 1))
    mu = 1e3 * solution.construction.figures[0].scale.value
    driver = next(one.driver for one in moved if one.broken is None)
    turning = Words(f"原动件 ${driver}$ 整周转动", f"Driver ${driver}$ turns fully")
    lines = [_Line(design, one, found[one.number], true.get(one.number, {}), mu, turning).items() for one in moved]
    told = [n for n in range(len(lines[0])) if any(line[n][1] != _NONE for line in lines)]
    header = [_NUMBER.of(lang), *(lines[0][n][0].of(lang) for n in told)]
    rows = [[str(one.number), *(line[n][1].of(lang) for n in told)] for one, line in zip(moved, lines, strict=True)]
    return DataTable(header, rows, None, "c" * len(header), lang=lang)


def as_moved(solution: Solution, lang: Lang) -> tuple[DataTable | None, str]:
    """What the solutions do, as moved: of several a table, of one a sentence."""
    table = verification_table(solution, lang)
    said = in_words(table, lang)
    return (None if said else table), said


def in_words(table: DataTable | None, lang: Lang) -> str:
    """A table of one line as a sentence; nothing of another."""
    if table is None or len(table.rows) > 1:
        return ""
    said = {head.of(lang): words.of(lang) for head, words in _SAID.items()}
    pairs = list(zip(table.header[1:], table.rows[0][1:], strict=True))
    told = [said[head].format(value) if head in said else _turning(head, value, lang) for head, value in pairs]
    return stopped(Words("，", "; ").of(lang).join(told), lang)


def _turning(head: str, value: str, lang: Lang) -> str:
    """Whether the driver turns fully, with what is added to a four-bar; any other item as it is headed."""
    turns = {_YES.of(lang): Words("能", "turns"), _NO.of(lang): Words("不能", "does not turn")}.get(value)
    driver = next(iter(_DRIVER.findall(head)), "")
    if turns is not None and driver:
        return Words(f"原动件 {driver} {turns.zh}整周转动", f"the driver {driver} {turns.en} fully").of(lang)
    if turns is not None and head == _ALL_TURNS.of(lang):
        return Words(f"连同杆组{turns.zh}整周转动", f"with what is added it {turns.en} fully").of(lang)
    return f"{head} = {value}" if head.startswith("$") else f"{head}{Words('：', ': ').of(lang)}{value}"


def heads_told(table: DataTable | None, lang: Lang) -> str:
    """What the heads of that table mean that do not say all."""
    header = () if table is None else table.header
    told = [meant.of(lang) for head, meant in _MEANT.items() if head.of(lang) in header]
    return stopped(Words("；", "; ").of(lang).join(told), lang) if told else ""


def beside_exact(solution: Solution) -> bool:
    """Whether exact values stand in that table, in brackets."""
    design = solution.problem.subject
    numbers = {one.number for one in solution.verification if one.broken is None}
    true = enumerate(exact(design), 1) if numbers and isinstance(design, Design) else ()
    return any(number in numbers and not _BESIDE.isdisjoint(values) for number, values in true)


class _Line:
    """What is said of one solution."""

    def __init__(
        self, design: Design, moved: Verified, drawn: Candidate, true: Mapping[str, float], mu: float, turning: Words
    ) -> None:
        self.design, self.moved, self.drawn, self.mu = design, moved, drawn, mu
        self.exact, self.turning = true, turning

    def items(self) -> list[tuple[Words, Words]]:
        """Item by item, in one order for all."""
        one = self.moved
        swings = one.unit == "°"
        named, turning = (_TYPE_OF, _ALL_TURNS) if self._added() else (_TYPE, self.turning)
        stroke, unit = ("psi", "°") if swings else ("H", " mm")
        return [
            (_ERROR, self._closes()),
            (_CIRCUIT, self._yes()),
            (_ORDER, self._order()),
            (named, _NONE if one.kind is None else one.kind),
            (MARGIN, _NONE if one.kind is None else Words.same(f"{number(one.margin)} mm")),
            (turning, self._turns()),
            (Words.same("$K$"), self._beside(one.ratio, "K", "", 4)),
            (_SWING if swings else _STROKE, self._beside(one.stroke, stroke, unit, 4)),
            (_GAMMA, self._beside(one.gamma, "gamma_min", "°", 4) if one.full else _NONE),
        ]

    def _closes(self) -> Words:
        """How much the bars differ in length from position to position, on paper."""
        spans = [self.mu * (max(lengths) - min(lengths)) for lengths in self._lengths() if len(lengths) > 1]
        return Words.same(f"{max(spans):.2f} mm") if spans else _NONE

    def _lengths(self) -> Iterator[list[float]]:
        for one, two in self._bars():
            places = [(self._pin(one, n), self._pin(two, n)) for n in range(1, self.positions + 1)]
            yield [abs(b - a) for a, b in places if a is not None and b is not None]

    def _bars(self) -> Iterable[tuple[str, str]]:
        """Those with a length: B slides along a guide bar BC."""
        if isinstance(self.design, Stages):
            return self.design.plan().bars()
        known = {named.key for named in self.design.quantities()}
        return [(one, two) for one, two in _BARS if {one + two, two + one} & known]

    def _added(self) -> bool:
        """Whether links are added to a four-bar, of which alone the type is told."""
        bars = {frozenset(bar) for bar in self._bars()} if isinstance(self.design, Stages) else set()
        return self.moved.kind is not None and bool(bars - {frozenset(bar) for bar in (*_BARS, ("A", "D"))})

    @property
    def positions(self) -> int:
        """How many positions its pins are known in."""
        return max((int(key[-1]) for key in self.drawn.pins if key[-1].isdigit()), default=1)

    def _pin(self, letter: str, n: int) -> complex | None:
        pins = self.drawn.pins
        return pins.get(f"{letter}{n}", pins.get(letter))

    def _yes(self) -> Words:
        """A candidate of another circuit or branch is none that is valid."""
        return _YES if self.positions > 1 and self.moved.broken is None else _NONE

    def _turns(self) -> Words:
        """Whether it turns right round; of one that does not move with the lengths read, that."""
        return _BROKEN if self.moved.broken is not None else _YES if self.moved.full else _NO

    def _order(self) -> Words:
        order = " → ".join(map(str, range(1, self.positions + 1)))
        return Words.same(order) if self.positions > 2 and self.moved.broken is None else _NONE

    def _beside(self, value: float, key: str, unit: str, digits: int) -> Words:
        if not isfinite(value):
            return _NONE
        exact = f" ({number(self.exact[key], digits)}{unit})" if key in self.exact else ""
        return Words.same(f"{number(value, digits)}{unit}{exact}")
