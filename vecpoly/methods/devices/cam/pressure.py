"""The maximum pressure angles, on the rise and on the return, each drawn where trial has found it."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi

import numpy as np

from ....board.board import Board
from ....board.construction import Pane, Scale, View
from ....board.paper.marks import Dot, Role
from ....devices.cams.asked import ALPHA, ALPHA_BACK, ALPHA_RISE
from ....devices.cams.cam import Cam
from ....diagram.single import pivot
from ....foundation.slotted import replace
from ....names import Named
from ....plane import Reals, nominal
from ....plane.traced import acts_of, bare, traced
from ....words import Words
from ..bench import Bench
from ..inclined import between
from .diagram import place_of
from .extremes import Spot, best, slanting
from .inversion import Cut, draw_follower
from .laws import lift
from .pose import Pose, pose
from .read.readings import acute
from .scales import fitting, reach

ARC, OVER, NEAR = 22.0, 16.0, pi / 5  # mm: of the angle mark, beyond B; rad: how much of the pitch curve is copied
APART = 95.0  # mm from O to a guided follower on a figure apart
ARMED = 78.0  # mm from O to the pivot of an arm, which is drawn there too
SAME = 1e-6  # rad: so near to a station it is that station
MOST_SLANTING, MOST_BENT = {1: "m_1", -1: "m_2"}, "m_3"  # the places of the extremes on the diagram


def pressure_angles(bench: Bench, cam: Cam, cuts: Sequence[Cut]) -> None:
    """α on rise and return, and the greater of them."""
    board = bench.board
    board.section(Words("压力角", "Pressure angle"))
    found = [
        _greatest(bench, cam, cuts, *each)
        for each in (
            (1, ALPHA_RISE, Words("推程最大压力角", "Maximum pressure angle of the rise")),
            (-1, ALPHA_BACK, Words("回程最大压力角", "Maximum pressure angle of the return")),
        )
    ]
    larger = max(found, key=lambda value: float(nominal(value)))
    larger = traced(np.maximum(*map(bare, found)), acts_of(larger))  # by each hand
    board.step(Words("两者中的大者：", "The greater of the two is:"))
    bench.stated(ALPHA, larger)


def _greatest(bench: Bench, cam: Cam, cuts: Sequence[Cut], way: int, named: Named, title: Words) -> Reals:
    board = bench.board
    pieces = [piece for piece in cam.pieces if piece.rises == way]
    spot = best(board, place_of(cam), pieces, slanting(cam))
    place = board.open_pane(View.MECHANISM, named.key, title, detail(board, cam))
    letter = MOST_SLANTING[way]
    at = lettered(cam, spot, letter)
    part = Words("摆杆", "arm") if cam.arm else Words("导路", "guide")
    board.step(
        Words(
            f"{'推程' if way > 0 else '回程'}：比较各分点的压力角，在最大值附近加密试作，最大压力角在 $φ$ = "
            f"{spot.told}° 处{at.zh}。作该位置的{part.zh}、瞬心 $P$ 和法线 $BP$，量法线与从动件"
            "运动方向的夹角：",
            f"On the {'rise' if way > 0 else 'return'} compare the stations and try more positions near the maximum "
            f"pressure angle; it is at $φ$ = {spot.told}°{at.en}. Draw the {part.en} there, the "
            "instant centre $P$ and the normal $BP$, and read the angle between the normal and the follower's motion:",
        ),
        place,
    )
    it = posed(bench, cam, place, spot, letter)
    copied(bench, place, cam, cuts, spot)
    show(bench, place, cam, it)
    outward = it.normal * -1
    along = it.way if float(nominal((np.conj(outward) * it.way).real)) > 0 else -it.way
    board.join(place, it.b, it.b + along * (ARC + 6), Role.CONSTRUCTION)
    between(bench, place, it.b, along, outward, ARC, "α")
    value = acute(bench, it.way, board.parallel(it.b, it.normal, key="nn").along)
    bench.stated(named, value)
    return value


def lettered(cam: Cam, spot: Spot, letter: str) -> Words:
    """Which letter an extreme between two stations has on the diagram."""
    return (
        Words(f"（位移线图上的 ${letter}$）", f" (${letter}$ on the diagram)")
        if _between(cam, spot)
        else Words.same("")
    )


def _between(cam: Cam, spot: Spot) -> bool:
    return all(abs(spot.phi - phi) > SAME for phi, _ in cam.places)


def posed(bench: Bench, cam: Cam, place: Pane, spot: Spot, letter: str) -> Pose:
    """The follower where trial has found the extreme, its station drawn on the diagram too, under this letter."""
    board = bench.board
    at = lift(board, place_of(cam), spot.piece, spot.phi, late=spot.late, letters=f"{letter} {letter}′")
    if _between(cam, spot):
        board.plot(place_of(cam), at.foot, letter, Dot.NONE)
    return pose(bench.board, place, cam, spot.phi, at)


def detail(board: Board, cam: Cam) -> Scale:
    """The scale of a figure apart: as large as a sheet holds three of, with a symbol of its own where it is larger."""
    whole = board.scale_of(View.MECHANISM)
    value = min(whole.value, fitting(reach(cam) / (ARMED if cam.arm else APART)))
    return whole if value == whole.value else replace(whole, symbol="μ_l′", value=value)


def copied(bench: Bench, place: Pane, cam: Cam, cuts: Sequence[Cut], spot: Spot, *, edge: bool = False) -> None:
    """The part of the pitch curve near the place, and of the profile on which its roller runs; or of the profile."""
    near = [cut for cut in cuts if abs((cut.station.phi - spot.phi + pi) % (2 * pi) - pi) < NEAR]
    near.sort(key=lambda cut: (cut.station.phi - spot.phi + pi) % (2 * pi))
    times = bench.board.scale_of(View.MECHANISM).value / bench.board.scale_of(place).value
    role = Role.HIDDEN if cam.follower.roller else Role.RESULT  # as on the sheet of the whole cam
    bench.board.curve(place, [times * (cut.touch if edge else cut.pose.b) for cut in near], role)
    if cam.follower.roller:
        bench.board.curve(place, [times * cut.touch for cut in near], Role.RESULT)


def show(bench: Bench, place: Pane, cam: Cam, it: Pose) -> None:
    """O and P, the follower on its pivot or in its guide, with its roller, and the normal."""
    board = bench.board
    if not cam.arm:
        board.join(place, it.start, it.b, Role.CENTRE)
    draw_follower(board, cam, it, place)
    if it.near:
        board.join(place, 0j, it.pole, Role.CONSTRUCTION)
    else:
        board.remark(
            Words(
                " $P$ 在 $OA$ 上很远处，法线几乎与 $OA$ 平行。",
                " The centre $P$ is far away on $OA$: the normal is all but parallel to it.",
            )
        )
    if cam.arm:
        board.join(place, 0j, it.start, Role.CONSTRUCTION)
    board.join(place, it.sighted, it.b - it.normal * OVER, Role.DIRECTION)
    board.depict(place, pivot(0j, "O"))
    if it.near and abs(complex(nominal(it.pole))) > 1.0:
        board.plot(place, it.pole, "P", Dot.POINT)
    board.plot(place, it.b, "B", Dot.NONE if cam.follower.roller else Dot.POINT)
    board.plot(place, it.b - it.normal * OVER, "n", Dot.NONE)
