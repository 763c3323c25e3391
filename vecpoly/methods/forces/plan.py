"""The force analysis of a mechanism: inertia forces, groups from the far end,
the link with the balancing load; without friction, then with it.

With friction the pass without it comes first: it tells on which side every reaction presses, and it gives the ideal
balancing load. The friction pass is tried on scratch paper until every reaction has the sense that was assumed (and the
pin couples of groups solved by moments have settled); then it is drawn.
"""

from __future__ import annotations

from collections.abc import Iterable

from ...board.construction import View
from ...diagram.single import friction_circle
from ...errors import EquilibriumError, LockedError, NoSlipSenseError
from ...foundation.slotted import replace
from ...mechanism.asked.forces import load_named, without_friction
from ...mechanism.groups.assur import Group
from ...mechanism.loads import Loads, Moment
from ...mechanism.model import Revolute
from ...plane import Reals, nominal
from ...problem.asked.asks import AskNamed
from ...problem.problem import Problem
from ...words import Words
from ..desk import Desk
from ..registry import Stage
from .balance.another_driver import found_before
from .balance.checks import check_methods
from .balance.efficiency import NOTHING, read_efficiency
from .balance.moving import moving
from .balance.power_alone import is_alone, is_drawn, power_first, refuse_undrawn
from .bodies.free_body import draw_free_bodies
from .bodies.given_loads import draw_given_loads
from .bodies.past_guides import say_past_guides
from .closing.thrust import (
    as_moved,
    as_outer_forces,
    floating_unknown,
    from_the_frame,
    unknown_thrust,
    without_cylinders,
)
from .closing.thrust_readings import read_thrusts
from .doors import DRIVERS
from .groups.group import solve_group
from .hubs import hub_couples, hubs_of, joined, say_hubs
from .inertia import inertia_forces
from .laws.found import Pulls, found_loads
from .lines.links_of_group import Held
from .order import order_of, order_without
from .readings import read_reactions
from .settling.settled import settled
from .settling.trial import say_trial, tried
from .state import Statics

IDEAL = Words("不计摩擦时的力分析", "Force analysis without friction")
REAL = Words("计入摩擦时的力分析", "Force analysis with friction")


def force_pass(desk: Desk, problem: Problem) -> Statics:
    """Draw the force analysis; the readings are in the result.

    Raises LockedError, EquilibriumError, NoSlipSenseError, NoMethodError.
    """
    assert problem.loads is not None
    here, pulls = found_loads(desk, from_the_frame(desk.mech, problem.loads))
    return _of_position(desk, replace(problem, loads=here), pulls)


def _of_position(desk: Desk, problem: Problem, pulls: Pulls) -> Statics:
    """The force analysis with the loads as they are in this position."""
    assert problem.loads is not None
    if not problem.loads.friction and is_alone(problem) and not _are_reactions_drawn(desk, problem.loads):
        return _balance_alone(desk, problem, pulls)
    loads = as_outer_forces(desk, problem.loads)
    floating = floating_unknown(desk.mech, problem.loads)
    order = order_of(desk.mech, loads, moving(desk)) if floating is None else order_without(desk.mech, floating)
    hubs = hubs_of(desk.mech, order.mech)
    st = Statics(desk=replace(desk, mech=order.mech), loads=loads, hubs=hubs, own=desk.mech, pulls=pulls)
    held, groups = order.held, without_cylinders(order.mech, order.groups, problem.loads)
    if not is_drawn(groups):
        raise refuse_undrawn(st, groups)
    inertia_forces(st)
    draw_given_loads(st)
    say_hubs(st)
    if st.loads.friction:
        desk.board.section(IDEAL)
    if floating is not None:
        power_first(st, problem.loads)
    elif order.known:
        held = found_before(st, order, problem.loads)
    assert held is not None
    _walk(st, groups, held)
    ideal, st = st, joined(st, desk)
    read_reactions(st, desk.mech)
    check_methods(_with_thrust(st, problem.loads), problem)
    if st.loads.friction:
        st = _with_friction(ideal, groups, held, desk)
    read_thrusts(st, problem.loads)
    draw_free_bodies(st, problem, (*(link for group in groups for link in group.links), held.link))
    say_past_guides(st)
    read_efficiency(_with_thrust(st, problem.loads))
    if not st.loads.friction:
        _as_they_are(st, problem)
    return st


def _with_thrust(st: Statics, loads: Loads) -> Statics:
    """The pass, with a thrust that is sought as the problem has it: one load that does work at both ends."""
    return st if unknown_thrust(loads) is None else replace(st, loads=loads)


def _as_they_are(st: Statics, problem: Problem) -> None:
    """Where nothing rubs, what is asked without friction is what was found: M_1_0 = M_1."""
    for ask in problem.asks:
        if (
            isinstance(ask, AskNamed)
            and (found := ask.rel.key.removesuffix("_0")) != ask.rel.key
            and found in st.board.readings
        ):
            st.keep(replace(st.board.readings[found], key=ask.rel.key, symbol=ask.rel.symbol), st.board.found[found])


def _are_reactions_drawn(desk: Desk, loads: Loads) -> bool:
    """Whether the reactions of all groups are drawn."""
    if (floating := floating_unknown(desk.mech, loads)) is not None:
        order = order_without(desk.mech, floating)
        return order.held is not None and is_drawn(order.groups)
    moved = replace(
        loads, forces=tuple(as_moved(desk.mech, loads, force) if force.against else force for force in loads.forces)
    )
    order = order_of(desk.mech, moved, moving(desk))
    return is_drawn(without_cylinders(order.mech, order.groups, loads))


def _balance_alone(desk: Desk, problem: Problem, pulls: Pulls) -> Statics:
    """No reaction is asked for, and not all are drawn:
    virtual power finds the balancing load, and the lever where it is asked for."""
    assert problem.loads is not None
    st = Statics(desk=desk, loads=problem.loads, pulls=pulls)
    inertia_forces(st)
    draw_given_loads(st)
    power_first(st)
    desk.board.remark(Words("此法不出现运动副反力，各反力未求。", " No reaction enters here, and none is found."))
    check_methods(st, problem)
    named = without_friction(load_named(st.unknown))
    st.keep(replace(st.board.readings[load_named(st.unknown).key], key=named.key, symbol=named.symbol), st.balance)
    return st


def _walk(st: Statics, groups: tuple[Group, ...], held: Held) -> None:
    """One pass: groups, then the balancing link, or the driving link where the balancing load is known already."""
    for group in groups:
        solve_group(st, group)
    kind = "crank" if isinstance(held.joint, Revolute) else "slide"
    load = "moment" if isinstance(st.unknown, Moment) else "force"
    DRIVERS.find(Stage.FORCE, f"{kind}, balanced" if st.balanced else f"{kind}, balancing {load}").draw(st, held)


def _with_friction(ideal: Statics, groups: tuple[Group, ...], held: Held, own: Desk) -> Statics:
    """Settle the senses on scratch paper, then draw; own: the desk of the problem's own joints."""
    try:
        guide, couples = settled(ideal, groups, lambda st: _walk(st, groups, held), lambda st: hub_couples(st, own))
    except (LockedError, NoSlipSenseError):
        raise
    except EquilibriumError as error:
        raise LockedError(Words("考虑摩擦时不能平衡：", "no equilibrium with friction: ") + error.words) from None
    desk = ideal.desk
    desk.board.section(REAL)
    _circles(ideal, couples.values())
    st = Statics(
        desk=desk,
        loads=ideal.loads,
        rubbing=True,
        ideal=guide,
        inertia=ideal.inertia,
        inertia_couples=ideal.inertia_couples,
        couples=couples,
        by_moments=set(guide.by_moments),
        hubs=ideal.hubs,
        own=ideal.own,
        pulls=ideal.pulls,
        balance=tried(ideal, couples),
        balanced=ideal.balanced,
    )
    if st.balanced:
        say_trial(st, groups, held)
    _walk(st, groups, held)
    _refuse_locked(ideal, st)
    st = joined(st, own)
    read_reactions(st, own.mech)
    return replace(st, ideal=replace(ideal, desk=own, hubs=(), own=None))


def _refuse_locked(ideal: Statics, st: Statics) -> None:
    """Friction may only lower a resisting load, not through zero:
    it would have to help, which not every load may."""
    before, after = float(nominal(ideal.balance)), float(nominal(st.balance))
    if not st.loads.helps and before * after <= 0 and abs(before) > NOTHING * abs(after):
        raise LockedError(
            Words(
                f"{st.unknown.name} 有摩擦时为 {after:.4g}，无摩擦时为 {before:.4g}：它反向后须帮助运动；"
                "机构在此位置自锁，请减小 f 或 ρ",
                f"{st.unknown.name} would be {after:.4g} with friction and {before:.4g} without: with its sense "
                "reversed it would have to help the motion; the mechanism is self-locking in this position, "
                "lower f or ρ",
            )
        )


def _circles(st: Statics, couples: Iterable[Reals]) -> None:
    """The friction circles on the diagram, to scale; couples: of friction in pins, for which moments are taken."""
    board = st.board
    radii = "、".join(f"$ρ_{point}$ = {1e3 * rho:.4g} mm" for point, rho in st.loads.friction.pins.items() if rho)
    if radii:
        board.step(
            Words(
                f"在机构图上按 $μ_l$ 作各转动副的摩擦圆：{radii}。",
                f"Draw the friction circles of the pins on the diagram to $μ_l$: {radii.replace('、', ', ')}.",
            ),
            View.MECHANISM,
        )
    else:
        board.step(
            Words(
                "转动副中的摩擦不计，其反力仍过铰链中心；其余有摩擦的运动副中，总反力偏离法线一个摩擦角。",
                "The pins have no friction, and their reactions still pass through the centres; in "
                "the other joints with friction the total reaction is inclined to the normal at the "
                "friction angle.",
            ),
            View.MECHANISM,
        )
    if any(nominal(couple) for couple in couples):
        board.remark(
            Words(
                "取矩时，铰链中的摩擦以力矩 $M_{fij}$ = $ρ R_{ij}$ 计入，与相对转动反向，其大小由试算得出。",
                " Where moments are taken, the friction at a pin is the couple $M_{fij}$ = $ρ R_{ij}$ against the "
                "relative turning; its size is found by trial.",
            )
        )
    for point, rho in st.loads.friction.pins.items():
        if rho:
            board.depict(View.MECHANISM, friction_circle(point, st.desk.at[point], st.desk.mm(rho)))
