"""The symbols of links and joints: each is carried along by the link that it belongs to."""

from __future__ import annotations

import cmath
from typing import Any

import numpy as np

from ...board import acts as done
from ...board.paper.marks import (
    Arc,
    Disc,
    FixedGuide,
    FrictionCircle,
    GearMark,
    Ground,
    LinkNumber,
    Mark,
    Passing,
    Slot,
    Weld,
)
from ...board.place import View
from ...drawing.scene import Stroke
from ...drawing.style import JOINT_RADIUS, LINK, THIN, Dash, Hue, Pen
from ...drawing.symbols.around import Surroundings
from ...drawing.symbols.bodies import WELD
from ...drawing.symbols.marks import draw
from ...mechanism.model import Drive
from ...methods.desk import Desk
from ...methods.diagram import Pose
from ...plane.derived import plain
from ...plane.traced import bare
from .figure import Figure

PLAIN = Surroundings(view=View.MECHANISM)
FINEST = 9  # decimals of a mm: ink need be no finer
FINE = 12  # points; a stroke through more is a ring or a rounded end
HALF_RING = JOINT_RADIUS + LINK / 2  # mm: of a bar that runs on past a pin
CIRCLES = Pen(width=THIN, dash=Dash.DASH_DOT, hue=Hue.GREY)


class Bodies:
    """What is drawn of the links of a mechanism."""

    def __init__(self, figure: Figure, desk: Desk, drive: Drive) -> None:
        self.figure, self.desk, self.drive = figure, desk, drive
        self._poses: dict[str, Pose] = {}

    def draw(self, act: done.Depict) -> None:
        """The symbols of one act, fixed on the frame or on the link that owns them."""
        for mark in act.marks:
            pose = None if isinstance(mark, Ground | FixedGuide) else self._pose(act.head.owner.removeprefix("link "))
            self._mark(mark, pose)

    def _mark(self, mark: Mark, pose: Pose | None) -> None:
        match mark:
            case (
                GearMark(centre=centre, radius=radius)
                | Disc(centre=centre, radius=radius)
                | FrictionCircle(centre=centre, radius=radius)
            ):
                self.figure.circle(
                    _carried(centre, pose), radius, CIRCLES if isinstance(mark, GearMark) else Pen(width=LINK)
                )
            case Slot(a=a, b=b):
                off = 2.5j * (b - a) / abs(b - a)
                for side in (off, -off):
                    self.figure.segment(_carried(a + side, pose), _carried(b + side, pose), Pen(width=0.5))
            case Passing(at=at, along=along):
                half = [at + HALF_RING * along * cmath.rect(1.0, cmath.pi * i / 6) for i in range(7)]
                self.figure.lines([_carried(spot, pose) for spot in half], Pen(width=LINK))
            case Weld(at=at, u=u, v=v, off=off):
                corner = at + off
                three = (corner, corner + WELD * u, corner + WELD * v, corner)
                self.figure.lines([_carried(spot, pose) for spot in three], Pen(width=LINK))
            case Arc() | LinkNumber():
                return
            case _:
                for item in draw(mark, PLAIN):
                    if isinstance(item, Stroke) and len(item.points) <= FINE:
                        self._stroke(item, pose)

    def _stroke(self, stroke: Stroke, pose: Pose | None) -> None:
        look = Pen(width=stroke.width, dash=stroke.dash, hue=stroke.hue)
        points = [_carried(point, pose) for point in stroke.points]
        if stroke.closed:
            points.append(points[0])
        if len(points) == 2:
            self.figure.segment(points[0], points[1], look)
        else:
            self.figure.lines(points, look)

    def angle(self, act: done.Angle) -> None:
        """The arc of φ, which ends on the crank wherever it is."""
        if act.label != f"φ_{self.drive.link}":
            return
        along = bare(self.desk.pose[self.drive.link].along)
        if (ray := self.drive.ray) is not None:
            along = along * cmath.rect(1.0, ray.lean)
        ends = (act.at, act.at + act.radius * cmath.rect(1.0, self.drive.zero), act.at + act.radius * along)
        self.figure.page.line("CircleArc", "conicpart", [self.figure.at(end) for end in ends], Pen(width=THIN))

    def _pose(self, link: str) -> Pose | None:
        """Where a link is: numbers of its own, so that all its lines are written short; None for what stands still."""
        if link not in self.desk.pose:
            return None
        if link not in self._poses:
            pose = self.desk.pose[link]
            self._poses[link] = Pose(bare(pose.origin), bare(pose.along))
            for value in (pose.origin, pose.along):
                for part in self.figure.terms.parts(bare(value)):
                    if not self.figure.spelling.knows(part):
                        self.figure.spelling.know(part, self.figure.page.hidden(self.figure.spelling.text(part)))
        return self._poses[link]


def _carried(at: complex, pose: Pose | None) -> Any:
    """A place fixed on a link, wherever the link goes."""
    if pose is None:
        return at
    own = complex((at - plain(pose.origin)) * np.conj(plain(pose.along)))
    return pose.origin + pose.along * complex(round(own.real, FINEST), round(own.imag, FINEST))
