"""The equations of equilibrium of a loaded mechanism, three for every link:
what acts, what the joints do, what friction adds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from ...mechanism.asked.forces import load_symbol
from ...mechanism.loads import GRAVITY, Force, Load, Loads, Mass
from ...mechanism.model import Mechanism, Rolling
from ..equations import Equation, Model
from ..expr import ZERO, Const, Expr, Var, total
from ..functions import cos, sin
from .laws import Act, spring_acts, spring_equations
from .pairs import Frame, Pair, Touch, touches


@dataclass(frozen=True, slots=True)
class LinkBalance:
    """ΣF_x = 0, ΣF_y = 0 and ΣM = 0 about `about` of one link (printed number)."""

    link: str
    about: str
    equations: tuple[Equation, ...]


@dataclass(frozen=True, slots=True)
class ForceModel:
    """All equations of the forces. inertia: inertia forces and couples by the motion; springs: theirs; normals: of the
    contacts; friction: by the reactions. The size of a load that depends on the motion is a variable."""

    touches: tuple[Touch, ...]
    inertia: tuple[Equation, ...]
    springs: tuple[Equation, ...]
    links: tuple[LinkBalance, ...]
    loads: tuple[Const, ...]
    unknowns: tuple[str, ...]  # of the frictionless system, the balancing load last

    @property
    def normals(self) -> tuple[Equation, ...]:
        return tuple(equation for touch in self.touches for equation in touch.before)

    @property
    def friction(self) -> tuple[Equation, ...]:
        return tuple(equation for touch in self.touches for equation in touch.friction)

    @property
    def shared_pins(self) -> tuple[Touch, ...]:
        """The rubbing hinges at letters with several such."""
        rubbing = [touch for touch in self.touches if touch.rub]
        return tuple(touch for touch in rubbing if sum(other.letter == touch.letter for other in rubbing) > 1)


def force_model(mech: Mechanism, loads: Loads, motion: Model, turned: Mapping[str, float]) -> ForceModel | None:
    """The model for a mechanism whose motion has this model;
    None where gears roll or a cylinder pushes, for which there is none on file."""
    if any(isinstance(joint, Rolling) for joint in mech.joints) or any(force.against for force in loads.forces):
        return None
    given = {motion.drive, *(symbol for symbol, _ in motion.given)}
    given |= {e.left.symbol for group in motion.groups for e in group.equations if e.gives and isinstance(e.left, Var)}
    frame = Frame(mech, frozenset(given), turned)
    found = tuple(touches(frame, loads.friction))
    inertia = tuple(e for mass in loads.masses for e in _inertia(frame, mass)) if loads.dynamic else ()
    springs = tuple(e for spring in loads.springs for e in spring_equations(frame, spring, loads.springs))
    acts = [_load(frame, load) for load in loads.all]
    acts += [act for spring in loads.springs for act in spring_acts(frame, spring)]
    acts += [act for mass in loads.masses for act in _mass(frame, loads, mass)]
    links = tuple(
        _balance(frame, link, found, [act for act in acts if act.link == link])
        for link in mech.bodies
        if link not in mech.slot_pins
    )
    sized = tuple(
        Const(load_symbol(load.name), load.size, "N" if isinstance(load, Force) else "N·m")
        for load in loads.all
        if load.size is not None and load.law is None
    )
    unknowns = (*(symbol for touch in found for symbol in touch.unknowns), load_symbol(loads.unknown.name))
    return ForceModel(found, inertia, springs, links, sized, unknowns)


def _load(frame: Frame, load: Load) -> Act:
    symbol = load_symbol(load.name)
    if isinstance(load, Force):
        size: Expr = Var(symbol) if load.size is None or load.law is not None else Const(symbol, load.size, "N")
        way: Expr = Const(f"θ_{{{load.name.replace('_', '')}}}", load.direction, "rad")
        if load.along is not None:
            way = frame.ray(load.link, *load.along)
        return Act(load.link, frame.xy(load.point), (size * cos(way), size * sin(way)))
    return Act(
        load.link,
        None,
        (ZERO, ZERO),
        Var(symbol) if load.size is None or load.law is not None else Const(symbol, load.size, "N·m"),
    )


def _inertia(frame: Frame, mass: Mass) -> tuple[Equation, ...]:
    """F_I = −m a_S, M_I = −J_S α; nothing where the centre of mass is fixed,
    or the link does not turn or turns evenly."""
    link, m, turns = mass.link, Const(f"m_{{{mass.link}}}", mass.mass, "kg"), Var(f"α_{{{mass.link}}}")
    found = tuple(
        Equation(left, -(m * right))
        for left, right in zip(
            _pushed(frame, mass), (Var(f"a_{{{mass.centre}x}}"), Var(f"a_{{{mass.centre}y}}")), strict=True
        )
        if isinstance(left, Var)
    )
    if mass.inertia and turns.symbol in frame.symbols:
        found += (Equation(Var(f"M_{{I{link}}}"), -(Const(mass.inertia_symbol, mass.inertia, "kg·m²") * turns)),)
    return found


def _pushed(frame: Frame, mass: Mass) -> Pair:
    if mass.centre in frame.mech.frame:
        return ZERO, ZERO
    return Var(f"F_{{I{mass.link}x}}"), Var(f"F_{{I{mass.link}y}}")


def _mass(frame: Frame, loads: Loads, mass: Mass) -> list[Act]:
    """Weight and inertia force of a link."""
    acts, at = [], frame.xy(mass.centre)
    if loads.weight:
        acts.append(Act(mass.link, at, (ZERO, -Const(f"G_{{{mass.link}}}", GRAVITY * mass.mass, "N"))))
    if loads.dynamic:
        turning = bool(mass.inertia) and f"α_{{{mass.link}}}" in frame.symbols
        acts.append(Act(mass.link, at, _pushed(frame, mass), Var(f"M_{{I{mass.link}}}") if turning else ZERO))
    return acts


def _balance(frame: Frame, link: str, found: tuple[Touch, ...], acts: list[Act]) -> LinkBalance:
    own = [(touch, 1 if touch.b == link else -1) for touch in found if link in (touch.a, touch.b)]
    letter, centre = own[0][0].letter, own[0][0].at
    forces = [
        total(*((touch.force[i], sign) for touch, sign in own), *((act.force[i], 1) for act in acts)) for i in (0, 1)
    ]
    turning: list[tuple[Expr, int]] = [
        (_moment(touch.at, centre, touch.force), sign) for touch, sign in own if touch.letter != letter
    ]
    turning += [(_moment(act.at, centre, act.force), 1) for act in acts if act.at is not None and act.at != centre]
    turning += [*((touch.couple, sign) for touch, sign in own), *((act.couple, 1) for act in acts)]
    equations = tuple(Equation(left, ZERO, gives=False) for left in (*forces, total(*turning)) if left != ZERO)
    return LinkBalance(frame.mech.number(link), letter, equations)


def _moment(at: Pair, centre: Pair, force: Pair) -> Expr:
    """(x − x_0) F_y − (y − y_0) F_x."""
    return (at[0] - centre[0]) * force[1] - (at[1] - centre[1]) * force[0]
