"""A four-bar that leads a body through two, three or four positions: pins on the body given, or on the frame."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from functools import partial
from typing import Any, ClassVar

from pydantic import Field, model_validator

from ...errors import FaultError
from ...names import Named
from ...words import Words
from ..base import Design, Which
from ..place import Carried
from ..quantities import FOUR_BAR, TURN_AB, TURN_AD, TURN_DC
from ..ranged.datum import Datum, of_point, put_in
from .built import posed_four_bar
from .loops import Hinged
from .plan import FRAME, Body, CentrePoints, Find, Pin, Plan, Stage
from .told import positions_task
from .written import Place, Point, Pose, on, said

_BODY = "S"
MANY = 4  # positions: neither end of a bar is given, and how many linkages there are comes out
_MOVING = {"A": "B", "D": "C"}
_VARIED = tuple(Named(letter, letter, "mm") for letter in "ADBC")  # lines


class Positions(Design):
    """poses: of the body S. A bar AB, and another DC, each with one end given (body: B, C; frame: A, D) or, of four
    positions, with neither; where there are two positions, or four, a line carries the end that is sought.

    onto: the position in which the body is kept where it is taken for the frame.
    """

    ranged: ClassVar[tuple[Named, ...]] = _VARIED
    kind: ClassVar[str] = "positions"
    poses: tuple[Pose, ...]
    body: dict[str, Place] = Field(default_factory=dict)
    frame: dict[str, Place] = Field(default_factory=dict)
    A: Carried | None = None
    B: Carried | None = None
    C: Carried | None = None
    D: Carried | None = None
    onto: Which = 1

    @model_validator(mode="after")
    def _determined(self) -> Positions:
        count = len(self.poses)
        if not 2 <= count <= 4:
            raise FaultError(
                Words(
                    f"给定了 {count} 个位置；一般可通过二至四个给定位置，请写 2、3 或 4 个",
                    f"{count} positions are given; a four-bar is found for two, three or four: write as many",
                ),
                "poses",
                code="out-of-range",
            )
        if self.onto > count:
            raise FaultError(
                Words(f"onto = {self.onto}：只有 {count} 个位置", f"onto = {self.onto}: there are {count} positions"),
                "onto",
                code="out-of-range",
            )
        _letters("body", self.body, "BC")
        _letters("frame", self.frame, "AD")
        for fixed, moving in _MOVING.items():
            self._bar(fixed, moving)
        return self

    def _bar(self, fixed: str, moving: str) -> None:
        """Just one end given (none of four positions), and a line for the other where one is needed."""
        given = [letter for letter in (fixed, moving) if letter in (*self.body, *self.frame)]
        wanted = 0 if len(self.poses) == 4 else 1
        if len(given) != wanted:
            raise FaultError(
                Words(
                    f"{len(self.poses)} 个位置时，{fixed}{moving} 的两端应给定 {wanted} 个，此处给定 {len(given)} 个；"
                    f"如写 body: {{{moving}: [30 mm, 5 mm]}}",
                    f"of {len(self.poses)} positions {wanted} of the ends of {fixed}{moving} must be given, and here "
                    f"are {len(given)}; write e.g. body: {{{moving}: [30 mm, 5 mm]}}",
                ),
                code="contradiction",
            )
        sought = fixed if moving in given or not given else moving
        if (self._line(sought) is None) != (len(self.poses) == 3):
            raise FaultError(_line_needed(sought, len(self.poses)), sought, code="contradiction")

    def _line(self, letter: str) -> Carried | None:
        return {"A": self.A, "B": self.B, "C": self.C, "D": self.D}[letter]

    def varied(self) -> Iterator[Datum[Design]]:
        """Where the lines lie; the places of the pins."""
        yield from super().varied()
        for key, places in (("body", self.body), ("frame", self.frame)):
            for letter, place in places.items():
                yield from of_point(Words.same(letter), place.at, partial(self._moved, key, letter))

    def _moved(self, key: str, letter: str, at: complex) -> Design:
        return put_in(self, key, letter, Point(at, f"{at:.17g}"))

    def task(self, asked: Collection[str]) -> Words:
        """A body led through positions by a four-bar."""
        lines = [(letter, line) for letter in "ABCD" if (line := self._line(letter)) is not None]
        shown = [(letter, line, letter in self._moving) for letter, line in lines if letter not in self._on_body_line]
        return positions_task(len(self.poses), shown, asked)

    def quantities(self) -> tuple[Named, ...]:
        """The four lengths, and the directions of AB, DC and AD in the first position."""
        return (*FOUR_BAR, TURN_AB, TURN_DC, TURN_AD)

    def built(self, values: Mapping[str, float]) -> dict[str, Any]:
        """The four-bar in the first position, AB driving it."""
        ab, dc, ad = (values[named.key] for named in (TURN_AB, TURN_DC, TURN_AD))
        return posed_four_bar(values, ab, dc, ad, self.omega)

    def driven_last(self, values: Mapping[str, float]) -> dict[str, Any]:
        """The same, DC driving it."""
        ab, dc, ad = (values[named.key] for named in (TURN_AB, TURN_DC, TURN_AD))
        return posed_four_bar(values, ab, dc, ad, self.omega, last=True)

    def given(self) -> tuple[tuple[str, str], ...]:
        """The pins, the lines; those of the body in its own coordinates, x′ and y′."""
        pins = tuple((letter, place.text) for letter, place in (*self.body.items(), *self.frame.items()))
        lines = [
            (letter, line) for letter in "ABCD" if (line := self._line(letter)) and letter not in self._on_body_line
        ]
        return (*pins, *(_primed(*said(one, line)) if one in self._moving else said(one, line) for one, line in lines))

    @property
    def _moving(self) -> tuple[str, ...]:
        """Pins of the body that are given, or have a line, in its own coordinates."""
        lines = tuple(letter for letter in _MOVING.values() if self._line(letter) is not None)
        return (*self.body, *(letter for letter in lines if letter not in self._on_body_line))

    @property
    def _on_body_line(self) -> list[str]:
        """Pins of the body that lie on its line PQ."""
        moving = [(letter, self._line(letter)) for letter in _MOVING.values()]
        return [one for one, line in moving if line is not None and line.along.real and not line.at]

    def told(self) -> tuple[Words, ...]:
        """The positions: of a point and a line of the body; of its coordinates where two pins of its own are given in
        them, and the line that joins these is drawn."""
        poses, own = enumerate(self.poses, 1), [f"${letter}$" for letter in self._moving]
        if len(self.body) == 2:
            return (*(_posed(n, pose, _ORIGIN, _ACROSS) for n, pose in poses), _measured(own, _AXES))
        posed = (_posed(n, pose, Words("$P$ ", "$P$"), Words("$PQ$ ", "$PQ$")) for n, pose in poses)
        pins = [f"${letter}$" for letter in self._on_body_line]
        lie = Words(f"{'、'.join(pins)} 在直线 $PQ$ 上", f"{' and '.join(pins)} on the line $PQ$")
        return (_LINED, *posed, *([lie] if pins else []), *([_measured(own, _FROM_P)] if own else []))

    @property
    def size(self) -> float:
        """From the first position to the furthest."""
        first = self.poses[0].position.at
        return 2 * max(abs(pose.position.at - first) for pose in self.poses) or 0.1

    def plan(self) -> Plan:
        """Two bars, one after the other."""
        body = Body(name=_BODY, positions=tuple(pose.position for pose in self.poses))
        pins = [Pin(letter=letter, on=_BODY, at=place.at) for letter, place in self.body.items()]
        pins += [Pin(letter=letter, on=FRAME, at=place.at) for letter, place in self.frame.items()]
        stages: tuple[Stage, ...] = tuple(self._find(fixed, moving) for fixed, moving in _MOVING.items())
        loop = Hinged(a="A", b="B", c="C", d="D")
        if len(self.poses) == 4:
            assert self.A is not None and self.D is not None
            stages = (CentrePoints(on=_BODY, one=("A", "B"), two=("D", "C"), lies=(on(self.A), on(self.D))),)
        return Plan(count=len(self.poses), either=True, bodies=(body,), pins=tuple(pins), stages=stages, loops=(loop,))

    def _find(self, fixed: str, moving: str) -> Find:
        sought, known, carrier = (fixed, moving, FRAME) if moving in self.body else (moving, fixed, _BODY)
        line = self._line(sought)
        return Find(pin=sought, on=carrier, known=known, lies=None if line is None else on(line), kept=self.onto - 1)


_LINED = Words(
    f"平面 ${_BODY}$ 以其上的标线 $PQ$ 表示（$PQ$ 的长度任取）",
    f"the body ${_BODY}$ is represented by a line $PQ$ on it, whose length may be chosen freely",
)
_ORIGIN = Words(f"${_BODY}$ 的动坐标原点", f"the origin of ${_BODY}$")
_ACROSS = Words("动坐标轴 $x′$ ", "its axis $x′$")
_AXES = Words("动坐标系 $x′y′$ ", "the body’s own axes $x′$, $y′$")
_FROM_P = Words(
    "动坐标系 $x′y′$（原点 $P$，$x′$ 轴沿 $PQ$）", "the body’s own axes, $x′$ from $P$ to $Q$, $y′$ to its left"
)


def _measured(pins: Sequence[str], axes: Words) -> Words:
    """In which coordinates these pins of the body are given."""
    return Words(
        f"{'、'.join(pins)} 的坐标在 ${_BODY}$ 的{axes.zh}中给出", f"{' and '.join(pins)} in coordinates of {axes.en}"
    )


def _primed(symbol: str, text: str) -> tuple[str, str]:
    """y_C of the body: y′_C."""
    return f"{symbol[:1]}′{symbol[1:]}", text


def _posed(n: int, pose: Pose, point: Words, line: Words) -> Words:
    """Position 1: P at (0, 0) mm, PQ at 0 deg."""
    at, _, angle = pose.text.partition(" at ")
    return Words(
        f"位置 {n}：{point.zh}在 {at}、{line.zh}的方向角为 {angle}",
        f"position {n}: {point.en} at {at}, {line.en} at {angle}",
    )


def _letters(key: str, places: dict[str, Place], known: str) -> None:
    for letter in places:
        if letter not in known:
            raise FaultError(
                Words(
                    f"“{letter}”不是 {key} 上的铰链；可写 {'、'.join(known)}",
                    f"'{letter}' is no pin of the {key}; it may have {', '.join(known)}",
                ),
                key,
                letter,
                code="unknown-name",
            )


def _line_needed(sought: str, count: int) -> Words:
    if count == 3:
        return Words(
            f"三个位置已确定 {sought}，不能再规定其所在直线；请删去 {sought}",
            f"three positions determine {sought} already: no line can be asked of it; leave {sought} out",
        )
    return Words(
        f"{count} 个位置时 {sought} 有无穷多解，须给定其所在直线；如写 {sought}: on y = -20 mm",
        f"of {count} positions there are infinitely many places for {sought}: a line that carries it is needed; "
        f"write e.g. {sought}: on y = -20 mm",
    )
