"""The cam by inversion: base circle, guide or arm at every station, pitch curve, roller circles, profile."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ....board.board import Board
from ....board.construction import Place, View
from ....board.paper.marks import Dot, Role
from ....devices.cams.asked import PSI0, S0, polar, pressure, radius
from ....devices.cams.cam import Cam
from ....devices.cams.motion import Piece
from ....diagram.cams.plate import arm, cam_pivot, face_arm, stem
from ....plane import Points, unit
from ....words import Words
from ..bench import Bench, trial_board
from .diagram import Station, place_of
from .laws import lift
from .numbered import beyond_faces, beyond_pivots, beyond_rollers, on_profile
from .pose import Pose, pose
from .read.readings import acute, length, noted, turned
from .read.stations import stations_read
from .words.inversion import enveloped, opening, turning

VIEW = View.MECHANISM
CLEAR = 14.0  # mm: of guides through the pivot, for its letter and the arrow of ω
SHOWN = 4  # the station of which the radius of the profile is drawn
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
    board.step(opening(cam), VIEW)
    board.circle(VIEW, 0j, cam.r0.si / mm, Role.CENTRE)
    if cam.arm:
        board.circle(VIEW, 0j, cam.arm[0] / mm, Role.CENTRE)
    elif cam.follower.e:
        board.circle(VIEW, 0j, abs(cam.follower.e) / mm, Role.CENTRE)
    board.depict(VIEW, *cam_pivot(0j, cam.sense))
    trial = trial_board(board)
    first = pose(board, VIEW, cam, 0.0, lift(trial, place_of(cam), cam.pieces[0], 0.0))
    draw_follower(board, cam, first)
    if cam.arm:
        ray = 1j * cam.side * first.way if cam.follower.flat else first.base - first.start
        bench.stated(PSI0, acute(bench, -first.start, unit(ray)))
    elif not cam.follower.flat:
        length(bench, S0, VIEW, first.start, first.base, "C_0 B_0" if cam.follower.e else "O B_0")
    if not cam.follower.flat:
        board.plot(VIEW, first.base, "B_0", Dot.NONE)
    if cam.follower.e and not cam.arm:
        board.plot(VIEW, first.start, "C_0", Dot.POINT)


def draw_follower(board: Board, cam: Cam, it: Pose, place: Place = VIEW) -> None:
    """The follower as it stands there: its arm with the face or the roller, or its stem in the guide."""
    mm = board.scale_of(place).value
    if cam.arm and cam.follower.flat:
        board.depict(place, *face_arm(it.start, it.b, _along_face(cam, it, mm)))
    elif cam.arm:
        board.depict(place, *arm(it.start, it.b, cam.follower.radius / mm))
    else:
        assert cam.r0
        face = FACE * cam.r0.si / mm if cam.follower.flat else 0.0
        board.depict(place, *stem(it.b, it.way, cam.follower.radius / mm, face))


def _at(bench: Bench, cam: Cam, phi: float, piece: Piece) -> Pose:
    """The follower at an angle, on scratch paper."""
    trial = trial_board(bench.board)
    return pose(trial, VIEW, cam, phi, lift(trial, place_of(cam), piece, phi))


def _pitch(bench: Bench, cam: Cam, stations: Sequence[Station]) -> tuple[Cut, ...]:
    board = bench.board
    board.step(turning(cam), VIEW)
    cuts = []
    for station in stations:
        it = pose(board, VIEW, cam, station.phi, station.lift)
        _ink(bench, cam, station, it)
        cuts.append(Cut(station=station, pose=it, touch=_touch(bench, cam, it)))
    if not cam.follower.flat:
        for through in _along(bench, cam, cuts, pitch=True):
            board.curve(VIEW, through, Role.HIDDEN if cam.follower.roller else Role.RESULT)
    return tuple(cuts)


def _ink(bench: Bench, cam: Cam, station: Station, it: Pose) -> None:
    board, mm = bench.board, bench.board.scale_of(VIEW).value
    foot = it.start if cam.arm or cam.follower.e else it.start + CLEAR * it.way  # a guide beside O touches its circle
    board.join(VIEW, foot, it.b, Role.CONSTRUCTION)
    if cam.follower.flat and cam.arm:
        board.join(VIEW, it.b, it.b + _along_face(cam, it, mm), Role.CONSTRUCTION)
    elif cam.follower.flat:
        assert cam.r0
        half = FACE * cam.r0.si / mm * 1j * it.way
        board.join(VIEW, it.b - half, it.b + half, Role.CONSTRUCTION)
    else:
        board.locate(VIEW, f"B_{station.number}", it.b)
    board.plot(VIEW, it.b, "", Dot.POINT)


def _number(bench: Bench, cam: Cam, cuts: Sequence[Cut]) -> None:
    """The stations, each outside the cam."""
    board, mm = bench.board, bench.board.scale_of(VIEW).value
    posed = [(cut.station, cut.pose) for cut in cuts]
    if cam.arm:
        beyond_pivots(board, posed, flat=cam.follower.flat)
    elif cam.follower.flat:
        assert cam.r0
        beyond_faces(board, posed, FACE * cam.r0.si / mm)
    elif cam.follower.roller:
        beyond_rollers(board, posed, cam.follower.radius / mm)
    else:
        on_profile(board, posed)


def _along_face(cam: Cam, it: Pose, mm: float) -> Points:
    """From the foot of A on a flat face to its end, past the cam."""
    assert cam.arm
    return 1j * cam.side * it.way * cam.arm[1] / mm


def _touch(bench: Bench, cam: Cam, it: Pose) -> Points:
    """Where the follower touches: on the normal through the instant centre P."""
    board, mm = bench.board, bench.board.scale_of(VIEW).value
    if cam.follower.flat:
        return board.meet(board.parallel(it.pole, it.way), board.parallel(it.b, 1j * it.way), "")
    if not cam.follower.roller:
        return it.b
    return board.lay_off(it.b, it.normal, cam.follower.radius / mm, key="r_r")


def _profile(bench: Bench, cam: Cam, cuts: Sequence[Cut]) -> None:
    """The envelope, its radii at the stations, the pressure angles."""
    board, mm = bench.board, bench.board.scale_of(VIEW).value
    board.step(enveloped(cam), VIEW)
    for cut in cuts:
        if cam.follower.roller:
            board.circle(VIEW, cut.pose.b, cam.follower.radius / mm, Role.CONSTRUCTION)
    _number(bench, cam, cuts)
    if cam.follower.roller or cam.follower.flat:
        for through in _along(bench, cam, cuts, pitch=False):
            board.curve(VIEW, through, Role.LINK)
    shown = cuts[min(SHOWN, len(cuts) - 1)]
    board.join(VIEW, 0j, shown.touch, Role.CONSTRUCTION)
    board.plot(VIEW, shown.touch / 2, radius(shown.station.name).symbol, Dot.NONE)
    for cut in cuts:
        letters = f"O T_{{{cut.station.number}}}"
        on_paper = board.measure(0j, cut.touch, letters)
        scale = board.scale_of(VIEW)
        named = radius(cut.station.name)
        noted(bench, named, 1e3 * scale.value * on_paper.value, on_paper.value, letters, scale.symbol)
        if not cam.follower.flat:
            noted(bench, pressure(cut.station.name), acute(bench, cut.pose.way, cut.pose.normal))
    for cut in cuts[1:]:
        noted(bench, polar(cut.station.name), turned(bench, cam, cut.station.name, cuts[0].touch, cut.touch))
    board.tabulate(stations_read(bench, cam, [cut.station for cut in cuts]))


def _along(bench: Bench, cam: Cam, cuts: Sequence[Cut], *, pitch: bool) -> Iterator[list[Points]]:
    """The points of every piece, with its two ends as seen from inside it."""
    for piece in cam.pieces:
        ends = [_at(bench, cam, phi, piece) for phi in (piece.start, piece.end)]
        mm = bench.board.scale_of(VIEW).value
        outer = [it.b if pitch else it.touch(cam, mm) for it in ends]
        inner = [
            cut.pose.b if pitch else cut.touch
            for cut in cuts
            if piece.start + 1e-9 < cut.station.phi < piece.end - 1e-9
        ]
        yield [outer[0], *inner, outer[1]]
