"""Which assembly is meant, in a lecturer's words:
on which side a point lies, or which figure a four-bar makes all the way round."""

from __future__ import annotations

from enum import StrEnum

from ...foundation.slotted import dataclass
from ...words import Words
from ..dimensions.placements import Side


class Form(StrEnum):
    """What a four-bar with equal opposite sides makes:
    with sides that stay parallel (平行四边形), or crossed (反平行四边形)."""

    PARALLELOGRAM = "parallelogram"
    ANTIPARALLELOGRAM = "antiparallelogram"

    @property
    def words(self) -> Words:
        """As a sentence calls it."""
        return (
            Words("平行四边形", "a parallelogram")
            if self is Form.PARALLELOGRAM
            else Words("反平行四边形", "an antiparallelogram")
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class SideOf:
    """Branch of an assembly: `point` lies on `side` of the ray ref[0] -> ref[1], or of the single point ref[0]."""

    point: str
    side: Side
    ref: tuple[str, ...]

    @property
    def letters(self) -> tuple[str, ...]:
        """The letters of which it speaks."""
        return (self.point, *self.ref)

    def __str__(self) -> str:
        of = "of " if self.side in (Side.LEFT, Side.RIGHT) else ""
        return f"{self.point} {self.side.value} {of}{''.join(self.ref)}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Shaped:
    """Branch of a four-bar ABCD, its corners in their order round the loop: AB = CD and BC = AD."""

    corners: tuple[str, str, str, str]
    form: Form

    @property
    def letters(self) -> tuple[str, ...]:
        """The letters of which it speaks."""
        return self.corners

    def __str__(self) -> str:
        return f"{''.join(self.corners)} {self.form.value}"


Statement = SideOf | Shaped
