"""What may be asked of a mechanism's instant centres, by key.

``P_13`` the centre of links 1 and 3 (printed numbers, the frame's included; beyond nine links ``P_3_12``): its place,
or where it is at
infinity the direction in which it lies; ``v_P13`` the velocity that both links have there; ``omega_ratio_13`` the ratio
ω_1/ω_3;
``phi_C_extended``, ``phi_C_overlapped`` the crank angles at which v_C vanishes, crank and rod being in one line.
"""

from __future__ import annotations

from itertools import combinations

from ...errors import MobilityError
from ...names import Named, Sort
from ..groups.assur import decompose
from ..model import FRAME, Mechanism, Prismatic, Revolute

Pair = tuple[str, str]  # two links by name, in the order of their printed numbers
ENDLESS = "deg"  # unit in which a centre at infinity is told: the direction of the line on which it lies


def real_links(mech: Mechanism) -> tuple[str, ...]:
    """All links that exist, by number, the frame last; what only stands for a higher pair does not count."""
    return (*sorted((name for name in mech.bodies if name[0].isdigit()), key=_number), FRAME)


def count(mech: Mechanism) -> int:
    """N = K (K − 1) / 2 centres of K links."""
    links = len(real_links(mech))
    return links * (links - 1) // 2


def link_pairs(mech: Mechanism) -> tuple[Pair, ...]:
    """Every two links, each pair once."""
    return tuple(combinations(real_links(mech), 2))


def pair_of(mech: Mechanism, a: str, b: str) -> Pair:
    """The two links in the order of their numbers."""
    order = real_links(mech)
    first, second = sorted((a, b), key=order.index)
    return first, second


def centre(mech: Mechanism, a: str, b: str) -> Named:
    """P_13: the instant centre of two links."""
    key, symbol = _subscript(mech, a, b)
    return Named(f"P_{key}", f"P_{{{symbol}}}", "m", True, Sort.CENTRE)


def centre_speed(mech: Mechanism, a: str, b: str) -> Named:
    """v_P13: the velocity of the centre of two links, as a point of either."""
    key, symbol = _subscript(mech, a, b)
    return Named(f"v_P{key}", f"v_{{P{symbol}}}", "m/s", True, Sort.CENTRE_SPEED)


def ratio(mech: Mechanism, a: str, b: str) -> Named:
    """omega_ratio_13: ω_1/ω_3, positive where both turn alike."""
    i, j = mech.number(a), mech.number(b)
    return Named(
        f"omega_ratio_{i}{j}" if _short(i, j) else f"omega_ratio_{i}_{j}", f"ω_{{{i}}}/ω_{{{j}}}", "", sort=Sort.RATIO
    )


def crank_groups(mech: Mechanism) -> tuple[tuple[str, str, str], ...]:
    """(pin of the crank, point that is led,
    rod) where a rod hangs on the crank and the led point runs on a fixed circle or line."""
    profiles = {one.centre for one in mech.cams}  # of which the rod is another at every place
    try:
        groups = () if mech.drive.slide else decompose(mech)
    except MobilityError:
        return ()
    found = []
    for group in groups:
        d = group.dyad
        if d is None or d.kind not in ("RRR", "RRP") or not isinstance(d.inner, Revolute):
            continue
        hung = ((d.outer_j, d.parent_j, d.link_j, d.parent_k), (d.outer_k, d.parent_k, d.link_k, d.parent_j))
        found += [
            (outer.point, d.inner.point, rod)
            for outer, parent, rod, other in hung
            if isinstance(outer, Revolute)
            and parent == mech.drive.link
            and other == FRAME
            and outer.point not in profiles
        ]
    return tuple(found)


def limits(mech: Mechanism, point: str) -> tuple[Named, Named]:
    """Crank angles (deg) at which a led point stands still: rod and crank extended, and overlapped."""
    return (
        Named(f"phi_{point}_extended", f"φ_{point}^{{′}}", "deg", sort=Sort.LIMIT),
        Named(f"phi_{point}_overlapped", f"φ_{point}^{{′′}}", "deg", sort=Sort.LIMIT),
    )


def centre_quantities(mech: Mechanism) -> dict[str, Named]:
    """Every quantity that instant centres give, by its key."""
    found: list[Named] = []
    for a, b in link_pairs(mech):
        found += [centre(mech, a, b), centre_speed(mech, a, b)]
        found += [ratio(mech, x, y) for x, y in ((a, b), (b, a)) if FRAME not in (x, y)]
    for _, led, _ in crank_groups(mech):
        found += limits(mech, led)
    return {named.key: named for named in found}


def sliding_pairs(mech: Mechanism) -> tuple[Prismatic, ...]:
    """Slides between links that exist."""
    real = set(real_links(mech))
    return tuple(j for j in mech.joints if isinstance(j, Prismatic) and {j.guide, j.block} <= real)


def _subscript(mech: Mechanism, a: str, b: str) -> tuple[str, str]:
    i, j = (mech.number(name) for name in pair_of(mech, a, b))
    return (f"{i}{j}", f"{i}{j}") if _short(i, j) else (f"{i}_{j}", f"{i},{j}")


def _short(i: str, j: str) -> bool:
    return len(i) == 1 and len(j) == 1


def _number(name: str) -> tuple[int, str]:
    return int("".join(filter(str.isdigit, name))), name
