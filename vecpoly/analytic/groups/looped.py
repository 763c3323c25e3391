"""Groups of class III and higher: no closed form; vector loops with the unknown angles and travels, their Jacobian, and
Newton's method."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from ...errors import NoMethodError
from ...mechanism.groups.assur import Group, ends
from ...mechanism.model import Joint, Prismatic, Revolute
from ...words import Words
from ..calculus import substituted
from ..drive import drive_symbols
from ..equations import Equation, GroupModel, Part, Stage
from ..expr import ZERO, Expr, Var
from ..newton import Loops
from ..points import points
from ..stages import ACCELERATION, POSITION, VELOCITY
from ..track import lettered, track
from ..variables import Scope, both

DETERMINANT = "Δ_{J}"


@dataclass(slots=True)
class _Chains:
    """Every link of the group reached from a known one; the joints left over close the loops."""

    scope: Scope
    group: Group
    placed: list[str] = field(default_factory=list)
    unknowns: dict[str, float] = field(default_factory=dict)
    rates: dict[str, tuple[Expr, Expr]] = field(default_factory=dict)
    places: list[Equation] = field(default_factory=list)  # of the letters on the way
    speeds: list[Equation] = field(default_factory=list)
    pushes: list[Equation] = field(default_factory=list)
    closed: list[tuple[Expr, Expr]] = field(default_factory=list)  # conditions met on the way

    def grow(self) -> list[Joint]:
        """Reach all links; slides and a motor's hinge are gone along first, so that none is left to close a loop.

        Gives the closing joints.
        """
        joints, driven = [*(out.joint for out in self.group.outer), *self.group.inner], self.scope.mech.drive.pair
        rest = sorted(joints, key=lambda joint: isinstance(joint, Revolute) and set(ends(joint)) != driven)
        while len(self.placed) < len(self.group.links):
            near = [
                joint for joint in rest if len(set(ends(joint)) & self._open()) == 1 and set(ends(joint)) - self._open()
            ]
            if not near:
                break
            joint = min(near, key=self._against_the_drive)
            rest.remove(joint)
            self._reach(joint)
        if len(self.placed) < len(self.group.links) or not all(isinstance(joint, Revolute) for joint in rest):
            raise NoMethodError(
                Words(
                    f"没有{self.group.name.zh}的数学模型：其封闭环应由转动副闭合",
                    f"no mathematical model on file for a {self.group.name.en}: its loops must close in hinges",
                )
            )
        return rest

    def _against_the_drive(self, joint: Joint) -> bool:
        """Whether the given motion of a driven slide would be that of the link from which it is reached."""
        drive = self.scope.mech.drive
        return isinstance(joint, Prismatic) and set(ends(joint)) == drive.pair and drive.link not in self._open()

    def _open(self) -> set[str]:
        """Links of the group that are not reached yet."""
        return set(self.group.links) - set(self.placed)

    def _reach(self, joint: Joint) -> None:
        link = next(end for end in ends(joint) if end in self._open())
        parent = next(end for end in ends(joint) if end != link)
        if isinstance(joint, Revolute):
            self.locate(parent, joint.point)
            self.scope.anchors[link] = joint.point
            if not self._turned(link, parent):
                self._unknown(
                    self.scope.phi(link),
                    self.scope.omega(link),
                    Var(f"α_{{{self.scope.name(link)}}}"),
                    self.scope.turned[link],
                )
        elif isinstance(joint, Prismatic):
            self._slide(joint, link)
        else:
            raise NoMethodError(
                Words(
                    f"没有{self.group.name.zh}的数学模型：其中有齿轮滚动",
                    f"no mathematical model on file for a {self.group.name.en}: gears roll in it",
                )
            )
        self.placed.append(link)

    def _turned(self, link: str, parent: str) -> bool:
        """Whether a motor in the hinge gives the angle between the two links; then the equations that say so."""
        scope, drive = self.scope, self.scope.mech.drive
        if {link, parent} != drive.pair or drive.slide:
            return False
        sign = 1.0 if link == drive.link else -1.0
        angle, rate, bend = (Var(symbol) if sign > 0 else ZERO - Var(symbol) for symbol in drive_symbols(scope))
        self.places.append(Equation(scope.phi(link), scope.phi(parent) + angle))
        self.speeds.append(Equation(scope.omega(link), scope.omega(parent) + rate))
        self.pushes.append(Equation(scope.alpha(link), scope.alpha(parent) + bend))
        return True

    def _unknown(self, what: Expr, rate: Expr, bend: Expr, start: float) -> None:
        assert isinstance(what, Var)
        self.unknowns[what.symbol] = start
        self.rates[what.symbol] = rate, bend

    def _slide(self, joint: Prismatic, link: str) -> None:
        """The link keeps its angle to the other; its place along the guide is unknown."""
        mech, parent = self.scope.mech, next(end for end in ends(joint) if end != link)
        points = lettered(self.scope, link).items()
        letter, local = min(points, key=lambda point: point[0] in self.scope.done)  # one whose place is not told yet
        path, turning = track(self.scope, joint, link, local)
        self.locate(parent, path.base)
        base = self.scope.at[path.base] if path.base in self.scope.at else mech.frame[path.base]
        if {link, parent} != mech.drive.pair:  # of a cylinder it is given
            self._unknown(
                path.travel, path.speed, path.push, ((self.scope.at[letter] - base) * path.along.conjugate()).real
            )
        self.scope.anchors[link] = letter
        self.places += turning.position
        self.speeds += turning.velocity
        self.pushes += turning.acceleration
        if letter in self.scope.done:
            self.closed += zip(self.scope.xy(letter), path.point(self.scope), strict=True)
            return
        self.scope.done.add(letter)
        self.places += both(self.scope.xy(letter), path.point(self.scope))
        self.speeds += both(self.scope.v(letter), path.velocity(self.scope, letter))
        self.pushes += both(self.scope.a(letter), path.acceleration(self.scope, letter))

    def locate(self, link: str, letter: str) -> None:
        """The letter's coordinates and rates from the link's anchor, where they are not told yet."""
        scope = self.scope
        if link not in self.group.links or letter in scope.done or letter in scope.mech.frame:
            return
        scope.done.add(letter)
        start = scope.anchors[link]
        self.places += both(scope.xy(letter), scope.place(link, start, letter))
        self.speeds += both(scope.v(letter), scope.velocity(link, start, letter))
        self.pushes += both(scope.a(letter), scope.acceleration(link, start, letter))

    def closing(self, joints: list[Joint]) -> Iterator[tuple[Expr, Expr]]:
        """Both sides of the scalar conditions of these hinges, and of those met on the way.

        A hinge between two links that are both anchored in it says nothing.
        """
        yield from self.closed
        for joint in joints:
            assert isinstance(joint, Revolute)
            one, two = self._seen(joint.a, joint.point), self._seen(joint.b, joint.point)
            left, right = (two, one) if joint.a not in self.group.links else (one, two)
            if left != right:
                yield from zip(left, right, strict=True)
            self.locate(joint.a if joint.a in self.group.links else joint.b, joint.point)

    def _seen(self, link: str, letter: str) -> tuple[Expr, Expr]:
        """The letter's place as this link has it."""
        if link not in self.group.links or self.scope.anchors[link] == letter:
            return self.scope.xy(letter)
        return self.scope.place(link, self.scope.anchors[link], letter)


def looped(scope: Scope, group: Group) -> GroupModel:
    """Loop equations, Jacobian, linear equations of the rates. Raises NoMethodError where gears roll, or loops close in
    slides."""
    chains = _Chains(scope, group)
    conditions = list(chains.closing(chains.grow()))
    chains.unknowns = dict(sorted(chains.unknowns.items()))
    told = {e.left.symbol: e.right for e in chains.places if isinstance(e.left, Var)}
    gaps = tuple(substituted(left - right, told) for left, right in conditions)
    loops = Loops(
        conditions=gaps,
        unknowns=tuple(chains.unknowns),
        rates=chains.rates | dict(_known(scope)),
        start=tuple(chains.unknowns.values()),
        name=DETERMINANT,
    )
    names = [scope.name(link) for link in group.links]
    more = points(scope, group.links)
    stages = [
        _position(loops, chains, conditions),
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
            f"Where ${DETERMINANT}$ = det $J$ vanishes the group is singular and its rates are "
            "not determined; near there the equations are ill-conditioned, and Newton's method "
            "fails to settle.",
        ),
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
                f"驱动副在构件 {listed} 组成的杆组之内，其相对运动已知；该杆组有 {len(group.outer)} 个外副和"
                f" {len(group.inner)} 个内副，位置方程联立求解。",
                "The driven pair, whose relative motion is known, is inside the group of links "
                f"{listed_en} {joints}; the position equations are solved together.",
            ),
        )
    roman = group.kind.removeprefix("class ")
    zh = {"III": "Ⅲ", "IV": "Ⅳ"}.get(roman, roman)
    return (
        Words(f"{zh} 级杆组（构件 {listed}）", f"Class {roman} group (links {listed_en})"),
        Words(
            f"{zh} 级杆组由构件 {listed} 组成，有 {len(group.outer)} 个外副和 {len(group.inner)} 个内副，"
            "不能拆成 Ⅱ 级杆组，位置方程没有封闭解，只能联立求解。",
            f"The class {roman} group consists of links {listed_en} {joints}. It cannot be taken "
            "apart into dyads: its position equations have no closed solution and are solved "
            "together.",
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


def _position(loops: Loops, chains: _Chains, conditions: list[tuple[Expr, Expr]]) -> Stage:
    listed = "、".join(f"${q}$" for q in loops.unknowns), ", ".join(f"${q}$" for q in loops.unknowns)
    count = len(conditions)
    parts = (
        [
            Part(
                Words(
                    f"取 {listed[0]} 为未知量。由外副和已知点出发，沿各构件有",
                    f"The unknowns are {listed[1]}. Along the links, from the known points,",
                ),
                tuple(chains.places),
            )
        ]
        if chains.places
        else []
    )
    closed = tuple(Equation(Var(f"f_{{{i}}}"), gap) for i, gap in enumerate(loops.conditions, 1))
    return Stage(
        POSITION,
        (
            *parts,
            Part(
                Words(
                    f"在其余转动副处封闭，得 {count // 2} 个封闭矢量方程，其投影为",
                    f"The remaining hinges close {count // 2} vector loops, whose projections are",
                ),
                tuple(Equation(left, right, False) for left, right in conditions),
            ),
            Part(
                Words(
                    f"消去中间点的坐标并移项，得 {count} 个方程 $f_i = 0$，含 {count} 个未知量：",
                    f"With the points on the way eliminated these are {count} equations $f_i = 0$ with "
                    f"{count} unknowns:",
                ),
                closed,
            ),
            Part(
                Words(
                    "用牛顿—拉弗森法求解：以邻近位置的解为初值，反复解 $J Δq = −f$，$q ← q + Δq$，直到 $f$ 足够小；"
                    "题设位置的初值由题目给出的大致位置确定。雅可比矩阵 $J = ∂f/∂q$ 列于下表。",
                    "They are solved by Newton's method: from the solution at the neighbouring position, $J Δq = "
                    "−f$ and $q ← q + Δq$ are repeated until $f$ is small enough. The Jacobian $J = ∂f/∂q$ is "
                    "given below.",
                )
            ),
        ),
    )


def _rates(loops: Loops, title: Words, letter: str, sides: tuple[Expr, ...], order: int, more: list[Equation]) -> Stage:
    symbols = [rate.symbol for name in loops.unknowns if isinstance(rate := loops.rates[name][order], Var)]
    column = ", ".join(f"${s}$" for s in symbols)
    start = (
        Words("将 $f_i = 0$ 对时间求导", "Differentiating $f_i = 0$ with respect to time")
        if not order
        else Words("再求导一次", "Differentiating once more")
    )
    said = Words(
        f"{start.zh}，得线性方程组 $J$ ({column.replace(', ', '，')})ᵀ = (${letter}_1$，…，"
        f"${letter}_{len(sides)}$)ᵀ，系数矩阵与位置方程相同，右端为",
        f"{start.en} gives linear equations with the same matrix, $J$ ({column})ᵀ = (${letter}_1$, "
        f"…, ${letter}_{len(sides)}$)ᵀ, with the right sides",
    )
    equations = tuple(Equation(Var(f"{letter}_{{{i}}}"), side) for i, side in enumerate(sides, 1))
    rest = (Part(Words("从而", "and then"), tuple(more)),) if more else ()
    return Stage(title, (Part(said, equations), *rest))
