"""From a problem to its construction: the groups in order, each with its textbook methods; scales chosen from a sketch.

The sketch is the same construction by an exact hand at provisional scales; only the size of its figures is used, to choose
round scales with which every figure fills its place on the sheet.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import replace

import numpy as np

from ..board.amended import AS_DRAWN, Amended
from ..board.board import Board
from ..board.construction import Construction, Reading, Scale, View
from ..board.extent import extent, figured
from ..board.hand import Hand, hand
from ..board.marks import Dot, Mark, Vector
from ..board.scales import Sketched, enlarged, round_scale
from ..mechanism.assur import Group, decompose
from ..names import subscripted
from ..problem.asks import AskNamed
from ..problem.problem import Problem
from ..words import Words
from .answers import Repeats, answer, named_answer
from .coincident import coincident_letters
from .desk import POLE, Desk
from .drawn import Drawn, motion_of
from .exchange import exchanged
from .higher import refuse_higher
from .kinematics.cam import letter_contacts, say_replaced
from .kinematics.diagram import draw_frame, draw_links
from .kinematics.drive_arrow import draw_drive_arrow
from .kinematics.position_drive import say_fixed_points, say_welded
from .kinematics.standing import told_point
from .kinematics.wanted import draw_wanted
from .passes import stages
from .registry import Stage, find

TITLES = {
    View.MECHANISM: Words("机构运动简图", "Kinematic diagram"),
    View.VELOCITY: Words("速度多边形", "Velocity polygon"),
    View.ACCELERATION: Words("加速度多边形", "Acceleration polygon"),
    View.BODY: Words("构件受力图", "Free body"),
    View.FORCE: Words("力多边形", "Force polygon"),
}
SECTIONS = {
    Stage.POSITION: Words("作机构位置图", "Position diagram"),
    Stage.CENTRES: Words("瞬心法", "Instant centres"),
    Stage.VELOCITY: Words("速度分析", "Velocity analysis"),
    Stage.ACCELERATION: Words("加速度分析", "Acceleration analysis"),
    Stage.FORCE: Words("力分析", "Force analysis"),
}
_UNIT = {View.MECHANISM: ("μ_l", "m"), View.BODY: ("μ_l", "m"), View.FORCE: ("μ_F", "N"), View.VELOCITY: ("μ_v", "m/s"), View.ACCELERATION: ("μ_a", "m/s^2")}
FAR = 2.0  # a scale that comes out so much finer than guessed is guessed again
SPECK = 1e-6  # mm: a force polygon of less is rounding; nothing acts there
Fit = Callable[[list[tuple[float, float]]], bool]
WIDE, LARGE = 165.0, 105.0  # mm: no diagram, no polygon need be larger
NOTHING: Mapping[Stage, Words] = {}
SLOT = (150.0, 100.0)  # mm, where the sheet names no place for a figure


def construct(problem: Problem, by: Hand, slots: Mapping[View, tuple[float, float]], fit: Fit | None = None, amended: Amended = AS_DRAWN) -> Drawn:
    """Solve the problem on a board.

    slots: width and height in mm that each figure should fill. fit: whether figures of these sizes go on one sheet; they are drawn
    as large as it allows. amended: what is done otherwise than this hand would; the ideal hand, and the choice of scales, know nothing of it.
    Raises AssemblyError, DeadPointError, NoMethodError.
    """
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):  # a repeated hand may miss a grazing meeting: NaN
        exchange = exchanged(problem.mechanism, stages(problem))
        problem = replace(problem, subject=exchange.mech)
        scales, sketch = _choose_scales(problem, slots, fit)
        desk = _draw(problem, by, scales, exchange.said, amended)
        readings, repeats = _answers(desk, problem)
        plain = sketch or _draw(problem, hand("exact"), scales)
        ideal, _ = _answers(plain, problem)
    construction = Construction(problem=problem.id, hand=by.name, figures=desk.board.figures(TITLES),
                                steps=tuple(desk.board.steps), acts=tuple(desk.board.acts), readings=readings, forces={key: desk.board.readings[key] for key in desk.forces})
    return Drawn(construction, repeats, ideal, motion_of(plain))


def drawn_exactly(problem: Problem, scales: Mapping[View, Scale], *, recorded: bool = False) -> Desk:
    """The drawing by an exact hand at these scales; recorded: the numbers of its acts know how they follow from the position of the driving link."""
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        desk = _draw(problem, hand("exact"), scales, recorded=recorded)
        _answers(desk, problem)
    return desk


def scale_symbols() -> dict[View, Scale]:
    """A scale of one for every kind of figure."""
    return {view: _scale(view, 1.0) for view in View}


def _choose_scales(problem: Problem, slots: Mapping[View, tuple[float, float]], fit: Fit | None) -> tuple[dict[View, Scale], Desk | None]:
    """The scales, and the last sketch drawn to find them; none where all are given."""
    mech, drive = problem.mechanism, problem.mechanism.drive
    size = mech.scale
    speed = abs(drive.rate) * (1.0 if drive.slide else size) or 1.0
    guess = {View.MECHANISM: size / 100, View.VELOCITY: speed / 100,
             View.ACCELERATION: (abs(drive.accel) + drive.rate**2) * (1.0 if drive.slide else size) / 100 or 1.0,
             View.FORCE: _typical_force(problem) / 60, View.BODY: size / 100}
    given = _given_scales(problem)
    if all(given[View(stage.value)] for stage in (Stage.VELOCITY, Stage.ACCELERATION, Stage.FORCE) if stage in stages(problem)) and given[View.MECHANISM]:
        return {view: _scale(view, given[view] or value) for view, value in guess.items()}, None
    chosen, sketch = _fitted(problem, slots, guess, fit)
    while chosen[View.FORCE].value < guess[View.FORCE] / FAR and problem.scales.mu_f is None:  # inertia forces far below the guess: a sketch of specks
        guess |= {View.FORCE: chosen[View.FORCE].value}
        chosen, sketch = _fitted(problem, slots, guess, fit)
    return chosen, sketch


def _typical_force(problem: Problem) -> float:
    """A force of the size of those to be drawn (N); of no matter where nothing acts."""
    if problem.loads is None:
        return 1.0
    from .forces.readings import largest_load

    return largest_load(problem)


def _given_scales(problem: Problem) -> dict[View, float | None]:
    wish = problem.scales
    return {View.MECHANISM: wish.mu_l, View.VELOCITY: wish.mu_v, View.ACCELERATION: wish.mu_a, View.FORCE: wish.mu_f, View.BODY: wish.mu_l}


def _fitted(problem: Problem, slots: Mapping[View, tuple[float, float]], guess: Mapping[View, float], fit: Fit | None) -> tuple[dict[View, Scale], Desk]:
    """Round scales with which the figures of a sketch at these scales would fill their slots, and their sheet; and the sketch."""
    sketch = _draw(problem, hand("exact"), {v: _scale(v, value) for v, value in guess.items()})
    given = _given_scales(problem)
    figures = [f for f in sketch.board.figures(TITLES) if f.view is not View.FORCE or any(isinstance(m, Vector) and abs(m.b - m.a) > SPECK for m in f.marks)]
    chosen = {}
    for view, value in guess.items():
        fitted = max((round_scale(value, extent(f.marks), slots.get(view, SLOT)) for f in figures if f.view is view and not f.name.startswith(("lever", "centre"))), default=value)
        chosen[view] = _scale(view, given[view] or fitted)
    views = {f.view: f for f in figures}
    if fit is not None and len(views) == len(figures):
        sketched = {view: _sketched(view, guess[view], f.marks) for view, f in views.items()}
        fixed = frozenset(view for view in views if given[view])
        values = enlarged(sketched, {view: chosen[view].value for view in views}, fixed, fit)
        chosen |= {view: _scale(view, value) for view, value in values.items()}
    return chosen | {View.BODY: chosen[View.MECHANISM]}, sketch


def _sketched(view: View, scale: float, marks: tuple[Mark, ...]) -> Sketched:
    """What a figure takes at any scale."""
    (w, h), (wide, high) = extent(figured(marks)), extent(marks)
    return Sketched(scale, (w, h), (wide - w, high - h), WIDE if view is View.MECHANISM else LARGE)


def _scale(view: View, value: float) -> Scale:
    symbol, unit_text = _UNIT[view]
    return Scale(symbol=symbol, value=value, unit=unit_text)


def _draw(problem: Problem, by: Hand, scales: Mapping[View, Scale], said: Mapping[Stage, Words] = NOTHING, amended: Amended = AS_DRAWN, *,
          recorded: bool = False) -> Desk:
    mech = problem.mechanism
    groups = decompose(mech)
    refuse_higher(mech, groups)
    desk = Desk(board=Board(by, scales, amended, recorded=recorded), mech=mech, coincident=coincident_letters(mech, groups), loaded=problem.loads is not None, thought=bool(said))
    for name, at in mech.frame.items():
        desk.letter(name, at * desk.mm(1.0))
    for stage in stages(problem):
        desk.board.section(SECTIONS[stage])
        if stage in said:
            desk.board.step(said[stage], View(stage.value) if stage is not Stage.POSITION else View.MECHANISM)
        if stage is Stage.CENTRES:
            from .centres.plan import centre_pass

            centre_pass(desk, problem, groups)
        elif stage is Stage.FORCE:
            from .forces.plan import force_pass

            before = set(desk.board.readings)
            force_pass(desk, problem)
            desk.forces = tuple(key for key in desk.board.readings if key not in before)
        else:
            _pass(desk, problem, stage, groups)
    return desk


def _pass(desk: Desk, problem: Problem, stage: Stage, groups: Iterable[Group]) -> None:
    shapes, held = problem.given.shapes, [drive for drive in desk.mech.drives if not drive.between]
    position = stage is Stage.POSITION
    if not held and position:
        say_fixed_points(desk)
    if position and desk.mech.welded:
        say_welded(desk)
    for drive in held:
        find(stage, "slide" if drive.slide else "crank").draw(desk, drive)
    if position:
        _further_points(desk, tuple(drive.link for drive in held))
        draw_frame(desk, shapes)
        draw_links(desk, shapes, tuple(drive.link for drive in held))
    else:
        view = View(stage.value)
        desk.board.plot(view, 0j, POLE[view], Dot.POLE)
    for group in groups:
        say_replaced(desk, stage, group)
        find(stage, group.kind).draw(desk, group.subject)
        if position:
            letter_contacts(desk, group.links)
            _further_points(desk, group.links, {letter for letter in (getattr(j, "point", "") for j in (*group.inner, *(o.joint for o in group.outer))) if letter})
            draw_links(desk, shapes, group.links)
    if position:
        draw_drive_arrow(desk)
    else:
        draw_wanted(desk, problem.asks, View(stage.value))


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




def _answers(desk: Desk, problem: Problem) -> tuple[dict[str, Reading], Repeats]:
    readings: dict[str, Reading] = {}
    repeats: Repeats = {}
    for ask in problem.asks:
        if isinstance(ask, AskNamed) or ask.rel.key in desk.board.readings:
            reading, scalars = named_answer(desk, ask.rel)
        else:
            reading, scalars = answer(desk, ask.rel)
        readings[reading.key] = reading
        repeats[reading.key] = np.asarray(scalars, dtype=float)
    return readings, repeats
