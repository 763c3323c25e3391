"""A rack that slides without turning: its pitch point moves as any other of its points."""

from __future__ import annotations

from ....board.construction import View
from ....board.paper.marks import Dot
from ....names import At, Kind, Rel
from ....words import Words
from ...desk import Desk

_CALLED = {View.VELOCITY: Words("速度", "velocity"), View.ACCELERATION: Words("加速度", "acceleration")}
_KIND = {View.VELOCITY: Kind.V, View.ACCELERATION: Kind.A}


def letter_translated(desk: Desk, view: View, link: str, own: At) -> None:
    """Letter the tip of a point of a link that does not turn, and tell beside which other it falls."""
    label = desk.tip_label(view, own)
    known = (At(letter) for letter in desk.mech.link(link).points if letter != own.point)
    base = next((at for at in known if desk.is_tip(view, desk.canonical(at)) and desk.name(at) != desk.name(own)), None)
    if base is not None:
        called, symbols = _CALLED[view], [desk.symbol(Rel(_KIND[view], at)) for at in (own, base)]
        equal, other = " = ".join(symbols), desk.tip_label(view, base)
        desk.board.step(
            Words(
                f"构件 {link} 不转动，其上各点{called.zh}相同：${equal}$，${label}$ 与 ${other}$ 重合。",
                f"Link {link} does not turn: all its points have the same {called.en}, ${equal}$, and ${label}$ "
                f"coincides with ${other}$.",
            ),
            view,
        )
    desk.board.plot(view, desk.tip(view, own), label, Dot.NONE)
