"""A plane in which a rotor is corrected: by a weight, by a hole, at any angle or at fixed places."""

from __future__ import annotations

from math import degrees, isclose, pi, tau
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, WithJsonSchema, model_validator

from ...errors import FaultError
from ...units.reading import Dim, Quantity, positive, read
from ...words import Words
from ..base import Angle, Length, Signed
from .mass import RotorDisc
from .written import Density, Entry, MassSize

THROUGH = Quantity(0.0, "through")
MOST_PLACES = 360


def _drilled(text: Any) -> Quantity:
    """The diameter of the drill; `through`: that of a hole through the disc is sought."""
    if isinstance(text, Quantity):
        return text
    return THROUGH if str(text).strip() in ("through", "通孔") else positive(text, Dim.LENGTH)


def _angles(value: Any) -> tuple[Quantity, ...]:
    """A list of directions; one alone is the pitch of a circle of holes that begins at 0°."""
    if isinstance(value, list | tuple):
        return tuple(one if isinstance(one, Quantity) else read(one, Dim.ANGLE) for one in value)
    pitch = read(value, Dim.ANGLE)
    count = round(tau / pitch.si) if pitch.si else 0
    if not 2 < count <= MOST_PLACES or not isclose(count * pitch.si, tau, rel_tol=1e-9):
        raise FaultError(
            Words(
                f"孔距 {pitch.text} 不能等分圆周；如写 30 deg，或列出各角度 [90 deg, 200 deg]",
                f"a pitch of {pitch.text} does not divide the circle; write e.g. 30 deg, or list the directions, "
                "[90 deg, 200 deg]",
            ),
            code="out-of-range",
        )
    return tuple(Quantity(k * tau / count, f"{360 * k / count:g} deg") for k in range(count))


Drill = Annotated[Quantity, BeforeValidator(_drilled), WithJsonSchema({"type": "string"})]
Places = Annotated[
    tuple[Quantity, ...], BeforeValidator(_angles), WithJsonSchema({"type": ["string", "array"], "items": {}})
]


class RotorPlane(Entry):
    """z: along the axis; r: radius of the correction. hole: drilled, `through` or with a drill of this diameter.

    spread: half the angle between two equal holes in place of one. places: where a weight may sit; use: two of them.
    only: whether weights may be added, or removed, only. step: the weights there are differ by so much.
    """

    z: Signed | None = None
    r: Length | None = None
    hole: Drill | None = None
    spread: Angle | None = None
    b: Length | None = None
    density: Density | None = None
    places: Places | None = None
    use: Places | None = None
    only: Literal["add", "remove"] | None = None
    step: MassSize | None = None

    def drilled(self, name: str) -> Words:
        """Where the two holes of this plane are."""
        apart = "" if self.spread is None else self.spread.text
        return Words(
            f"平面 {name} 内在所需方位两侧各 {apart} 处钻两个相同的孔",
            f"in plane {name} two equal holes are drilled, {apart} to either side of the direction needed",
        )

    @property
    def at(self) -> float:
        """Along the axis (m)."""
        return 0.0 if self.z is None else self.z.si

    @property
    def through(self) -> bool:
        """Whether the diameter of a hole through the disc is sought."""
        return self.hole is not None and self.hole.text == THROUGH.text

    @property
    def holes(self) -> int:
        """How many holes are drilled."""
        return 0 if self.hole is None else 1 if self.spread is None else 2

    def within(self, disc: RotorDisc, name: str) -> RotorPlane:
        """The same with thickness and density of the disc, where holes are drilled; FaultError where they lack."""
        if self.hole is None:
            return self
        deep, density = self.b or disc.b, self.density or disc.density
        if deep is None or density is None:
            raise FaultError(
                Words(
                    "钻孔校正须知厚度 b 和密度 density；如写 disc: {b: 40 mm, density: 7850 kg/m^3}",
                    "a hole needs the thickness b and the density of the disc: write e.g. "
                    "disc: {b: 40 mm, density: 7850 kg/m^3}",
                ),
                "correct",
                name,
                code="missing",
                keys=("hole",),
            )
        return self.model_copy(update={"b": deep, "density": density})

    @model_validator(mode="after")
    def _fits(self) -> RotorPlane:
        for key in ("hole", "places", "step"):
            if getattr(self, key) is not None and self.r is None:
                raise FaultError(
                    Words(
                        f"写了 {key} 就须写校正半径 r，如 r: 250 mm",
                        f"{key} needs the radius of the correction: write e.g. r: 250 mm",
                    ),
                    code="missing",
                    keys=("r",),
                )
        if self.hole is not None and (self.places or self.use or self.only or self.step):
            raise FaultError(
                Words(
                    "钻孔校正的方位由作图定出，不能再写 places、use、only、step",
                    "a hole is drilled where the drawing says: places, use, only and step belong to weights",
                ),
                code="contradiction",
                keys=("hole", "places", "use", "only", "step"),
            )
        if self.spread is not None and not (self.hole is not None and 0 < self.spread.si < pi / 2):
            raise FaultError(
                Words(
                    f"spread = {self.spread.text}：两孔与所求方向的夹角，只用于钻孔，在 0 与 90 deg 之间",
                    f"spread = {self.spread.text}: the angle of two holes from the direction found; it belongs to "
                    "holes and lies between 0 and 90 deg",
                ),
                code="out-of-range",
                keys=("hole", "spread"),
            )
        self._placed()
        self._two_places()
        return self

    def _placed(self) -> None:
        """FaultError where something is said of places and there are none."""
        if (self.only or self.use) and not self.places:
            raise FaultError(
                Words(
                    "only、use 属于固定方位；请同时写 places，如 places: 30 deg",
                    "only and use belong to fixed places: write places as well, e.g. places: 30 deg",
                ),
                code="missing",
                keys=("places", "use", "only"),
            )

    def _two_places(self) -> None:
        """FaultError where two places are no two directions."""
        pair = self.use if self.use is not None else self.places
        if self.use is not None and len(self.use) != 2:
            raise FaultError(
                Words("use 是两个方位，如 [90 deg, 120 deg]", "use: two directions, e.g. [90 deg, 120 deg]"),
                code="spelling",
                keys=("use",),
            )
        if pair is None:
            return
        turns = {round(degrees(one.si) % 360, 6) % 360 for one in pair}
        if len(turns) != len(pair) or (len(pair) == 2 and abs(abs(turns.pop() - turns.pop()) - 180) < 1e-6):
            raise FaultError(
                Words(
                    f"方位 {'、'.join(one.text for one in pair)} 相同或相反，不能沿它们分解",
                    f"the directions {', '.join(one.text for one in pair)} are equal or opposite: nothing can be "
                    "resolved along them",
                ),
                code="contradiction",
            )
