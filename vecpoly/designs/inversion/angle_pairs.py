"""A rocker whose angles, or a slider whose places, correspond to those of the input link: two or three pairs."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from math import degrees
from typing import Any, ClassVar

from pydantic import model_validator

from ...devices.base import Length, as_written
from ...errors import FaultError
from ...names import Named
from ...words import Words
from ..base import Design, Which
from ..place import Carried
from ..quantities import AB, BC, FOUR_BAR
from ..ranged.datum import Datum
from .built import posed_four_bar, posed_slider_crank
from .loops import Hinged, Sliding
from .paired import of_pairs
from .plan import FRAME, Body, Find, On, Pin, Plan, Position, Slide
from .told import rocker_task, slider_task
from .written import Corresponding, on, said

AHEAD_C, AHEAD_B = Named("delta_C", "δ_{C}", "deg"), Named("delta_B", "δ_{B}", "deg")

_VARIED = (AB, Named("guide", "guide", "mm"))


class AnglePairs(Design):
    """pairs of a rocker, φ of AB -> ψ of a line DE of the output link: AB and AD are given, C is sought on the link
    (of two pairs on DE itself, or on the line C in the coordinates of DE).

    pairs of a slider, φ of a line AE of the input link -> s of C along the guide from the foot of A: B is sought.
    onto: the position in which the link that is sought on is kept. A is the origin, D lies on the x axis.
    """

    ranged: ClassVar[tuple[Named, ...]] = _VARIED
    kind: ClassVar[str] = "angle-pairs"
    pairs: tuple[Corresponding, ...]
    AB: Length | None = None
    AD: Length | None = None
    guide: Carried | None = None
    C: Carried | None = None
    B: Carried | None = None
    onto: Which = 1

    @model_validator(mode="after")
    def _determined(self) -> AnglePairs:
        count, slides = len(self.pairs), {pair.slides for pair in self.pairs}
        if count not in (2, 3) or len(slides) != 1 or self.onto > count:
            raise FaultError(
                Words(
                    f"应给定两组或三组对应位置，从动件全为角度或全为滑块位移，onto 不大于组数；此处有 {count} 组",
                    "two or three pairs are needed, all to angles or all to places of the slider, and onto must not "
                    f"be above their number; here are {count}",
                ),
                "pairs",
                code="out-of-range",
            )
        needed = ("guide",) if self.slides else ("AB", "AD")
        strange = {"AB", "AD", "C"} if self.slides else {"guide", "B"}
        missing = [name for name in needed if getattr(self, name) is None]
        excess = [name for name in sorted(strange) if getattr(self, name) is not None]
        if missing or excess:
            raise FaultError(_not_these(missing, excess, self.slides), code="contradiction")
        if count == 3 and (self.C or self.B):
            raise FaultError(_determined_already("B" if self.B else "C"), code="contradiction")
        return self

    @property
    def slides(self) -> bool:
        """Whether the output is a slider."""
        return self.pairs[0].slides

    def varied(self) -> Iterator[Datum[Design]]:
        """The crank or the guide; what belongs to its angle in each pair."""
        yield from super().varied()
        yield from of_pairs(self, self.pairs)

    def task(self, asked: Collection[str]) -> Words:
        """Pairs of a rocker, or of a slider."""
        count = len(self.pairs)
        if self.guide is not None:
            return slider_task(self.guide, self.B, count, turned=AHEAD_B.key in asked)
        return rocker_task(self.C, count, turned=AHEAD_C.key in asked)

    def quantities(self) -> tuple[Named, ...]:
        """The lengths, and by how much the sought pin is ahead of the line of its link."""
        return (AB, BC, AHEAD_B) if self.slides else (*FOUR_BAR, AHEAD_C)

    def built(self, values: Mapping[str, float]) -> dict[str, Any]:
        """The linkage in the position of the first pair, AB driving it."""
        first = self.pairs[0]
        if self.slides:
            slide = self.plan().slides[0]
            turned = degrees(first.one) + values[AHEAD_B.key]
            return posed_slider_crank(values, turned, slide.places[0], slide.along, self.omega)
        return posed_four_bar(values, degrees(first.one), degrees(first.two) + values[AHEAD_C.key], 0.0, self.omega)

    def given(self) -> tuple[tuple[str, str], ...]:
        """The pairs, and the links that are given."""
        place = "x_{{C{}}}" if self.guide is None or self.guide.along.real else "y_{{C{}}}"
        of = place if self.slides else "ψ_{{{}}}"
        pairs = tuple(
            (symbol.format(n), text)
            for n, pair in enumerate(self.pairs, 1)
            for symbol, text in zip(("φ_{{{}}}", of), pair.told, strict=True)
        )
        lengths = (("l_{AB}", self.AB), ("l_{AD}", self.AD))
        lines = (("C", self.guide), ("C", self.C), ("B", self.B))
        return (*as_written(lengths), *(said(letter, line) for letter, line in lines if line is not None), *pairs)

    @property
    def size(self) -> float:
        """The frame, or the furthest place of the slider."""
        if self.AD is not None:
            return 2 * self.AD.si
        return 2 * max(abs(pair.two) for pair in self.pairs) or 0.1

    def plan(self) -> Plan:
        """One bar, BC."""
        return self._slider() if self.slides else self._rocker()

    def _rocker(self) -> Plan:
        assert self.AB is not None and self.AD is not None
        a, d = complex(0), complex(self.AD.si)
        ones, twos = (
            tuple(Position(at=at, angle=angle) for angle in angles)
            for at, angles in ((a, [pair.one for pair in self.pairs]), (d, [pair.two for pair in self.pairs]))
        )
        crank = Body(name="AB", pivot="A", positions=ones, symbol="φ")
        rocker = Body(name="DE", pivot="D", positions=twos, symbol="ψ")
        pins = (
            Pin(letter="A", on=FRAME, at=a),
            Pin(letter="D", on=FRAME, at=d),
            Pin(letter="B", on="AB", at=complex(self.AB.si)),
        )
        sought = Find(pin="C", on="DE", known="B", lies=self._lies(self.C), kept=self.onto - 1)
        loops = (Hinged(a="A", b="B", c="C", d="D"),)
        return Plan(count=len(self.pairs), bodies=(crank, rocker), pins=pins, stages=(sought,), loops=loops)

    def _slider(self) -> Plan:
        assert self.guide is not None
        along = self.guide.along
        foot = self.guide.at - along * (along.conjugate() * self.guide.at).real
        slide = Slide(letter="C", places=tuple(foot + pair.two * along for pair in self.pairs), along=along)
        turns = tuple(Position(angle=pair.one) for pair in self.pairs)
        rocker = Body(name="AE", pivot="A", positions=turns, symbol="φ")
        sought = Find(pin="B", on="AE", known="C", lies=self._lies(self.B), kept=self.onto - 1)
        return Plan(
            count=len(self.pairs),
            bodies=(rocker,),
            pins=(Pin(letter="A", on=FRAME, at=0j),),
            slides=(slide,),
            stages=(sought,),
            loops=(Sliding(a="A", b="B", c="C", along=along),),
        )

    def _lies(self, line: Carried | None) -> On | None:
        if len(self.pairs) == 3:
            return None
        return On() if line is None else on(line)


def _not_these(missing: list[str], excess: list[str], slides: bool) -> Words:
    zh = "；".join(
        part
        for part in (f"缺少 {'、'.join(missing)}" if missing else "", f"{'、'.join(excess)} 不适用" if excess else "")
        if part
    )
    en = ", and ".join(
        part
        for part in (
            f"{', '.join(missing)} is missing" if missing else "",
            f"{', '.join(excess)} has no place" if excess else "",
        )
        if part
    )
    zh_what, en_what = ("滑块", "a slider") if slides else ("摇杆", "a rocker")
    return Words(
        f"从动件为{zh_what}时{zh}；{zh_what}须给定 {'guide' if slides else 'AB 和 AD'}",
        f"with {en_what} {en}; {en_what} needs {'guide' if slides else 'AB and AD'}",
    )


def _determined_already(pin: str) -> Words:
    return Words(
        f"三组对应位置已确定 {pin}，不能再规定其所在直线；请删去 {pin}",
        f"three pairs determine {pin} already: no line can be asked of it; leave {pin} out",
    )
