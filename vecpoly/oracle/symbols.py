"""What a textbook's symbol means: from the key of a quantity to its value."""

from __future__ import annotations

from typing import Protocol, assert_never

from ..errors import UnknownNameError
from ..mechanism.groups.assur import hinges
from ..mechanism.model import FRAME, Mechanism, Prismatic
from ..names import At, Kind, Rel
from ..words import Words
from .state import Points, Reals


class Moving(Protocol):
    """What a symbol's value is found from: the places and rates of links and letters, as `Motion` gives them."""

    @property
    def mech(self) -> Mechanism: ...

    def at(self, point: str | At) -> At: ...

    def omega(self, link: str) -> Reals: ...

    def alpha(self, link: str) -> Reals: ...

    def position(self, point: str | At) -> Points: ...

    def velocity(self, point: str | At) -> Points: ...

    def acceleration(self, point: str | At) -> Points: ...


def value(motion: Moving, rel: Rel) -> Points | Reals:
    """The quantity's value in SI units, of the motion's shape."""
    match rel.kind:
        case Kind.OMEGA:
            return motion.omega(rel.to.link)
        case Kind.ALPHA:
            return motion.alpha(rel.to.link)
        case Kind.P:
            here = motion.position(rel.to)
            return here if rel.ref is None else here - motion.position(rel.ref)
        case Kind.V:
            speed = motion.velocity(_thought(motion, rel.to, rel))
            return speed if rel.ref is None else speed - motion.velocity(_thought(motion, rel.ref, rel))
        case Kind.A:
            pull = motion.acceleration(_thought(motion, rel.to, rel))
            return pull if rel.ref is None else pull - motion.acceleration(_thought(motion, rel.ref, rel))
        case Kind.AN | Kind.AT:
            return _component(motion, rel)
        case Kind.AK | Kind.AR:
            return _sliding(motion, rel)
        case _:
            assert_never(rel.kind)


def _thought(motion: Moving, point: At, rel: Rel) -> At:
    """The point on the link that carries both letters, where neither names its link."""
    at = motion.at(point)
    if at.link or rel.ref is None:
        return at
    link = _common(motion, motion.at(rel.to), motion.at(rel.ref))
    return At(at.point, link) if link and link in motion.mech.links_at(at.point) else at


def _common(motion: Moving, to: At, ref: At) -> str:
    """The link that carries both points; of numbers, the one that carries the other letter; empty if none."""
    shared = [n for n in motion.mech.links_at(to.point) if n in motion.mech.links_at(ref.point)]
    for own, other in ((to, ref), (ref, to)):
        if own.link and (not other.link or other.link == own.link):
            carried = own.link in motion.mech.links_at(other.point) or other.link == own.link
            return own.link if carried else ""
    return shared[0] if shared else ""


def _component(motion: Moving, rel: Rel) -> Points:
    """a^n_CB = -ω² (C - B), a^t_CB = iα (C - B) of the link with both points; a^n_C about its frame pivot."""
    to = motion.at(rel.to)
    if rel.ref is None:
        link, pivot = _pivoted(motion, to, rel)
        ref = At(pivot)
    else:
        ref = motion.at(rel.ref)
        link = _common(motion, to, ref)
        if not link:
            raise UnknownNameError(
                Words(
                    f"{rel.key}：没有构件同时含有 {to} 和 {ref}；请写出构件号",
                    f"{rel.key}: no link carries both {to} and {ref}; write the link's number",
                )
            )
    ray = motion.position(At(to.point, link)) - motion.position(At(ref.point, link))
    if rel.kind is Kind.AN:
        omega = motion.omega(link)
        return -omega * omega * ray
    return 1j * motion.alpha(link) * ray


def _pivoted(motion: Moving, at: At, rel: Rel) -> tuple[str, str]:
    """The link that carries the point and has a pivot on the frame, and the pivot's letter."""
    names = [at.link] if at.link else [n for n in motion.mech.links_at(at.point) if n != FRAME]
    for name in names:
        for point, pinned in hinges(motion.mech).items():
            if FRAME in pinned and name in pinned and point != at.point:
                return name, point
    raise UnknownNameError(
        Words(
            f"{rel.key}：含点 {at} 的构件都没有固定铰链；请写出参考点",
            f"{rel.key}: no link with the point {at} has a frame pivot; name a reference point",
        )
    )


def _sliding(motion: Moving, rel: Rel) -> Points:
    """a^k_B3B2 = 2iω (v_B3 - v_B2) with the ω of the guide; a^r_B3B2 = a_B3 - a_B2 - a^k."""
    to, ref = motion.at(rel.to), None if rel.ref is None else motion.at(rel.ref)
    if ref is None or not to.link or not ref.link:
        raise UnknownNameError(
            Words(
                f"{rel.key}：请写出两构件的编号，如 {rel.kind.value}_B3B2",
                f"{rel.key}: write both links' numbers, as in {rel.kind.value}_B3B2",
            )
        )
    coriolis: Points = 2j * motion.omega(_guide(motion, to, ref)) * (motion.velocity(to) - motion.velocity(ref))
    if rel.kind is Kind.AK:
        return coriolis
    return motion.acceleration(to) - motion.acceleration(ref) - coriolis


def _guide(motion: Moving, to: At, ref: At) -> str:
    """The link with the guide along which B3 slides over B2:
    a block turns with it, a pin in a slot or a disc on a face does not."""
    slides = (j for j in motion.mech.joints if isinstance(j, Prismatic) and j.pin == to.point == ref.point)
    return next((j.guide for j in slides if j.guide in (to.link, ref.link)), ref.link)
