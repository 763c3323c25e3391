"""A problem drawn on a board, whose scales are known: the groups in order, each with its textbook methods."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping

from ..board.board import Board
from ..board.paper.marks import Dot
from ..mechanism.groups.assur import Group, decompose
from ..names import subscripted
from ..problem.problem import Problem
from ..words import Words
from .coincident import coincident_letters
from .desk import POLE, Desk
from .higher import refuse_higher
from .kinematics.diagram.cam import letter_contacts, say_replaced
from .kinematics.diagram.drive_arrow import draw_drive_arrow
from .kinematics.diagram.links import draw_frame, draw_links, number_guide
from .kinematics.doors import draw_drive, draw_group
from .kinematics.position.drive import say_fixed_points, say_welded, stepped_off
from .kinematics.position.standing import told_point
from .kinematics.wanted import draw_wanted
from .passes import stages
from .registry import Stage

SECTIONS = {
    Stage.POSITION: Words("作机构位置图", "Position diagram"),
    Stage.CENTRES: Words("瞬心法", "Instant centres"),
    Stage.CURVATURE: Words("曲率与瞬心线", "Curvature and centrodes"),
    Stage.PRESSURE: Words("压力角和传动角", "Pressure and transmission angles"),
    Stage.VELOCITY: Words("速度分析", "Velocity analysis"),
    Stage.ACCELERATION: Words("加速度分析", "Acceleration analysis"),
    Stage.FORCE: Words("力分析", "Force analysis"),
    Stage.MACHINE: Words("等效动力学模型", "Equivalent model"),
    Stage.BALANCE: Words("惯性力的完全平衡", "Full balance of the inertia forces"),
}
NOTHING: Mapping[Stage, Words] = {}


def draw(problem: Problem, board: Board, said: Mapping[Stage, Words] = NOTHING) -> Desk:
    """The desk after all stages of the problem; said: what comes first of a stage."""
    mech = problem.mechanism
    groups = decompose(mech)
    refuse_higher(mech, groups)
    desk = Desk(
        board=board,
        mech=mech,
        coincident=coincident_letters(mech, groups),
        shapes=problem.given.shapes,
        loaded=problem.loads is not None,
        mass_centres=_mass_centres(problem),
        thought=Stage.VELOCITY in said,  # of a cam's profile, whose link does drive, only the position is told
    )
    for name, at in mech.frame.items():
        desk.letter(name, at * desk.mm(1.0))
    for stage in stages(problem):
        desk.board.section(SECTIONS[stage])
        if stage in said and not any(step.words.zh.startswith(said[stage].zh) for step in desk.board.steps):
            desk.board.step(said[stage], stage.view)  # by centres and by a polygon alike it is tried once
        _draw_stage(desk, problem, stage, groups)
    return desk


def _mass_centres(problem: Problem) -> frozenset[str]:
    """The letters of the centres of mass that are given, for forces, a machine or its balance."""
    return frozenset(mass.centre for mass in problem.acting.masses) if problem.acting is not None else frozenset()


def _draw_stage(desk: Desk, problem: Problem, stage: Stage, groups: tuple[Group, ...]) -> None:
    """One pass, by the planner of its own where it has one."""
    if stage is Stage.CENTRES:
        from .centres.plan import centre_pass

        centre_pass(desk, problem, groups)
    elif stage is Stage.CURVATURE:
        from .curvature.plan import curvature_pass

        curvature_pass(desk, problem, groups)
    elif stage is Stage.PRESSURE:
        from .pressure.plan import pressure_pass

        pressure_pass(desk, problem)
    elif stage is Stage.FORCE:
        from .forces.plan import force_pass
        from .machine.constant import draw_constant

        before = set(desk.board.readings)
        force_pass(desk, problem)
        draw_constant(desk, problem)
        desk.forces = tuple(key for key in desk.board.readings if key not in before)
    elif stage is Stage.MACHINE:
        from .machine.plan import machine_pass

        machine_pass(desk, problem, groups)
    elif stage is Stage.BALANCE:
        from .balance.plan import balance_pass

        balance_pass(desk, problem)
    else:
        _pass(desk, problem, stage, groups)
        if stage is Stage.POSITION and problem.target is not None:
            from .kinematics.diagram.target import draw_target

            draw_target(desk, problem.target)


def _pass(desk: Desk, problem: Problem, stage: Stage, groups: Iterable[Group]) -> None:
    held = [drive for drive in desk.mech.drives if not drive.between]
    position = stage is Stage.POSITION
    if not held and position:
        say_fixed_points(desk)
    if position and desk.mech.welded:
        say_welded(desk)
    for drive in held:
        draw_drive(desk, stage, drive)
    if position:
        on_lines = {stepped_off(desk, drive) for drive in held if not drive.slide}
        _further_points(desk, tuple(drive.link for drive in held), on_lines)
        draw_frame(desk)
        draw_links(desk, tuple(drive.link for drive in held))
    else:
        view = stage.view
        desk.board.plot(view, 0j, POLE[view], Dot.POLE)
    for group in groups:
        say_replaced(desk, stage, group)
        draw_group(desk, stage, group)
        if position:
            letter_contacts(desk, group.links)
            _further_points(
                desk,
                group.links,
                {
                    letter
                    for letter in (getattr(j, "point", "") for j in (*group.inner, *(o.joint for o in group.outer)))
                    if letter
                },
            )
            draw_links(desk, group.links)
    if position:
        number_guide(desk)
        draw_drive_arrow(desk)
    else:
        draw_wanted(desk, problem.asks, stage.view)


def _further_points(desk: Desk, links: tuple[str, ...], found: Collection[str] = ()) -> None:
    """Say that the other lettered points of these links are set out too; `found`: the pins of their group."""
    parts: list[tuple[str, list[str]]] = []
    for name in links:
        link = desk.mech.link(name)
        placed = [p.point for p in link.placements]
        if set(placed) & set(found):  # a pin was given on a longer bar, whose other end follows
            placed += [p for p in link.points if p not in (*placed, *found, *desk.mech.frame)]
        points = [subscripted(p) for p in placed if p not in (*found, told_point(desk, name))]
        parts += [(name, points)] if points else []
    if parts:
        zh = "、".join(f"构件 {name} 上的 ${'$、$'.join(points)}$" for name, points in parts)
        en = ", ".join(f"${'$, $'.join(points)}$ of link {name}" for name, points in parts)
        desk.board.remark(Words(f"按已知尺寸定出{zh}。", f" Set out {en} from the given lengths."))
