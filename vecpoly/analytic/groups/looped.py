"""Groups of class III and higher: no closed form;
vector loops with the unknown angles and travels, their Jacobian, and Newton's method."""

from __future__ import annotations

from collections.abc import Iterator

from ...mechanism.groups.assur import Group
from ...mechanism.model import Rack, Rolling
from ...words import Words
from ..calculus import substituted
from ..drive import drive_symbols
from ..equations import Equation, GroupModel, Part, Stage
from ..expr import Expr, Var
from ..newton import Loops
from ..points import points
from ..stages import ACCELERATION, POSITION, VELOCITY
from ..variables import Scope
from .chains import Chains
from .linear import is_linear, linear

DETERMINANT = "Δ_{J}"
_FEW = 3  # right sides that are all named
_NEWTON = Words(
    "用牛顿—拉弗森法求解：以邻近位置的解为初值，反复解 $J Δq = −f$，$q ← q + Δq$，直到 $f$ 足够小；"
    "题设位置的初值由题目给出的大致位置确定。雅可比矩阵 $J = ∂f/∂q$ 列于下表。",
    "They are solved by Newton's method: from the solution at the neighbouring position, $J Δq = "
    "−f$ and $q ← q + Δq$ are repeated until $f$ is small enough. The Jacobian $J = ∂f/∂q$ is "
    "given below.",
)


def looped(scope: Scope, group: Group) -> GroupModel:
    """Loop equations, Jacobian, linear equations of the rates.
    Raises NoMethodError where loops close in slides."""
    chains = Chains(scope, group)
    conditions = list(chains.closing(chains.grow()))
    loops = _loops(scope, chains, conditions)
    if chains.geared and is_linear(loops):
        return linear(scope, group, chains, loops, conditions)
    names = [scope.name(link) for link in group.links]
    more = points(scope, group.links)
    stages = [
        _position(loops, chains, conditions, chains.geared),
        _rates(loops, VELOCITY, "b", loops.velocity_sides, 0, chains.speeds),
        _rates(loops, ACCELERATION, "c", loops.acceleration_sides, 1, chains.pushes),
    ]
    joined = tuple(Stage(stage.title, stage.parts + (more[i].parts if more else ())) for i, stage in enumerate(stages))
    title, opening = _named(group, names)
    return GroupModel(
        title=title,
        links=group.links,
        stages=joined,
        opening=opening,
        determinant=Var(DETERMINANT),
        loops=loops,
        singular=Words(
            f"雅可比行列式 ${DETERMINANT}$ = det $J$ 为零时杆组处于奇异位置，各速度、加速度无确定解；"
            "接近该位置时方程组病态，牛顿法也难以收敛。",
            f"Where ${DETERMINANT}$ = det $J$ vanishes, the group is singular and its velocities are "
            "not determined; near there the equations are ill-conditioned, and Newton's method "
            "does not converge.",
        ),
    )


def _loops(scope: Scope, chains: Chains, conditions: list[tuple[Expr, Expr]]) -> Loops:
    """The conditions with the points on the way eliminated."""
    chains.unknowns = dict(sorted(chains.unknowns.items()))
    told = {e.left.symbol: e.right for e in chains.places if isinstance(e.left, Var)}
    gaps = tuple(substituted(left - right, told) for left, right in conditions)
    return Loops(
        conditions=gaps,
        unknowns=tuple(chains.unknowns),
        rates=chains.rates | dict(_known(scope)),
        start=tuple(chains.unknowns.values()),
        name=DETERMINANT,
    )


def _named(group: Group, names: list[str]) -> tuple[Words, Words]:
    """Title and first sentence of the group."""
    listed, listed_en, joints = (
        "、".join(names),
        ", ".join(names),
        f"with {len(group.outer)} outer and {len(group.inner)} inner joints",
    )
    if group.kind == "driven" or group.ram is not None:
        return (
            Words(f"含驱动副的杆组（构件 {listed}）", f"The group with the driven pair (links {listed_en})"),
            Words(
                f"驱动副在构件 {listed} 组成的杆组之内，其相对运动已知；该杆组有 {len(group.outer)} 个外接副和"
                f" {len(group.inner)} 个内接副，位置方程联立求解。",
                "The driven pair, whose relative motion is known, is inside the group of links "
                f"{listed_en} {joints}; the position equations are solved together.",
            ),
        )
    if any(isinstance(joint, Rolling) for joint in (*group.inner, *(out.joint for out in group.outer))):
        return _geared(group, names, racks=_racks(group))
    roman = group.kind.removeprefix("class ")
    zh = {"III": "Ⅲ", "IV": "Ⅳ"}.get(roman, roman)
    return (
        Words(f"{zh} 级杆组（构件 {listed}）", f"Class {roman} group (links {listed_en})"),
        Words(
            f"{zh} 级杆组由构件 {listed} 组成，有 {len(group.outer)} 个外接副和 {len(group.inner)} 个内接副，"
            "不能拆成 Ⅱ 级杆组，位置方程没有封闭解，只能联立求解。",
            f"The class {roman} group consists of links {listed_en} {joints}. It cannot be taken "
            "apart into dyads: its position equations have no closed solution and are solved "
            "together.",
        ),
    )


def _racks(group: Group) -> bool:
    """Whether any of what rolls is a rack."""
    every = (*group.inner, *(out.joint for out in group.outer))
    return any(isinstance(joint.on, Rack) for joint in every if isinstance(joint, Rolling))


def _geared(group: Group, names: list[str], *, racks: bool) -> tuple[Words, Words]:
    """Of gears and racks: what they have rolled is one equation among those of the loops."""
    listed, listed_en = "、".join(names), ", ".join(names)
    noun = "links" if len(names) > 1 else "link"
    return (
        Words(
            f"齿轮{'齿条' if racks else ''}传动的杆组（构件 {listed}）",
            f"The group of {'gear and rack' if racks else 'gears'} ({noun} {listed_en})",
        ),
        Words(
            f"该杆组由构件 {listed} 组成，其中有纯滚动。节点处速度恒相同，故自题设位置起两轮滚过的弧长相等"
            f"{'（齿条则为移动的距离）' if racks else ''}；各节点的常数 $θ$ 由题设位置定出，转角以弧度计，不跳变整周。"
            "这些关系与封闭矢量方程联立求解。",
            f"Gears roll in the group of {noun} {listed_en}. Both bodies always have one velocity at the pitch point, "
            f"so they have rolled equal arcs since the given position{' (a rack: lengths)' if racks else ''}. "
            "That position fixes the "
            "constant $θ$ of each pitch point; angles are in radians, counted continuously, without jumps of whole "
            "turns. These relations and the vector loops are solved together.",
        ),
    )


def _known(scope: Scope) -> Iterator[tuple[str, tuple[Expr, Expr]]]:
    """The rates of everything that may be known: the drive, letters' coordinates, and angles of links."""
    place, rate, bend = drive_symbols(scope)
    if scope.mech.drive.between:
        yield place, (Var(rate), Var(bend))
    for letter in {p for link in scope.mech.links for p in link.points}:
        at = scope.xy(letter)
        yield from (
            (p.symbol, (v, a))
            for p, v, a in zip(at, scope.v(letter), scope.a(letter), strict=True)
            if isinstance(p, Var)
        )
    for link in scope.mech.links:
        if isinstance(phi := scope.phi(link.name), Var):
            yield phi.symbol, (scope.omega(link.name), scope.alpha(link.name))


def _position(loops: Loops, chains: Chains, conditions: list[tuple[Expr, Expr]], geared: bool) -> Stage:
    places = (_reached(loops, chains),) if chains.places else ()
    return Stage(POSITION, (*places, *_closed(loops, conditions, geared), Part(_NEWTON)))


def _reached(loops: Loops, chains: Chains) -> Part:
    """The points on the way from the known ones."""
    listed = [f"${q}$" for q in loops.unknowns]
    return Part(
        Words(
            f"取 {'、'.join(listed)} 为未知量。由外接副和已知点出发，沿各构件有",
            f"The unknowns are {', '.join(listed)}. Along the links, from the known points,",
        ),
        tuple(chains.places),
    )


def _closed(loops: Loops, conditions: list[tuple[Expr, Expr]], geared: bool) -> tuple[Part, Part]:
    """The loops closed, and the equations that are left when the points on the way are eliminated."""
    count = len(conditions)
    closing = Words(
        f"在其余转动副处封闭，得 {count // 2} 个封闭矢量方程，其投影为",
        f"The remaining revolutes close {count // 2} vector loops, whose projections are",
    )
    rolling = Words("由其余运动副的封闭条件和纯滚动条件得", "The remaining joints close, and the gears roll:")
    return (
        Part(rolling if geared else closing, tuple(Equation(left, right, False) for left, right in conditions)),
        Part(
            Words(
                f"消去中间点的坐标并移项，得 {count} 个方程 $f_i = 0$，含 {count} 个未知量：",
                f"With the points on the way eliminated these are {count} equations $f_i = 0$ with {count} unknowns:",
            ),
            tuple(Equation(Var(f"f_{{{i}}}"), gap) for i, gap in enumerate(loops.conditions, 1)),
        ),
    )


def _listed(letter: str, count: int) -> Words:
    """b_1, b_2; of many the first, dots, the last."""
    names = [f"${letter}_{i}$" for i in (range(1, count + 1) if count <= _FEW else (1, count))]
    if count > _FEW:
        names.insert(1, "…")
    return Words("，".join(names), ", ".join(names))


def _rates(loops: Loops, title: Words, letter: str, sides: tuple[Expr, ...], order: int, more: list[Equation]) -> Stage:
    symbols = [rate.symbol for name in loops.unknowns if isinstance(rate := loops.rates[name][order], Var)]
    column = ", ".join(f"${s}$" for s in symbols)
    start = (
        Words("将 $f_i = 0$ 对时间求导", "Differentiating $f_i = 0$ with respect to time")
        if not order
        else Words("再求导一次", "Differentiating once more")
    )
    said = Words(
        f"{start.zh}，得线性方程组 $J$ ({column.replace(', ', '，')})ᵀ = ({_listed(letter, len(sides)).zh})ᵀ，"
        "系数矩阵与位置方程相同，右端为",
        f"{start.en} gives linear equations with the same matrix, $J$ ({column})ᵀ = "
        f"({_listed(letter, len(sides)).en})ᵀ, with the right sides",
    )
    equations = tuple(Equation(Var(f"{letter}_{{{i}}}"), side) for i, side in enumerate(sides, 1))
    rest = (Part(Words("由此得", "hence"), tuple(more)),) if more else ()
    return Stage(title, (Part(said, equations), *rest))
