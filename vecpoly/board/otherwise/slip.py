"""One mistake that somebody makes at the board; all that follows is drawn from it."""

from __future__ import annotations

from enum import StrEnum
from typing import NamedTuple

from ...foundation.slotted import dataclass
from ...words import Words


class Mistake(StrEnum):
    """What is done wrongly."""

    REVERSED = "reversed"  # a vector laid off the wrong way
    DROPPED = "dropped"  # a vector left out
    HALVED = "halved"  # the 2 of 2ωv forgotten
    DOUBLED = "doubled"  # a diameter for a radius
    TURNED = "turned"  # along the link instead of across it
    SCALED = "scaled"  # laid off with another figure's scale
    COINCIDENT = "coincident"  # the vector of the other link's point at this place
    OTHER_MEETING = "other meeting"  # the links put together the other way
    TURNED_OVER = "turned over"  # an image whose letters run the other way round
    OTHER_CENTRE = "other centre"  # a line through the wrong two centres
    OTHER_TANGENT = "other tangent"  # on the wrong side of the friction circle
    COMPLEMENT = "complement"  # θ set out for 90° − θ, or the other way round
    OTHER_SIDE = "other side"  # an angle set out on the wrong side
    SWAPPED = "swapped"  # of two shares each taken for the other
    FORWARDS = "forwards"  # a figure carried on with the motion, not turned back
    DEGREES = "degrees"  # an area under M over φ taken with degrees for radians
    PER_MINUTE = "per minute"  # n (r/min) taken for ω
    COUNTED = "counted as a crossing"  # where two lines only touch, so that the next area has the wrong sign
    WITH_FRAME = "counted with the frame"  # the moving links
    AS_ONE = "counted as one"  # a compound hinge as a single revolute
    OMITTED = "left out of its formula"  # a term
    SIGN = "of the wrong sign in its formula"  # a term
    INVERTED = "upside down in its formula"  # a ratio, or an efficiency multiplied by in place of divided by
    UNSQUARED = "not squared in its formula"
    COFUNCTION = "sine for cosine in its formula"  # or the other way round

    @property
    def words(self) -> Words:
        """What is done wrongly, in words: 方向画反, reversed."""
        return Words(_WORDS[self], self.value)


_WORDS = {
    Mistake.REVERSED: "方向画反",
    Mistake.DROPPED: "漏画",
    Mistake.HALVED: "大小少了一半",
    Mistake.DOUBLED: "大小多了一倍",
    Mistake.TURNED: "方向转过了 90°",
    Mistake.SCALED: "用错比例尺",
    Mistake.COINCIDENT: "取错重合点",
    Mistake.OTHER_MEETING: "取了另一交点",
    Mistake.TURNED_OVER: "所在相似形的字母绕行顺序取反",
    Mistake.OTHER_CENTRE: "连错瞬心",
    Mistake.OTHER_TANGENT: "切于摩擦圆的另一侧",
    Mistake.COMPLEMENT: "取了余角",
    Mistake.OTHER_SIDE: "角作在另一侧",
    Mistake.SWAPPED: "两分量互换",
    Mistake.FORWARDS: "反转方向取反",
    Mistake.DEGREES: "转角未化为弧度",
    Mistake.PER_MINUTE: "把转速 n 当作角速度",
    Mistake.COUNTED: "把同号相邻当作变号",
    Mistake.WITH_FRAME: "把机架计入活动构件",
    Mistake.AS_ONE: "把复合铰链按一个转动副计",
    Mistake.OMITTED: "的算式中漏了一项",
    Mistake.SIGN: "的算式中有一项符号取反",
    Mistake.INVERTED: "的算式中分子与分母颠倒",
    Mistake.UNSQUARED: "的算式中漏了平方",
    Mistake.COFUNCTION: "的算式中正弦与余弦取错",
}
FOUND_AMISS = (Mistake.OTHER_MEETING, Mistake.TURNED_OVER)  # of two places where a point may be found, the wrong one
# whose words tell of what
TOLD_OF = (Mistake.AS_ONE, Mistake.OMITTED, Mistake.SIGN, Mistake.INVERTED, Mistake.UNSQUARED, Mistake.COFUNCTION)


class Chance(NamedTuple):
    """A mistake that may be made with what is computed; instead: what is taken for it, or mistaken in its formula."""

    mistake: Mistake
    instead: str = ""


@dataclass(frozen=True, slots=True)
class Slip:
    """A mistake, and of what:
    the key of a quantity, with its figure where it stands on several (``force 23:R_32``), or the letter of a point.

    instead: of a coincident point, or of a centre on a line, the letter of the one taken for it; of a formula the term,
    ratio or factor that is mistaken.
    """

    mistake: Mistake
    key: str
    instead: str = ""

    @property
    def words(self) -> Words:
        """The mistake, of what, and on which figure: e 方向画反（mechanism rho_min）."""
        figure, _, key = self.key.rpartition(":")
        there = Words(f"（{figure}）", f" ({figure})") if figure else Words.same("")
        what = Words.same("")
        if self.mistake in TOLD_OF:
            what = Words(f"（{self.instead}）", f" ({self.instead})")
        return Words.same(f"{key} ") + self.mistake.words + what + there

    def __str__(self) -> str:
        return f"{self.key} {self.mistake.value}" + (f" ({self.instead})" if self.instead else "")
