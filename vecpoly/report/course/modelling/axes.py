"""Chapter 3, the coordinate system: the axes in the sketch, and how the angle of each link is told."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from math import degrees
from typing import Any

import numpy as np

from ....algebra.quantity import number
from ....board.construction import Figure
from ....board.paper.marks import AngleMark, Dot, Mark, Point, Role, Segment, TurnArrow, Vector
from ....drawing.figure import draw_figure
from ....findings.study.study import Study
from ....foundation.slotted import replace
from ....mechanism.groups.assur import hinges
from ....mechanism.model import FRAME, Link, Prismatic
from ....names import subscripted
from ....problem.problem import Shape
from ....words import Words
from ...picture import picture
from ..numbering import Press

_PICTURE = (125.0, 68.0)  # mm
_STILL = 1e-9  # rad, rad/s
_AXIS, _RAY, _RADIUS = 32.0, 15.0, 9.0  # mm
_ANGLES = {
    "zh": ["构件", "转角", "由 $x$ 轴正向量至", "题设位置"],
    "en": ["Link", "Angle", "Measured from $+x$ to", "Given position"],
}


def chapter(study: Study, press: Press) -> dict[str, Any]:
    """The figure, the origin, the table of angles."""
    press.chapter = "3"
    drawn = picture(replace(study.problem, loads=None), study.solution.construction, *_PICTURE)
    origin = _origin(study)
    place = study.mech.frame[origin]
    figure = None
    if drawn is not None:
        marks = tuple(m for m in drawn.marks if not isinstance(m, (AngleMark, TurnArrow)))
        figure = press.figure(
            draw_figure(replace(drawn, marks=(*marks, *_added(study, drawn, place))), lang=press.lang, caption=False),
            Words("坐标系与构件的转角", "The coordinate system and the angles of the links"),
        )
    frame = ("；" if press.lang == "zh" else "; ").join(
        f"${name}$ ({number(1e3 * at.real, 6)}, {number(1e3 * at.imag, 6)})" for name, at in study.mech.frame.items()
    )
    return {
        "figure": figure or "",
        "origin": subscripted(origin),
        "at_origin": abs(place) < 1e-12,
        "frame": frame,
        "angles": _table(study, press),
    }


def _origin(study: Study) -> str:
    """The fixed letter at the origin, else the input link's pivot."""
    frame = study.mech.frame
    pinned = next(
        (p for p, names in hinges(study.mech).items() if FRAME in names and study.mech.drive.link in names),
        next(iter(frame)),
    )
    return next((name for name, at in frame.items() if abs(at) < 1e-12), pinned)


def _added(study: Study, figure: Figure, place: complex) -> Iterator[Mark]:
    """Axes from the origin, and φ of every link that turns."""
    per_m = 1 / figure.scale.value
    start = place * per_m
    for way, name in ((1 + 0j, "x"), (1j, "y")):
        yield Vector(a=start, b=start + _AXIS * way, role=Role.GIVEN)
        yield Point(at=start + (_AXIS + 0.5) * way, label=name, dot=Dot.NONE)
    for link in (study.mech.drive.link, *study.links):
        points = study.mech.link(link).points
        if not points or (link == study.mech.drive.link and study.mech.drive.slide) or _gear(study, link):
            continue
        first = study.at[next(iter(points))] * per_m
        angle = cmath.phase(cmath.rect(1.0, study.turned[link]))
        sweep = angle if angle > 0 else angle + 2 * cmath.pi
        if abs(first - start) > 1e-9:
            yield Segment(a=first, b=first + _RAY, role=Role.CENTRE)
        yield AngleMark(at=first, radius=_RADIUS, start=0.0, sweep=sweep, label=f"φ_{{{study.name(link)}}}")


def _gear(study: Study, link: str) -> bool:
    """Whether the link is a gear: no line on it tells its angle."""
    return study.problem.given.shapes.get(link) is Shape.GEAR


def _lettered(link: Link) -> bool:
    """Whether its first two letters lie on its axis, in this order: the second may be set out beside it."""
    first, second = [*link.points.values(), 0j, 0j][:2]
    return len(link.points) > 1 and abs(cmath.phase(second - first)) < _STILL


def _guided(study: Study, link: str, letter: str) -> Words:
    """The axis of a link that no two letters tell: parallel to the link whose angle it keeps, else its own slideway,
    else the guide's positive direction."""
    joint = next(
        (j for j in study.mech.joints if isinstance(j, Prismatic) and link == j.block and j.guide != FRAME), None
    )
    if joint is not None:
        return Words(
            f"随构件 {study.name(joint.guide)} 的导路方向（过 ${letter}$）",
            f"the guide of link {study.name(joint.guide)}, through ${letter}$",
        )
    if any(isinstance(j, Prismatic) and j.guide == link for j in study.mech.joints):
        return Words(f"本构件的导路（过 ${letter}$）", f"its own slideway, through ${letter}$")
    return Words(f"导路正方向（过 ${letter}$）", f"the positive direction of the guide, through ${letter}$")


def _table(study: Study, press: Press) -> str:
    rows = []
    for link in study.mech.numbered:
        letters = [subscripted(letter) for letter in study.mech.link(link).points]
        if not letters or _gear(study, link):
            continue
        ray = (
            Words.same(f"${letters[0]}→{letters[1]}$")
            if _lettered(study.mech.link(link))
            else _guided(study, link, letters[0])
        )
        if all(abs(z) < _STILL for z in (study.turned[link],)) and not np.any(
            np.abs(study.turn.real(f"omega_{link}")) > _STILL
        ):
            continue  # it keeps its direction along x
        told = study.turn.at(f"phi_{link}", [study.mech.drive.position])
        angle = degrees(float(np.asarray(told).real[0]))
        rows.append(
            (study.name(link), f"$φ_{{{study.name(link)}}}$", ray.of(press.lang), f"{angle:.2f}°".replace("-", "−"))
        )
    return press.table(Words("各构件的转角", "The angles of the links"), _ANGLES[press.lang], rows, "cclr")
