"""The follower of a cam: knife edge, roller or flat face; it slides in a guide, or swings on an arm."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, WithJsonSchema, model_validator

from ...errors import FaultError
from ...words import Words
from ..base import Length, Signed


def _yes(value: Any) -> bool:
    if isinstance(value, bool):
        return value
    if str(value).lower() not in ("yes", "true", "是"):
        raise FaultError(
            Words(f"“{value}”应写 yes，或略去此项", f"'{value}': write yes, or leave the key out"), code="spelling"
        )
    return True


Yes = Annotated[bool, BeforeValidator(_yes), WithJsonSchema({"enum": ["yes", True]})]


class Arm(BaseModel):
    """A follower that swings about A, to the right of the cam's centre O or to its left (`side`).

    Its end B starts above OA and leaves O. A flat face has no B; it lies on the cam from above, through A or at the
    distance `face` from A, positive away from the cam.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, defer_build=True)
    OA: Length
    AB: Length | None = None
    side: Literal["left", "right"] = "right"
    face: Signed | None = None

    @property
    def sign(self) -> int:
        """+1 to the right of O, −1 to its left."""
        return 1 if self.side == "right" else -1

    @property
    def length(self) -> float:
        """AB, or of a flat face OA (m)."""
        return self.AB.si if self.AB else self.OA.si

    @property
    def off(self) -> float:
        """How far the face stands off A (m)."""
        return self.face.si if self.face else 0.0


class Follower(BaseModel):
    """One of knife, roller (its radius) and flat; offset: the guide to the right of O; arm: where it swings."""

    model_config = ConfigDict(extra="forbid", frozen=True, defer_build=True)
    knife: Yes = False
    roller: Length | None = None
    flat: Yes = False
    offset: Signed | None = None
    arm: Arm | None = None

    @model_validator(mode="after")
    def _is_one(self) -> Follower:
        ends = [key for key, there in (("knife", self.knife), ("roller", self.roller), ("flat", self.flat)) if there]
        if len(ends) != 1:
            raise FaultError(
                Words(
                    f"从动件应为尖顶、滚子、平底之一，这里写的是 {'、'.join(ends) or '空'}；如写 {{roller: 10 mm}}、"
                    "{knife: yes} 或 {flat: yes}",
                    "a follower has a knife edge, a roller or a flat face, and here stand "
                    f"{', '.join(ends) or 'none'}; "
                    "write e.g. {roller: 10 mm}, {knife: yes} or {flat: yes}",
                ),
                code="spelling",
                keys=ends,
            )
        if self.offset is not None and (self.flat or self.arm):
            raise FaultError(
                Words(
                    "平底从动件的偏置不影响凸轮廓线，摆动从动件没有偏置；请略去 offset",
                    "the offset of a flat face changes nothing of the cam, and an arm has none; leave out 'offset'",
                ),
                code="contradiction",
                keys=("offset", "flat", "arm"),
            )
        if self.arm is not None:
            self._fits(self.arm)
        return self

    def _fits(self, arm: Arm) -> None:
        """An arm has the length AB up to its tip; a flat face has none, and may stand off A."""
        if self.flat and arm.AB is not None:
            raise FaultError(
                Words(
                    "摆动平底从动件没有端点 B，平底由 OA 与 face（到 A 的距离，可略）给出；请略去 AB",
                    "an arm with a flat face has no tip B: OA and 'face', its distance from A (0 where left out), say "
                    "where it is; leave out AB",
                ),
                code="contradiction",
                keys=("flat", ("arm", "AB")),
            )
        if not self.flat and (arm.AB is None or arm.face is not None):
            raise FaultError(
                Words(
                    "尖顶或滚子摆杆应写 OA 和 AB，face 只用于平底；如 arm: {OA: 80 mm, AB: 70 mm}",
                    "an arm with a roller or a knife edge has OA and AB, and 'face' belongs to a flat one; write e.g. "
                    "arm: {OA: 80 mm, AB: 70 mm}",
                ),
                code="missing" if arm.AB is None else "contradiction",
                keys=("arm", ("arm", "face")),
            )

    @property
    def remedy(self) -> Words:
        """What to do about a profile that is undercut: a flat face has no roller."""
        if self.roller:
            return Words("请减小滚子或加大 r0", "take a smaller roller or a larger r0")
        return Words("请加大 r0，或减小行程、加大其转角", "take a larger r0, or a smaller stroke over a larger angle")

    @property
    def radius(self) -> float:
        """Of the roller (m); 0 of a knife edge."""
        return self.roller.si if self.roller else 0.0

    @property
    def e(self) -> float:
        """Offset (m), to the right positive."""
        return self.offset.si if self.offset else 0.0
