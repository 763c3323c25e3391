"""Further points of a link by the image principle: the figure on the polygon is similar, with the same letter order."""

from __future__ import annotations

import numpy as np

from ...algebra.formula import adjoined
from ...algebra.quantity import magnitude
from ...board.board import NO_LENGTH
from ...board.construction import View
from ...board.paper.marks import Dot, Role
from ...names import At, Kind, Rel, alpha, omega
from ...plane import Points, Reals, cross, nominal, similar
from ...vector.close import close
from ...vector.equation import UNKNOWN, Equation, Term
from ...words import Words
from ..desk import QUANTITY, VECTOR, Desk
from .lengths import write_lengths
from .terms import known, normal, plain_symbol, ref_at
from .turning_said import turning_said

_ONE_PLACE = 1e-6  # mm on paper: nearer points have no direction from one to the other


def known_tips(desk: Desk, view: View, link: str) -> list[tuple[str, At]]:
    """Points thought on this link whose vectors are drawn: (letter, which point), at different places."""
    found: list[tuple[str, At]] = []
    places: list[complex] = []
    own = [At(p) for p in desk.letters(link)]
    passed = [at for at in desk.tips(view) if at.link == link]
    for at in (*own, *passed):
        place = complex(nominal(desk.where(at))) if {at.point, str(at)} & set(desk.at) else None
        if place is None or not desk.has_tip(view, at) or any(abs(place - p) < _ONE_PLACE for p in places):
            continue
        found.append((at.point, at))
        places.append(place)
    return found


def imaged(desk: Desk, view: View, link: str, at: At) -> None:
    """Find one point's vector: by the image of the link, by translation, or from ω (and α) about a known point."""
    held = known_tips(desk, view, link)
    turn = desk.turns[omega(link)]
    if turn.never and held:
        desk.board.plot(view, desk.put_tip(view, at, desk.tip(view, held[0][1])), desk.tip_label(view, at))
    elif len(held) >= 2 and _is_one(desk, view, held[0][1], held[1][1]):
        _all_alike(desk, view, link, at, held)
    elif len(held) >= 2:
        _by_image(desk, view, link, at, held)
    elif held and abs(complex(nominal(desk.where(at) - desk.where(held[0][1])))) < _ONE_PLACE:
        _at_one_place(desk, view, link, at, held[0][1])
    elif held:
        _by_turning(desk, view, link, at, held[0][1])


def found_tip(desk: Desk, view: View, at: At) -> Points:
    """End of the vector of a link's point on a polygon; found by the image where it is missing."""
    own = desk.canonical(at)
    if not desk.has_tip(view, own):
        imaged(desk, view, at.link, own)
    return desk.tip(view, own)


def images_of_link(desk: Desk, view: View, link: str) -> None:
    """All lettered points of the link that are still missing on the polygon."""
    for name in desk.mech.link(link).points:
        if not desk.has_tip(view, At(name)):
            imaged(desk, view, link, At(name))


def _by_image(desk: Desk, view: View, link: str, at: At, held: list[tuple[str, At]]) -> None:
    (p, p_at), (q, q_at) = held[0], held[1]
    board, named = desk.board, _named(desk, link, at)
    x = at.point if named.en else desk.name(at)
    letters = [desk.tip_label(view, a) for a in (p_at, q_at, at)]
    kind, kind_en = QUANTITY[view].zh, QUANTITY[view].en
    a, b, c = letters
    if _in_line(desk, p_at, q_at, at):
        three = (p_at, q_at, at)
        one, two = _between(desk, three, f"{p}{q}", f"{q}{p}"), _between(desk, three, adjoined(a, b), adjoined(b, a))
        ratio = f"${adjoined(a, c)} : {adjoined(a, b)} = {p}{x} : {p}{q}$"
        words = Words(
            f"求 ${x}$ 点{named.zh}的{kind}（{kind}影像法）：${x}$ 在{one.zh}上，按 {ratio} 在{two.zh}上定出影像点 "
            f"${c}$。",
            f"{kind_en.capitalize()} image: since ${x}$ lies on {one.en}, ${c}$ lies on {two.en} with {ratio}."
            f"{named.en}",
        )
    else:
        words = Words(
            f"求构件 {link} 上 ${x}$ 点{named.zh}的{kind}（{kind}影像法）：作 $△{adjoined(a, b, c)} ∽ △{p}{q}{x}$，"
            f"字母绕行顺序相同，得影像点 ${c}$。",
            f"{kind_en.capitalize()} image of link {link}: the triangle ${adjoined(a, b, c)}$, similar to "
            f"${p}{q}{x}$ with its letters in the same order, gives ${c}$.{named.en}",
        )
    board.step(words, view)
    letter_at_pole(desk, view, p_at, q_at)
    tips = desk.tip(view, p_at), desk.tip(view, q_at)
    corners = desk.where(p_at), desk.where(q_at), desk.where(at)
    corner = desk.put_tip(view, at, board.image(corners, tips))
    for tip in tips:
        board.join(view, tip, corner, Role.DIRECTION)
    board.join(view, tips[0], tips[1], Role.DIRECTION)
    board.tint(view, (*tips, corner))
    board.plot(view, corner, letters[2])
    board.arrow(view, 0j, corner, Role.RESULT, key=desk.key(Rel(VECTOR[view], at)))


def _named(desk: Desk, link: str, at: At) -> Words:
    """What the point is called where the link is pinned to a block, under whose number it has its letter: F_4."""
    owner, name = at.link or desk.coincident.get(at.point, ""), desk.name(at)
    if owner in ("", link) or owner not in desk.mech.bodies:
        return Words("", "")
    return Words(
        f"（也是构件 {owner} 上的 ${name}$）", f" The pin ${at.point}$ is also the point ${name}$ of link {owner}."
    )


def _is_one(desk: Desk, view: View, p: At, q: At) -> bool:
    """Whether two tips are one: no figure similar to the link stands on them."""
    return abs(complex(nominal(desk.tip(view, q) - desk.tip(view, p)))) < NO_LENGTH


def _all_alike(desk: Desk, view: View, link: str, at: At, held: list[tuple[str, At]]) -> None:
    """v_X = v_P: two points of the link have one vector, and so has every other."""
    board, label, (p_at, q_at) = desk.board, desk.tip_label(view, at), (one for _, one in held[:2])
    one, other = desk.tip_label(view, p_at), desk.tip_label(view, q_at)
    board.step(
        Words(
            f"${other}$ 与 ${one}$ 重合，此时构件 {link} 上各点的{QUANTITY[view].zh}相同，故 ${label}$ 也与之重合。",
            f"Point ${other}$ coincides with ${one}$: all points of link {link} have the same {QUANTITY[view].en} "
            f"here, so ${label}$ coincides with them, too.",
        ),
        view,
    )
    letter_at_pole(desk, view, p_at, q_at)
    corners = desk.where(p_at), desk.where(q_at), desk.where(at)
    tip = desk.put_tip(view, at, similar(*corners, desk.tip(view, p_at), desk.tip(view, q_at)))
    board.plot(view, tip, label)
    board.arrow(view, 0j, tip, Role.RESULT, key=desk.key(Rel(VECTOR[view], at)))


def _between(desk: Desk, at: tuple[At, At, At], line: str, back: str) -> Words:
    """The line from the first point to the second; produced, where the third lies beyond one of them."""
    p, q, x = (complex(nominal(desk.where(one))) for one in at)
    part = ((x - p) / (q - p)).real
    if 0.0 <= part <= 1.0:
        return Words(f" ${line}$ ", f"${line}$")
    beyond = line if part > 1.0 else back
    return Words(f" ${beyond}$ 的延长线", f"${beyond}$ produced")


def letter_at_pole(desk: Desk, view: View, *points: At) -> None:
    """Points at rest have their letters at the pole, once a construction speaks of them."""
    for at in points:
        if desk.at_rest(view, at):
            desk.board.plot(view, 0j, desk.tip_label(view, at), Dot.NONE)


def _in_line(desk: Desk, p: At, q: At, x: At) -> bool:
    """Whether three points of a link lie on one straight line."""
    a, b, c = (complex(nominal(desk.where(at))) for at in (p, q, x))
    return abs(float(cross(b - a, c - a))) < 1e-6 * abs(b - a) * abs(c - a)


def _at_one_place(desk: Desk, view: View, link: str, at: At, held: At) -> None:
    """v_X = v_P, a_X = a_P: X stands at the very place of P in this position."""
    board, x, p = desk.board, desk.name(at), desk.name(held)
    label, there = desk.tip_label(view, at), desk.tip_label(view, held)
    board.step(
        Words(
            f"此位置上 ${x}$ 与构件 {link} 上的 ${p}$ 重合，故 ${label}$ 与 ${there}$ 重合。",
            f"In this position ${x}$ coincides with ${p}$ of link {link}, so ${label}$ coincides with ${there}$.",
        ),
        view,
    )
    letter_at_pole(desk, view, held)
    tip = desk.put_tip(view, at, desk.tip(view, held))
    board.plot(view, tip, label)
    board.arrow(view, 0j, tip, Role.RESULT, key=desk.key(Rel(VECTOR[view], at)))


def _by_turning(desk: Desk, view: View, link: str, at: At, held: At) -> None:
    """v_X = v_P + ω × PX, or a_X = a_P + a^n + a^t, all known: the vector of X is the closing side."""
    board, label = desk.board, desk.tip_label(view, at)
    board.step(turning_said(desk, view, link, at, held), view)
    rests = ref_at(desk, view, held, link) is None
    terms = (*(() if rests else (known(desk, view, held),)), *_turning_terms(desk, view, link, at, held))
    rel = Rel(VECTOR[view], desk.canonical(at))
    left = Term(rel=rel, symbol=desk.symbol(rel), direction=UNKNOWN, magnitude="?", tip="")
    eq = Equation(left=(left,), right=terms)
    if len(terms) > 1:
        board.equate(eq.table())
    closed = close(board, view, 0j, eq, to=label, of=desk.canonical(at))
    write_lengths(desk, view, eq)
    desk.reach_tip(view, at, closed.meeting)
    board.plot(view, closed.meeting, label)


def _turning_terms(desk: Desk, view: View, link: str, at: At, held: At) -> tuple[Term, ...]:
    """v_XP = ω l, or a^n_XP and a^t_XP: P is a pivot, a pin of the link,
    or its point under which another link slides or rolls."""
    p, x, ref = held.point, at.point, ref_at(desk, view, held, link)
    if view is View.VELOCITY:
        rel = Rel(Kind.V, desk.canonical(at), ref)
        return (_laid(desk, view, rel, link, p, x, desk.turns[omega(link)].value),)
    n = normal(desk, at, held, link, further=True)
    accel = desk.turns[alpha(link)]
    if accel.never or not np.any(accel.value):
        return (n,)
    return n, _laid(desk, view, Rel(Kind.AT, desk.canonical(at), ref), link, p, x, accel.value)


def _laid(desk: Desk, view: View, rel: Rel, link: str, p: str, x: str, rate: Reals) -> Term:
    """A vector perpendicular to PX of known magnitude and sense: ω l or α l."""
    length = desk.length(p, x)
    way = np.sign(rate)
    along = 1j * way * desk.towards(p, x)
    along = np.where(way == 0, 1.0, along)
    greek = "ω" if view is View.VELOCITY else "α"
    factor = magnitude(f"{greek}_{link}", np.abs(rate), "rad/s")
    size = desk.board.compute(desk.symbol(rel), factor * length, rel.kind.unit)
    return Term(
        rel=rel,
        symbol=desk.symbol(rel),
        direction=Words.same(f"⊥$ {p}{x}$"),
        magnitude=f"${greek}_{link} {plain_symbol(length)}$",
        along=along[()],
        mm=desk.board.to_paper(view, size.value),
    )
