"""The minimum radius of curvature by Hartmann's construction, the osculating circle, and whether the profile is cut."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ....algebra.quantity import Quantity, magnitude, number
from ....board.board import Board
from ....board.construction import Pane, View
from ....board.paper.marks import Dot, Role
from ....devices.cams.asked import RHO, RHO_PROFILE, UNDERCUT, UNDERCUT_FLAT
from ....devices.cams.cam import Cam
from ....devices.cams.corners import corners_of
from ....plane import nominal
from ....words import Words
from ..bench import Bench
from .diagram import place_of
from .extremes import Spot, best, curving
from .face import osculating_circle, reach, under_a_face
from .inversion import VIEW, Cut
from .pose import centre_of_curvature
from .pressure import MOST_BENT, copied, detail, lettered, posed, show
from .read.readings import length
from .trying import interferes
from .words.motion import corners

HALF = 0.5  # the share at which velocities are drawn
SPECK = 0.15  # mm: a shorter u′ is not seen


def least_radius(bench: Bench, cam: Cam, cuts: Sequence[Cut]) -> None:
    """ρ_min of the pitch curve; what the roller leaves of it."""
    board = bench.board
    board.section(Words("曲率半径与失真", "Curvature and undercut"))
    spot = best(board, place_of(cam), cam.pieces, curving(cam))
    title = Words("最小曲率半径", "Minimum radius of curvature")
    place = board.open_pane(View.MECHANISM, RHO.key, title, detail(board, cam))
    if cam.follower.flat:
        rho = under_a_face(bench, cam, cuts, place, spot)
        _judged_flat(bench, cam, rho)
        reach(bench, cam)
        return
    rho = _hartmann(bench, cam, cuts, place, spot)
    if cam.follower.roller:
        _judged(bench, cam, rho)


def is_spoilt(board: Board, cam: Cam) -> bool:
    """Whether the profile cannot be made: judged as on the sheet, by trial alone."""
    worst = best(board, place_of(cam), cam.pieces, curving(cam)).merit  # 1/ρ (1/mm on paper), or −ρ under a face
    if corners(board, place_of(cam), cam) and (cam.follower.flat or cam.follower.roller):
        return True
    if cam.follower.flat:
        return worst >= 0
    radius = cam.follower.radius / board.scale_of(VIEW).value
    return bool(radius) and (radius * worst > 1 or interferes(board, cam))


def _hartmann(bench: Bench, cam: Cam, cuts: Sequence[Cut], place: Pane, spot: Spot) -> Quantity:
    board = bench.board
    board.step(
        Words(
            f"外凸部分曲率半径的最小值{_but(cam).zh}经试作在 $φ$ = {spot.told}° 处"
            f"{lettered(cam, spot, MOST_BENT).zh}。该处用哈特曼法作曲率中心：反转运动中 "
            "$v_B$ ⊥ $PB$，$v_B$ = $PB$·$ω$；取瞬心 $P$ 的换位速度 $u$ 垂直于法线的分量 $u′$。两速度用同一比例"
            "（取一半）画出，两矢量端点的连线交法线于 $K$，即曲率中心。以 $K$ 为圆心过 $B$ 作曲率圆：",
            f"Trial shows that the radius of curvature of the convex parts is least{_but(cam).en} at $φ$ = {spot.told}°"
            f"{lettered(cam, spot, MOST_BENT).en}. "
            "The centre of curvature there follows from Hartmann's construction: in the inversion $v_B$ ⊥ $PB$ with "
            "$v_B$ = $PB$·$ω$. The instant centre $P$ itself moves with the velocity $u$, of which the component "
            "$u′$ at right angles to the normal is taken. Draw both to one scale (halved); the line through their tips "
            "meets the normal at the centre of curvature $K$. Draw the osculating circle about $K$ through $B$:",
        ),
        place,
    )
    it = posed(bench, cam, place, spot, MOST_BENT)
    copied(bench, place, cam, cuts, spot)
    show(bench, place, cam, it)
    centre, tip, moved = centre_of_curvature(board, it, HALF)
    board.arrow(place, it.b, tip, Role.GIVEN, label="v_B")
    if float(nominal(np.abs(moved - it.pole))) > SPECK:
        board.arrow(place, it.pole, moved, Role.GIVEN, label="u′")
    board.join(place, tip, centre, Role.CONSTRUCTION)
    board.join(place, moved, centre, Role.CONSTRUCTION)
    board.join(place, it.pole, centre, Role.DIRECTION)
    board.plot(place, centre, "K", Dot.POINT)
    osculating_circle(board, place, centre, it.b)
    return length(bench, RHO, place, centre, it.b, "K B")


def _but(cam: Cam) -> Words:
    """That corners are left out, where there are some."""
    return Words("（尖点除外）", ", corners apart,") if corners_of(cam.pieces) else Words("", "")


def _judged(bench: Bench, cam: Cam, rho: Quantity) -> None:
    """ρ_a = ρ − r_r; cut where that is negative, at a corner, or where another part lies in the roller's way."""
    board = bench.board
    board.step(
        Words(
            "实际廓线的最小曲率半径等于理论廓线的最小曲率半径减去滚子半径：",
            "The minimum radius of the profile is that of the pitch curve less the roller's:",
        )
    )
    roller = magnitude("r_r", 1e3 * cam.follower.radius, "mm")
    left = bench.worked(RHO_PROFILE, rho - roller)
    board.step(Words("检查失真：", "Check for undercut."))
    sharp, hit = corners(board, place_of(cam), cam), interferes(board, cam)
    spoilt = np.asarray(left.value) < 0 if not (sharp or hit) else np.full_like(np.asarray(left.value), 1.0) > 0
    bench.judged(UNDERCUT, spoilt, _verdict(float(nominal(left.value)), sharp, hit, cam), left.value)


def _verdict(left: float, sharp: bool, hit: bool, cam: Cam) -> Words:
    radius = number(1e3 * cam.follower.radius)
    if left < 0:
        most = number(left + 1e3 * cam.follower.radius)
        return Words(
            f"$r_r$ = {radius} mm 大于 $ρ_min$，实际廓线相交，运动失真；滚子半径应小于 {most} mm，或加大基圆。",
            f" The radius $r_r$ = {radius} mm exceeds $ρ_min$: the profile crosses itself and is undercut. The "
            f"roller's radius must be less than {most} mm, or the base circle larger.",
        )
    if sharp:
        return Words(
            "理论廓线有外凸的尖点，滚子不能沿它运动，运动失真。",
            " The pitch curve has a corner that points outward, which no roller follows: the motion is lost there.",
        )
    if hit:
        return Words(
            "滚子在别处切入廓线，运动失真；应减小滚子或加大基圆。",
            " Elsewhere the roller cuts into the profile: take a smaller roller or a larger base circle.",
        )
    return Words("$ρ_{a min}$ > 0，廓线不失真。", " Since $ρ_{a min}$ > 0 the profile is not undercut.")


def _judged_flat(bench: Bench, cam: Cam, rho: Quantity) -> None:
    sharp = corners(bench.board, place_of(cam), cam)
    value = np.asarray(rho.value)
    spoilt = value <= 0 if not sharp else np.full_like(value, 1.0) > 0
    least = 1e3 * (cam.r0.si if cam.r0 else 0.0) - float(nominal(rho.value))
    verdict = Words("$ρ_min$ > 0，廓线处处外凸，不失真。", " Since $ρ_min$ > 0 the profile is convex and not undercut.")
    if float(nominal(rho.value)) <= 0:
        verdict = Words(
            "$ρ_min$ ≤ 0，平底各位置的包络线相交，运动失真；",
            " Since $ρ_min$ ≤ 0 the envelope of the face crosses itself and is undercut; ",
        ) + (
            Words("应加大基圆。", "take a larger base circle.")
            if cam.arm
            else Words(f"基圆半径应大于 {number(least)} mm。", f"r_0 must exceed {number(least)} mm.")
        )
    elif sharp:
        verdict = Words(
            "速度突减处平底的包络线中断，运动失真。",
            " Where the velocity drops at once the envelope breaks off: undercut.",
        )
    bench.judged(UNDERCUT_FLAT, spoilt, verdict, rho.value)
