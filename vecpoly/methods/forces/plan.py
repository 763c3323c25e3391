"""The force analysis of a mechanism: inertia forces, groups from the far end, the link with the balancing load; without friction, then with it.

With friction the pass without it comes first: it tells on which side every reaction presses, and it gives the ideal balancing
load. The friction pass is tried on scratch paper until every reaction has the sense that was assumed (and the pin couples of
groups solved by moments have settled); then it is drawn.
"""

from __future__ import annotations

from dataclasses import replace

from ...board.construction import View
from ...board.marks import FrictionCircle
from ...errors import EquilibriumError, LockedError, NoMethodError, NoSlipSenseError
from ...mechanism.assur import Group, decompose, ends
from ...mechanism.loads import Loads, Moment
from ...mechanism.model import FRAME, Joint, Mechanism, Prismatic, Revolute
from ...mechanism.quantities import load_named
from ...mechanism.seats import seat, seated
from ...plane import nominal
from ...problem.asks import AskNamed
from ...problem.problem import Problem
from ...words import Words
from ..desk import Desk
from ..registry import Stage, find
from .checks import check_methods
from .efficiency import NOTHING, read_efficiency
from .free_body import draw_free_bodies
from .given_loads import draw_given_loads
from .group import solve_group
from .inertia import inertia_forces
from .pieces import Held
from .readings import read_reactions
from .settling import settled
from .state import Statics
from .thrust import as_outer_force, read_thrusts, without_cylinders

IDEAL = Words("不计摩擦时的力分析", "Force analysis without friction")
REAL = Words("计入摩擦时的力分析", "Force analysis with friction")


def force_pass(desk: Desk, problem: Problem) -> Statics:
    """Draw the force analysis; the readings are in the result.

    Raises LockedError, EquilibriumError, NoSlipSenseError, NoMethodError.
    """
    assert problem.loads is not None
    st = Statics(desk=desk, loads=as_outer_force(desk, problem.loads))
    held, groups = _order(desk, st.loads)
    _refuse_pins(desk.mech, groups)
    groups = without_cylinders(groups, problem.loads)
    inertia_forces(st)
    draw_given_loads(st)
    if st.loads.friction:
        desk.board.section(IDEAL)
    if held is None:
        held = _power_first(st)
    _walk(st, groups, held)
    read_reactions(st, desk.mech)
    check_methods(st, problem)
    if st.loads.friction:
        st = _with_friction(st, groups, held)
    read_thrusts(st, problem.loads)
    draw_free_bodies(st, problem)
    read_efficiency(st)
    if not st.loads.friction:
        _as_they_are(st, problem)
    return st


def _as_they_are(st: Statics, problem: Problem) -> None:
    """Where nothing rubs, what is asked without friction is what was found: M_1_0 = M_1."""
    for ask in problem.asks:
        if isinstance(ask, AskNamed) and (found := ask.rel.key.removesuffix("_0")) != ask.rel.key and found in st.readings:
            st.keep(replace(st.readings[found], key=ask.rel.key, symbol=ask.rel.symbol), st.repeats[found])


def _order(desk: Desk, loads: Loads) -> tuple[Held | None, tuple[Group, ...]]:
    """The link that the balancing load acts on with its joint to the frame, and the groups from the far end.

    No link where that one has no fixed pin (or guide, for a force), or where from it the mechanism comes apart into groups above class II
    though from the driving link it does not: then the groups end at the driving link.
    """
    mech, link = desk.mech, loads.unknown.link
    joint = fixed_joint(mech, link)
    if joint is None or (isinstance(loads.unknown, Moment) and not isinstance(joint, Revolute)):
        return None, tuple(reversed(decompose(mech, pressing=True)))
    own = decompose(replace(mech, drives=(replace(mech.drive, link=link, on=FRAME),)), pressing=True)
    by_drive = decompose(mech, pressing=True)
    if not loads.friction and any(group.dyad is None for group in own) and all(group.dyad for group in by_drive):
        return None, tuple(reversed(by_drive))
    return Held(link=link, parent=FRAME, joint=joint), tuple(reversed(own))


def _refuse_pins(mech: Mechanism, groups: tuple[Group, ...]) -> None:
    """NoMethodError where the forces come in groups above class II for no other reason than that the problem gives a pin to another link."""
    above = next((group for group in groups if group.dyad is None), None)
    plain = seated(mech)
    if above is None or plain.joints == mech.joints or any(group.dyad is None for group in decompose(plain, pressing=True)):
        return
    moved = [p for p in sorted({j.point for j in mech.joints if isinstance(j, Revolute)}) if seat(mech, p) != seat(plain, p)]
    said = ", ".join(f"{p}: {seat(mech, p)}" for p in moved)
    raise NoMethodError(Words(
        f"按 pins: {{{said}}}，各力须由{above.name.zh}求解，没有可用的图解法；请去掉 pins（不计摩擦时它只改变反力的名称），或用 vecpoly exact",
        f"with pins: {{{said}}} the forces come in a {above.name.en}, for which no graphical method is on file; leave 'pins' out (without friction it only renames reactions), "
        "or use 'vecpoly exact'"), code="pins", numbers={"pins": said})


def fixed_joint(mech: Mechanism, link: str) -> Joint | None:
    """The joint of a link to the frame."""
    return next((j for j in mech.joints if not (isinstance(j, Prismatic) and j.guide != FRAME) and set(ends(j)) == {FRAME, link}), None)


def _power_first(st: Statics) -> Held:
    """The balancing load acts on a link that hangs on no fixed joint: by virtual power it is known before any reaction; the driving link closes.

    Raises NoMethodError with friction, of which virtual power knows nothing.
    """
    name, link, driver = st.unknown.name, st.mech.number(st.unknown.link), st.mech.drive.link
    joint = fixed_joint(st.mech, driver)
    if st.loads.friction or joint is None:
        raise NoMethodError(Words(f"{name} 作用于构件 {link}，该构件不与机架相连；计入摩擦时没有可用的图解法。请令平衡力（矩）作用于与机架相连的构件，或去掉 friction，或用 vecpoly exact",
                                  f"{name} acts on link {link}, which is not joined to the frame: with friction no graphical method on file balances it there; let it act on a "
                                  f"link joined to the frame, leave out the friction, or use 'vecpoly exact'"), code="no-method", numbers={"link": link})
    find(Stage.FORCE, "virtual power").draw(st, None)
    found, key = st.readings[f"{name}_power"], load_named(st.unknown).key
    st.keep(replace(found, key=key, symbol=load_named(st.unknown).symbol), st.repeats[f"{name}_power"])
    st.balance, st.balanced = st.repeats[f"{name}_power"], True
    return Held(link=driver, parent=FRAME, joint=joint)


def _walk(st: Statics, groups: tuple[Group, ...], held: Held) -> None:
    """One pass: groups, then the balancing link, or the driving link where the balancing load is known already."""
    for group in groups:
        solve_group(st, group)
    kind = "crank" if isinstance(held.joint, Revolute) else "slide"
    load = "moment" if isinstance(st.unknown, Moment) else "force"
    find(Stage.FORCE, f"{kind}, balanced" if st.balanced else f"{kind}, balancing {load}").draw(st, held)


def _with_friction(ideal: Statics, groups: tuple[Group, ...], held: Held) -> Statics:
    """Settle the senses on scratch paper, then draw."""
    try:
        guide, couples = settled(ideal, groups, lambda st: _walk(st, groups, held))
    except (LockedError, NoSlipSenseError):
        raise
    except EquilibriumError as error:
        raise LockedError(Words("考虑摩擦时不能平衡：", "no equilibrium with friction: ") + error.words) from None
    desk = ideal.desk
    desk.board.section(REAL)
    _circles(ideal)
    st = Statics(desk=desk, loads=ideal.loads, rubbing=True, ideal=guide, inertia=ideal.inertia, inertia_couples=ideal.inertia_couples, couples=couples,
                 readings=dict(ideal.readings), repeats=dict(ideal.repeats))
    _walk(st, groups, held)
    _refuse_locked(ideal, st)
    read_reactions(st, desk.mech)
    return replace(st, ideal=ideal)


def _refuse_locked(ideal: Statics, st: Statics) -> None:
    """Friction may only lower a resisting load, not through zero: it would have to help. Inertia forces may turn it round."""
    before, after = float(nominal(ideal.balance)), float(nominal(st.balance))
    if not st.loads.dynamic and before * after <= 0 and abs(before) > NOTHING * abs(after):
        raise LockedError(Words(
            f"{st.unknown.name} 有摩擦时为 {after:.4g}，无摩擦时为 {before:.4g}：它反向后须帮助运动；机构在此位置自锁，请减小 f 或 ρ",
            f"{st.unknown.name} would be {after:.4g} with friction and {before:.4g} without: with its sense reversed it would have to help the motion; the mechanism is self-locking in this position, lower f or ρ"))


def _circles(st: Statics) -> None:
    """The friction circles on the diagram, to scale."""
    board = st.board
    radii = "、".join(f"$ρ_{point}$ = {1e3 * rho:g} mm" for point, rho in st.loads.friction.pins.items() if rho)
    if radii:
        board.step(Words(f"在机构图上按 $μ_l$ 作各转动副的摩擦圆：{radii}。", f"Draw the friction circles of the pins on the diagram to $μ_l$: {radii.replace('、', ', ')}."), View.MECHANISM)
    else:
        board.step(Words("转动副中的摩擦不计，其反力仍过铰链中心；其余有摩擦的运动副中，总反力偏离法线一个摩擦角。",
                         "The pins have no friction, their reactions still pass through the centres; in the other joints with friction the total reaction leans from the normal by the friction angle."), View.MECHANISM)
    for point, rho in st.loads.friction.pins.items():
        if rho:
            board.mark(View.MECHANISM, FrictionCircle(centre=complex(nominal(st.desk.at[point])), radius=st.desk.mm(rho), label=""))
