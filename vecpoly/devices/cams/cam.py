"""A plate cam and its follower, designed by inversion.

follower: {roller: 10 mm, offset: 6 mm}
r0: 50 mm                              # or alpha: {rise: 30 deg, return: 70 deg}, and the least r0 is sought
turns: ccw
motion: [rise 30 mm in 120 deg cosine, dwell 30 deg, return in 120 deg parabolic, dwell 90 deg]
stations: 15 deg
"""

from __future__ import annotations

from collections.abc import Collection
from math import degrees, pi, radians
from typing import Annotated, ClassVar, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, WithJsonSchema, model_validator

from ...errors import FaultError
from ...names import Named
from ...units.reading import Dim, Quantity
from ...words import Words
from ..base import Angle, Device, Length, as_written
from .asked import (
    ALPHA,
    ALPHA_BACK,
    ALPHA_RISE,
    APEX,
    CENTRAL,
    FARTHEST,
    NEAREST,
    PSI0,
    R0,
    REACH_BACK,
    REACH_RISE,
    RHO,
    RHO_PROFILE,
    S0,
    UNDERCUT,
    UNDERCUT_FLAT,
    E,
    polar,
    pressure,
    radius,
    travel,
)
from .corners import corners_noted
from .fits import clears, closes, first_angle, may_be_sized, stays_behind
from .follower import Follower
from .motion import Entry, Piece, pieces_of, read_entry, stations
from .told import cam_task, motion_told

Motion = Annotated[Entry, BeforeValidator(read_entry), WithJsonSchema({"type": "string"})]
FINEST, COARSEST = 5.0, 45.0  # deg between stations


class Allowed(BaseModel):
    """The greatest pressure angles that are allowed, on the rise and on the return.

    start: to the other side where the rise begins (s = 0, ds/dφ = 0), if that is bounded too.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, defer_build=True, populate_by_name=True)
    rise: Angle
    back: Angle = Field(alias="return")
    start: Angle | None = None

    @model_validator(mode="after")
    def _are_acute(self) -> Allowed:
        for key, angle in (("rise", self.rise), ("return", self.back), ("start", self.start)):
            if angle and not 0 < angle.si < pi / 2:
                raise FaultError(
                    Words(
                        f"alpha.{key} = {angle.text}：许用压力角应在 0 与 90 deg 之间；如写 30 deg",
                        f"alpha.{key} = {angle.text}: an allowed pressure angle lies between 0 and 90 deg; write e.g. "
                        "30 deg",
                    ),
                    code="out-of-range",
                )
        return self


class Cam(Device):
    """r0: radius of the base circle (of the pitch curve, where there is a roller); alpha instead: what is allowed."""

    kind: ClassVar[str] = "cam"
    ends_apart: ClassVar[bool] = True
    follower: Follower
    motion: Annotated[tuple[Motion, ...], Field(min_length=2)]
    r0: Length | None = None
    alpha: Allowed | None = None
    turns: Literal["ccw", "cw"] = "ccw"
    stations: Angle = Quantity(radians(15), "15 deg")

    @model_validator(mode="after")
    def _is_possible(self) -> Cam:
        assert self.pieces  # its refusals first
        step = degrees(self.stations.si)
        if not FINEST - 1e-9 <= step <= COARSEST + 1e-9:
            raise _out(
                "stations",
                self.stations.text,
                Words("分点间隔", "the stations stand"),
                f"{FINEST:g} … {COARSEST:g} deg",
            )
        if (self.r0 is None) == (self.alpha is None):
            raise FaultError(
                Words(
                    "r0 与 alpha 应写其一且只写其一：给出基圆半径 r0，或给出许用压力角 alpha 以求最小基圆",
                    "write one of r0 and alpha: the radius of the base circle, or the allowed pressure angles from "
                    "which the least one is found",
                ),
                code="contradiction",
                keys=("r0", "alpha"),
            )
        if self.r0 is None:
            may_be_sized(self.follower)
            return self
        clears(self.r0, self.follower)
        if self.arm:
            closes(self.r0, self.follower, self.lift)
        if self.arm and self.follower.flat:
            stays_behind(self.pieces, -self.sense * self.side)
        return self

    # -- what follows from the data ------------------------------------------------------------------------------

    @property
    def arm(self) -> tuple[float, float] | None:
        """OA and AB (m), where the follower swings; of a flat face, which has no B, the length that is drawn."""
        arm = self.follower.arm
        return (arm.OA.si, arm.length) if arm else None

    @property
    def side(self) -> int:
        """+1 where the arm swings about a pivot to the right of the axis, −1 to the left."""
        return self.follower.arm.sign if self.follower.arm else 1

    @property
    def face(self) -> float:
        """How far a flat face stands off the pivot of its arm, away from the cam (m)."""
        return self.follower.arm.off if self.follower.arm else 0.0

    @property
    def sense(self) -> int:
        """+1 where the cam turns counter-clockwise."""
        return 1 if self.turns == "ccw" else -1

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """The motion over a turn."""
        return pieces_of(tuple(self.motion), Dim.ANGLE if self.follower.arm else Dim.LENGTH)

    @property
    def lift(self) -> float:
        """The highest level (m, or rad)."""
        return max(piece.high for piece in self.pieces)

    @property
    def psi0(self) -> float:
        """The angle OAB at the start, or that between OA and a flat face (rad)."""
        assert self.follower.arm and self.r0
        return first_angle(self.r0, self.follower.arm, flat=self.follower.flat)

    @property
    def places(self) -> tuple[tuple[float, Piece], ...]:
        """The stations of a turn: angle and piece; the end of the turn is its start."""
        return tuple(stations(self.pieces, self.stations.si))[:-1]

    @property
    def size(self) -> float:
        """The largest radius (m), about."""
        if self.r0 is None:
            return self.lift
        return self.r0.si + (self.lift * self.arm[1] if self.arm else self.lift)

    def task(self, asked: Collection[str]) -> Words:
        """Which cam it is, in which letters."""
        return cam_task(self.follower, sized=self.alpha is not None, bounded=bool(self.alpha and self.alpha.start))

    def quantities(self) -> tuple[Named, ...]:
        """What is found of the whole cam, then at every station; or the least base circle."""
        if self.alpha is not None:
            return self.usual()
        here = [round(degrees(phi), 6) for phi, _ in self.places]
        moved = [travel(phi, swings=bool(self.arm)) for phi in here if phi]  # at the start it is nothing, as is θ
        points = (*(radius(phi) for phi in here), *(polar(phi) for phi in here if phi))
        pressed = () if self.follower.flat else tuple(pressure(phi) for phi in here)
        return (*self.usual(), *moved, *pressed, *points)

    def usual(self) -> tuple[Named, ...]:
        """What is found of the whole cam: nobody asks for a hundred numbers of its stations without naming them."""
        if self.alpha is not None:
            return (R0, E, S0, *APEX, CENTRAL)
        if self.follower.flat and self.arm:
            return (PSI0, RHO, UNDERCUT_FLAT, NEAREST, FARTHEST)
        if self.follower.flat:
            return (RHO, UNDERCUT_FLAT, REACH_RISE, REACH_BACK)
        first = (PSI0 if self.arm else S0, ALPHA, ALPHA_RISE, ALPHA_BACK, RHO)
        return (*first, RHO_PROFILE, UNDERCUT) if self.follower.roller else first

    def noted(self, asked: Collection[str]) -> tuple[Words, ...]:
        """That corners have no radius of curvature, where the least one is asked."""
        keys = {*asked} or {one.key for one in self.quantities()}
        return () if self.follower.flat or not {RHO.key, RHO_PROFILE.key} & keys else corners_noted(self.pieces)

    def told(self) -> tuple[Words, ...]:
        """Which way it turns, and how the follower moves."""
        return (motion_told(self.follower, self.pieces, clockwise=self.turns == "cw"),)

    def given(self) -> tuple[tuple[str, str], ...]:
        """r0 or [α], and the sizes of the follower."""
        f, told = self.follower, [("r_0", self.r0)]
        if self.alpha:
            told = [("[α_1]", self.alpha.rise), ("[α_2]", self.alpha.back), ("[α_0]", self.alpha.start)]
        told += [("r_r", f.roller), ("e", f.offset)]
        if f.arm:
            told += [("l_{OA}", f.arm.OA), ("l_{AB}", f.arm.AB), ("d", f.arm.face)]
        return as_written(told)


def _out(key: str, text: str, what: Words, span: str) -> FaultError:
    return FaultError(
        Words(f"{key} = {text}：{what.zh}应为 {span}", f"{key} = {text}: {what.en} {span} apart"), code="out-of-range"
    )
