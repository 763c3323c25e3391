"""Kinds of curve, of body and of force that a legend explains."""

from __future__ import annotations

from math import tau

from ...board.construction import Figure, View
from ...board.paper.marks import Arc, Curve, Disc, Dot, Hatched, Lump, Mark, Plate, Point, Role, Segment, Vector
from ...words import Words
from .entry import HALF, MIDDLE, WIDE
from .kind import Kind
from .met import (
    Met,
    allowed,
    at_infinity,
    bored,
    has_lobes,
    is_added,
    is_arc_of_cam,
    is_base_circle,
    is_cognate,
    is_coupler_curve,
    is_flow,
    is_force,
    is_lump,
    is_path,
    is_solid,
    is_speed,
    is_void,
    of_rotor,
    osculates,
    taken_off,
    traced,
)
from .samples import Marks, arrow, line, pinned

BODY = (-1j * HALF, WIDE - 1j * HALF, WIDE + 1j * HALF, 1j * HALF)  # corners of a sample
AT, AWAY = 0.1, 6.0  # mm: an arrow starts at its point; no farther beside it
SMALL = HALF + 0.2  # mm: radius of a round sample


def _ring(mark: Mark) -> Marks:
    """A circle drawn as this one."""
    role = getattr(mark, "role", Role.RESULT)
    return (Arc(centre=MIDDLE, radius=SMALL, start=0.0, sweep=tau, role=role),)


def _role(mark: Mark) -> Role:
    return mark.role if isinstance(mark, Vector) else Role.RESULT


def _is_product(figure: Figure, mark: Mark) -> bool:
    """Whether it is the direction of a mass–radius product, on a rotor seen from its end."""
    return isinstance(mark, Vector) and of_rotor(figure) and mark.label.startswith("W")


def _mass(mark: Mark) -> Marks:
    """A mass, tinted where it is."""
    return (Disc(centre=MIDDLE, radius=SMALL, owner="mass"),) if isinstance(mark, Disc) else _ring(mark)


def _starts_beside(figure: Figure, mark: Mark) -> bool:
    """Whether it is a velocity that starts square beside a lettered point, and at none."""
    if not isinstance(mark, Vector) or not is_speed(figure, mark) or abs(mark.b - mark.a) < AT:
        return False
    back = ((mark.b - mark.a) / abs(mark.b - mark.a)).conjugate()
    offs = [back * (one.at - mark.a) for one in figure.marks if isinstance(one, Point) and one.label]
    return not any(abs(off) < AT for off in offs) and any(abs(off.real) < AT and abs(off.imag) < AWAY for off in offs)


def _beside_target(role: Role, *types: type[Mark]) -> Met:
    """Whether it is drawn so where the path of a point is held against a curve that is given."""
    drawn, path = traced(role, *types), traced(Role.CONSTRUCTION, Curve)

    def met(figure: Figure, mark: Mark) -> bool:
        return figure.view is View.MECHANISM and drawn(figure, mark) and any(path(figure, one) for one in figure.marks)

    return met


CURVES: tuple[Kind, ...] = (
    Kind(words=Words("点的轨迹", "path of a point"), met=_beside_target(Role.CONSTRUCTION, Curve), sample=line),
    Kind(words=Words("给定曲线", "curve that is given"), met=_beside_target(Role.HIDDEN, Curve), sample=line),
    Kind(words=Words("最大偏差", "maximum deviation"), met=_beside_target(Role.RESULT, Segment), sample=line),
    Kind(
        words=Words("廓线的曲率圆", "osculating circle of the profile"),
        met=osculates,
        sample=line,
        brief=Words("曲率圆", "osculating circle"),
    ),
    Kind(words=Words("定瞬心线", "fixed centrode"), met=traced(Role.LOCUS, Curve), sample=line),
    Kind(words=Words("动瞬心线", "moving centrode"), met=traced(Role.CARRIED, Curve), sample=line),
    Kind(words=Words("点的轨迹", "path of a point"), met=traced(Role.CENTRE, Curve), sample=line),
    Kind(words=Words("同源机构一", "first cognate"), met=is_cognate(Role.GIVEN), sample=line),
    Kind(words=Words("同源机构二", "second cognate"), met=is_cognate(Role.OTHER), sample=line),
    Kind(words=Words("点的轨迹", "path of a point"), met=is_path, sample=line),
    Kind(words=Words("连杆曲线", "coupler curve"), met=is_coupler_curve, sample=line),
    Kind(
        words=Words("凸轮廓线的一段", "part of the profile"),
        met=is_arc_of_cam(Role.RESULT),
        sample=line,
        brief=Words("凸轮廓线", "profile of the cam"),
    ),
    Kind(
        words=Words("理论廓线的一段", "part of the pitch curve"),
        met=is_arc_of_cam(Role.HIDDEN),
        sample=line,
        brief=Words("理论廓线", "pitch curve"),
    ),
    Kind(words=Words("基圆", "base circle"), met=is_base_circle, sample=line),
)


BODIES: tuple[Kind, ...] = (
    Kind(
        words=Words("力（长度不表示大小）", "force (length not to scale)"),
        met=is_force,
        sample=lambda _: arrow(Role.RESULT),
        plain=True,
    ),
    Kind(
        words=Words("质径积的方向", "direction of a mass–radius product"),
        met=_is_product,
        sample=lambda one: arrow(_role(one)),
        plain=True,
    ),
    Kind(
        words=Words("瞬心在无穷远的方向", "to a centre at infinity"),
        met=at_infinity,
        sample=lambda _: arrow(Role.DIRECTION),
    ),
    Kind(words=Words("配重", "counterweight"), met=is_lump(Lump.COUNTERWEIGHT), sample=_mass),
    Kind(words=Words("集中质量", "concentrated mass"), met=is_lump(Lump.OWN), sample=_mass),
    Kind(words=Words("试重", "trial weight"), met=is_lump(Lump.TRIAL), sample=_mass),
    Kind(words=Words("平衡质量", "balancing mass"), met=is_added, sample=_mass),
    Kind(words=Words("原有的孔、键槽", "hole or keyway it has"), met=is_void, sample=_ring),
    Kind(words=Words("去重孔、负质量", "hole to drill, negative mass"), met=bored, sample=_mass),
    Kind(
        words=Words("已随杆组拆去的转动副", "joint removed with an earlier group"),
        met=taken_off,
        sample=pinned(Dot.POINT),
    ),
    Kind(words=Words("功率流向", "flow of power"), met=is_flow, sample=lambda _: arrow(Role.GIVEN), plain=True),
    Kind(words=Words("许用不平衡量", "allowed unbalance"), met=allowed, sample=line),
    Kind(
        words=Words("点的速度", "velocity of a point"),
        met=lambda figure, mark: is_speed(figure, mark) and not _starts_beside(figure, mark),
        sample=lambda one: arrow(_role(one)),
        plain=True,
    ),
    Kind(
        words=Words("点的速度，画在点旁（以免与构件重合）", "velocity, drawn beside its point, off the link"),
        met=_starts_beside,
        sample=lambda one: arrow(_role(one)),
        plain=True,
        brief=Words("有的画在点旁（以免与构件重合）", "some beside their points, off the link"),
    ),
    Kind(
        words=Words("构件实体", "body of a link"),
        met=lambda _, mark: is_solid(mark),
        sample=lambda _: (Plate(points=BODY),),
        plain=True,
    ),
    Kind(
        words=Words("量取的面积", "area that is measured"),
        met=lambda figure, mark: isinstance(mark, Hatched) and not has_lobes(figure),
        sample=lambda _: (Hatched(points=BODY, rising=True),),
        plain=True,
    ),
)
