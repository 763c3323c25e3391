"""What to change in a chain that cannot move:
a hinge between two moving links asks too much, and is given one freedom more."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from ....algebra.quantity import Expr, Times, magnitude
from ....board.construction import View
from ....devices.structure import Structure
from ....devices.structure_pairs import FRAME, Chain, Form, Pair
from ....foundation.slotted import replace
from ....names import subscripted
from ....words import Words
from ..bench import Bench
from .count import Count, count, size
from .groups import take_apart
from .replacement import replaced
from .sketch import draw_chain, pane

OFF = 0.22  # length of an added link in sizes of the sketch


@dataclass(frozen=True, slots=True, kw_only=True)
class Remedy:
    """A changed chain: name of its figure, and what was changed."""

    name: Words
    words: Words
    chain: Chain


def remedies(bench: Bench, device: Structure, found: Count) -> None:
    """One freedom is missing: draw the changes that give it; more are missing: say how many."""
    board = bench.board
    drivers = device.drive_sets[0] if device.drivers else ()
    missing = max(1, len(drivers)) - found.freedom
    board.section(Words("修改方案", "What to change"))
    board.step(
        Words(
            f"要使机构能按要求运动，自由度须增加 {missing}：或增加一个构件和一个低副（自由度增加 3 − 2 = 1），"
            "或用一个高副代替一个低副（少 2 − 1 = 1 个约束）。",
            f"For the mechanism to move as it should it needs {missing} "
            f"freedom{'s' * (missing > 1)} more: add a link with one lower pair (3 − 2 = 1 more), "
            "or put a higher pair in place of a lower one (2 − 1 = 1 constraint less).",
        )
    )
    for number, remedy in enumerate(_working(device, drivers) if missing == 1 else (), start=1):
        place = pane(
            board, View.MECHANISM, f"remedy {number}", Words(f"修改方案 {number}：", f"Remedy {number}: ") + remedy.name
        )
        board.step(Words(f"方案 {number}：", f"Remedy {number}: ") + remedy.words + _counted(remedy.chain), place)
        draw_chain(board, place, device, remedy.chain, drivers)
        counted = count(remedy.chain, drivers)
        n, low, high = len(remedy.chain.links), remedy.chain.lower, remedy.chain.higher
        freedom: Expr = (
            Times(3, magnitude("n", float(n), ""))
            - Times(2, magnitude("p_L", float(low), ""))
            - magnitude("p_H", float(high), "")
        )
        local = magnitude("F′", float(len(counted.rollers)), "")
        board.formula("F", freedom - local if counted.rollers else freedom, "")


def _counted(chain: Chain) -> Words:
    rolls = len(count(chain).rollers)
    turns = (
        Words("，滚子的转动为局部自由度", "; the roller's turning is a passive degree of freedom")
        if rolls
        else Words.same("")
    )
    return turns + Words("。自由度为：", ". Its degree of freedom is:")


def _working(device: Structure, drivers: tuple[str, ...]) -> tuple[Remedy, ...]:
    """The changes at the first hinge between moving links at which they help."""
    for pair in device.chain.pairs:
        if pair.form is Form.R and len(pair.links) == 2 and FRAME not in pair.links:
            helping = tuple(remedy for remedy in _changes(device, pair) if _works(remedy.chain, device, drivers))
            if helping:
                return helping
    return ()


def _works(chain: Chain, device: Structure, drivers: tuple[str, ...]) -> bool:
    """Whether the changed chain moves, and as its drivers say."""
    found = count(chain, drivers)
    return found.freedom == max(1, len(drivers)) and (
        not drivers or take_apart(replaced(found.reduced, device).chain, drivers).complete
    )


def _changes(device: Structure, pair: Pair) -> Iterator[Remedy]:
    """A link between the two, a block on the lever, a roller on the lever."""
    chain, new = device.chain, device.free_number(0)
    lever, other = sorted(pair.links, key=lambda link: _slide(chain, link) is not None)
    yield Remedy(
        name=Words("增加一个连杆", "a link added"),
        chain=_linked(chain, pair, lever, other, new),
        words=Words(
            f"在构件 {lever} 与 {other} 之间增加构件 {new} 和一个转动副",
            f"between links {lever} and {other} add link {new} and a revolute joint",
        ),
    )
    yield Remedy(
        name=Words("增加一个滑块", "a block added"),
        chain=_blocked(chain, pair, lever, other, new),
        words=Words(
            f"在 ${subscripted(pair.letter)}$ 处加一滑块 {new}，它与构件 {other} 铰接，并在构件 {lever} 上滑动",
            f"at ${subscripted(pair.letter)}$ add block {new}, pinned to link {other} and sliding on link {lever}",
        ),
    )
    yield Remedy(
        name=Words("用滚子高副代替转动副", "a roller instead of the revolute joint"),
        chain=_rolling(chain, pair, lever, other, new),
        words=Words(
            f"把转动副 ${subscripted(pair.letter)}$ 改为高副：构件 {other} 上装滚子 {new}，与构件 {lever} 的平面接触",
            f"make a higher pair of the revolute joint ${subscripted(pair.letter)}$: link {other} carries a "
            f"roller {new}, which touches a flat face of link {lever}",
        ),
    )


def _slide(chain: Chain, link: str) -> Pair | None:
    """Its slide on the frame, if it has one."""
    return next((p for p in chain.at(link) if p.form is Form.P and FRAME in p.links), None)


def _lever_way(chain: Chain, pair: Pair, lever: str) -> complex:
    """The direction of the lever at the hinge, away from its other joints."""
    away = [
        pair.at - p.at
        for p in chain.at(lever)
        if p.letter != pair.letter and p.form is Form.R and abs(p.at - pair.at) > 1e-6
    ]
    return away[0] / abs(away[0]) if away else 1 + 0j


def _free_letter(chain: Chain) -> str:
    used = {p.letter for p in chain.pairs}
    return next((letter for letter in "EFGHJLMNPQRSTUVW" if letter not in used), "E1")


def _with(chain: Chain, pair: Pair, new: str, *pairs: Pair) -> Chain:
    """The chain with this hinge exchanged for others, and a new link."""
    return Chain((*chain.links, new), tuple(p for p in chain.pairs if p.letter != pair.letter) + pairs)


def _linked(chain: Chain, pair: Pair, lever: str, other: str, new: str) -> Chain:
    slide = _slide(chain, other)
    way = slide.along if slide is not None else 1j * _lever_way(chain, pair, lever)
    down = -way if way.imag > 0 else way
    foot = pair.at + OFF * size(chain) * down
    return _with(
        chain,
        pair,
        new,
        replace(pair, links=(lever, new)),
        Pair(letter=_free_letter(chain), form=Form.R, links=(new, other), at=foot),
    )


def _blocked(chain: Chain, pair: Pair, lever: str, other: str, new: str) -> Chain:
    slide = Pair(
        letter=f"{pair.letter}'", form=Form.P, links=(new, lever), at=pair.at, along=_lever_way(chain, pair, lever)
    )
    return _with(chain, pair, new, replace(pair, links=(other, new)), slide)


def _rolling(chain: Chain, pair: Pair, lever: str, other: str, new: str) -> Chain:
    radius, way = 0.06 * size(chain), _lever_way(chain, pair, lever)
    up = 1j * way if (1j * way).imag > 0 else -1j * way
    touch = Pair(
        letter=_free_letter(chain), form=Form.H, links=(new, lever), at=pair.at + radius * up, about=(pair.at, None)
    )
    return _with(chain, pair, new, replace(pair, links=(other, new)), touch)
