"""The block diagram of a train of machines: a box for each machine with its efficiency, the power on every arrow."""

from __future__ import annotations

from dataclasses import dataclass

from ....board.board import Board
from ....board.construction import Pane
from ....board.paper.marks import Role
from ....devices.power_train import PowerTrain
from ....devices.train import Part, Train
from ....diagram.single import machine
from ....words import Words

BOX, HEIGHT, GAP, ROW = 16.5, 12.0, 13.5, 24.0  # mm on paper: five machines in a row fit the text
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
    board.depict(place, machine("motor", complex(BOX / 2, y), BOX, HEIGHT, NAMES[""]))
    _Rows(board, place, train, into, out).draw(train.train, complex(BOX, y), 0.0)


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


@dataclass(frozen=True, slots=True)
class _Rows:
    """The rows of a block diagram, and the power on each arrow."""

    board: Board
    place: Pane
    device: PowerTrain
    into: Flows
    out: Flows

    def draw(self, train: Train, start: complex, top: float) -> None:
        """The parts of a train from where its power comes, then its branches."""
        here = start
        for part in train:
            if part.parallel is not None:
                self._branches(part, part.parallel, here, top)
                return
            self._arrow(here, here + GAP, self.into[id(part)])
            symbol, here = self.device.symbol(part), here + GAP
            words = _named(self.device, part) + Words.same(f"\n${symbol}$ = {part.eta:g}")
            self.board.depict(self.place, machine(part.kind, here + BOX / 2, BOX, HEIGHT, words))
            here += BOX
        self._arrow(here, here + GAP, self.out[id(train[-1])])

    def _branches(self, part: Part, branches: tuple[Train, ...], here: complex, top: float) -> None:
        """A line down the branches, and each of them from there."""
        tops = _tops(branches, top)
        heights = [_middle(branch, t) for branch, t in zip(branches, tops, strict=True)]
        fork = here + GAP
        self._arrow(here, fork, self.into[id(part)], head=False)
        first, last = complex(fork.real, heights[0]), complex(fork.real, heights[-1])
        self.board.join(self.place, first, last, Role.GIVEN)
        for branch, t, y in zip(branches, tops, heights, strict=True):
            self.draw(branch, complex(fork.real, y), t)

    def _arrow(self, a: complex, b: complex, flow: Flow, head: bool = True) -> None:
        """The arrow with its power, and over that the power's symbol where it has one."""
        if head:
            self.board.arrow(self.place, a, b, Role.GIVEN)  # power is no vector: its symbol is in the note
        else:
            self.board.join(self.place, a, b, Role.GIVEN)
        name = f"${flow.symbol}$\n" if flow.symbol else ""
        self.board.note(self.place, (a + b) / 2 + ASIDE, Words.same(f"{name}{flow.power:.4g} kW"))


def _named(device: PowerTrain, part: Part) -> Words:
    name = NAMES[part.kind]
    letter = device.symbol(part).removeprefix("η_")
    return name + Words.same(f" ${letter}$") if part.kind == "machine" and letter.isupper() else name
