"""The diagram of angular velocities: rays parallel to the lines of the links cut them off on one level."""

from __future__ import annotations

from collections.abc import Mapping

from ....algebra.formula import sym
from ....algebra.quantity import Expr, Quantity, Sum, magnitude
from ....algebra.worked import worked
from ....board.board import NO_LENGTH
from ....board.paper.marks import Dot, Role
from ....devices.gears.epicyclic import Epicyclic
from ....names import Named
from ....plane import Line, Points, nominal, unit
from ....words import Words, joined
from ..bench import Bench
from .letters import turning
from .scales import RADII, TURNS


def angular_velocities(bench: Bench, train: Epicyclic, tips: Mapping[str, Points]) -> None:
    """ω of every link, and the ratio where one link is held."""
    board = bench.board
    board.section(Words("角速度图", "Angular-velocity diagram"))
    turn, up = board.scale_of(TURNS).value, board.scale_of(RADII)
    pole_distance = up.right.value / (up.value * turn)
    board.step(
        Words(
            "在水平线下方取极点 $Π$，极距 $ΠF$ = $μ_v$/($μ_l$ $μ_ω$)；过 $Π$ 作各构件速度线的平行线，在水平线上截得各"
            "角速度：$F$ 以左为逆时针，以右为顺时针。",
            "Below a horizontal line take the pole $Π$ at the distance $ΠF$ = $μ_v$/($μ_l$ $μ_ω$). Rays through $Π$ "
            "parallel to the velocity lines of the links cut off their angular velocities on the horizontal line: "
            "those to the left of $F$ are counter-clockwise, those to the right clockwise.",
        ),
        TURNS,
    )
    board.compute(
        "ΠF", magnitude("μ_v", up.right.value, "") / (magnitude("μ_l", up.value, "") * magnitude("μ_ω", turn, "")), "mm"
    )
    pole = board.lay_off(0j, -1j, pole_distance)
    board.plot(TURNS, pole, "Π", Dot.POLE)
    board.join(TURNS, pole, 0j, Role.CENTRE)
    board.plot(TURNS, 0j, "F", Dot.NONE)
    lines = dict(tips) | {"2": tips["H"] - tips["1"]}
    level = Line(0j + 0 * pole, board.turn(1 + 0j))
    cuts = {key: _cut(bench, pole, level, key, lines[key]) for key in ("1", "2", "3", "H")}
    reach = [0.0, *(float(nominal(at).real) for at in cuts.values())]
    board.join(TURNS, complex(min(reach) - 6, 0), complex(max(reach) + 6, 0), Role.CONSTRUCTION)
    known = {key: omega.si for key, omega in train.omegas.items() if omega is not None}
    found = {key: _given(bench, key, known[key]) if key in known else _read(bench, key, at) for key, at in cuts.items()}
    _senses(bench, cuts)
    for key, at in cuts.items():
        if train.omegas.get(key) is None:
            turning(bench, train, key, -float(nominal(at).real))
    if train.ratio is not None and train.driver is not None:
        board.step(Words("传动比（角速度以逆时针为正）：", "The ratio is (counter-clockwise positive):"))
        bench.worked(train.ratio, found[train.driver] / found[train.sought])
    _by_teeth(bench, train, found)


def _by_teeth(bench: Bench, train: Epicyclic, found: Mapping[str, Quantity]) -> None:
    """The ratio relative to the carrier, by what was read and by the teeth; none where the train turns as one block."""
    arm, symbol = found["H"], sym("i_{13}^{H}")
    relative = float(nominal(found["3"].value)) - float(nominal(arm.value))
    if abs(relative) < NO_LENGTH * bench.board.scale_of(TURNS).value:
        return
    bench.board.step(
        Words(
            "校核：转化轮系的传动比，由角速度（逆时针为正）求得者应与由齿数求得者相符，差别为作图误差：",
            "Check: the ratio relative to the carrier is to be the same by the angular velocities (counter-clockwise "
            "positive) and by the teeth:",
        )
    )
    bench.board.write(worked(symbol, (found["1"] - arm) / (found["3"] - arm), ""), worked(symbol, _teeth(train), ""))


def _teeth(train: Epicyclic) -> Expr:
    """± (driven teeth)/(driving teeth), negative where one mesh is outer and one inner."""
    sun, other = magnitude("z_1", float(train.sun), ""), magnitude("z_3", float(train.other), "")
    ratio = other / sun
    if len(train.planet) > 1:
        first, second = (magnitude(z, float(n), "") for z, n in zip(("z_2", "z_{2′}"), train.planet, strict=True))
        ratio = (first * other) / (sun * second)
    return Sum((ratio,), (-1,)) if train.ring else ratio


def _cut(bench: Bench, pole: Points, level: Line, key: str, line: Points) -> Points:
    """Where the ray of a link meets the level."""
    board = bench.board
    ray = board.parallel(pole, unit(line) if float(nominal(line).imag) > 0 else -unit(line))
    at = board.meet(ray, level, Words(f"构件 {key} 的射线", f"the ray of link {key}"))
    board.join(TURNS, pole, at, Role.RESULT)
    board.plot(TURNS, at, key, Dot.POINT)
    return at


def _given(bench: Bench, key: str, omega: float) -> Quantity:
    """An angular velocity that is given is gone on with as it is, and not read back."""
    named = Named(f"omega_{key}", f"ω_{key}", "rad/s")
    return bench.told_otherwise(named, magnitude(named.symbol, omega, named.unit))


def _read(bench: Bench, key: str, at: Points) -> Quantity:
    board = bench.board
    on_paper = board.measure(0j, at, f"F {key}")
    scale = board.scale_of(TURNS)
    named = Named(f"omega_{key}", f"ω_{key}", "rad/s")
    sense = -1 if float(nominal(at).real) > 0 else 1
    found = bench.worked(named, magnitude(scale.symbol, scale.value, scale.per_mm) * on_paper, sense)
    bench.read_off(named, TURNS, on_paper, f"F {key}")
    return found


def _senses(bench: Bench, cuts: Mapping[str, Points]) -> None:
    """How each turns: the lines have the sizes alone."""
    told = []
    for side, turn in ((-1, Words("逆时针", "counter-clockwise")), (1, Words("顺时针", "clockwise"))):
        found = [Words.same(f"$ω_{key}$") for key, at in cuts.items() if side * float(nominal(at).real) > NO_LENGTH]
        if found:
            names, verb = joined(found), "is" if len(found) == 1 else "are"
            told.append(Words(f"{names.zh} 为{turn.zh}方向", f"{names.en} {verb} {turn.en}"))
    if told:
        zh, en = "，".join(one.zh for one in told), ", and ".join(one.en for one in told)
        bench.board.remark(Words(f"故 {zh}。", f" So {en}."))
