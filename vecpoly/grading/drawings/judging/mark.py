"""What a drawing is worth: a verdict on every vector, on every figure, on the whole, each with its reason."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from ....board.otherwise.slip import Slip
from ....words import Words
from ..segment import Segment

NO_WORDS = Words("", "")
_OTHERS = Words(
    "图上没有一个矢量与本题相符：是否交错了题，或是别人的图？请核对",
    "no vector on it is one of this problem: is it the drawing of another problem, or another student's? check it",
)

_ALL_TURNED = Words(
    "各多边形整体转了方向或镜像了：图纸是否放斜了，或是别人的图？请核对",
    "every polygon is turned as a whole, or in a mirror: did the sheet lie askew, or is it another student's? check it",
)


class Verdict(StrEnum):
    """As for numbers: within T, within `wrong` T, beyond; or not drawn."""

    RIGHT = "right"
    CLOSE = "close"
    WRONG = "wrong"
    MISSING = "missing"

    @property
    def words(self) -> Words:
        """In words."""
        return Words({"right": "正确", "close": "接近", "wrong": "错误", "missing": "漏画"}[self.value], self.value)


class Basis(StrEnum):
    """What a vector was held against: the exact drawing, or what follows from the student's own lines before it; or
    whether it is wrong because of the one mistake that explains the drawing."""

    EXACT = "exact"
    OWN = "own"
    SLIP = "slip"


@dataclass(frozen=True, slots=True, kw_only=True)
class VectorMark:
    """One vector as drawn (`own`) and as it should be on this basis (`should`), both in mm of the reference drawing.

    keys: of all quantities that it stands for. length, direction: each by itself; sense: whether the arrow points the
    right way, None where it has no head in a drawing with heads. off: mm in length; turned: degrees (ccw); allowed: T,
    mm. tail: where it begins on the figure.
    """

    key: str
    symbol: str
    figure: str
    verdict: Verdict
    length: Verdict = Verdict.RIGHT
    direction: Verdict = Verdict.RIGHT
    sense: bool | None = True
    own: complex | None = None
    should: complex = 0j
    off: float = 0.0
    turned: float = 0.0
    allowed: float = 0.0
    basis: Basis = Basis.EXACT
    tail: complex = 0j
    where: str = ""
    reason: Words = NO_WORDS
    keys: tuple[str, ...] = ()

    @property
    def costs(self) -> bool:
        """Whether it is a mistake of its own, and no consequence of another."""
        return self.verdict in (Verdict.WRONG, Verdict.MISSING) and self.basis is not Basis.SLIP


def _as_asked(one: VectorMark) -> bool:
    return one.verdict in (Verdict.RIGHT, Verdict.CLOSE) and one.basis is Basis.EXACT


@dataclass(frozen=True, slots=True, kw_only=True)
class FigureMark:
    """One figure: its vectors, what is drawn beside them, the gap of its polygon (mm on the sheet).

    mu: the own scale, SI per mm; declared: whether it was stated, or is that of the problem. turned: by how many
    degrees (ccw) this polygon alone is turned as a whole; mirrored: it is drawn in a mirror. doubt: why a person must
    look at it.
    """

    figure: str
    title: Words
    mu: float
    unit: str
    declared: bool
    vectors: tuple[VectorMark, ...]
    extra: tuple[Segment, ...] = ()
    gap: float = 0.0
    remarks: tuple[Words, ...] = ()
    drawn: bool = True
    turned: float = 0.0
    mirrored: bool = False
    doubt: Words | None = None

    def __getitem__(self, key: str) -> VectorMark:
        """The mark of this vector. Raises KeyError."""
        return next((one for one in self.vectors if one.key == key), None) or _none(key)


def _none(key: str) -> VectorMark:
    raise KeyError(key)


@dataclass(frozen=True, slots=True, kw_only=True)
class DrawingMark:
    """A drawing handed in: its figures, and what holds of all of it.

    slips: the catalogued mistakes that explain it; more than one where they draw the same, and none is named then.
    turned: degrees by which the whole sheet is turned; twice: lines that were drawn a second time over another.
    """

    problem: str
    file: str
    figures: tuple[FigureMark, ...]
    slips: tuple[Slip, ...] = ()
    mirrored: bool = False
    turned: float = 0.0
    twice: tuple[Segment, ...] = ()
    remarks: tuple[Words, ...] = ()

    @property
    def doubt(self) -> Words | None:
        """Why a person must look at all of it: it had to be held otherwise than it was handed in."""
        if self.mirrored:
            return Words("整幅图左右镜像了；请核对", "the whole drawing is mirrored; check it")
        if self.turned:
            return Words("整幅图转了方向；请核对", "the whole drawing is turned; check it")
        if (there := [one for one in self.figures if one.drawn]) and all(one.turned or one.mirrored for one in there):
            return _ALL_TURNED
        return _OTHERS if self.vectors and not self.slips and not any(map(_as_asked, self.vectors)) else None

    @property
    def vectors(self) -> tuple[VectorMark, ...]:
        """Those of all figures that are drawn."""
        return tuple(vector for one in self.figures if one.drawn for vector in one.vectors)

    @property
    def right(self) -> bool:
        """Whether every figure is drawn, and every vector right or nearly so."""
        fair = all(one.verdict in (Verdict.RIGHT, Verdict.CLOSE) for one in self.vectors)
        return fair and not self.mirrored and all(one.drawn for one in self.figures)

    @property
    def told(self) -> tuple[Words, ...]:
        """What is said of the whole, and of each figure: that it does not close, that a letter stands elsewhere."""
        figures = (one.title + Words("：", ": ") + said for one in self.figures for said in one.remarks)
        return (*self.remarks, *figures)

    @property
    def slip(self) -> Slip | None:
        """The one mistake that explains the drawing."""
        return self.slips[0] if len(self.slips) == 1 else None

    def __getitem__(self, figure: str) -> FigureMark:
        """The mark of this figure: ``velocity``. Raises KeyError."""
        for one in self.figures:
            if one.figure == figure:
                return one
        raise KeyError(figure)
