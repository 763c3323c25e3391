"""The equivalent link (等效构件) by the velocity polygon: T = ½ J_e ω², P = M_e ω; only ratios of velocities enter."""

from __future__ import annotations

import numpy as np

from ...algebra.columns import TOTAL, column, decimals, headed, summed
from ...algebra.formula import Row, Txt, sym
from ...algebra.quantity import Expr, Product, Quantity, Sum, magnitude
from ...board.board import NO_LENGTH
from ...board.construction import Listing, View
from ...foundation.slotted import replace
from ...mechanism.asked.machine import Equivalent
from ...mechanism.loads import Mass
from ...names import At, Kind, Rel, omega, written_unit
from ...plane import Reals, nominal
from ...words import Words
from ..desk import POLE
from ..forces.balance.power_terms import works
from ..forces.balance.virtual_power import total_of, written_power
from ..forces.friction import STILL
from ..forces.readings import keep_nothing, keep_value
from ..forces.senses import told_by_powers
from ..forces.state import Statics
from ..kinematics.image import found_tip
from ..registry import Stage, method
from ..standing import computed
from .motion_of import Motion, motion_of

_SOURCE = "机械原理, equivalent link: its kinetic energy and its power are those of the whole machine"
_Values = tuple[float, ...]
RATIOS = Words("只用到速度比", "only ratios of velocities enter")
MEASURED = Words(
    "作用点的速度沿力方向的分量由速度多边形量得。",
    "The component of each velocity along its force is measured on the polygon.",
)
_FIGURES = 5  # of the largest number of a column: small ratios keep some


@method(
    stage=Stage.MACHINE,
    group="turning link",
    source=_SOURCE,
    example="7-1",
    title=Words("等效转动惯量与等效力矩", "Equivalent moment of inertia and moment"),
)
def equivalent_turning(st: Statics, to: Equivalent) -> None:
    """J_e = Σ [m (v_S/ω)² + J_S (ω_i/ω)²] (kg·m²), M_e = Σ (F v cos α ± M ω_i) / ω (N·m)."""
    _reduce(st, to)


@method(
    stage=Stage.MACHINE,
    group="slider",
    source=_SOURCE,
    example="7-1",
    title=Words("等效质量与等效力", "Equivalent mass and force"),
)
def equivalent_slider(st: Statics, to: Equivalent) -> None:
    """m_e = Σ [m (v_S/v)² + J_S (ω_i/v)²] (kg), F_e = Σ (F v_F cos α ± M ω_i) / v (N), positive along the motion."""
    _reduce(st, to)


def _reduce(st: Statics, to: Equivalent) -> None:
    _say(st, to)
    moved = motion_of(st, to)
    if st.loads.masses:
        _inertia(st, to, moved)
    else:
        st.board.remark(
            Words(f"各构件不计质量，故 ${to.inertia.symbol}$ = 0。", f" No link has a mass: ${to.inertia.symbol}$ = 0.")
        )
        keep_nothing(st, to.inertia)
    _load(st, to, moved)


def _say(st: Statics, to: Equivalent) -> None:
    """The rule of J_e, in full where it is used first."""
    link, stem = st.mech.number(to.link), "v" if to.slide else "ω"
    if _is_told(st, RATIOS):
        words = Words(
            f"再取构件 {link} 为等效构件，同样由动能等效求 ${to.inertia.symbol}$：",
            f"Now link {link} is the equivalent link; its kinetic energy gives ${to.inertia.symbol}$ in the same way:",
        )
    else:
        words = Words(
            f"取构件 {link} 为等效构件。动能等效：${to.inertia.symbol}$ = Σ[$m_i$ ($v_{{Si}}/{stem}$)² + $J_{{Si}}$ "
            f"($ω_i/{stem}$)²]，{RATIOS.zh}，与 ${stem}$ 的大小无关；各速度由速度多边形量得。",
            f"Link {link} is the equivalent link. Its kinetic energy equals that of all the links: "
            f"${to.inertia.symbol}$ = Σ[$m_i$ ($v_{{Si}}/{stem}$)² + $J_{{Si}}$ ($ω_i/{stem}$)²]; {RATIOS.en}, so the "
            f"value of ${stem}$ does not matter. The velocities are measured on the polygon.",
        )
    st.board.step(words, View.VELOCITY)


def _is_told(st: Statics, words: Words) -> bool:
    """Whether a step has said so already."""
    return any(words.zh in step.words.zh for step in st.board.steps)


def _inertia(st: Statics, to: Equivalent, moved: Motion) -> None:
    """Every mass by its ratios, several as a table; then their sum."""
    terms: list[Expr] = []
    rows: list[_Values] = []
    for mass in st.loads.masses:
        found = [_moving(st, mass, moved), _turning(st, mass, moved)]
        terms += [term for _, term in found if term is not None]
        rows.append(_values(found))
    if len(rows) > 1:
        links = [st.mech.number(mass.link) for mass in st.loads.masses]
        st.board.tabulate(_table(moved, links, rows, to.inertia.unit))
    if not terms:
        st.board.remark(
            Words(
                f"各质量都没有动能，故 ${to.inertia.symbol}$ = 0。",
                f" No mass has kinetic energy: ${to.inertia.symbol}$ = 0.",
            )
        )
        keep_nothing(st, to.inertia)
        return
    total = Sum(tuple(terms), (1,) * len(terms)) if len(terms) > 1 else terms[0]
    value = st.board.compute(to.inertia.symbol, total, to.inertia.unit)
    keep_value(st, to.inertia, value.value, total)


_Found = tuple[Quantity | None, Expr | None]


def _moving(st: Statics, mass: Mass, moved: Motion) -> _Found:
    """v_S over the motion of the equivalent link, and m (v_S / ω)²; nothing of a centre at rest.

    All points of a slider move alike: of the equivalent link itself the ratio is 1, and need not be worked out.
    """
    if mass.link == moved.link and moved.slides:
        return magnitude("1", 1.0, ""), Product((magnitude(f"m_{{{mass.link}}}", mass.mass, "kg"),))
    board, at = st.board, At(mass.centre, mass.link)
    tip = found_tip(st.desk, View.VELOCITY, at)
    if abs(complex(nominal(tip))) < NO_LENGTH:
        return None, None
    letters = f"{POLE[View.VELOCITY]} {st.desk.tip_label(View.VELOCITY, st.desk.canonical(at))}"
    known, symbol = computed(st.desk, Rel(Kind.V, at)), f"v_{{{mass.centre}}}"
    speed = replace(known, node=sym(symbol)) if known else board.mu(View.VELOCITY) * board.measure(0j, tip, letters)
    ratio = board.compute(f"{symbol}/{moved.symbol}", speed / moved.size, moved.of_speeds)
    return ratio, magnitude(f"m_{{{mass.link}}}", mass.mass, "kg") * _bracketed(ratio).squared()


def _turning(st: Statics, mass: Mass, moved: Motion) -> _Found:
    """ω_i over the motion of the equivalent link, and J (ω_i / ω)²; nothing of a link that does not turn."""
    turn = st.desk.turns[omega(mass.link)]
    if not mass.inertia or turn.never or abs(nominal(turn.value)) <= STILL * st.speed / st.mech.scale:
        return None, None
    inertia = magnitude(mass.inertia_symbol, mass.inertia, "kg·m^2")
    if mass.link == moved.link and not moved.slides:
        return magnitude("1", 1.0, ""), Product((inertia,))
    rate = magnitude(f"ω_{mass.link}", np.abs(turn.value), "rad/s")
    ratio = st.board.compute(f"ω_{{{mass.link}}}/{moved.symbol}", rate / moved.size, moved.of_turns)
    return ratio, inertia * _bracketed(ratio).squared()


def _bracketed(ratio: Quantity) -> Quantity:
    return Quantity(Row((Txt("("), ratio.node, Txt(")"))), ratio.value, ratio.unit)


def _values(found: list[_Found]) -> _Values:
    """Both ratios, and both parts of the sum."""
    every = [*(ratio for ratio, _ in found), *(part for _, part in found)]
    return tuple(0.0 if one is None else float(nominal(one.value)) for one in every)


def _table(moved: Motion, links: list[str], rows: list[_Values], unit: str) -> Listing:
    """Symbols over their units, under the parts their sums; unit: of every part of the sum."""
    speeds, turns = f"$v_S/{moved.symbol}$", f"$ω_i/{moved.symbol}$"
    head = (
        Words("构件", "link"),
        _in(f"({speeds})", moved.of_speeds) if moved.of_speeds else Words.same(speeds),
        _in(f"({turns})", moved.of_turns) if moved.of_turns else Words.same(turns),
        _in(f"$m$ ({speeds})²", unit),
        _in(f"$J_S$ ({turns})²", unit),
    )
    linear, angular, moving, turning = zip(*rows, strict=True)
    count = decimals([*moving, *turning], _FIGURES)
    (*moved_on, first), (*turned, second) = (summed(each, count) for each in (moving, turning))
    ratios = (column(each, decimals(each, _FIGURES)) for each in (linear, angular))
    told = zip(links, *ratios, moved_on, turned, strict=True)
    return Listing(head=head, rows=(*told, (TOTAL, "", "", first, second)), blocks=1)


def _in(symbol: str, unit: str) -> Words:
    return Words.same(headed(symbol, written_unit(unit)))


def _load(st: Statics, to: Equivalent, moved: Motion) -> None:
    """P = M_e ω: the powers of all loads and weights over the motion of the equivalent link."""
    if not (st.loads.weight and st.loads.masses) and all(load.size is None for load in st.loads.all):
        keep_nothing(st, to.load)
        return
    st.board.step(_of_power(to.load.symbol, moved.symbol, force=to.slide), View.VELOCITY)
    given = list(works(st))  # measured in this step
    if not _is_told(st, MEASURED):
        st.board.remark(MEASURED)
    parts = [written_power(st, work) for work in given]
    value = total_of(parts) / (moved.size.value * moved.sign)
    moving = [part for part in parts if nominal(part.value)]
    if not moving:
        keep_nothing(st, to.load, value)
        return
    _keep_load(st, to, moved, moving, value)


def _of_power(load: str, speed: str, *, force: bool) -> Words:
    """The rule: the size of a force or of a moment is computed, and its way is told by the sign of the sum."""
    way = Words("指向", "its direction") if force else Words("转向", "its sense")
    kind = "force" if force else "moment"
    return Words(
        f"功率等效：${load}$ 的大小等于各力（矩）的功率 $F v cos α$、$M ω$ 之和 $ΣP$ 的绝对值除以 ${speed}$，"
        f"{way.zh}由 $ΣP$ 的正负判定。",
        f"The {kind} ${load}$ has the power $ΣP$, the sum of the powers $F v cos α$ and $M ω$ of all forces and "
        f"moments: its magnitude is $|ΣP|/{speed}$, and the sign of $ΣP$ determines {way.en}. ",
    )


def _along(load: str, speed: str, along: bool) -> Words:
    """Which way an equivalent force acts."""
    sign, way = (
        (Words("正", "positive"), Words("同向", "along"))
        if along
        else (Words("负", "negative"), Words("反向", "against"))
    )
    return Words(
        f"各功率之和为{sign.zh}，故 ${load}$ 与 ${speed}$ {way.zh}：",
        f" The powers sum to a {sign.en} value, so ${load}$ acts {way.en} ${speed}$:",
    )


def _keep_load(st: Statics, to: Equivalent, moved: Motion, moving: list[Quantity], value: Reals) -> None:
    """The size of F_e or M_e, |ΣP| over the motion, and which way it acts or turns; value: with its sign."""
    named, every = to.load, Sum(tuple(moving), (1,) * len(moving))
    sense, along = int(np.sign(nominal(value))), nominal(every.value) > 0
    if to.slide and sense:
        st.board.remark(_along(named.symbol, moved.symbol, along))
    elif sense:
        powers = Words("各功率", "The powers")
        st.board.remark(told_by_powers(powers, along, (named.symbol, moved.symbol), sense, along=along))
    total = moving[0] if len(moving) == 1 else st.board.compute("ΣP", every, "W")
    size = Quantity(Row((Txt("|"), total.node, Txt("|"))), np.abs(total.value), "W")
    st.board.compute(named.symbol, size / moved.size, named.unit)
    keep_value(st, named, value, size / moved.size)
