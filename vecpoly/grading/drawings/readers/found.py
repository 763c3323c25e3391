"""What a reader collects, within limits; heads are then put on their lines, and runs of letters together."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from math import isfinite

from ....errors import FaultError
from ....foundation.slotted import replace
from ....limits import DRAWING_SPAN, DRAWN
from ....words import Words
from ..segment import Drawing, Label, Segment

HEAD = 8.0  # mm: larger triangles are areas
ROUND, DOT = 8, 4.0  # corners, and mm across, of what stands for a small circle
NEAR = 0.2  # mm: from a head's axis to its line
SAME_LINE = 0.35  # of the letters' height: a subscript
GAP = 0.6
FLAT = 1e-3  # of its chord: a curve that leaves it by less is a line


@dataclass(slots=True)
class Found:
    """Segments, triangles and lettering in the order of the file."""

    file: str
    segments: list[Segment] = field(default_factory=list)
    heads: list[tuple[complex, ...]] = field(default_factory=list)
    labels: list[Label] = field(default_factory=list)
    remarks: list[Words] = field(default_factory=list)

    def line(self, points: Sequence[complex], like: Segment) -> None:
        """A line through points, with the name, layer and place of `like`; a head at its end is at the last."""
        points = [self.sound(z, like.where) for z in points]
        if len(points) > ROUND and points[0] == points[-1] and max(abs(z - points[0]) for z in points) < DOT:
            return  # a dot, or a circle about a joint
        pieces = [(a, b) for a, b in pairwise(points) if a != b]
        for n, (a, b) in enumerate(pieces):
            last = n == len(pieces) - 1
            self.segments.append(replace(like, start=a, end=b, headed=like.headed and last))
        self.counted()

    def area(self, points: Sequence[complex]) -> None:
        """A filled area, of which a small triangle is an arrow head."""
        corners = tuple(dict.fromkeys(points))
        if len(corners) == 3 and max(abs(a - b) for a in corners for b in corners) <= HEAD:
            self.heads.append(corners)
            self.counted()

    def letter(self, label: Label) -> None:
        """Lettering."""
        if label.text.strip() and isfinite(abs(label.at)):
            self.labels.append(label)
            self.counted()

    def remark(self, words: Words) -> None:
        """What had to be assumed, once."""
        if words not in self.remarks:
            self.remarks.append(words)

    def counted(self) -> None:
        """Refuse a file of more objects than any exercise has."""
        number = len(self.segments) + len(self.heads) + len(self.labels)
        if number > DRAWN:
            raise FaultError(
                Words(
                    f"图中对象多于 {DRAWN} 个；请只保留作图本身",
                    f"more than {DRAWN} objects; keep only the drawing itself",
                ),
                code="too-many",
                numbers={"most": DRAWN},
            )

    def sound(self, at: complex, where: str) -> complex:
        """The place, which must lie on some sheet of paper."""
        if not abs(at) <= DRAWING_SPAN:
            raise FaultError(
                Words(
                    f"{where} 的坐标 {at} mm 超出 ±{DRAWING_SPAN:g} mm；请检查图形单位",
                    f"{where} lies at {at} mm, beyond ±{DRAWING_SPAN:g} mm; check the unit of the drawing",
                ),
                code="coordinate",
                numbers={"most": DRAWING_SPAN},
            )
        return at

    def drawing(self) -> Drawing:
        """All that was found. Raises FaultError where there is no line at all."""
        if not self.segments:
            raise FaultError(
                Words(
                    "图中没有直线段；请交矢量图（不是图片），并检查图层是否可见",
                    "there is no straight line in it; hand in a vector drawing (no picture), with its layers visible",
                ),
                code="no-lines",
            )
        headed = _headed(self.segments, self.heads)
        return Drawing(file=self.file, segments=headed, labels=tuple(_runs(self.labels)), remarks=tuple(self.remarks))


def is_straight(start: complex, *through: complex, end: complex) -> bool:
    """Whether a curve by these points runs straight: some programs draw the shaft of an arrow as a spline."""
    places = [(point - start) / (end - start) for point in through] if end != start else [1j]
    return all(abs(at.imag) <= FLAT and -FLAT <= at.real <= 1 + FLAT for at in places)


def _headed(segments: Sequence[Segment], heads: Iterable[tuple[complex, ...]]) -> tuple[Segment, ...]:
    """Each head on the line that runs into it, which then ends at its tip."""
    found = list(segments)
    for corners in heads:
        tip, back = _tip(corners)
        axis = (tip - back) / abs(tip - back)
        best, gap = -1, NEAR
        for n, one in enumerate(found):
            for a, b in ((one.start, one.end), (one.end, one.start)):
                off, ahead = abs(((b - tip) / axis).imag), ((tip - b) / axis).real
                turned = abs(((b - a) / abs(b - a) / axis) - 1)
                if turned < 0.02 and -NEAR <= ahead <= abs(tip - back) + NEAR and _better(off, one, gap, best, found):
                    best, gap = n, off
        if best >= 0:
            one = found[best]
            way = one if ((one.along) / axis).real > 0 else one.turned()
            found[best] = replace(way, end=tip, headed=True)
    return tuple(found)


def _better(off: float, one: Segment, gap: float, best: int, found: Sequence[Segment]) -> bool:
    """Nearer, or as near and of a line that has no head and is drawn more heavily."""
    if one.headed or off > NEAR:
        return False
    return best < 0 or off < gap - NEAR / 4 or one.width > found[best].width


def _tip(corners: tuple[complex, ...]) -> tuple[complex, complex]:
    """The tip of a head, opposite to its shortest side, and the middle of that."""
    a, b, c = corners
    base, tip = min(((abs(a - b), c), (abs(b - c), a), (abs(c - a), b)), key=lambda pair: pair[0])
    rest = [z for z in corners if z != tip]
    return tip, sum(rest) / len(rest) if base else tip - 1


def _runs(labels: Sequence[Label]) -> Iterable[Label]:
    """Runs of letters that stand together as one: c and its small 2."""
    made: list[Label] = []
    for one in labels:
        last = made[-1] if made else None
        if last is not None and _continues(last, one):
            made[-1] = replace(last, text=last.text + one.text.strip())
        else:
            made.append(one)
    return made


def _continues(last: Label, one: Label) -> bool:
    step = one.at - last.at
    width = GAP * last.height * len(last.text)
    return 0 < step.real <= width + GAP * last.height and abs(step.imag) <= last.height * (1 - SAME_LINE)
