"""The block diagram of a train of machines: a box for each machine with its efficiency, the power on every arrow."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from ....board.board import Board
from ....board.construction import Pane
from ....board.paper.marks import Cell, Mark, Note, Role, Segment, Vector
from ....devices.power_train import PowerTrain
from ....devices.train import Part, Train
from ....words import Words

BOX, HEIGHT, GAP, ROW = 17.0, 12.0, 16.0, 24.0  # mm on paper: five machines in a row fit the text
ASIDE = 0.5j  # mm: the power stands over the arrow

NAMES = {
    "": Words("电动机", "motor"),
    "belt": Words("带传动", "belt drive"),
    "chain": Words("链传动", "chain drive"),
    "gear": Words("齿轮传动", "gear pair"),
    "worm": Words("蜗杆传动", "worm gear"),
    "bearing": Words("轴承", "bearings"),
    "coupling": Words("联轴器", "coupling"),
    "screw": Words("螺旋传动", "screw"),
    "conveyor": Words("输送机", "conveyor"),
    "winch": Words("卷筒", "winch"),
    "pump": Words("泵", "pump"),
    "machine": Words("工作机", "machine"),
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Flow:
    """Power on one arrow: its symbol, if it has one, and its size (kW)."""

    symbol: str
    power: float


Flows = dict[int, Flow]  # by id of the part that takes it; under MINUS the part that delivers it


def draw_train(board: Board, place: Pane, train: PowerTrain, into: Flows, out: Flows) -> None:
    """Draw the motor and all that it drives; into, out:
    the power that a part takes, and that an end delivers, by id of the part."""
    y = _middle(train.train, 0.0)
    board.mark(place, Cell(at=complex(BOX / 2, y), width=BOX, height=HEIGHT, words=NAMES[""]))
    board.mark(place, *_row(train, train.train, complex(BOX, y), 0.0, into, out))


def _rows(train: Train) -> int:
    """How many rows a train takes: one for each of its ends."""
    last = train[-1].parallel
    return sum(_rows(branch) for branch in last) if last else 1


def _middle(train: Train, top: float) -> float:
    """The height of a train's line, midway between its first and last branch."""
    branches = train[-1].parallel
    if not branches:
        return top
    tops = _tops(branches, top)
    return (_middle(branches[0], tops[0]) + _middle(branches[-1], tops[-1])) / 2


def _tops(branches: tuple[Train, ...], top: float) -> list[float]:
    tops = [top]
    for branch in branches[:-1]:
        tops.append(tops[-1] - ROW * _rows(branch))
    return tops


def _row(device: PowerTrain, train: Train, start: complex, top: float, into: Flows, out: Flows) -> Iterator[Mark]:
    """The parts of a train from where its power comes, then its branches."""
    here = start
    for part in train:
        if part.parallel is not None:
            yield from _branches(device, part, here, top, into, out)
            return
        yield from _arrow(here, here + GAP, into[id(part)])
        here += GAP
        yield Cell(
            at=here + BOX / 2,
            width=BOX,
            height=HEIGHT,
            words=_named(device, part) + Words.same(f"\n${device.symbol(part)}$ = {part.eta:g}"),
        )
        here += BOX
    yield from _arrow(here, here + GAP, out[id(train[-1])])


def _branches(device: PowerTrain, part: Part, here: complex, top: float, into: Flows, out: Flows) -> Iterator[Mark]:
    """A line down the branches, and each of them from there."""
    assert part.parallel is not None
    tops = _tops(part.parallel, top)
    heights = [_middle(branch, t) for branch, t in zip(part.parallel, tops, strict=True)]
    fork = here + GAP
    yield from _arrow(here, fork, into[id(part)], head=False)
    yield Segment(a=complex(fork.real, heights[0]), b=complex(fork.real, heights[-1]), role=Role.GIVEN)
    for branch, t, y in zip(part.parallel, tops, heights, strict=True):
        yield from _row(device, branch, complex(fork.real, y), t, into, out)


def _arrow(a: complex, b: complex, flow: Flow, head: bool = True) -> Iterator[Mark]:
    """The arrow with its power, and over that the power's symbol where it has one."""
    yield Vector(a=a, b=b, role=Role.GIVEN) if head else Segment(a=a, b=b, role=Role.GIVEN)
    name = f"${flow.symbol}$\n" if flow.symbol else ""
    yield Note(at=(a + b) / 2 + ASIDE, words=Words.same(f"{name}{flow.power:.4g} kW"))


def _named(device: PowerTrain, part: Part) -> Words:
    name = NAMES[part.kind]
    letter = device.symbol(part).removeprefix("η_")
    return name + Words.same(f" ${letter}$") if part.kind == "machine" and letter.isupper() else name
