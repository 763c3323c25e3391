"""Where a link stands at the problem's own position, where its joints leave that open because gears roll."""

from __future__ import annotations

from ...foundation.slotted import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Start:
    """The phase of a gear, the angle of an arm that gears move, the travel of a rack:
    a datum, as the drive's position is one.

    value: angle (rad) of the link's x axis from the ray ray[0] -> ray[1], or from the frame's x axis where there is no
    ray; or, where `slide`, travel (m) of the pin of the link's slide along its guide from the guide's origin. A gear
    that has no point but its centre needs none; one that is not told stands with its x axis along the frame's.
    """

    link: str
    value: float
    ray: tuple[str, ...] = ()
    slide: bool = False

    @property
    def key(self) -> str:
        """Of its value on a sheet."""
        return f"start_{self.link}"
