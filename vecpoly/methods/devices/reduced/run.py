"""A train that runs up with constant moments: speed, time, turns; what it lifts meanwhile."""

from __future__ import annotations

from math import pi

from ....algebra.formula import Txt
from ....algebra.formula import named as named_node
from ....algebra.quantity import Quantity, magnitude
from ....algebra.worked import worked
from ....devices.dynamics.reduced import LIFT, ROPE, TIME, TURNS, ReducedTrain, alpha_of, omega_of
from ....devices.dynamics.shafts import G
from ....words import Words
from ..bench import Bench
from ..speeds import of_turns

TWO, FOUR_PI = Quantity(Txt("2"), 2.0, ""), Quantity(Txt("4π"), 4 * pi, "")


def run_up(bench: Bench, train: ReducedTrain, ratios: dict[str, Quantity | None], alpha: Quantity) -> None:
    """α is constant: ω = ω_0 + α t, and the turns from the mean speed."""
    board, hoist = bench.board, train.hoist
    if hoist is not None:
        _rope(bench, train, hoist[0])
    if not train.moves:
        return
    board.section(Words("起动", "Run-up"))
    rest = Words("", "") if train.start.si else Words("（由静止起动，$ω_0$ = 0）", " (from rest, $ω_0$ = 0)")
    board.step(
        Words(
            f"力矩不变，角加速度不变{rest.zh}：",
            f"The moments are constant, and so is the angular acceleration{rest.en}:",
        )
    )
    first = magnitude("ω_0", train.start.si, "rad/s")
    if train.until is not None:
        last = _at_last(bench, train, train.until.si, train.until.text)
        time = bench.worked(TIME, (last - first) / alpha)
    else:
        assert train.after is not None
        time = bench.stated(TIME, train.after.si)
        last = bench.worked(omega_of(train.main), first + alpha * time)
    for name, ratio in ratios.items():
        if name != train.main and ratio is not None:
            bench.worked(omega_of(name), ratio * last)
    turns = bench.worked(TURNS, (first + last) * time / FOUR_PI)
    if hoist is not None:
        _lifted(bench, hoist[0], train, ratios[hoist[0]], turns)


def _at_last(bench: Bench, train: ReducedTrain, speed: float, text: str) -> Quantity:
    """The speed at the end, that is given: as ω, or as n (r/min)."""
    named = omega_of(train.main)
    line = worked(named_node(named.symbol), of_turns(f"n_{{{train.main}}}", speed), named.unit)
    return bench.stated(named, speed, line if "r/min" in text else None)


def _rope(bench: Bench, train: ReducedTrain, name: str) -> None:
    """The rope carries the weight and accelerates it."""
    shaft = train.shafts[name]
    assert shaft.lifts is not None and shaft.drum is not None
    bench.board.step(Words("起动时绳的拉力为：", "The tension of the rope while it starts is:"))
    alpha = magnitude(alpha_of(name).symbol, bench.board.found[alpha_of(name).key], "rad/s^2")
    a = bench.board.compute("a", alpha * magnitude("R", shaft.drum.si / 2, "m"), "m/s^2")
    bench.worked(ROPE, magnitude("m", shaft.lifts.si, "kg") * (magnitude("g", G, "m/s^2") + a))


def _lifted(bench: Bench, name: str, train: ReducedTrain, ratio: Quantity | None, turns: Quantity) -> None:
    shaft = train.shafts[name]
    assert shaft.drum is not None
    drum = Quantity(Txt("π"), pi, "") * magnitude(f"D_{{{name}}}", shaft.drum.si, "m") * turns
    bench.worked(LIFT, drum if ratio is None else drum * ratio)
