"""From an Assur group to the step that solves it."""

from __future__ import annotations

import numpy as np

from ..errors import AssemblyError
from ..mechanism.groups.assur import Dyad, Group, is_held
from ..mechanism.model import Joint, Mechanism, Prismatic, Revolute, Rolling
from ..mechanism.rams import Ram, drives_within
from ..words import Words
from .closed.cammed import Cammed, cammed
from .closed.crossed import Crossed
from .closed.dyads import Hinged, Swinging
from .closed.loci import Arc, Locus, roll, slide
from .closed.off_centre import crossing
from .closed.parallel import Parallel
from .closed.telescope import Telescope, telescope
from .iterated.driven import driven
from .iterated.newton import Newton
from .iterated.rows import row
from .iterated.standing import standings, start_of

Step = Hinged | Swinging | Crossed | Parallel | Cammed | Newton


def step_for(mech: Mechanism, group: Group) -> Step:
    """The closed form of a dyad, Newton for anything else."""
    step: Step | None = cammed(mech, group) if mech.cams else None
    if step is not None:
        return step
    if group.ram is not None:
        return _extended(mech, group, group.ram)
    if group.dyad is not None:
        dyad = group.dyad
        match dyad.outer_j, dyad.inner, dyad.outer_k:
            case _, Revolute() as pin, _:
                step = _hinged(mech, group, dyad, pin)
            case Revolute() as first, Prismatic() as guide, Revolute() as second:
                step = _swinging(mech, group, dyad, (first, guide, second))
            case Revolute() as first, Prismatic() as guide, Prismatic() as last:
                step = _crossed(mech, group, dyad, (first, guide, last))
    return step or newton(mech, group)


def _extended(mech: Mechanism, group: Group, ram: Ram) -> Hinged:
    """A driven cylinder and the link at its end."""
    other = _locus(mech, ram.link_joint, ram.link, ram.link_parent, ram.inner.point)
    assert other is not None  # the link hangs on a hinge or on a guide
    return Hinged(group, other, telescope(mech, ram, drives_within(mech, group.links)[0]), ram.inner.point)


def _hinged(mech: Mechanism, group: Group, dyad: Dyad, pin: Revolute) -> Hinged | None:
    j = _locus(mech, dyad.outer_j, dyad.link_j, dyad.parent_j, pin.point)
    k = _locus(mech, dyad.outer_k, dyad.link_k, dyad.parent_k, pin.point)
    return None if j is None or k is None else Hinged(group, j, k, pin.point)


def _locus(mech: Mechanism, joint: Joint, name: str, parent: str, point: str) -> Locus | None:
    """The locus that the outer joint leaves to the link's point; None where it is no circle or line."""
    link, base = mech.link(name), mech.link(parent)
    inner = link.points[point]
    match joint:
        case Revolute():
            start = link.points[joint.point]
            if inner == start:
                raise _one_place(name, joint.point, point)
            return Arc(name, parent, base.points[joint.point], start, inner - start)
        case Prismatic():
            return slide(joint, name, inner, mech.link(joint.block).points[joint.pin])
        case Rolling():
            locus = roll(joint, link, base, start_of(mech, name))
            return locus if locus is not None and locus.start == inner else None


def _one_place(link: str, one: str, other: str) -> AssemblyError:
    return AssemblyError(
        Words(
            f"构件 {link} 的铰链 {one} 与 {other} 重合，其方向不定；请给出两者的距离，或将两铰链合为一个复合铰链",
            f"the hinges {one} and {other} of link {link} lie in one place, so that its direction is not determined; "
            "give their distance, or make one multiple joint of them",
        ),
        code="coincident",
    )


def _swinging(mech: Mechanism, group: Group, dyad: Dyad, joints: tuple[Revolute, Prismatic, Revolute]) -> Swinging:
    """RPR: all in the coordinates of the guide line, from the guide's pivot to the block's."""
    first, slider, second = joints
    ends = {dyad.link_j: (dyad.parent_j, first.point), dyad.link_k: (dyad.parent_k, second.point)}
    (g_parent, g), (b_parent, b) = ends[slider.guide], ends[slider.block]
    guide, block = mech.link(slider.guide), mech.link(slider.block)
    turn = complex(np.exp(1j * slider.turn))
    line = (slider.origin - guide.points[g]) * complex(np.exp(-1j * slider.direction))
    pin = (block.points[slider.pin] - block.points[b]) * turn
    return Swinging(
        group,
        guide.name,
        block.name,
        g_parent,
        b_parent,
        mech.link(g_parent).points[g],
        mech.link(b_parent).points[b],
        guide.points[g],
        block.points[b],
        complex(np.exp(-1j * slider.direction)),
        turn,
        across=_clean(line.imag + slider.offset - pin.imag, mech.scale),
        shift=pin.real - line.real if slider.through else 0.0,
        size=mech.scale,
        joint=slider.pin,
    )


def _clean(length: float, scale: float) -> float:
    """Zero where rounding alone makes it differ."""
    return 0.0 if abs(length) < 1e-15 * scale else length


def _crossed(mech: Mechanism, group: Group, dyad: Dyad, joints: tuple[Revolute, Prismatic, Prismatic]) -> Crossed:
    """RPP: link k's first point on its outer line and on its line on link j."""
    first, inner, outer = joints
    j, k = mech.link(dyad.link_j), mech.link(dyad.link_k)
    point = next(iter(k.points.values()), 0j)
    on_parent = slide(outer, k.name, point, mech.link(outer.block).points[outer.pin])
    on_j = slide(inner, k.name, point, mech.link(inner.block).points[inner.pin])
    return Crossed(
        group,
        dyad.parent_j,
        mech.link(dyad.parent_j).points[first.point],
        j.points[first.point],
        on_j.turn.conjugate(),
        on_parent,
        on_j,
        f"slider {inner.pin}",
    )


def is_followed(step: Step) -> bool:
    """Whether the step needs a path from the own position: it iterates, or gears roll."""
    match step:
        case Newton():
            return True
        case Hinged(j=j, k=k):
            return any(not isinstance(locus, Telescope) and locus.gearing is not None for locus in (j, k))
    return False


def newton(mech: Mechanism, group: Group) -> Newton:
    """The step for a group that has no closed form here; of a hinge off a gear's centre there are two assemblies."""
    joints = (*group.inner, *(out.joint for out in group.outer))
    rows = tuple(row(mech, joint, isinstance(joint, Rolling) and is_held(mech, joint)) for joint in joints)
    drives = tuple(driven(mech, drive) for drive in drives_within(mech, group.links))
    if (cross := crossing(mech, group)) is not None:
        return Newton(mech, group, (*rows, *drives), standings(mech, group), two=True, joint=cross[0])
    return Newton(mech, group, (*rows, *drives), standings(mech, group))
