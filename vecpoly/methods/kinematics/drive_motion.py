"""Velocity and acceleration of the driving link: v_B = ω_1 l_AB, a_B^n = ω_1² l_AB, a_B^t = α_1 l_AB."""

from __future__ import annotations

import numpy as np

from ...algebra.quantity import Product, magnitude
from ...board.construction import View
from ...board.paper.marks import Role
from ...mechanism.model import FRAME, Drive, Prismatic
from ...names import At, Kind, Rel, alpha, omega
from ...plane import Points, Reals
from ...words import Words
from ..desk import POLE, VECTOR, Desk, Turn
from ..devices.speeds import of_turns
from ..registry import Stage, method
from .chains import never_turns
from .image import images_of_link

_SOURCE = "机械原理, kinematic analysis by the vector equation method"
_TITLE = Words("原动件的运动", "Motion of the driving link")


@method(stage=Stage.VELOCITY, group="crank", title=_TITLE, source=_SOURCE, example="3-9")
def velocity_crank(desk: Desk, drive: Drive) -> None:
    """v_B = ω_1 l_AB, perpendicular to AB in the sense of ω_1: the first vector of the polygon."""
    board = desk.board
    desk.turns[omega(drive.link)] = Turn(drive.rate)
    pivot, others = desk.crank(drive.link)
    if not others:
        return
    b = others[0]
    name, tip = desk.show(At(b)), desk.tip_label(View.VELOCITY, At(b))
    way, way_en = ("逆时针", "counter-clockwise") if drive.rate > 0 else ("顺时针", "clockwise")
    board.step(
        Words(
            f"$v_{{{name}}}$ ⊥ ${pivot}{b}$，指向与 $ω_{drive.link}$（{way}）一致；{_taken(desk, View.VELOCITY)}"
            f"作 $p{tip}$ 代表 $v_{{{name}}}$：",
            f"The velocity $v_{{{name}}}$ is perpendicular to ${pivot}{b}$ in the sense of $ω_{drive.link}$ "
            f"({way_en}); from the pole $p$ lay off $p{tip}$ for $v_{{{name}}}$:",
        ),
        View.VELOCITY,
    )
    w = magnitude(f"ω_{drive.link}", abs(drive.rate), "rad/s")
    if drive.in_turns:
        board.write_worked(w.node, of_turns(f"n_{drive.link}", w.value), w.unit)
    speed = board.compute(f"v_{{{name}}}", w * desk.length(pivot, b), "m/s")
    board.write_length(View.VELOCITY, f"p {tip}", speed)
    along = 1j * np.sign(drive.rate) * desk.towards(pivot, b)
    _first_vector(desk, View.VELOCITY, b, along, speed.value)
    desk.known_as[View.VELOCITY, At(b)] = (
        Words.same(f"⊥$ {pivot}{b}$"),
        f"$ω_{drive.link} l_{desk.bar(drive.link, pivot, b)}$",
    )
    images_of_link(desk, View.VELOCITY, drive.link)


@method(stage=Stage.ACCELERATION, group="crank", title=_TITLE, source=_SOURCE, example="3-9")
def acceleration_crank(desk: Desk, drive: Drive) -> None:
    """a_B = a_B^n (towards A) + a_B^t (perpendicular, in the sense of α_1)."""
    board = desk.board
    desk.turns[alpha(drive.link)] = Turn(drive.accel)
    pivot, others = desk.crank(drive.link)
    if not others:
        return
    b = others[0]
    shown = desk.show(At(b))
    name = f"a^n_{{{shown}}}" if drive.accel else f"a_{{{shown}}}"
    board.step(_turned(desk, drive, pivot, b), View.ACCELERATION)
    w = magnitude(f"ω_{drive.link}", abs(drive.rate), "rad/s")
    size = board.compute(name, w.squared() * desk.length(pivot, b), "m/s^2")
    first = desk.n_tip(drive.link) if drive.accel else desk.tip_label(View.ACCELERATION, At(b))
    board.write_length(View.ACCELERATION, f"p′ {first}", size)
    along = desk.towards(b, pivot)
    tip = _first_vector(desk, View.ACCELERATION, b, along, size.value, desk.n_tip(drive.link) if drive.accel else "")
    if not drive.accel:
        desk.known_as[View.ACCELERATION, At(b)] = (
            Words.same(f"${b}→{pivot}$"),
            f"$ω_{drive.link}^2 l_{desk.bar(drive.link, pivot, b)}$",
        )
    else:
        _tangential(desk, drive, pivot, b, tip)
    images_of_link(desk, View.ACCELERATION, drive.link)


def _tangential(desk: Desk, drive: Drive, pivot: str, b: str, tip: Points) -> None:
    """a_B^t = α_1 l_AB laid off from the end of a_B^n; it ends in b′."""
    board = desk.board
    eps = magnitude(f"α_{drive.link}", abs(drive.accel), "rad/s^2")
    size_t = board.compute(f"a^t_{{{desk.show(At(b))}}}", eps * desk.length(pivot, b), "m/s^2")
    board.write_length(
        View.ACCELERATION, f"{desk.n_tip(drive.link)} {desk.tip_label(View.ACCELERATION, At(b))}", size_t
    )
    parts = [desk.key(Rel(kind, At(b))) for kind in (Kind.AT, Kind.A)]
    end = board.lay_off(
        tip,
        1j * np.sign(drive.accel) * desk.towards(pivot, b),
        board.to_paper(View.ACCELERATION, size_t.value),
        key=parts[0],
    )
    end = desk.put_tip(View.ACCELERATION, At(b), end)
    board.arrow(View.ACCELERATION, tip, end, Role.GIVEN, key=parts[0])
    board.plot(View.ACCELERATION, end, desk.tip_label(View.ACCELERATION, At(b)))
    board.arrow(View.ACCELERATION, 0j, end, Role.RESULT, key=parts[1])


def _turned(desk: Desk, drive: Drive, pivot: str, b: str) -> Words:
    """The directions of a_B^n and a_B^t, or of a_B at constant speed."""
    tip, link, n = desk.tip_label(View.ACCELERATION, At(b)), drive.link, desk.n_tip(drive.link)
    if drive.accel:
        return Words(
            f"${b}$ 点的法向加速度由 ${b}$ 指向 ${pivot}$，切向加速度垂直于 ${pivot}{b}$，指向与 $α_{link}$ 一致；"
            f"{_taken(desk, View.ACCELERATION)}依次作 $p′{n}$、${n}{tip}$：",
            f"The normal acceleration of ${b}$ points from it to ${pivot}$, and the "
            f"tangential one is perpendicular to ${pivot}{b}$ in the sense of $α_{link}$; from the "
            f"pole $p′$ lay off $p′{n}$ and ${n}{tip}$:",
        )
    return Words(
        f"构件 {link} 匀速转动（$α_{link}$ = 0），$a_{{{desk.show(At(b))}}}$ 只有法向分量，由 ${b}$ 指向 ${pivot}$；"
        f"{_taken(desk, View.ACCELERATION)}作 $p′{tip}$：",
        f"Link {link} rotates uniformly ($α_{link}$ = 0), so $a_{{{desk.show(At(b))}}}$ is purely normal and points "
        f"from ${b}$ to ${pivot}$; from the pole $p′$ lay off $p′{tip}$:",
    )


def _taken(desk: Desk, view: View) -> str:
    """The pole is taken once, for the first of several drives that lays off a vector."""
    taken = any(place is view for place, _ in desk.board.ledger.laid)
    return "" if taken else f"取极点 ${POLE[view]}$，"


@method(stage=Stage.VELOCITY, group="slide", title=_TITLE, source=_SOURCE, example="")
def velocity_slide(desk: Desk, drive: Drive) -> None:
    """All points of a driving slider have its velocity along the guide."""
    never_turns(desk, drive.link)
    _slide(desk, View.VELOCITY, drive, drive.rate, "v", "m/s")


@method(stage=Stage.ACCELERATION, group="slide", title=_TITLE, source=_SOURCE, example="")
def acceleration_slide(desk: Desk, drive: Drive) -> None:
    """All points of a driving slider have its acceleration along the guide."""
    _slide(desk, View.ACCELERATION, drive, drive.accel, "a", "m/s^2")


def _slide(desk: Desk, view: View, drive: Drive, value: float, stem: str, unit_text: str) -> None:
    joint = next(j for j in desk.mech.joints if isinstance(j, Prismatic) and j.block == drive.link and j.guide == FRAME)
    along = desk.guide_line(joint).along * (np.sign(value) or 1)
    pole, b = POLE[view], joint.pin
    if not value:
        _no_vector(desk, view, drive, b)
        return
    tip = desk.tip_label(view, At(b))
    desk.board.step(
        Words(
            f"滑块 {drive.link} 沿导路移动；{_taken(desk, view)}作 ${pole}{tip}$ 代表 ${stem}_{b}$：",
            f"Slider {drive.link} moves along its guide; from the pole ${pole}$ lay off "
            f"${pole}{tip}$ for ${stem}_{b}$:",
        ),
        view,
    )
    own = Product((magnitude(f"{stem}_{drive.link}", abs(value), unit_text),))  # the given v_1 is v_A
    size = desk.board.compute(f"{stem}_{b}", own, unit_text)
    desk.board.write_length(view, f"{pole} {tip}", size)
    _first_vector(desk, view, b, along, abs(value))
    images_of_link(desk, view, drive.link)


def _no_vector(desk: Desk, view: View, drive: Drive, b: str) -> None:
    """A slider at constant speed, or at rest: its point is at the pole."""
    rel, pole = Rel(VECTOR[view], At(b)), POLE[view]
    tip, why = (
        desk.tip_label(view, At(b)),
        Words("作匀速移动", "moves at constant speed") if view is View.ACCELERATION else Words("静止", "is at rest"),
    )
    desk.board.step(
        Words(
            f"滑块 {drive.link} {why.zh}，${rel.symbol}$ = 0，${tip}$ 与极点 ${pole}$ 重合。",
            f"Slider {drive.link} {why.en}: ${rel.symbol}$ = 0, and ${tip}$ lies at the pole ${pole}$.",
        ),
        view,
    )
    desk.board.given_size(desk.symbol(rel), 0.0, rel.kind.unit)
    _first_vector(desk, view, b, 1 + 0j, 0.0)
    images_of_link(desk, view, drive.link)


def _first_vector(desk: Desk, view: View, b: str, along: Points, size: Reals, part: str = "") -> Points:
    """Lay the first vector off from the pole; part: the letter of its tip where it is not the whole."""
    board = desk.board
    name = desk.key(Rel(VECTOR[view] if not part else Kind.AN, At(b)))
    tip = board.lay_off(0j, along, board.to_paper(view, size), key=name)
    tip = desk.put_tip(view, At(b), tip) if not part else board.locate(view, part, tip)
    board.arrow(view, 0j, tip, Role.GIVEN, key=name)
    board.plot(view, tip, part or desk.tip_label(view, At(b)))
    return tip
