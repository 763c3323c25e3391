"""What is known of the forces while they are being found: one pass over the links, with friction or without.

Vectors are mm on the force polygon (× μ_F = N), lines of action are in mm on the kinematic diagram. A force `by` → `on`
is known under that pair and, reversed, under the opposite one: R_21 = −R_12.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from ...board.board import Board
from ...board.construction import Pane, Reading, Scale, View
from ...board.paper.marks import Role
from ...foundation.slotted import replace
from ...mechanism.asked.forces import load_named, press_named, without_friction
from ...mechanism.loads import Force, Load, Moment
from ...mechanism.model import Joint, Mechanism, Prismatic, Revolute
from ...names import Named, reaction
from ...plane import Line, Points, Reals, foot, nominal
from ...words import Words
from .acting import Acting, Drawn, summed
from .friction import Rubbing
from .laws.pull import Pull

OFF_SHEET = 300.0  # mm from a joint: a meeting point farther away is on no drawing board


@dataclass(slots=True)
class Statics(Rubbing):
    """One pass. `ideal`: the finished pass without friction; `couples`: pin couples of the last round (N·m)."""

    ideal: Statics | None = None
    acting: dict[tuple[str, str], Acting] = field(default_factory=dict)  # (by, on) of reactions
    inertia: dict[str, list[Acting]] = field(default_factory=dict)  # link → inertia force (displaced by h) and weight
    inertia_couples: dict[str, Reals] = field(default_factory=dict)  # link → couple that no displaced force bears (N·m)
    # (by, on) → friction couple on `on`, where the method wants couples
    couples: dict[tuple[str, str], Reals] = field(default_factory=dict)
    by_moments: set[tuple[str, ...]] = field(default_factory=set)  # links of groups that were solved by moments
    balance: Reals = 0.0  # the balancing load as found (N along its direction, or N·m)
    balanced: bool = False  # whether it was found before the reactions
    rest: Reals = 0.0  # power (W) that the link which closes would still need, where the balancing load is on trial
    leaning: Words | None = None  # the last step that says nothing but how slides' reactions lean
    own: Mechanism | None = None  # the problem's mechanism, where hubs are hung otherwise
    pulls: Mapping[str, Pull] = field(default_factory=dict)  # loads whose size was read off the sheet, by name

    # -- names ------------------------------------------------------------------------------------------------

    @property
    def board(self) -> Board:
        """The sheet."""
        return self.desk.board

    def named(self, by: str, on: str) -> Named:
        """R_12, or R_12,0 in the pass without friction that precedes one with friction."""
        hub = next((one for one in self.hubs if one.hung in (by, on) and {by, on} <= {*one.links, *one.blocks}), None)
        if hub is not None and {by, on} & set(hub.blocks):  # the slot presses on the pin of its carrier
            by, on = (hub.carrier if link == hub.hung else link for link in (by, on))
            hub = None
        name = (
            press_named(self.own or self.mech, by, on)
            if hub is None
            else reaction(*(hub.point if link == hub.hung else self.mech.number(link) for link in (by, on)))
        )
        return without_friction(name) if self.preliminary else name

    @property
    def preliminary(self) -> bool:
        """Whether this is the pass without friction that precedes one with friction:
        on the diagram it is dashed, and its letters have a 0."""
        return bool(self.loads.friction) and not self.rubbing

    def ruled(self, role: Role) -> Role:
        """How a thin line is ruled: dashed in the preliminary pass, which stands beside the one that counts."""
        return Role.IDEAL if self.preliminary else role

    @property
    def without_friction(self) -> Statics:
        """The pass without friction from which this one came."""
        first = self
        while first.ideal is not None:
            first = first.ideal
        return first

    @property
    def unknown(self) -> Load:
        """The balancing load."""
        return self.loads.unknown

    @property
    def unknown_named(self) -> Named:
        """The balancing load's name in this pass: M_1, or M_1,0 without friction."""
        return self.name_of(self.unknown)

    def name_of(self, load: Load) -> Named:
        """A load's name in this pass; only what is found has another one without friction."""
        name = load_named(load)
        return without_friction(name) if self.preliminary and load.size is None else name

    def polygon(self, name: str, title: Words) -> Pane:
        """The force polygon of this name, begun where it is new; one without friction stands apart."""
        zero = Words("不计摩擦时", " without friction")
        return self.board.open_pane(
            View.FORCE,
            f"{name} ideal" if self.preliminary else name,
            Words(zero.zh + title.zh, title.en + zero.en) if self.preliminary else title,
        )

    # -- forces -----------------------------------------------------------------------------------------------

    @property
    def scale(self) -> Scale:
        """μ_F."""
        return self.board.scales[View.FORCE]

    def mm(self, newtons: Reals) -> Reals:
        """A force on paper."""
        return newtons / self.scale.value

    def newton_metres(self, paper: Reals) -> Reals:
        """A moment on paper (mm of force × mm of arm) in N·m."""
        return paper * self.scale.value * self.board.scales[View.MECHANISM].value

    def paper_moment(self, moment: Reals) -> Reals:
        """N·m as mm of force × mm of arm."""
        return moment / (self.scale.value * self.board.scales[View.MECHANISM].value)

    def push(self, by: str, on: str) -> Acting | None:
        """The reaction of `by` on `on`, if found."""
        if (by, on) in self.acting:
            return self.acting[by, on]
        other = self.acting.get((on, by))
        drawn = other.drawn.reversed() if other is not None and other.drawn is not None else None
        return (
            None
            if other is None
            else replace(
                other,
                named=self.named(by, on),
                vector=-other.vector,
                drawn=drawn,
                tangent=-other.tangent,
                couple=-other.couple,
            )
        )

    def pushed_before(self, by: str, on: str) -> Points | None:
        """The reaction's vector in the pass that went before, if there was one."""
        found = None if self.ideal is None else self.ideal.push(by, on)
        return None if found is None else found.vector

    def settle(
        self,
        by: str,
        on: str,
        vector: Points,
        at: Points,
        drawn: Drawn | None = None,
        tangent: int = 0,
        *,
        computed: Reals | None = None,
    ) -> Acting:
        """Keep a reaction as found."""
        if computed is None and drawn is not None and drawn.laid is not None:
            computed = drawn.laid.value
        return self.keep_reaction(
            by,
            on,
            Acting(named=self.named(by, on), vector=vector, at=at, drawn=drawn, tangent=tangent, computed=computed),
        )

    def keep_reaction(self, by: str, on: str, found: Acting) -> Acting:
        """Keep a reaction with all that is known of it."""
        self.acting[by, on] = found
        return found

    def keep(self, reading: Reading, value: Reals, each: Points | None = None) -> None:
        """Keep an answer, as it is read and by every hand; each: of a force its vector (N) by every hand."""
        self.board.keep(reading, value, each)

    def known(self, link: str) -> list[Acting]:
        """All known forces on a link: loads, inertia force, weight, reactions already found."""
        forces = [self._load(load) for load in self.sized(link) if isinstance(load, Force)]
        return [*forces, *self.inertia.get(link, []), *self.reactions(link)]

    def sized(self, link: str) -> list[Load]:
        """The loads on a link whose size is known: given, or found already."""
        return [load for load in self.loads.on(link) if load.size is not None or self.balanced]

    def size_of(self, load: Load) -> Reals:
        """N along the load's direction, or N·m."""
        if load.size is None:
            return self.balance
        return self.pulls[load.name].size if load.name in self.pulls else load.size

    def is_told_signed(self, load: Load) -> bool:
        """Whether the symbol of a load stands for its value with the sign: F = −39.3 N, off a table."""
        return load.name in self.pulls and self.pulls[load.name].is_signed

    def along(self, load: Force) -> Points:
        """The direction of a force (a unit vector)."""
        return self.pulls[load.name].along if load.name in self.pulls else complex(np.exp(1j * load.direction))

    def reactions(self, link: str) -> list[Acting]:
        """The reactions on a link found so far."""
        others = [by if on == link else on for by, on in self.acting if link in (by, on)]
        return [found for other in others if (found := self.push(other, link)) is not None]

    def moment(self, link: str) -> Reals:
        """Sum of the given couples on a link, of those that slides pass on,
        and of the friction couples of its pins (N·m)."""
        parts: list[Reals] = [self.size_of(load) for load in self.sized(link) if isinstance(load, Moment)]
        parts += [
            self.inertia_couples.get(link, 0.0),
            *(f.couple for f in self.reactions(link)),
            *(c for (_, on), c in self.couples.items() if on == link),
        ]
        return summed(parts)

    def loaded(self, link: str) -> bool:
        """Whether anything but the two joints of a group acts on the link: then it is no two-force link."""
        return (
            any(abs(nominal(f.vector)) > 1e-9 for f in self.known(link))
            or bool(self.loads.on(link))
            or bool(np.any(self.moment(link)))
        )

    def _load(self, load: Force) -> Acting:
        vector = self.mm(self.size_of(load)) * self.along(load)
        named = self.name_of(load)
        return Acting(named=named, vector=vector, at=self.desk.at[load.point], size=f"${named.symbol}$")

    def at_joint(self, joint: Joint, line: Line) -> Points:
        """Where a line of action passes a joint:
        nearest to the pin, or, if that is on the sheet, the point that the line was laid through."""
        if isinstance(joint, Revolute):
            return foot(line, self.desk.at[joint.point])
        away = isinstance(joint, Prismatic) and abs(complex(nominal(line.at - self.desk.at[joint.pin]))) > OFF_SHEET
        return foot(line, self.desk.at[joint.pin]) if isinstance(joint, Prismatic) and away else line.at
