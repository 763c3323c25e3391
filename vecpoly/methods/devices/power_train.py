"""The efficiency of machines in series, in parallel and mixed: from the loads back to the motor."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from ...algebra.quantity import Expr, Powered, Product, Quantity, Sum, magnitude
from ...board.construction import View
from ...devices.power_train import ETA, POWER, POWER_OUT, PowerTrain, eta_prime, out, share
from ...devices.train import Part, Train, ends, partings
from ...names import Named
from ...plane import nominal
from ...words import Words
from .bench import Bench
from .registry import device_method
from .sketches.power_train import Flow, Flows, draw_train


@dataclass(slots=True)
class _Way:
    """The walk back from the loads: what the ends deliver, and the power on every arrow of the diagram."""

    bench: Bench
    device: PowerTrain
    delivered: dict[str, Quantity] = field(default_factory=dict)
    taken: dict[str, Quantity] = field(default_factory=dict)
    into: Flows = field(default_factory=dict)
    out: Flows = field(default_factory=dict)

    def letters(self, train: Train) -> str:
        """The ends of a train, A or AB."""
        mine = {id(end) for end in ends(train)}
        return "".join(letter for letter, end in self.ends() if id(end) in mine)

    def ends(self) -> Iterator[tuple[str, Part]]:
        """Every end with its letter."""
        return zip(self.device.letters, ends(self.device.train), strict=True)

    def useful(self, train: Train) -> Expr:
        """What a train delivers: P_A + P_B."""
        return _sum([self.delivered[letter] for letter in self.letters(train)])


@device_method(
    PowerTrain,
    title=Words("机器的串联、并联与混联", "Machines in series, in parallel and in series–parallel"),
    source="机械原理, efficiency of trains of machines",
    example="5-7",
)
def draw_power_train(bench: Bench, device: PowerTrain) -> None:
    """η = P_r / P: series η = Π η_i, parallel η′ = Σ P_out / Σ P_in; the motor gives P = P_r / η."""
    board, way = bench.board, _Way(bench, device)
    place = board.open_pane(View.MECHANISM, "train", Words("传动简图", "Block diagram"))
    board.section(Words("机组的效率与功率", "Efficiency and power"))
    useful = _loads(way)
    factors = _etas(way, device.train)
    if device.train[-1].parallel is None:
        board.step(
            Words(
                "各部分串联，前一级的输出功率即后一级的输入功率，故总效率等于各级效率的连乘积：",
                "The machines are in series: the output of each is the input of the next, so the "
                "total efficiency is the product of all efficiencies:",
            )
        )
    else:
        factors.append(_parting(way, device.train[-1]))
        board.step(
            Words(
                "公共部分与并联部分串联，总效率为：",
                "The common part and the parallel part are in series; the total efficiency is:",
            )
        )
    eta = bench.worked(ETA, _product(factors))
    board.step(Words("电动机所需的功率为：", "The motor must supply:"))
    power = bench.worked(POWER, useful / eta)
    if len(device.letters) > 1:
        _shares(way)
    _flow(way, device.train, POWER.symbol, float(nominal(power.value)))
    board.step(
        Words(
            "把各处的功率标在传动简图上：功率由电动机到工作机逐级减小，相邻两处之差即为该级的损失。",
            "Enter the powers in the block diagram: they fall from machine to machine on the way "
            "from the motor to the load, and each difference is the loss in that machine.",
        ),
        place,
    )
    draw_train(board, place, device, way.into, way.out)


def _loads(way: _Way) -> Quantity:
    """What the ends deliver: P each, or F v; and all together."""
    several = len(way.device.letters) > 1
    way.bench.board.step(
        Words(
            "从工作机开始，逆着功率流计算。工作机的有用功率为："
            if not several
            else "从工作机开始，逆着功率流计算。各工作机的有用功率及其总和为：",
            "Start at the load and work back against the flow of power. The useful power is:"
            if not several
            else "Start at the loads and work back against the flow of power. The useful powers and their sum are:",
        )
    )
    for letter, end in way.ends():
        named = out(letter) if several else POWER_OUT
        way.delivered[letter] = _delivered(way.bench, named, end)
        way.out[id(end)] = Flow(symbol=named.symbol, power=float(nominal(way.delivered[letter].value)))
    return (
        way.bench.worked(POWER_OUT, way.useful(way.device.train)) if several else way.delivered[way.device.letters[0]]
    )


def _delivered(bench: Bench, named: Named, end: Part) -> Quantity:
    """P as given, or F v: force in kN, speed in m/s, power in kW."""
    if end.P is not None:
        return bench.stated(named, end.P.si / 1e3)
    assert end.F is not None and end.v is not None
    sub = "" if named is POWER_OUT else named.symbol.removeprefix("P")
    return bench.worked(named, magnitude(f"F{sub}", end.F.si / 1e3, "kN") * magnitude(f"v{sub}", end.v.si, "m/s"))


def _parting(way: _Way, part: Part) -> Quantity:
    """η′ = Σ P_out / Σ P_in of parallel branches; first what each of them takes."""
    assert part.parallel is not None
    bench, taken = way.bench, [_taken(way, branch) for branch in part.parallel]
    names = Words(
        "、".join(f"${way.letters(b)}$" for b in part.parallel), ", ".join(f"${way.letters(b)}$" for b in part.parallel)
    )
    bench.board.step(
        Words("支路 ", "The branches ")
        + names
        + Words(
            " 并联，总输入、总输出功率各为两者之和，并联部分的效率为："
            if len(taken) == 2
            else " 并联，总输入、总输出功率各为它们之和，并联部分的效率为：",
            " are in parallel: their inputs add up, and so do their outputs; the efficiency of the parallel part is:",
        )
    )
    places = partings(way.device.train)
    index = next(i for i, other in enumerate(places) if other is part)
    return bench.worked(eta_prime(index, len(places)), way.useful((part,)) / _sum(taken))


def _taken(way: _Way, train: Train) -> Quantity:
    """P′_A: what a branch takes where the train parts."""
    letters, factors = way.letters(train), _etas(way, train)
    if train[-1].parallel is not None:
        factors.append(_parting(way, train[-1]))
    way.bench.board.step(
        Words(f"支路 ${letters}$ 在分路处的输入功率：", f"The input of branch ${letters}$, where the train parts, is:")
    )
    way.taken[letters] = way.bench.board.compute(_taken_symbol(letters), way.useful(train) / _product(factors), "kW")
    return way.taken[letters]


def _taken_symbol(letters: str) -> str:
    return f"P′_{{{letters}}}"


def _shares(way: _Way) -> None:
    """P_Ad = P_A / Π η over the whole way from the motor to the end A."""
    way.bench.board.step(
        Words(
            "其中电动机供给各工作机的功率，等于该机的有用功率除以从电动机到该机各级效率的连乘积；"
            "各机之和应等于电动机的功率：",
            "Of this the motor supplies to each machine its useful power divided by the "
            "product of the efficiencies on the way from the motor; together they must "
            "make up the power of the motor:",
        )
    )
    parts = []
    for letter, end in way.ends():
        parts.append(
            way.bench.worked(share(letter), way.delivered[letter] / _product(_etas(way, _path(way.device.train, end))))
        )
    way.bench.board.compute(POWER.symbol, _sum(parts), "kW")


def _path(train: Train, end: Part) -> Train:
    """The parts from the motor to an end."""
    for branch in train[-1].parallel or ():
        if any(part is end for part in ends(branch)):
            return (*train[:-1], *_path(branch, end))
    return train


def _etas(way: _Way, train: Train) -> list[Expr]:
    """The efficiencies of the parts in series, equal ones as a power."""
    row = [(way.device.symbol(part), part.eta) for part in train if part.parallel is None]
    leaves = {one: magnitude(one[0], one[1], "") for one in row}
    return [leaf if row.count(one) == 1 else Powered(leaf, row.count(one)) for one, leaf in leaves.items()]


def _product(factors: list[Expr]) -> Expr:
    return factors[0] if len(factors) == 1 else Product(tuple(factors))


def _sum(terms: list[Quantity]) -> Expr:
    return terms[0] if len(terms) == 1 else Sum(tuple(terms), (1,) * len(terms))


def _flow(way: _Way, train: Train, symbol: str, power: float) -> None:
    """The power on every arrow, from the motor on."""
    for part in train:
        way.into[id(part)] = Flow(symbol=symbol, power=power)
        if part.parallel is None:
            symbol, power = "", power * part.eta
            continue
        for branch in part.parallel:
            letters = way.letters(branch)
            _flow(way, branch, _taken_symbol(letters), float(way.taken[letters].value))
