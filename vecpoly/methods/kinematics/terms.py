"""Terms of the velocity and acceleration equations, with the words of their direction and magnitude rows."""

from __future__ import annotations

import numpy as np

from ...algebra.quantity import Quantity, Times, magnitude
from ...board.board import NO_LENGTH
from ...board.construction import View
from ...diagram.cams.contact import contact_replaced
from ...mechanism.model import FRAME, Prismatic
from ...names import At, Kind, Rel, omega
from ...plane import Points, nominal
from ...vector.equation import KNOWN, Term
from ...words import Words
from ..desk import VECTOR, Desk, Turn
from ..standing import sized

ABSENT = Words.same("—")


def known(desk: Desk, view: View, at: At) -> Term:
    """A vector already on the polygon: direction and magnitude both known."""
    rel = Rel(VECTOR[view], desk.canonical(at))
    vector = desk.tip(view, at)
    is_zero = desk.at_rest(view, at) or abs(nominal(vector)) < NO_LENGTH
    unsaid = (ABSENT, "0") if is_zero else (KNOWN, "✓")
    direction, size = desk.known_as.get((view, rel.to), unsaid)
    return Term(rel=rel, symbol=desk.symbol(rel), vector=vector, drawn=True, direction=direction, magnitude=size)


def across(desk: Desk, rel: Rel, p: str, q: str) -> Term:
    """A vector perpendicular to the drawn line PQ, its magnitude unknown: v_QP or a^t_QP of a turning link."""
    return Term(
        rel=rel,
        symbol=desk.symbol(rel),
        direction=Words.same(f"⊥$ {p}{q}$"),
        magnitude="?",
        along=1j * desk.towards(p, q),
    )


def sliding(desk: Desk, rel: Rel, joint: Prismatic) -> Term:
    """A vector along the drawn guide, its magnitude unknown: v^r or a^r of a sliding pair."""
    name = guide_name(desk, joint)
    if rel.ref is not None:
        _note_slide(desk, joint, rel.to, rel.ref)
    return Term(rel=rel, symbol=desk.symbol(rel), direction=name, magnitude="?", along=desk.guide_line(joint).along)


def _note_slide(desk: Desk, joint: Prismatic, to: At, ref: At) -> None:
    """Remember under which key the relative motion of a sliding pair was drawn, and of which link against which."""
    pair = joint.guide, joint.block
    upper = to.link if to.link in pair else pair[pair.index(ref.link) - 1] if ref.link in pair else ""
    if upper:
        desk.slides[upper, pair[pair.index(upper) - 1]] = Rel(Kind.V, to, ref)


def guide_name(desk: Desk, joint: Prismatic) -> Words:
    """∥ the guide, by two letters on it where there are two, else in words; a face that a disc touches is no guide."""
    letters = [joint.pin, *desk.mech.link(joint.guide).points]
    on_line = [p for p in dict.fromkeys(letters) if _on_guide(desk, joint, p)]
    if joint.guide != FRAME and len(on_line) >= 2:
        return Words.same(f"∥$ {on_line[1]}{on_line[0]}$")
    flat = contact_replaced(desk.mech, joint.block) is not None
    return Words("∥平底", "∥face") if flat else Words("∥导路", "∥guide")


def _on_guide(desk: Desk, joint: Prismatic, point: str) -> bool:
    """Whether a lettered point lies on the line of the guide."""
    link = joint.block if point == joint.pin else joint.guide
    return abs(desk.offset(joint, link, point)) < 1e-12


def normal(desk: Desk, at: At, about: At, link: str, *, further: bool = False) -> Term:
    """a^n = ω² l, from the point towards the reference point; computed, then laid off to μ_a. further: the link may
    have another one that was laid off before."""
    rel = Rel(Kind.AN, desk.canonical(at), ref_at(desk, View.ACCELERATION, about, link))
    return normal_of(desk, rel, about.point, link, desk.further_n_tip(link) if further else desk.n_tip(link))


def normal_of(desk: Desk, rel: Rel, about: str, link: str, tip: str) -> Term:
    """The normal acceleration of two points of a link; tip: the letter at its end on the polygon."""
    turn, q, sign = desk.turns[omega(link)], rel.to.point, desk.symbol(rel)
    length = desk.length(about, q)
    w = magnitude(f"ω_{link}", np.abs(turn.value), "rad/s")
    at_rest = abs(nominal(turn.value)) < 1e-12
    size = w.squared() * length
    value = size.value
    if not at_rest:
        value = desk.board.compute(sign, size, "m/s^2").value
    return Term(
        rel=rel,
        symbol=sign,
        direction=ABSENT if at_rest else Words.same(f"${q}→{about}$"),
        magnitude="0" if at_rest else f"$ω_{link}^2 {plain_symbol(length)}$",
        along=desk.towards(q, about),
        mm=desk.board.to_paper(View.ACCELERATION, value),
        tip="" if at_rest else tip,
    )


def tangential(desk: Desk, at: At, about: At, link: str) -> Term:
    """a^t = α l: perpendicular to the line, magnitude unknown."""
    return across(
        desk, Rel(Kind.AT, desk.canonical(at), ref_at(desk, View.ACCELERATION, about, link)), about.point, at.point
    )


def coriolis(desk: Desk, to: At, ref: At, link: str) -> Term:
    """a^k = 2 ω v_r: v_r turned by 90° in the sense of ω; it does not exist where ω or v_r is zero."""
    board, turn = desk.board, desk.turns[omega(link)]
    rel = Rel(Kind.AK, desk.canonical(to), desk.canonical(ref))
    sign = desk.symbol(rel)
    relative = Rel(Kind.V, rel.to, rel.ref)
    stood = desk.stands(relative)
    assert stood is not None
    v_rel = stood.ends
    letters = f"{desk.start_label(View.VELOCITY, ref)} {desk.tip_label(View.VELOCITY, to)}"
    vr = sized(desk, relative, desk.symbol(relative), v_rel, letters)
    expr = Times(2, magnitude(f"ω_{link}", np.abs(turn.value), "rad/s") * vr)
    size = board.compute(sign, expr, "m/s^2")
    vanishes = abs(nominal(expr.value)) < 1e-12
    along = _turned(v_rel[1] - v_rel[0], turn)
    board.remark(_coriolis_words(sign, plain_symbol(vr), link, nominal(turn.value), nominal(abs(v_rel[1] - v_rel[0]))))
    return Term(
        rel=rel,
        symbol=sign,
        magnitude="0" if vanishes else f"$2ω_{link} {plain_symbol(vr)}$",
        direction=ABSENT if vanishes else Words.same(f"⊥$ {plain_symbol(vr)}$"),
        along=along,
        mm=board.to_paper(View.ACCELERATION, size.value),
        tip="" if vanishes else desk.k_tip(rel),
    )


def plain_symbol(quantity: Quantity) -> str:
    """The quantity's symbol in the short notation."""
    node = quantity.node
    sub, sup = getattr(node, "sub", ""), getattr(node, "sup", "")
    return f"{getattr(node, 'base', '')}" + (f"^{sup}" if sup else "") + (f"_{{{sub}}}" if sub else "")


def _turned(vector: Points, turn: Turn) -> Points:
    """The unit vector turned by 90° in the sense of ω."""
    size = np.abs(vector)
    along = np.where(size > NO_LENGTH, vector / np.maximum(size, NO_LENGTH), 1.0)
    result = 1j * np.where(turn.value < 0, -1, 1) * along
    return result[()]


def _coriolis_words(sign: str, v: str, link: str, w: float, size: float) -> Words:
    if abs(w) < 1e-12:
        return Words(f"此瞬时 $ω_{link}$ = 0，故 ${sign}$ = 0。", f" At this instant $ω_{link}$ = 0, so ${sign}$ = 0.")
    if size < NO_LENGTH:
        return Words(f"此瞬时 ${v}$ = 0，故 ${sign}$ = 0。", f" At this instant ${v}$ = 0, so ${sign}$ = 0.")
    way, way_en = ("逆时针", "counter-clockwise") if w > 0 else ("顺时针", "clockwise")
    return Words(
        f"将 ${v}$ 沿 $ω_{link}$ 的转向（{way}）转过 90°，即得哥氏加速度 ${sign}$ 的方向。",
        f" Turning ${v}$ by 90° in the sense of $ω_{link}$ ({way_en}) gives the direction of the "
        f"Coriolis term ${sign}$.",
    )


def ref_at(desk: Desk, view: View, about: At, link: str) -> At | None:
    """The reference point of a turning link, none where it is a fixed pivot.

    Of a pitch point, whose accelerations differ, it is the link's own;
    D2, a point of a link that slides over the pivot D, is no pivot.
    """
    own = At(about.point, link)
    if view is View.ACCELERATION and desk.is_tip(view, own):
        return own
    return None if desk.at_rest(view, about) else desk.canonical(about)
