"""Kutzbach: the velocity over the radius is one straight line for each link; its slope is the angular velocity."""

from __future__ import annotations

from collections.abc import Mapping
from math import pi

from ....algebra.formula import sym
from ....algebra.quantity import Sum, magnitude, number
from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....devices.gears.epicyclic import Epicyclic, speed_of
from ....diagram.half_section import half_section
from ....diagram.wheels import body_of_ring, epicyclic_train, held, number_of_ring, second_sun
from ....errors import NotAskedError
from ....plane import Line, Points, nominal, unit
from ....words import Words
from ..bench import Bench
from ..inclined import row_of
from ..registry import device_method
from .letters import teeth, turning
from .scales import RADII, farthest_left, train_scales
from .turns import angular_velocities

POINTS = {"1": "A", "H": "O2", "3": "C"}  # the point of the radius whose velocity tells the link's
LEFT = -1 + 0j  # where a point above O moves whose link turns counter-clockwise
ASIDE = 10.0  # mm between the half-section of the train and the velocity farthest left
READABLE, NOTHING = 0.5, 1e-9  # mm: a velocity shorter than this cannot be read; shorter than that it is none


@device_method(
    Epicyclic,
    title=Words("周转轮系的图解（库茨巴赫法）", "An epicyclic train by Kutzbach's diagrams"),
    source="机械原理, epicyclic trains: velocities of pitch points over the radius, Willis' equation as a check",
    example="train-ring",
    scales=train_scales,
    called=Words("轮系简图", "The train"),
)
def draw_epicyclic(bench: Bench, train: Epicyclic) -> None:
    """The gears, the velocities over the radius, the angular velocities, the ratio."""
    _gears(bench, train)
    tips = _velocities(bench, train)
    angular_velocities(bench, train, tips)


def _gears(bench: Bench, train: Epicyclic) -> None:
    board, mm = bench.board, bench.board.scale_of(View.MECHANISM).value
    board.section(Words("轮系简图", "The train"))
    board.step(
        Words(
            "按 $μ_l$ 画出各轮的节圆，行星轮中心 $O_2$ 在 $O$ 的正上方；$A$、$C$ 为行星轮与轮 1、3 的节点。节圆半径：",
            "To the scale $μ_l$ draw the pitch circles with the centre $O_2$ of a planet straight above $O$; $A$ and "
            "$C$ are the pitch points of the planet with gears 1 and 3. The pitch radii are:",
        ),
        View.MECHANISM,
    )
    radii = {key: radius / mm for key, radius in train.radii.items()}
    ring = radii["3"] if train.ring else 0.0
    board.depict(View.MECHANISM, *epicyclic_train(radii["1"], radii["H"], (radii["2"], radii["2′"]), ring))
    if train.ring:
        board.depict(View.MECHANISM, number_of_ring(body_of_ring(ring, radii["H"] + radii["2"])))
    else:
        board.depict(View.MECHANISM, *second_sun(radii["3"]))
    _held_and_turned(bench, train, radii)
    for letter, key in (("A", "1"), ("C", "3")):
        board.plot(View.MECHANISM, 1j * radii[key], letter, Dot.POINT)
    stepped = len(train.planet) > 1
    for key in ("1", "2", *(("2′",) if stepped else ()), "3", "H"):
        radius = 1e3 * train.radii[key]
        board.write(row_of(sym(f"r_{{{key}}}"), f" = {number(radius)} mm"))


def _held_and_turned(bench: Bench, train: Epicyclic, radii: Mapping[str, float]) -> None:
    """What is given of the motion: the hatching of a wheel that stands still, the arrows of ω; the teeth."""
    for key, omega in train.omegas.items():
        if key in train.held:
            ring = key == "3" and bool(train.ring)
            rim = body_of_ring(radii[key], radii["H"] + radii["2"]) if ring else radii[key]
            bench.board.depict(View.MECHANISM, held(rim, *((0.0, pi) if ring else (-pi / 6, -5 * pi / 6)), inner=ring))
        elif omega is not None:
            turning(bench, train, key, omega.si)
    teeth(bench, train)


def _laid_words(train: Epicyclic, known: list[str]) -> Words:
    """The half-section, and the known velocities laid off on it; that of a held gear is zero."""
    moving = [key for key in known if (omega := train.omegas[key]) is not None and omega.si] or known
    told = "、".join(f"$v_{{{POINTS[key]}}}$" for key in moving)
    held = [f"$v_{{{POINTS[key]}}}$ = 0" for key in known if key not in moving]
    return Words(
        "按 $μ_l$ 画出轮系轴线以上的半剖面简图，以半径为纵坐标、速度为横坐标。各点都在 $O$ 的正上方，构件逆时针转"
        "动时速度向左，取为正；顺时针转动时向右，为负。"
        f"由已知的角速度算出 {told}，在{'各自' if len(moving) > 1 else '其'}半径的高度上按其方向量出"
        f"{f'（{held[0]}）' if held else ''}；轮 1、3 和系杆的速度线都过 $O$。",
        "Draw the half-section of the train above its axis to the scale $μ_l$. Radii are plotted upwards, "
        "velocities sideways. All points lie vertically above $O$; a point of a link that turns counter-clockwise "
        "moves to the left (positive), of one that turns clockwise to the right (negative). "
        f"Compute {told.replace('、', ' and ')} from the given angular velocities and lay "
        + (
            "them off, each in its direction, at the heights of their radii"
            if len(moving) > 1
            else "it off in its direction, at the height of its radius"
        )
        + (f" ({held[0]})" if held else "")
        + ". The velocity lines of gears 1 and 3 and of the carrier pass through $O$.",
    )


def _velocities(bench: Bench, train: Epicyclic) -> dict[str, Points]:
    """The tips of the velocities of A, O_2 and C, at the height of their radii."""
    board = bench.board
    board.section(Words("线速度图", "Linear-velocity diagram"))
    known = [key for key, omega in train.omegas.items() if omega is not None]
    board.step(_laid_words(train, known), RADII)
    mm = board.scale_of(RADII).value
    top = max(train.radii["3"], train.radii["H"]) / mm
    board.join(RADII, 0j, 1j * (top + 8), Role.CENTRE)
    board.plot(RADII, 0j, "O", Dot.POLE)
    feet = {key: board.lay_off(0j, 1j, train.radii[key] / mm) for key in POINTS}
    _section(bench, train, feet)
    tips = {key: _laid(bench, train, key, feet[key]) for key in known}
    tips[train.sought] = _found(bench, train, feet[train.sought], tips)
    for key in POINTS:
        board.join(RADII, 0j, tips[key], Role.RESULT)
        board.plot(RADII, tips[key], POINTS[key].lower().replace("o2", "o_2"), Dot.POINT)
        board.join(RADII, feet[key], tips[key], Role.CONSTRUCTION)
        board.plot(RADII, feet[key], POINTS[key].replace("O2", "O_2"), Dot.NONE)
    return tips


def _section(bench: Bench, train: Epicyclic, feet: Mapping[str, Points]) -> None:
    """The half-section of the train to the left of all velocities, each mesh level with its own."""
    board, scale = bench.board, bench.board.scale_of(RADII)
    radii = {key: radius / scale.value for key, radius in train.radii.items()}
    end = -farthest_left(train) / scale.right.value - ASIDE
    ring, stepped, fixed = bool(train.ring), len(train.planet) > 1, next(iter(train.held), "")
    board.depict(RADII, *half_section(end, radii, ring=ring, stepped=stepped, fixed=fixed))
    for key in POINTS:
        board.join(RADII, complex(end, radii[key]), feet[key], Role.CONSTRUCTION)


def _laid(bench: Bench, train: Epicyclic, key: str, foot: Points) -> Points:
    board, omega = bench.board, train.omegas[key]
    assert omega is not None
    radius = magnitude(f"r_{{{key}}}", train.radii[key], "m")
    named = speed_of(POINTS[key])
    speed = bench.worked(named, magnitude(f"ω_{key}", omega.si, "rad/s") * radius)
    mm = abs(float(nominal(board.to_paper_across(RADII, speed.value))))
    if NOTHING < mm < READABLE:
        raise _unreadable(POINTS[key], mm)
    sense = 1 if omega.si >= 0 else -1
    return board.lay_off(foot, LEFT * sense, sense * board.to_paper_across(RADII, speed.value), key=named.key)


def _found(bench: Bench, train: Epicyclic, foot: Points, tips: dict[str, Points]) -> Points:
    """The planet's line through the two known tips meets the level of the third."""
    board, (one, other) = bench.board, tips.values()
    point = POINTS[train.sought]
    letter = point.replace("O2", "O_2")
    letters, scale = f"{letter} {letter[0].lower()}{letter[1:]}", board.scale_of(RADII).right
    board.step(
        Words(
            f"行星轮的速度线过两已知点的矢端，它与 ${letter}$ 高度的水平线的交点即 ${letter}$ 的速度的矢端。量得 "
            f"${letters}$：",
            f"The planet's line passes through the two known tips; where it meets the level of ${letter}$ is the tip "
            f"of the velocity of ${letter}$. Measure ${letters}$:",
        ),
        RADII,
    )
    line = board.parallel(one, unit(other - one))
    tip = board.meet(line, Line(foot, board.turn(1 + 0j)), Words("行星轮的速度线", "the planet's line"))
    ends = sorted((one, other, tip), key=lambda at: float(nominal(at).imag))
    board.join(RADII, ends[0], ends[-1], Role.RESULT)
    mm = abs(float(nominal(tip - foot).real))
    if NOTHING < mm < READABLE:
        raise _unreadable(point, mm)
    on_paper = board.measure(foot, tip, letters)
    size = magnitude(scale.symbol, scale.value, scale.per_mm) * on_paper
    named = speed_of(point)
    bench.worked(named, size if float(nominal(tip - foot).real) <= 0 else Sum((size,), (-1,)))
    bench.read_off(named, RADII, on_paper, letters, scale)
    return tip


def _unreadable(point: str, mm: float) -> NotAskedError:
    return NotAskedError(
        Words(
            f"v_{point} 在图上只有 {mm:.2g} mm，不足 {READABLE:g} mm：各速度线几乎重合，传动比太大，无法量取；请用 "
            "vecpoly exact，或减小传动比",
            f"v_{point} would measure {mm:.2g} mm on paper, less than {READABLE:g} mm: the lines nearly coincide, the "
            "ratio is too large to be measured; use 'vecpoly exact', or a smaller ratio",
        ),
        code="unreadable",
        numbers={"mm": mm},
    )
