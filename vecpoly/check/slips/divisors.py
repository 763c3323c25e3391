"""A divisor left out: ω or α of a dyad's link is numerator / determinant, and a program forgot to divide.

The two closed equations of a dyad have the determinant l_j l_k sin γ (RRR), l cos θ (RRP) or the distance of its hinges
along the guide (RPR). All that hangs on the link is computed with the undivided rate, and is wrong too.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from ...errors import VecpolyError
from ...foundation.slotted import replace
from ...mechanism.groups.assur import Dyad, decompose
from ...mechanism.model import Joint, Mechanism, Prismatic, Revolute, Rolling
from ...names import Kind
from ...oracle import Motion
from ...oracle.iterated.rows import Row, row
from ...oracle.state import Body, Reals
from ...words import Words
from .rates import Bodies, bent, jacobian, posed, stacked

Divisor = tuple[Words, Reals]
_OF = {Kind.OMEGA: "ω", Kind.ALPHA: "α"}


def undivided(mech: Mechanism, motion: Motion) -> Iterator[tuple[Kind, Words, Motion]]:
    """The motion with ω (α then as it is), or α, of one dyad's links not divided by the dyad's determinant;
    in mm or m."""
    if any(isinstance(joint, Rolling) for joint in mech.joints):
        return
    try:
        groups = decompose(mech)
    except VecpolyError:
        return
    count = max(motion.shape[0] if motion.shape else 1, 1)
    bodies = {name: _with_rates(body, count) for name, body in motion.bodies.items()}
    for i, group in enumerate(groups):
        after = [link for later in groups[i + 1 :] for link in later.links]
        for links in _turning(group.dyad) if group.dyad else ():
            for words, divisor in _divisors(mech, group.dyad, links, bodies, count):
                for kind in (Kind.ALPHA, Kind.OMEGA):
                    changed = bodies | {
                        name: _spun(bodies[name], mech, name, pin, divisor, kind) for name, pin in links
                    }
                    symbols = (
                        "、".join(f"${_OF[kind]}_{{{name}}}$" for name, _ in links),
                        ", ".join(f"${_OF[kind]}_{{{name}}}$" for name, _ in links),
                    )
                    told = Words(f"{symbols[0]} 漏除以{words.zh}", f"{symbols[1]} not divided by {words.en}")
                    yield kind, told, Motion(mech, _followed(mech, changed, after, kind, count), motion.shape, 2)


def _turning(dyad: Dyad) -> list[tuple[tuple[str, str], ...]]:
    """Links with the hinge about which each turns, grouped as they share one rate."""
    outer = [(dyad.link_j, dyad.outer_j), (dyad.link_k, dyad.outer_k)]
    hung = tuple((name, joint.point) for name, joint in outer if isinstance(joint, Revolute))
    if isinstance(dyad.inner, Prismatic):
        return [hung] if len(hung) == 2 else []
    return [(one,) for one in hung]


def _divisors(
    mech: Mechanism, dyad: Dyad | None, links: Sequence[tuple[str, str]], bodies: Bodies, count: int
) -> Iterator[Divisor]:
    """The dyad's determinant at every position, with the name that the textbook has for it."""
    assert dyad is not None
    names = (dyad.link_j, dyad.link_k)
    joints: list[Joint] = [dyad.outer_j, dyad.inner, dyad.outer_k]
    rows = [row(mech, joint, False) for joint in joints]
    guides = sum(isinstance(joint, Prismatic) for joint in joints)
    value = np.linalg.det(np.nan_to_num(jacobian(tuple(rows), names, bodies, count))) / mech.scale**guides
    size = 2 - guides
    zh, en = _name(dyad, links)
    for unit, factor in (("mm", 1e3), ("m", 1.0)):
        power = "²" if size == 2 else ""
        for sign in (1, -1):  # a determinant may be written either way
            yield (
                Words(f"{zh}（以 {unit}{power} 计）", f"{en} (in {unit}{power})"),
                np.asarray(sign * value * factor**size),
            )


def _name(dyad: Dyad, links: Sequence[tuple[str, str]]) -> tuple[str, str]:
    if isinstance(dyad.inner, Prismatic):
        return "两外接副沿导路的距离", "the distance of the dyad's outer joints along the guide"
    assert isinstance(dyad.inner, Revolute)
    bars = [
        f"l_{{{joint.point}{dyad.inner.point}}}"
        for joint in (dyad.outer_j, dyad.outer_k)
        if isinstance(joint, Revolute)
    ]
    if len(bars) == 2:
        return (
            f"杆组的系数行列式 ${bars[0]} {bars[1]} sin γ$",
            f"the determinant of its dyad, ${bars[0]} {bars[1]} sin γ$",
        )
    return (
        f"杆组的系数 ${bars[0]} cos θ$（$θ$ 为该杆与导路的夹角）",
        f"the coefficient of its dyad, ${bars[0]} cos θ$ ($θ$: of the bar with the guide)",
    )


def _with_rates(body: Body, count: int) -> Body:
    still = posed(body, count)
    lines = [
        np.asarray(np.broadcast_to(v, (count,)), np.complex128)
        for v in (body.velocity_of(0j), body.acceleration_of(0j))
    ]
    turns = [np.asarray(np.broadcast_to(v, (count,)), np.float64) for v in (body.omega, body.alpha)]
    return still.moving(lines[0], turns[0], lines[1], turns[1])


def _spun(body: Body, mech: Mechanism, name: str, pin: str, times: Reals, kind: Kind) -> Body:
    """The link with its rate multiplied, about its hinge."""
    arm = -1j * body.unit * mech.link(name).points[pin]
    if kind is Kind.ALPHA:
        more = body.alpha * (times - 1)
        return body.moving(body.velocity, body.omega, body.acceleration + more * arm, body.alpha + more)
    more = body.omega * (times - 1)
    return body.moving(body.velocity + more * arm, body.omega + more, body.acceleration, body.alpha)


def _followed(mech: Mechanism, bodies: Bodies, after: Sequence[str], kind: Kind, count: int) -> Bodies:
    """The links of later groups, as they follow from those before them."""
    if not after:
        return bodies
    rows: tuple[Row, ...] = tuple(r for joint in mech.joints if {(r := row(mech, joint, False)).a, r.b} & {*after})
    return bodies | _solved(rows, tuple(after), bodies, kind, count)


def _solved(rows: tuple[Row, ...], links: tuple[str, ...], bodies: Bodies, kind: Kind, count: int) -> Bodies:
    matrix = jacobian(rows, links, bodies, count)
    lost = ~np.isfinite(matrix).all(axis=(1, 2)) | (np.abs(np.linalg.det(np.nan_to_num(matrix))) < 1e-300)
    inverse = np.linalg.inv(np.where(lost[:, None, None], np.eye(matrix.shape[1]), matrix))
    inverse[lost] = np.nan
    none, nil = np.zeros(count, np.complex128), np.zeros(count)
    if kind is Kind.ALPHA:
        start = bodies | {name: replace(bodies[name], acceleration=none, alpha=nil) for name in links}
        rates = bent(inverse, stacked(rows, [r.accel(start[r.a], start[r.b]) for r in rows], count))
    else:
        start = bodies | {name: replace(bodies[name], velocity=none, omega=nil) for name in links}
        rates = bent(inverse, stacked(rows, [r.rate(start[r.a], start[r.b]) for r in rows], count))
    line, turn = rates[:, :, 0] + 1j * rates[:, :, 1], rates[:, :, 2]
    if kind is Kind.ALPHA:
        return {name: replace(bodies[name], acceleration=line[:, i], alpha=turn[:, i]) for i, name in enumerate(links)}
    return {name: replace(bodies[name], velocity=line[:, i], omega=turn[:, i]) for i, name in enumerate(links)}
