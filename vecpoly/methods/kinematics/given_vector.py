"""Points of a link with a given velocity or acceleration, read back from the polygon (zero:
instant centre, acceleration pole)."""

from __future__ import annotations

from ...algebra.formula import adjoined
from ...board.board import NO_LENGTH
from ...board.construction import View
from ...board.paper.marks import Dot, Role
from ...errors import NoMethodError
from ...names import Rel
from ...plane import nominal, similar
from ...problem.asked.asks import AskPoint
from ...words import Words
from ..desk import POLE, VECTOR, Desk
from .image import known_tips, letter_at_pole


def find_point(desk: Desk, ask: AskPoint) -> None:
    """X on the link is where triangle P Q X is similar to p q x, x being the tip of the given vector.

    Raises NoMethodError where the link only translates: then no single point has that vector.
    """
    view = View.VELOCITY if ask.velocity is not None else View.ACCELERATION
    wanted = ask.velocity if ask.velocity is not None else ask.acceleration
    assert wanted is not None
    held = known_tips(desk, view, ask.link)
    if len(held) < 2:
        raise NoMethodError(
            Words(
                f"{ask.name}：构件 {ask.link} 在多边形上的已知点不足两个；请在该构件上另设一点",
                f"{ask.name}: fewer than two points of link {ask.link} are known on the polygon; set out "
                "another point on it",
            )
        )
    (p, p_at), (q, q_at) = held[0], held[1]
    tips = desk.tip(view, p_at), desk.tip(view, q_at)
    if abs(complex(nominal(tips[1] - tips[0]))) < NO_LENGTH:
        raise NoMethodError(
            Words(
                f"{ask.name}：构件 {ask.link} 上各点此时的矢量相同",
                f"{ask.name}: all points of link {ask.link} have the same vector at this instant",
            )
        )
    board = desk.board
    letter_at_pole(desk, view, p_at, q_at)
    tip = board.to_paper(view, 1.0) * wanted
    letter = desk.tip_label(view, ask.at)
    board.step(_words(ask, view, p, q, [desk.tip_label(view, a) for a in (p_at, q_at)], letter), view)
    desk.letter(ask.name, similar(tips[0], tips[1], tip, desk.at[p], desk.at[q]) + board.hand.carry(0.0))
    tip = desk.put_tip(view, ask.at, tip)
    for corner in (p, q):
        board.join(View.MECHANISM, desk.at[corner], desk.at[ask.name], Role.HIDDEN)
    board.plot(View.MECHANISM, desk.at[ask.name], f"{ask.name[0]}_{ask.name[1:]}", Dot.POINT)
    if wanted:
        board.arrow(view, 0j, tip, Role.RESULT, key=desk.key(Rel(VECTOR[view], ask.at)))
    board.plot(view, tip, letter)


def _words(ask: AskPoint, view: View, p: str, q: str, tips: list[str], letter: str) -> Words:
    pole = POLE[view]
    name = f"{ask.name[0]}_{ask.name[1:]}"
    value = ask.velocity if view is View.VELOCITY else ask.acceleration
    if not value:
        kind, kind_en = ("绝对瞬心", "instant centre") if view is View.VELOCITY else ("加速度中心", "acceleration pole")
        return Words(
            f"构件 {ask.link} 的{kind} ${name}$：其影像即极点 ${pole}$。在机构图上作 $△{p}{q}{name} ∽ "
            f"△{adjoined(*tips, pole)}$，字母绕行顺序相同。",
            f"The {kind_en} ${name}$ of link {ask.link}: its image is the pole ${pole}$. On the "
            f"diagram make triangle ${p}{q}{name}$ similar to ${adjoined(*tips, pole)}$, "
            "letters in the same order.",
        )
    return Words(
        f"在多边形上由极点 ${pole}$ 作给定矢量，得 ${letter}$；在机构图上作 $△{p}{q}{name} ∽ △"
        f"{adjoined(*tips, letter)}$，得构件 {ask.link} 上的 ${name}$。",
        f"Lay the given vector off from ${pole}$ to ${letter}$; on the diagram make triangle "
        f"${p}{q}{name}$ similar to ${adjoined(*tips, letter)}$: the point ${name}$ of link "
        f"{ask.link}.",
    )
