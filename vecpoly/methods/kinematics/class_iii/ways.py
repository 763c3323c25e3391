"""The equations of a class III group:
from known points over a leg to the central link, and on it to its special point."""

from __future__ import annotations

from typing import assert_never

import numpy as np

from ....algebra.quantity import magnitude
from ....board.construction import View
from ....names import At, Kind, Rel, alpha, omega
from ....vector.equation import Term
from ....words import Words
from ...desk import VECTOR, Desk
from ..chains import coincident_tip, sliding_chain, turning_chain
from ..terms import ABSENT, across, coriolis, known, normal_of, sliding
from .star import Axial, Guided, Hinged, Slotted, Star, point_of

Chain = tuple[Term, ...]


def prepare(desk: Desk, view: View, leg: Axial) -> None:
    """The coincident point of a moving guide is found first."""
    if isinstance(leg, Guided):
        coincident_tip(desk, view, leg.inner, leg.parent)


def chain_of(desk: Desk, view: View, star: Star, leg: Axial) -> Chain:
    """Over a leg to the central link's point; only the last term is unknown, in size: it lies across the leg's axis."""
    match leg:
        case Hinged(link=link, outer=o, inner=b):
            return turning_chain(desk, view, At(b), o, link)
        case Guided(parent=parent, slide=slide, inner=b):
            return sliding_chain(desk, view, At(b), At(b, parent), slide, parent)
        case Slotted():
            return _over_pin(desk, view, star, leg)
        case _:
            assert_never(leg)


def _over_pin(desk: Desk, view: View, star: Star, leg: Slotted) -> Chain:
    """v_Q + v_QcQ (∥ slide), or a_Q + a^k + a^r; both links turn alike."""
    to, ref = point_of(star, leg), desk.canonical(At(leg.outer))
    front = known(desk, view, ref)
    if view is View.VELOCITY:
        return front, sliding(desk, Rel(Kind.V, to, ref), leg.slide)
    if desk.turns[omega(star.plate)].never:
        return front, sliding(desk, Rel(Kind.A, to, ref), leg.slide)
    return (front, coriolis(desk, to, ref, star.plate), sliding(desk, Rel(Kind.AR, to, ref), leg.slide))


def on_plate(desk: Desk, view: View, plate: str, to: At, ref: At, primes: int) -> Chain:
    """From one point of the central link to another: v, or a^n and a^t, ⊥ of unknown size. primes: of the letter n."""
    to, ref = desk.canonical(to), desk.canonical(ref)
    if view is View.VELOCITY:
        return (across(desk, Rel(Kind.V, to, ref), ref.point, to.point),)
    return (_normal(desk, plate, to, ref, primes), across(desk, Rel(Kind.AT, to, ref), ref.point, to.point))


def turned_on_plate(desk: Desk, view: View, plate: str, to: At, ref: At, primes: int) -> Chain:
    """The same where ω (and α) of the central link are known: all known."""
    to, ref = desk.canonical(to), desk.canonical(ref)
    rates = desk.turns[(omega if view is View.VELOCITY else alpha)(plate)]
    if desk.turns[omega(plate)].never:
        rel = Rel(VECTOR[view], to, ref)
        return (Term(rel=rel, symbol=desk.symbol(rel), direction=ABSENT, magnitude="0", vector=0j, drawn=True),)
    rel = Rel(Kind.V if view is View.VELOCITY else Kind.AT, to, ref)
    front = () if view is View.VELOCITY else (_normal(desk, plate, to, ref, primes),)
    greek, unit = ("ω", "rad/s") if view is View.VELOCITY else ("α", "rad/s^2")
    length = desk.length(ref.point, to.point)
    desk.board.compute(
        desk.symbol(rel), magnitude(f"{greek}_{plate}", np.abs(rates.value), unit) * length, rel.kind.unit
    )
    along = 1j * np.where(rates.value < 0, -1.0, 1.0) * desk.towards(ref.point, to.point)
    laid = Term(
        rel=rel,
        symbol=desk.symbol(rel),
        direction=Words.same(f"⊥$ {ref.point}{to.point}$"),
        magnitude=f"$ {greek}_{plate} l_{ref.point}{to.point}$",
        along=along[()],
        mm=desk.board.to_paper(view, np.abs(rates.value) * length.value),
    )
    return (*front, laid)


def _normal(desk: Desk, plate: str, to: At, ref: At, primes: int) -> Term:
    """a^n of two points of the central link."""
    return normal_of(desk, Rel(Kind.AN, to, ref), ref.point, plate, desk.n_tip(plate, primes))


def to_special(desk: Desk, view: View, star: Star, leg: Axial, special: At, primes: int) -> tuple[Chain, Chain]:
    """The way over a leg to the special point on the leg's axis: all its unknowns are parallel, and count as one.

    Returns the way and the leg's own chain, which tells the leg's motion later.
    """
    chain = chain_of(desk, view, star, leg)
    *normals, last = on_plate(desk, view, star.plate, special, point_of(star, leg), primes)
    base = next((term.rel.ref for term in chain if isinstance(term.rel, Rel)), None)
    start = (
        chain[0].rel.to if len(chain) > 1 and chain[0].vector is not None and isinstance(chain[0].rel, Rel) else base
    )
    assert isinstance(chain[-1].rel, Rel) and isinstance(last.rel, Rel)
    total = Term(
        rel=Rel(last.rel.kind, last.rel.to, start),
        symbol=f"({chain[-1].symbol} + {last.symbol})",
        direction=chain[-1].direction,
        magnitude="?",
        along=chain[-1].along,
        summed=(chain[-1].rel, last.rel),
    )
    return (*chain[:-1], *normals, total), chain
