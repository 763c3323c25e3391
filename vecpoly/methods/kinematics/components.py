"""Normal and tangential component of a relative acceleration that no equation needed:
drawn because they are asked for."""

from __future__ import annotations

from ...board.construction import View
from ...board.paper.marks import Role
from ...mechanism.model import FRAME
from ...names import At, Kind, Rel, omega
from ...words import Words
from ..desk import Desk
from .terms import normal, ref_at

_VIEW = View.ACCELERATION


def draw_components(desk: Desk, rel: Rel) -> None:
    """a_CB (or a_C, about the fixed pivot) split:
    a^n_CB = ω² l from C towards B, a^t_CB from its tip to c'. Nothing where a link is missing."""
    link, about = _link(desk, rel)
    to = desk.canonical(rel.to)
    known = (
        link
        and about is not None
        and omega(link) in desk.turns
        and desk.has_tip(_VIEW, to)
        and desk.has_tip(_VIEW, about)
    )
    ref = None if about is None else ref_at(desk, _VIEW, about, link)
    parts_of = [Rel(kind, to, ref) for kind in (Kind.AN, Kind.AT)]
    if not known or about is None or all(desk.stands(part) for part in parts_of) or to.point == about.point:
        return
    board, start, end = desk.board, desk.tip(_VIEW, about), desk.tip(_VIEW, to)
    whole, parts = desk.symbol(Rel(Kind.A, to, ref)), [desk.symbol(Rel(kind, to, ref)) for kind in (Kind.AN, Kind.AT)]
    board.step(
        Words(
            f"将 ${whole}$ 分解为 ${parts[0]}$ 和 ${parts[1]}$。",
            f"Resolve ${whole}$ into ${parts[0]}$ and ${parts[1]}$.",
        ),
        _VIEW,
    )
    term = normal(desk, to, about, link, further=True)
    assert term.along is not None and term.mm is not None
    foot = board.lay_off(start, term.along, term.mm, key=desk.key(parts_of[0]))
    board.arrow(_VIEW, start, foot, Role.GIVEN, key=desk.key(parts_of[0]))
    board.arrow(_VIEW, foot, end, Role.RESULT, key=desk.key(parts_of[1]))
    if term.tip:
        board.plot(_VIEW, foot, term.tip)


def _link(desk: Desk, rel: Rel) -> tuple[str, At | None]:
    """The link that carries both letters, and the second of them; of a_C the fixed pivot of C's link."""
    to = desk.canonical(rel.to)
    carriers = [to.link] if to.link else [name for name in desk.mech.links_at(to.point) if name != FRAME]
    for name in carriers:
        points = desk.mech.link(name).points
        if rel.ref is None:
            pivot = next((p for p in points if p in desk.mech.frame and p != to.point), None)
            if pivot is not None:
                return name, At(pivot)
        elif desk.canonical(rel.ref).point in points or desk.canonical(rel.ref).link == name:
            return name, desk.canonical(rel.ref)
    return "", None
