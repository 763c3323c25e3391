"""Under a flat face: the minimum radius of curvature of the profile, and how far the face must reach."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ....algebra.quantity import Quantity
from ....board.board import Board
from ....board.construction import Pane
from ....board.paper.marks import Dot, Role
from ....devices.cams.asked import FARTHEST, NEAREST, REACH_BACK, REACH_RISE, RHO
from ....devices.cams.cam import Cam
from ....diagram.single import pivot
from ....names import Named
from ....plane import Points, dot, nominal
from ....words import Words
from ..bench import Bench
from .diagram import place_of
from .extremes import Spot, best, parting, reaching
from .inversion import VIEW, Cut, draw_follower
from .laws import lift
from .pose import Pose, osculating, pose
from .pressure import MOST_BENT, copied, lettered, posed
from .read.readings import length

ALONG = np.radians(60)  # of the circle of curvature to either side of where it touches


def under_a_face(bench: Bench, cam: Cam, cuts: Sequence[Cut], place: Pane, spot: Spot) -> Quantity:
    """ρ_min: the centre of curvature on the normal through the instant centre."""
    board = bench.board
    board.step(_told(cam, spot), place)
    it = posed(bench, cam, place, spot, MOST_BENT)
    copied(bench, place, cam, cuts, spot, edge=True)
    touch = board.meet(board.parallel(it.pole, it.way), board.parallel(it.b, 1j * it.way), "")
    centre, _ = osculating(board, cam, it)
    _shown(bench, place, cam, it)
    board.join(place, touch, centre, Role.DIRECTION)
    board.join(place, it.pole, centre, Role.DIRECTION)
    for letter, at in (("P", it.pole), ("B", touch), ("K", centre)):
        board.plot(place, at, letter, Dot.POINT)
    osculating_circle(board, place, centre, touch)
    ahead = float(nominal(dot(it.way, touch - centre))) >= 0
    rho = length(bench, RHO, place, centre, touch, "K B", 1 if ahead else -1)
    board.step(Words("检查失真：", "Check for undercut."))
    return rho


def osculating_circle(board: Board, place: Pane, centre: Points, touch: Points) -> None:
    """An arc of the circle of curvature, as far as is seen how the profile leaves it, with its radius ρ_min, which is
    asked for."""
    start = float(np.angle(complex(nominal(touch - centre)))) - ALONG
    board.circle(place, centre, np.abs(centre - touch), Role.CONSTRUCTION, start=start, sweep=2 * ALONG)
    board.join(place, centre, touch, Role.CONSTRUCTION)
    board.plot(place, (centre + touch) / 2, RHO.symbol, Dot.NONE, key=RHO.key)


def _shown(bench: Bench, place: Pane, cam: Cam, it: Pose) -> None:
    """The guide or the arm, the face, OP."""
    board = bench.board
    board.depict(place, pivot(0j, "O"))
    draw_follower(board, cam, it, place)
    if cam.arm:
        board.join(place, 0j, it.start, Role.CONSTRUCTION)
    else:
        board.join(place, 0j, it.b, Role.CENTRE)
        board.join(place, 2 * it.b - it.foot, 2 * it.foot - it.b, Role.LINK)
    board.join(place, 0j, it.pole, Role.CONSTRUCTION)


def _told(cam: Cam, spot: Spot) -> Words:
    """Where the radius is least, and where the centre of curvature lies."""
    at = spot.told
    opened = Words(
        f"经试作，廓线的曲率半径在 $φ$ = {at}° 处{lettered(cam, spot, MOST_BENT).zh}最小。",
        f"By trial the radius of the profile is least at $φ$ = {at}°{lettered(cam, spot, MOST_BENT).en}. ",
    )
    if cam.arm:
        return opened + Words(
            "瞬心 $P$ 分 $OA$ 为 $OP$∶$PA$ = d$ψ$/d$φ$∶1，过 $P$ 作平底的垂线即法线，垂足为切点 $B$。$P$ "
            "的换位速度沿平底的分量 $u′$ "
            "除以平底对凸轮的角速度 $ω_r$，得法线上的曲率中心 $K$：$PK$ = $u′$/$ω_r$。切点 $B$ 到 $K$ 的距离：",
            "The instant centre $P$ divides $OA$ as $OP$ : $PA$ = d$ψ$/d$φ$ : 1; the normal is the perpendicular from "
            "$P$ to the face and meets it at the point of contact $B$. The velocity with which $P$ itself moves has "
            "the component $u′$ along the face; divided by the angular velocity $ω_r$ of the face relative to the cam "
            "it gives the centre of curvature $K$ on the normal, $PK$ = $u′$/$ω_r$. The distance of $K$ from $B$ is:",
        )
    return opened + Words(
        "法线平行于导路且过瞬心 $P$（$OP$ = d$s$/d$φ$），曲率中心 $K$ 在其上，$PK$ = d²$s$/d$φ$²（加速度向外时在 $P$ "
        "的内侧）。切点 $B$ 到 $K$ 的距离：",
        "The normal is parallel to the guide through the instant centre $P$ ($OP$ = d$s$/d$φ$); on it lies the centre "
        "of curvature $K$ with $PK$ = d²$s$/d$φ$², inwards where the acceleration points outwards. Its distance from "
        "the contact $B$ is:",
    )


def reach(bench: Bench, cam: Cam) -> None:
    """How far the contact wanders along the face."""
    return _along_the_arm(bench, cam) if cam.arm else _about_the_guide(bench, cam)


def _along_the_arm(bench: Bench, cam: Cam) -> None:
    """The least and the maximum distance of the contact from the foot of A on the face."""
    board = bench.board
    for mark, sign, named, told in (
        (
            "_1",
            -1,
            NEAREST,
            Words("切点离 $A$ 在平底上的垂足最近", "The contact is nearest to the foot of $A$ on the face"),
        ),
        ("_2", 1, FARTHEST, Words("切点离该垂足最远", "It is farthest from it")),
    ):
        spot = best(board, place_of(cam), cam.pieces, reaching(cam, sign))
        where = spot.told
        board.step(told + Words(f"（$φ$ = {where}°），距离为：", f" at $φ$ = {where}°:"), VIEW)
        at = lift(board, place_of(cam), spot.piece, spot.phi, late=spot.late)
        it = pose(board, VIEW, cam, spot.phi, at)
        foot, touch = f"A{mark}^′" if cam.face else f"A{mark}", f"T{mark}"
        board.join(VIEW, it.b, it.foot, Role.CONSTRUCTION)
        for letter, end in ((foot, it.b), (touch, it.foot)):
            board.plot(VIEW, end, letter, Dot.POINT)
        length(bench, named, VIEW, it.b, it.foot, f"{foot} {touch}")


def _about_the_guide(bench: Bench, cam: Cam) -> None:
    """The greatest ds/dφ either way."""
    board = bench.board
    for way, named, told in (
        (1, REACH_RISE, Words("推程时切点偏离导路的最大距离等于", "On the rise the contact lies at most")),
        (-1, REACH_BACK, Words("回程时切点偏离导路的最大距离等于", "On the return the contact lies at most")),
    ):
        spot = best(board, place_of(cam), [p for p in cam.pieces if p.rises == way], parting)
        board.step(
            told
            + Words(
                f" d$s$/d$φ$ 的最大值（$φ$ = {spot.told}°），平底由导路向该侧至少应有此长度：",
                f" as far from the guide as the maximum d$s$/d$φ$ (at $φ$ = {spot.told}°); the face "
                "must reach so far on that side:",
            ),
            VIEW,
        )
        _contact_off(bench, cam, spot, named)


def _contact_off(bench: Bench, cam: Cam, spot: Spot, named: Named) -> None:
    board = bench.board
    at = lift(board, place_of(cam), spot.piece, spot.phi, late=spot.late)
    side = cam.sense * spot.piece.rises  # the pole lies where the turning cam goes the way of the follower
    pole = board.lay_off(0j, side * np.exp(-1j * cam.sense * spot.phi), np.abs(at.slope) / board.scale_of(VIEW).value)
    letter = f"P_{named.symbol[-1]}"
    board.join(VIEW, 0j, pole, Role.CONSTRUCTION)
    board.plot(VIEW, pole, letter, Dot.POINT)
    length(bench, named, VIEW, 0j, pole, f"O {letter}")
