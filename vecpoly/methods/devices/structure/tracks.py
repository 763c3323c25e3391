"""Redundant constraints where a point runs on the track that a link prescribes without that link (轨迹重合):
the Cardan circle of a trammel.

A rod whose middle C is led on a circle about O, and one of whose points X, as far from C as O is, slides on a line
through O, is a rod of an elliptic trammel:
every other point at this distance from C runs on a straight line through O, and C on a circle about O, by itself.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from dataclasses import dataclass

from ....devices.structure_pairs import FRAME, Chain, Form, Pair
from ....names import subscripted
from ....words import Words
from .parallel import Found, bars

STRAIGHT = 1e-4  # sine below which two directions are one


@dataclass(frozen=True, slots=True)
class Runner:
    """A block that slides on the frame along a line through O, pinned to the rod at X."""

    block: str
    pin: Pair
    spare: bool  # whether it has these two pairs alone


def trammel(chain: Chain, near: float, drivers: tuple[str, ...]) -> Iterator[Found]:
    """The bar from O to the rod's middle, or where it drives, one of two blocks."""
    for bar in bars(chain):
        for root, tip in (bar.ends, bar.ends[::-1]):
            for rod in tip.links if FRAME in root.links else ():
                runners = tuple(_runners(chain, rod, root, tip, near)) if rod not in (bar.link, FRAME) else ()
                if len(runners) > 1 and bar.link not in drivers:
                    yield (bar.link,), _of_the_bar(bar.link, rod, root, tip, runners)
                spare = [runner for runner in runners if runner.spare and runner.block not in drivers]
                if len(runners) > 1 and spare:
                    yield (spare[-1].block,), _of_the_block(spare[-1], bar.link, rod, root, tip, runners)


def _runners(chain: Chain, rod: str, root: Pair, tip: Pair, near: float) -> Iterator[Runner]:
    """Blocks on lines through the root whose pins are as far from the tip as the root is."""
    reach = abs(tip.at - root.at)
    for pin in chain.at(rod):
        if pin.form is not Form.R or abs(abs(pin.at - tip.at) - reach) > near or abs(pin.at - root.at) < near:
            continue
        for block in pin.links:
            slide = (
                next((p for p in chain.at(block) if p.form is Form.P and set(p.links) == {block, FRAME}), None)
                if block != rod
                else None
            )
            if slide is not None and _leads(slide, pin.at - root.at):
                yield Runner(block, pin, len(chain.at(block)) == 2 and len(pin.links) == 2)


def _leads(slide: Pair, way: complex) -> bool:
    """Whether the block's pin, seen from O, moves along the line through O."""
    return abs(cmath.sin(cmath.phase(way / slide.along)).real) < STRAIGHT


def _equal(root: Pair, tip: Pair, runners: tuple[Runner, ...]) -> str:
    """OC = AC = BC."""
    c = subscripted(tip.letter)
    return " = ".join(subscripted(letter) + c for letter in (root.letter, *(runner.pin.letter for runner in runners)))


def _of_the_bar(bar: str, rod: str, root: Pair, tip: Pair, runners: tuple[Runner, ...]) -> Words:
    o, c = subscripted(root.letter), subscripted(tip.letter)
    return Words(
        f"导路交于 ${o}$，且 ${_equal(root, tip, runners)}$，构件 {rod} 上 ${c}$ 点的轨迹本来就是以 ${o}$ "
        f"为圆心的圆，与构件 {bar} 所限定的轨迹重合，构件 {bar} 不起独立的约束作用",
        f"the guides meet at ${o}$ and ${_equal(root, tip, runners)}$: point ${c}$ of link {rod} "
        f"moves on a circle about ${o}$ even without link {bar}, on the very track that this link "
        "prescribes",
    )


def _of_the_block(runner: Runner, bar: str, rod: str, root: Pair, tip: Pair, runners: tuple[Runner, ...]) -> Words:
    o, x = subscripted(root.letter), subscripted(runner.pin.letter)
    return Words(
        f"${_equal(root, tip, runners)}$，构件 {rod} 上 ${x}$ 点的轨迹本来就是过 ${o}$ 的直线，"
        f"与滑块 {runner.block} 的导路重合，滑块 {runner.block} 不起独立的约束作用",
        f"since ${_equal(root, tip, runners)}$, with crank {bar} point ${x}$ of link {rod} moves on a "
        f"straight line through ${o}$ even without block {runner.block}, on the very line of its "
        "guide",
    )
