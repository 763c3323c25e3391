"""Where an asked vector stands on the polygons:
under its own key, as the opposite of another, or as that of the same sliding pair."""

from __future__ import annotations

import numpy as np

from ..algebra.formula import sym
from ..algebra.quantity import Quantity
from ..board.board import NO_LENGTH
from ..board.construction import View
from ..errors import NoMethodError
from ..foundation.slotted import replace
from ..names import At, Kind, Rel, omega
from ..plane import Points, nominal
from ..words import Words
from .desk import Desk, polygon_of
from .lettered import lettered

STILL = 1e-12  # rad/s: a link that does not turn
Standing = tuple[View, Points, Points, str]  # figure, start, end, letters


def standing(desk: Desk, rel: Rel) -> Standing:
    """Figure, start, end and letters of a vector; raises NoMethodError where the construction holds no such line.

    v_BC is v_CB turned round, and so are all relative vectors. Two links of a sliding pair turn alike, so that v, a^k
    and a^r of the one against the other are the same at every point.
    """
    found = _drawn(desk, rel) or _turned(_drawn(desk, _back(rel))) or _sliding(desk, rel)
    found = found or _plain(desk, rel) or _turned(_plain(desk, _back(rel)))
    if found is None:
        raise NoMethodError(
            Words(
                f"图上没有作出 {rel.key}：现有图解法对此机构求不出此量",
                f"{rel.key} was not drawn: no method on file gives it for this mechanism",
            )
            + _instead(desk, rel),
            code="not-drawn",
        )
    return found


def _instead(desk: Desk, asked: Rel) -> Words:
    """What to ask instead: the vectors of its kind that were drawn."""
    stand = (key for place, key in desk.board.ledger.vectors if place is polygon_of(asked))
    drawn = sorted(key for key in stand if key.startswith(f"{asked.kind.value}_"))
    return Words(f"；图上有 {', '.join(drawn)}", f"; drawn are {', '.join(drawn)}") if drawn else Words.same("")


def computed(desk: Desk, rel: Rel) -> Quantity | None:
    """The quantity itself where it was computed and laid off, of this vector, of its opposite, or of another point of a
    link that only translates, or of a sliding pair: it is not read again."""
    for one in (rel, _back(rel)):
        if one is not None:
            size = desk.size(_own(desk, one))
            if size is not None:
                return size
    return _translated(desk, _own(desk, rel)) or _of_pair(desk, rel)


def sized(desk: Desk, rel: Rel, symbol: str, ends: tuple[Points, Points], letters: str) -> Quantity:
    """How large a vector is, of which a line goes on: as it was computed or given; else it is measured, and so told."""
    known = computed(desk, rel)
    if known is not None:
        return replace(known, node=sym(symbol))
    on_paper = desk.board.measure(*ends, letters)
    return desk.board.compute(symbol, desk.board.mu(polygon_of(rel)) * on_paper, rel.kind.unit)


def _of_pair(desk: Desk, rel: Rel) -> Quantity | None:
    """The Coriolis term of a sliding pair, as it was computed at another of its points."""
    if rel.kind is not Kind.AK or rel.ref is None:
        return None
    slide = desk.slides.get((rel.to.link, rel.ref.link)) or desk.slides.get((rel.ref.link, rel.to.link))
    return None if slide is None else desk.size(Rel(Kind.AK, slide.to, slide.ref))


def _translated(desk: Desk, rel: Rel) -> Quantity | None:
    """What was laid off as the motion of one point of a link that only translates is that of all its points."""
    view, at = polygon_of(rel), rel.to
    carriers = [link.name for link in desk.mech.links if at.link == link.name or at.point in link.points]
    never = any((turn := desk.turns.get(omega(name))) is not None and turn.never for name in carriers)
    if rel.ref is not None or rel.kind not in (Kind.V, Kind.A) or not never or not desk.has_tip(view, at):
        return None
    ledger, tip = desk.board.ledger, desk.tip(view, at)
    same = (
        size
        for (place, key), size in ledger.laid.items()
        if size is not None
        and (stood := ledger.vectors.get((view, key))) is not None
        and place is view
        and not np.any(stood.start)
        and np.array_equal(stood.end, tip)
    )
    return next(same, None)


def _own(desk: Desk, rel: Rel) -> Rel:
    """The vector as it is drawn: of the points themselves."""
    return Rel(rel.kind, desk.canonical(rel.to), desk.canonical(rel.ref) if rel.ref else None)


def _drawn(desk: Desk, rel: Rel | None) -> Standing | None:
    """The vector itself, or from the tips of both its points."""
    if rel is None:
        return None
    own, view = _own(desk, rel), polygon_of(rel)
    if (stood := desk.stands(_as_drawn(desk, own))) is not None:
        return _lettered(desk, view, own, stood.ends)
    if rel.kind in (Kind.V, Kind.A) and desk.has_tip(view, own.to) and (own.ref is None or desk.has_tip(view, own.ref)):
        start = 0j if own.ref is None else desk.tip(view, own.ref)
        return _lettered(desk, view, own, (start, desk.tip(view, own.to)))
    return None


def _plain(desk: Desk, rel: Rel | None) -> Standing | None:
    """Where no link of the pair turns, or nothing slides, a^r is all the relative acceleration, and a^k is nothing."""
    if rel is None or rel.kind not in (Kind.AK, Kind.AR):
        return None
    own = _own(desk, rel)
    moves, whole = (desk.stands(Rel(kind, own.to, own.ref)) for kind in (Kind.V, Kind.A))
    if moves is None or (_turns(desk, rel) and abs(nominal(moves.ends[1] - moves.ends[0])) > NO_LENGTH):
        return None
    if rel.kind is Kind.AK:
        return View.ACCELERATION, 0j, 0j, "—"
    return None if whole is None else _lettered(desk, View.ACCELERATION, replace(own, kind=Kind.A), whole.ends)


def _turns(desk: Desk, rel: Rel) -> bool:
    """Whether either of the two links turns here."""
    found = (desk.turns.get(omega(at.link)) for at in (rel.to, rel.ref) if at is not None)
    return any(turn is not None and not turn.never and abs(float(nominal(turn.value))) > STILL for turn in found)


def _as_drawn(desk: Desk, rel: Rel) -> Rel:
    """The vector that was drawn for it: a^n of the first pin of a crank at constant speed is all its acceleration."""
    steady = (drive.link for drive in desk.mech.drives if not drive.slide and not drive.accel)
    pins = (At(pin) for link in steady for pin in desk.crank(link)[1][:1])
    return Rel(Kind.A, rel.to) if rel.kind is Kind.AN and rel.ref is None and rel.to in pins else rel


def _back(rel: Rel) -> Rel | None:
    """v_CB for v_BC."""
    return None if rel.ref is None else Rel(rel.kind, rel.ref, rel.to)


def _turned(found: Standing | None) -> Standing | None:
    if found is None:
        return None
    view, start, end, letters = found
    return view, end, start, " ".join(reversed(letters.split()))


def _sliding(desk: Desk, rel: Rel) -> Standing | None:
    """A relative vector of a sliding pair, as it was drawn at another of its points."""
    if rel.ref is None or rel.kind not in (Kind.V, Kind.AK, Kind.AR):
        return None
    ahead, back = (rel.to.link, rel.ref.link), (rel.ref.link, rel.to.link)
    slide = desk.slides.get(ahead) or desk.slides.get(back)
    if slide is None:
        return None
    other = Rel(rel.kind, slide.to, slide.ref)
    found = _drawn(desk, other) or _plain(desk, other)
    return found if ahead in desk.slides else _turned(found)


def _lettered(desk: Desk, view: View, rel: Rel, ends: tuple[Points, Points]) -> Standing:
    return view, *ends, lettered(desk, view, ends, _letters(desk, view, rel))


def _letters(desk: Desk, view: View, rel: Rel) -> str:
    """The letters that the ends have as a rule, v_B → p b: which stand there depends on what was drawn before."""
    start, end = desk.start_label(view, rel.ref), desk.tip_label(view, rel.to)
    if rel.kind in (Kind.V, Kind.A):
        return f"{start} {end}"
    k = desk.k_tip(Rel(Kind.AK, rel.to, rel.ref))
    return {Kind.AN: f"{start} n′", Kind.AT: f"n′ {end}", Kind.AK: f"{start} {k}", Kind.AR: f"{k} {end}"}[rel.kind]
