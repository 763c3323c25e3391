"""Groups of class III and higher, and those of gears, as chains of links reached from known ones;
the joints left over close the loops."""

from __future__ import annotations

from cmath import phase
from collections.abc import Iterator
from dataclasses import dataclass, field

from ...errors import NoMethodError
from ...mechanism.groups.assur import Group, ends, holders
from ...mechanism.model import Circle, Joint, Prismatic, Revolute, Rolling
from ...words import Words
from ..drive import drive_symbols, given_angles
from ..equations import Equation
from ..expr import ZERO, Expr, Var
from ..stages import Arm
from ..track import lettered, track
from ..variables import Scope, both
from .rolled import distance, line_of_centres, pitch_line, rolled


@dataclass(slots=True)
class Chains:
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
    centred: set[Rolling] = field(default_factory=set)  # gears of which the line of centres told the place

    @property
    def geared(self) -> bool:
        """Whether gears roll in the group."""
        return any(isinstance(joint, Rolling) for joint in self._joints())

    def _joints(self) -> list[Joint]:
        return [*(out.joint for out in self.group.outer), *self.group.inner]

    def grow(self) -> list[Joint]:
        """Reach all links; slides and a motor's hinge are gone along first, so that none is left to close a loop.

        Gives the closing joints.
        """
        joints, driven = self._joints(), self.scope.mech.drive.pair
        rest = sorted(joints, key=lambda joint: isinstance(joint, Revolute) and set(ends(joint)) != driven)
        while len(self.placed) < len(self.group.links):
            near = [joint for joint in rest if self._leads_on(joint)]
            if not near:
                break
            joint = min(near, key=lambda one: (isinstance(one, Rolling), self._against_the_drive(one)))
            rest.remove(joint)
            self._reach(joint)
        rest += self.centred
        if len(self.placed) < len(self.group.links) or any(isinstance(joint, Prismatic) for joint in rest):
            raise NoMethodError(
                Words(
                    f"没有{self.group.name.zh}的数学模型：其封闭环应由转动副闭合",
                    f"no mathematical model on file for a {self.group.name.en}: its loops must close in hinges",
                )
            )
        return rest

    def _leads_on(self, joint: Joint) -> bool:
        """Whether it leads from a link that is reached to one that is not; of a rolling pair, to the gear."""
        far = set(ends(joint)) & self._open()
        gears = {joint.gear.link} if isinstance(joint, Rolling) else far
        return len(far) == 1 and far <= gears

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
            self._roll(joint)
        self.placed.append(link)

    def _roll(self, joint: Rolling) -> None:
        """A gear that nothing but its partner reaches: the line of centres, or the rack, leads to its centre."""
        scope, gear, on = self.scope, joint.gear, joint.on
        scope.anchors[gear.link] = gear.centre
        phi = scope.phi(gear.link)
        self._unknown(phi, scope.omega(gear.link), Var(f"α_{{{scope.name(gear.link)}}}"), scope.turned[gear.link])
        if isinstance(on, Circle):
            self.locate(on.link, on.centre)
            arm = self._centres(joint, on)
            rows = arm.tip(scope), arm.tip_velocity(scope, gear.centre), arm.tip_acceleration(scope, gear.centre)
        else:
            line = pitch_line(scope, joint, on)
            self.locate(on.link, line.base)
            gap = scope.at[gear.centre] - self._at(line.base)
            self._unknown(line.travel, line.speed, line.push, (gap * line.along.conjugate()).real)
            rows = line.point(scope), line.velocity(scope, gear.centre), line.acceleration(scope, gear.centre)
        scope.done.add(gear.centre)
        self.centred.add(joint)
        for said, left, right in zip(
            (self.places, self.speeds, self.pushes),
            (scope.xy(gear.centre), scope.v(gear.centre), scope.a(gear.centre)),
            rows,
            strict=True,
        ):
            said += both(left, right)

    def _centres(self, joint: Rolling, on: Circle) -> Arm:
        """The line from the partner's centre to the gear's as an arm, its angle unknown."""
        arm = Arm(name=joint.point, outer=on.centre, length=distance(joint))
        start = phase(self._at(joint.gear.centre) - self._at(on.centre))
        self._unknown(Var(line_of_centres(joint)), arm.rate, arm.bend, start)
        return arm

    def _at(self, letter: str) -> complex:
        """The place of a letter at the given position."""
        return self.scope.at[letter] if letter in self.scope.at else self.scope.mech.frame[letter]

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
        known = {*self.scope.done, *mech.frame}
        letter, local = min(points, key=lambda point: point[0] in known)  # one whose place is not told yet
        path, turning = track(self.scope, joint, link, local)
        self.locate(parent, path.base)
        base = self._at(path.base)
        if {link, parent} != mech.drive.pair:  # of a cylinder it is given
            self._unknown(
                path.travel, path.speed, path.push, ((self.scope.at[letter] - base) * path.along.conjugate()).real
            )
        self.scope.anchors[link] = letter
        self.places += turning.position
        self.speeds += turning.velocity
        self.pushes += turning.acceleration
        if letter in known:
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
            if isinstance(joint, Rolling):
                yield from self._rolls(joint)
                continue
            assert isinstance(joint, Revolute)
            one, two = self._seen(joint.a, joint.point), self._seen(joint.b, joint.point)
            left, right = (two, one) if joint.a not in self.group.links else (one, two)
            if left != right:
                yield from zip(left, right, strict=True)
            self.locate(joint.a if joint.a in self.group.links else joint.b, joint.point)

    def _rolls(self, joint: Rolling) -> Iterator[tuple[Expr, Expr]]:
        """What pure rolling says, its letters located first."""
        self.locate(joint.gear.link, joint.gear.centre)
        if isinstance(joint.on, Circle):
            self.locate(joint.on.link, joint.on.centre)
            if joint not in self.centred and not holders(self.scope.mech, joint):
                self._centres(joint, joint.on)
        else:
            self.locate(joint.on.link, pitch_line(self.scope, joint, joint.on).base)
        conditions = [*rolled(self.scope, joint, self._given)]
        yield from conditions[-1:] if joint in self.centred else conditions

    def _given(self, angle: Expr) -> float:
        """The value of an angle at the given position: what the loops start from, with what they tell of it."""
        env = given_angles(self.scope) | self.unknowns
        for equation in self.places:
            if isinstance(equation.left, Var) and equation.left.symbol.startswith("φ"):
                env[equation.left.symbol] = float(equation.right.value(env))
        return float(angle.value(env))

    def _seen(self, link: str, letter: str) -> tuple[Expr, Expr]:
        """The letter's place as this link has it."""
        if link not in self.group.links or self.scope.anchors[link] == letter:
            return self.scope.xy(letter)
        return self.scope.place(link, self.scope.anchors[link], letter)
