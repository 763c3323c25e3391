"""A parallelogram ABCD: the coupler BC stays parallel to AD and CD to AB,
so that no equation is needed, not even in one line with A."""

from __future__ import annotations

from ....board.construction import View
from ....board.paper.marks import Role
from ....mechanism.assembly.branch import margin
from ....mechanism.assembly.four_bar import fourth_corner
from ....mechanism.assembly.statements import Form
from ....mechanism.groups.assur import Dyad
from ....mechanism.model import FRAME, Revolute, Shaped
from ....names import At, Rel, alpha, omega
from ....plane import nominal
from ....vector.equation import UNKNOWN, Equation, Term
from ....words import Words
from ...desk import QUANTITY, VECTOR, Desk, Turn
from ..chains import never_turns
from ..image import imaged, images_of_link
from ..terms import ABSENT, known


def is_parallelogram(desk: Desk, d: Dyad) -> bool:
    """Whether the group is drawn as the half of a parallelogram whose other half is the two links on which it hangs."""
    corner = fourth_corner(desk.mech, d)
    if corner is None:
        return False
    b, c, end = _pins(d)
    drawn = {letter: complex(nominal(desk.at[letter])) for letter in (corner, b, c, end)}
    return _is_said(desk, d) or margin(Shaped(corners=(corner, b, c, end), form=Form.PARALLELOGRAM), drawn) > 0


def step_off(desk: Desk, d: Dyad) -> bool:
    """Draw BC parallel and equal to AD where the problem says that ABCD is a parallelogram; whether it does."""
    corner = fourth_corner(desk.mech, d)
    if corner is None or not _is_said(desk, d):
        return False
    b, c, end = _pins(d)
    board, length = desk.board, desk.mm(abs(desk.mech.link(d.link_j).points[c] - desk.mech.link(d.link_j).points[b]))
    board.step(
        Words(
            f"${corner}{b}{c}{end}$ 为平行四边形：过 ${b}$ 作 ${corner}{end}$ 的平行线，"
            f"截取 ${b}{c} = {corner}{end}$，得 ${c}$。",
            f"The quadrilateral ${corner}{b}{c}{end}$ is a parallelogram: through ${b}$ draw a line parallel to "
            f"${corner}{end}$ and step off ${b}{c} = {corner}{end}$ on it.",
        ),
        View.MECHANISM,
    )
    desk.letter(c, board.lay_off(desk.at[b], desk.towards(corner, end), length))
    board.join(View.MECHANISM, desk.at[b], desk.at[c], Role.CONSTRUCTION)
    desk.settle(d.link_j, (b, c))
    desk.settle(d.link_k, (end, c))
    return True


def move_parallelogram(desk: Desk, view: View, d: Dyad) -> None:
    """ω_BC = ω_AD and ω_CD = ω_AB, and so α; with AD at rest the coupler translates: v_C = v_B, a_C = a_B."""
    b, c, end = _pins(d)
    letter = "ω" if view is View.VELOCITY else "α"
    pairs = ((d.link_j, d.parent_k), (d.link_k, d.parent_j))
    fixed = [link for link, along in pairs if along == FRAME]
    corners = f"{fourth_corner(desk.mech, d)}{b}{c}{end}"
    words = Words(
        f"${corners}$ 为平行四边形，对边始终平行，",
        f"The quadrilateral ${corners}$ is a parallelogram, whose opposite sides remain parallel: ",
    )
    if fixed:
        coupler, held = (d.link_j, b) if fixed[0] == d.link_j else (d.link_k, end)
        turning = (d.link_k, d.parent_j) if coupler == d.link_j else (d.link_j, d.parent_k)
        vectors = [desk.symbol(Rel(VECTOR[view], desk.canonical(At(p)))) for p in (c, held)]
        words += Words(
            f"连杆 {coupler} 作平动，各点{QUANTITY[view].zh}相同：${vectors[0]}$ = ${vectors[1]}$；"
            f"$ {letter}_{turning[0]}$ = $ {letter}_{turning[1]}$。",
            f"link {coupler} translates, so all its points have the same {QUANTITY[view].en}, "
            f"${vectors[0]}$ = ${vectors[1]}$, and $ {letter}_{turning[0]}$ = $ "
            f"{letter}_{turning[1]}$.",
        )
    else:
        coupler = d.link_j
        words += Words(
            f"故 $ {letter}_{d.link_j}$ = $ {letter}_{d.parent_k}$，$ {letter}_{d.link_k}$ = $ "
            f"{letter}_{d.parent_j}$。",
            f"so $ {letter}_{d.link_j}$ = $ {letter}_{d.parent_k}$ and $ {letter}_{d.link_k}$ = "
            f"$ {letter}_{d.parent_j}$.",
        )
    desk.board.step(words, view)
    for link, along in pairs:
        _turn_as(desk, view, link, along)
    if fixed:
        _equate(desk, view, c, b if coupler == d.link_j else end)
    _reach(desk, view, coupler, c)
    for link in (d.link_j, d.link_k):
        images_of_link(desk, view, link)
    for further in [p for p in desk.mech.link(coupler).points if fixed and p not in (b, c, end)]:
        desk.board.plot(view, desk.tip(view, At(further)), desk.tip_label(view, At(further)))


def _equate(desk: Desk, view: View, c: str, b: str) -> None:
    """v_C = v_B + v_CB with v_CB = 0, written with its rows; what is zero needs no line."""
    kind = VECTOR[view]
    whole, turned = Rel(kind, At(c)), Rel(kind, At(c), At(b))
    left = Term(rel=whole, symbol=desk.symbol(whole), direction=UNKNOWN, magnitude="?")
    none = Term(rel=turned, symbol=desk.symbol(turned), direction=ABSENT, magnitude="0", vector=0j, drawn=True)
    desk.board.equate(Equation(left=(left,), right=(known(desk, view, At(b)), none)).table())


def _reach(desk: Desk, view: View, coupler: str, c: str) -> None:
    """The tip of C on the polygon, lettered."""
    imaged(desk, view, coupler, At(c))
    tip = desk.tip(view, At(c))
    desk.board.plot(view, tip, desk.tip_label(view, At(c)))


def _turn_as(desk: Desk, view: View, link: str, along: str) -> None:
    """Both links turn alike: concluded in the step that says why."""
    if along == FRAME:
        never_turns(desk, link)
        return
    of, unit = (omega, "rad/s") if view is View.VELOCITY else (alpha, "rad/s^2")
    own, first = of(link), desk.turns[of(along)]
    value = first.value if first.never else desk.board.conclude(own.key, first.value, unit)
    desk.turns[own] = Turn(value, first.never, first.same or of(along))


def _pins(d: Dyad) -> tuple[str, str, str]:
    assert isinstance(d.inner, Revolute) and isinstance(d.outer_j, Revolute) and isinstance(d.outer_k, Revolute)
    return d.outer_j.point, d.inner.point, d.outer_k.point


def _is_said(desk: Desk, d: Dyad) -> bool:
    letters = {fourth_corner(desk.mech, d), *_pins(d)}
    return any(
        isinstance(s, Shaped) and s.form is Form.PARALLELOGRAM and set(s.letters) == letters for s in desk.mech.branches
    )
