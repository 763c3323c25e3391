"""Each link drawn apart (取分离体) at its place and scale:
friction circles, forces at their lines of action, normals with φ, couples."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ....board.construction import Pane, View
from ....board.paper.marks import Dot, Role
from ....diagram.links import link_alone
from ....mechanism.loads import Moment
from ....mechanism.model import Contact, Prismatic, Revolute
from ....names import At
from ....plane import nominal
from ....problem.problem import Problem
from ....words import Words
from ..acting import Acting
from ..closing.thrust_readings import in_cylinders
from ..couples import couples_on
from ..inertia import SHORT, draw_arm
from ..state import Statics
from .arrows import REACH, Arrow, place_arrows
from .bars import bars_of
from .brought import brought_near
from .circles import draw_circles, tangent_as_drawn
from .couple_arm import draw_couple_arm
from .given_loads import ways_of_loads
from .inked import ink_arrows

NORMAL = 18.0  # mm, length of a normal beside a reaction
COUPLE = 8.0  # mm, radius of a couple's arrow


def draw_free_bodies(st: Statics, problem: Problem, solved: Sequence[str]) -> None:
    """One pane for every link, in the order in which they were solved; the last step of the drawing."""
    places = {name: place for place, name in reversed(list(enumerate(solved)))}
    bodies = [name for name in st.mech.bodies if name not in st.mech.slot_pins and st.known(name)]
    bodies.sort(key=lambda name: places.get(name, len(solved)))
    if not bodies:
        return
    st.board.step(
        Words(
            "将各构件取为分离体，画出受力图：标明全部力的作用线和指向。",
            "Draw the free body of every link, with the line and sense of every force on it.",
        ),
        View.BODY,
    )
    assert problem.loads is not None
    inside = in_cylinders(st, problem.loads)
    thrusts = {
        key for forces in inside.values() for force in forces for key in (force.named.key, f"{force.named.key}′")
    }
    posed, (pushed, pulled) = st.desk.posed(), ways_of_loads(st)
    for name in bodies:
        number = st.mech.number(name)
        pane = st.board.open_pane(View.BODY, number, Words(f"构件 {number} 受力图", f"Free body of link {number}"))
        st.board.depict(pane, link_alone(posed, name, pressed=_guided(st, name)))
        larger = draw_circles(st, pane, name)
        pressing = inside.get(name, [])
        forces = [
            *(force for force in (*st.known(name), *_balance(st, name)) if force.named.key not in thrusts),
            *pressing,
        ]
        spots = [*_spots(st, name), *(complex(nominal(force.at)) for force in pressing)]
        forces, couples = brought_near(st, name, tangent_as_drawn(st, forces, larger), spots)
        pressed = pushed.union(_pressing(st, name), (force.named.symbol for force in pressing))
        arrows = place_arrows(forces, spots, pressed, pulled, bars=[*bars_of(st.board.marks(pane))])
        _displaced(st, pane, name)
        ink_arrows(st, pane, (name,), forces, arrows)
        draw_couple_arm(st, pane, name, forces, arrows)
        _draw_normals(st, pane, name, {force.named.symbol: force for force in forces}, arrows)
        _couple(st, pane, name, couples)


def _guided(st: Statics, link: str) -> tuple[complex, ...]:
    """Where the guides of a block press on it."""
    others = [j.guide for j in st.mech.joints if isinstance(j, Prismatic) and j.block == link]
    forces = [force for other in others if (force := st.push(other, link)) is not None]
    return tuple(complex(nominal(force.at)) for force in forces if abs(nominal(force.vector)) > 1e-9)


def _displaced(st: Statics, pane: Pane, link: str) -> None:
    """The arm by which an inertia force stands beside the centre of mass."""
    mass = st.loads.mass(link)
    for force in st.inertia.get(link, []) if mass is not None else []:
        if mass is not None and force.named.key == f"F_I{link}":
            centre = st.desk.where(At(mass.centre))
            if SHORT < abs(nominal(force.at - centre)) < REACH:
                draw_arm(st, pane, f"h_{{{link}}}", centre, force.at, force.line.along)


def _pressing(st: Statics, link: str) -> set[str]:
    """Reactions of guides and of contacts, which press on the link: they end where they act."""
    pairs = [(j.guide, j.block) for j in st.mech.joints if isinstance(j, Prismatic)] + [
        c.links for c in st.mech.contacts
    ]
    pairs += [(pin.block, pin.carrier) for pin in st.mech.slot_pins.values()]
    return {st.named(b if a == link else a, link).symbol for a, b in pairs if link in (a, b)}


def _spots(st: Statics, link: str) -> list[complex]:
    """Points of the body: its lettered ones, and where it is touched."""
    points = [st.desk.at[p] for p in st.mech.link(link).points if p in st.desk.at]
    return [
        complex(nominal(p)) for p in (*points, *(st.desk.contact_of(c) for c in st.mech.contacts if link in c.links))
    ]


def _balance(st: Statics, link: str) -> list[Acting]:
    """The balancing force, where this link carries it."""
    load = st.unknown
    if isinstance(load, Moment) or load.link != link or st.balanced or not nominal(st.balance):
        return []
    vector = st.mm(np.abs(st.balance)) * complex(np.exp(1j * load.direction)) * np.sign(nominal(st.balance))
    return [Acting(named=st.unknown_named, vector=vector, at=st.desk.at[load.point])]


def _draw_normals(st: Statics, pane: Pane, link: str, forces: Mapping[str, Acting], arrows: Sequence[Arrow]) -> None:
    """The normal of every slide and contact of the link, and the friction angle from it to the reaction, where that is
    drawn."""
    drawn = {arrow.symbol: arrow for arrow in arrows}
    for joint in (*st.mech.joints, *st.mech.contacts):
        if isinstance(joint, Revolute) or not isinstance(joint, Prismatic | Contact):
            continue
        a, b = joint.links if isinstance(joint, Contact) else (joint.guide, joint.block)
        if b in st.mech.slot_pins and link == st.mech.slot_pins[b].carrier:
            a = link
        if link not in (a, b) or not st.phi(joint):
            continue
        force = forces.get(st.named(b if link == a else a, link).symbol)
        if force is not None and abs(nominal(force.vector)) > 1e-9:
            arrow = drawn.get(force.named.symbol)
            if arrow is None:
                continue  # off the paper
            middle = (arrow.start + arrow.end) / 2 - complex(nominal(force.at))
            _draw_leaning(st, pane, joint, force, middle)


def _draw_leaning(st: Statics, pane: Pane, joint: Prismatic | Contact, force: Acting, arrow: complex) -> None:
    """The normal on the side on which the arrow stands, so that φ lies between the two."""
    along = st.desk.normal_of(joint) if isinstance(joint, Contact) else 1j * st.desk.guide_line(joint).along
    n, u, at = (complex(nominal(z)) for z in (along, force.line.along, force.at))
    u = u if (u.conjugate() * arrow).real > 0 else -u
    n = n if (n.conjugate() * u).real > 0 else -n
    st.board.join(pane, at, at + n * NORMAL, Role.CENTRE)
    st.board.plot(pane, at + n * NORMAL, "n", Dot.NONE)
    st.board.angle(pane, at, n, float(np.angle(u / n)), NORMAL * 0.8, st.phi_symbol(joint))


def _couple(st: Statics, pane: Pane, link: str, brought: Sequence[tuple[str, float]]) -> None:
    """All couples, those of forces brought near, and the balancing moment as curved arrows at the link's pin."""
    pivot = next((p for p in st.mech.link(link).points if p in st.mech.frame), next(iter(st.mech.link(link).points)))
    at, free = complex(nominal(st.desk.at[pivot])), st.unknown
    own = (
        [(st.unknown_named.symbol, st.balance)]
        if isinstance(free, Moment) and free.link == link and not st.balanced
        else []
    )
    turning = [(symbol, size) for symbol, size in (*couples_on(st, link), *brought, *own) if nominal(size)]
    for i, (symbol, size) in enumerate(turning):
        st.board.curved_arrow(pane, at, COUPLE + 3 * i, 2.2, bool(nominal(size) > 0), symbol)
