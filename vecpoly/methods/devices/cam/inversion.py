"""The cam by inversion: base circle, guide or arm at every station, pitch curve, roller circles, profile."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....devices.cams.cam import PSI0, S0, Cam, pressure, radius
from ....devices.cams.motion import Piece
from ....diagram.cam_plate import draw_arm, draw_pivot, draw_stem
from ....plane import Line, Points, foot
from ....words import Words
from ..bench import Bench
from .diagram import Station, place_of
from .laws import lift
from .pose import Pose, pose
from .readings import acute, length, noted, written

VIEW = View.MECHANISM
CROWDED = 24  # stations: of more only every other is numbered
FACE = 0.6  # of r0: how far a flat face is drawn to either side


@dataclass(frozen=True, slots=True, kw_only=True)
class Cut:
    """A station of the cam: where the follower stands, and where it touches the profile."""

    station: Station
    pose: Pose
    touch: Points


def invert(bench: Bench, cam: Cam, stations: Sequence[Station]) -> tuple[Cut, ...]:
    """Draw the cam; gives every station of it."""
    _given(bench, cam)
    cuts = _pitch(bench, cam, stations)
    _profile(bench, cam, cuts)
    return cuts


def _given(bench: Bench, cam: Cam) -> None:
    """Base circle, offset circle or circle of pivots, the follower at the start."""
    board, mm = bench.board, bench.board.scale_of(VIEW).value
    assert cam.r0
    board.section(Words("凸轮廓线（反转法）", "Profile of the cam, by inversion"))
    board.step(_opening(cam), VIEW)
    board.circle(VIEW, 0j, cam.r0.si / mm, Role.CENTRE)
    if cam.arm:
        board.circle(VIEW, 0j, cam.arm[0] / mm, Role.CENTRE)
    elif cam.follower.e:
        board.circle(VIEW, 0j, abs(cam.follower.e) / mm, Role.CENTRE)
    draw_pivot(board, VIEW, 0j, cam.sense)
    first = _at(bench, cam, 0.0, cam.pieces[0])
    if cam.arm:
        draw_arm(board, VIEW, first.start, first.b, cam.follower.radius / mm)
    else:
        face = FACE * cam.r0.si / mm if cam.follower.flat else 0.0
        draw_stem(board, VIEW, first.b, first.way, cam.follower.radius / mm, face)
    if cam.follower.flat:
        return
    if cam.arm:
        angle = acute(bench, -first.start, first.base - first.start)
        bench.stated(PSI0, angle)
    else:
        length(bench, S0, VIEW, first.start, first.base, "C_0 B_0")


def _opening(cam: Cam) -> Words:
    if cam.arm:
        return Words(
            "按 $μ_l$ 作基圆（半径 $r_0$）和以 $OA$ 为半径的摆动中心圆；以 $A$ 为圆心、$AB$ 为半径的弧交基圆于 $B_0$，"
            "量得摆杆的初始角 $ψ_0$。",
            "To the scale $μ_l$ draw the base circle of radius $r_0$ and the circle of the pivots through $A$ about "
            "$O$; "
            "the arc of radius $AB$ about $A$ meets the base circle in $B_0$, and $ψ_0$ is read there.",
        )
    if cam.follower.flat:
        return Words(
            "按 $μ_l$ 作基圆（半径 $r_0$）；从动件的导路过 $O$，平底与导路垂直，起始时与基圆相切。",
            "To the scale $μ_l$ draw the base circle of radius $r_0$. The guide passes through $O$; the face, at right "
            "angles to it, touches the base circle at the start.",
        )
    return Words(
        "按 $μ_l$ 作基圆（半径 $r_0$）和偏距圆（半径 $e$）；导路切偏距圆于 $C_0$，交基圆于 $B_0$，量得 $s_0$。",
        "To the scale $μ_l$ draw the base circle of radius $r_0$ and the offset circle of radius $e$. The guide "
        "touches "
        "the offset circle at $C_0$ and meets the base circle in $B_0$; $s_0$ is read there.",
    )


def _at(bench: Bench, cam: Cam, phi: float, piece: Piece) -> Pose:
    """The follower at an angle, on scratch paper."""
    trial = bench.board.scratch()
    trial.step(Words("试作", "trial"))
    return pose(trial, VIEW, cam, phi, lift(trial, place_of(cam), piece, phi))


def _pitch(bench: Bench, cam: Cam, stations: Sequence[Station]) -> tuple[Cut, ...]:
    board = bench.board
    board.step(_turning(cam), VIEW)
    cuts = []
    for station in stations:
        it = pose(board, VIEW, cam, station.phi, station.lift)
        _ink(bench, cam, station, it)
        cuts.append(Cut(station=station, pose=it, touch=_touch(bench, cam, it)))
    if not cam.follower.flat:
        for through in _along(bench, cam, cuts, pitch=True):
            board.curve(VIEW, through, Role.HIDDEN if cam.follower.roller else Role.RESULT)
    return tuple(cuts)


def _turning(cam: Cam) -> Words:
    against = Words("顺时针", "clockwise") if cam.sense > 0 else Words("逆时针", "counter-clockwise")
    opened = Words(
        f"给整个机构加上 $−ω$，凸轮不动，导路按{against.zh}反转（与凸轮转向相反），",
        f"Turn the whole by $−ω$: the cam stands still and the guide turns {against.en}, against the cam. ",
    )
    if cam.arm:
        opened = Words(
            f"给整个机构加上 $−ω$，凸轮不动，摆动中心 $A$ 按{against.zh}反转（与凸轮转向相反），",
            f"Turn the whole by $−ω$: the cam stands still and $A$ goes round {against.en}, against the cam. ",
        )
        return opened + Words(
            "在各分点以 $AB$ 为半径作弧交基圆，自该处转过位移线图上的 $ψ$ 得 $B_1$、$B_2$…，连成理论廓线。",
            "At each station the arc of radius $AB$ meets the base circle; from there the arm is turned by the $ψ$ "
            "of the "
            "diagram. The points $B_1$, $B_2$ ... give the pitch curve.",
        )
    if cam.follower.flat:
        return opened + Words(
            "在各分点的导路上自基圆向外量 $s$，作导路的垂线，即平底的各位置。",
            "On each guide lay off $s$ outwards from the base circle and draw the perpendicular: the face in its "
            "places.",
        )
    return opened + Words(
        "各分点的导路都切于偏距圆；自基圆沿导路向外量位移线图上的 $s$，得 $B_1$、$B_2$…，连成理论廓线。",
        "touching the offset circle at each station. Lay off the $s$ of the diagram outwards from the base circle "
        "along "
        "it: the points $B_1$, $B_2$ ... give the pitch curve.",
    )


def _ink(bench: Bench, cam: Cam, station: Station, it: Pose) -> None:
    board, mm = bench.board, bench.board.scale_of(VIEW).value
    board.join(VIEW, it.start, it.b, Role.CONSTRUCTION)
    if cam.follower.flat:
        assert cam.r0
        half = FACE * cam.r0.si / mm * 1j * it.way
        board.join(VIEW, it.b - half, it.b + half, Role.CONSTRUCTION)
    else:
        board.locate(VIEW, f"B_{station.number}", it.b)
    numbered = len(cam.places) <= CROWDED or station.number % 2 == 0
    board.plot(VIEW, it.b, f"{station.number}" if numbered else "", Dot.POINT)


def _touch(bench: Bench, cam: Cam, it: Pose) -> Points:
    """Where the follower touches: on the normal through the instant centre P."""
    board, mm = bench.board, bench.board.scale_of(VIEW).value
    if cam.follower.flat:
        return board.meet(board.parallel(it.pole, it.way), board.parallel(it.b, 1j * it.way), "")
    if not cam.follower.roller:
        return it.b
    return board.lay_off(it.b, it.normal, cam.follower.radius / mm)


def _profile(bench: Bench, cam: Cam, cuts: Sequence[Cut]) -> None:
    """The envelope, its radii at the stations, the pressure angles."""
    board, mm = bench.board, bench.board.scale_of(VIEW).value
    board.step(_enveloped(cam), VIEW)
    for cut in cuts:
        if cam.follower.roller:
            board.circle(VIEW, cut.pose.b, cam.follower.radius / mm, Role.CONSTRUCTION)
    if cam.follower.roller or cam.follower.flat:
        for through in _along(bench, cam, cuts, pitch=False):
            board.curve(VIEW, through, Role.LINK)
    values = []
    for cut in cuts:
        letters = f"O K_{{{cut.station.number}}}"
        on_paper = board.measure(0j, cut.touch, letters)
        scale = board.scale_of(VIEW)
        named = radius(cut.station.name)
        values.append(noted(bench, named, 1e3 * scale.value * on_paper.value, on_paper.value, letters, scale.symbol))
    written(bench, values)
    if not cam.follower.flat:
        written(bench, [noted(bench, pressure(c.station.name), acute(bench, c.pose.way, c.pose.normal)) for c in cuts])


def _enveloped(cam: Cam) -> Words:
    normal = Words(
        "法线过凸轮与从动件的瞬心 $P$（过 $O$ 作导路的垂线，在其上量 $OP$ = d$s$/d$φ$，由位移线图的作图线得出）",
        "The normal passes through the instant centre $P$ of cam and follower, on the perpendicular to the guide "
        "through "
        "$O$ with $OP$ = d$s$/d$φ$ from the lines of the diagram",
    )
    if cam.arm:
        normal = Words(
            "法线过凸轮与从动件的瞬心 $P$（在 $OA$ 上，按 $OP$∶$PA$ = d$ψ$/d$φ$∶1 分线段 $OA$）",
            "The normal passes through the instant centre $P$ of cam and follower, which divides $OA$ as $OP$ : $PA$ = "
            "d$ψ$/d$φ$ : 1",
        )
    if cam.follower.flat:
        return (
            Words("平底各位置的包络线即凸轮廓线。", "The envelope of the face is the profile. ")
            + normal
            + Words(
                "，与平底的交点即切点 $K$。量各切点到 $O$ 的距离：",
                "; it meets the face where they touch, in $K$. The distances from $O$:",
            )
        )
    if cam.follower.roller:
        return (
            Words(
                "以理论廓线上各点为圆心作滚子圆，其内包络线即实际廓线。",
                "Circles of the roller about the points of the pitch curve; their inner envelope is the profile. ",
            )
            + normal
            + Words(
                "，沿法线向内量 $r_r$ 得切点 $K$。量各切点到 $O$ 的距离，以及法线与从动件运动方向所夹的压力角：",
                "; $r_r$ inwards along it leads to the point of contact $K$. The distances of the points from $O$, "
                "and the "
                "pressure angles between normal and motion:",
            )
        )
    return (
        Words("尖顶从动件的理论廓线就是实际廓线。", "Under a knife edge the pitch curve is the profile. ")
        + normal
        + Words(
            "。量各点到 $O$ 的距离，以及法线与从动件运动方向所夹的压力角：",
            ". The distances of the points from $O$, and the pressure angles between normal and motion:",
        )
    )


def _along(bench: Bench, cam: Cam, cuts: Sequence[Cut], *, pitch: bool) -> Iterator[list[Points]]:
    """The points of every piece, with its two ends as seen from inside it."""
    for piece in cam.pieces:
        trial = bench.board.scratch()
        trial.step(Words("试作", "trial"))
        ends = [_at(bench, cam, phi, piece) for phi in (piece.start, piece.end)]
        mm = bench.board.scale_of(VIEW).value
        outer = [it.b if pitch else _contact(cam, it, mm) for it in ends]
        inner = [
            cut.pose.b if pitch else cut.touch
            for cut in cuts
            if piece.start + 1e-9 < cut.station.phi < piece.end - 1e-9
        ]
        yield [outer[0], *inner, outer[1]]


def _contact(cam: Cam, it: Pose, mm: float) -> Points:
    if cam.follower.flat:
        return foot(Line(it.b, 1j * it.way), it.pole)
    return it.b + cam.follower.radius / mm * it.normal
