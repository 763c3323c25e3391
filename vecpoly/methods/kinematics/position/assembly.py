"""Which of two meeting points is meant: the branch statement of the problem, read on the drawing."""

from __future__ import annotations

from collections.abc import Mapping
from typing import assert_never

from ....errors import AssemblyError, DeadPointError
from ....mechanism.assembly.branch import margin, nearer, not_yet
from ....mechanism.model import FRAME, Shaped, Side, SideOf, Statement
from ....plane import Points, nominal
from ....words import Words
from ...desk import Desk

HAIR = 1e-7  # of the mechanism's size: meeting points nearer than this are one point
_SIDE = {"left": "左侧", "right": "右侧", "above": "上方", "below": "下方"}
_EN = {"left": "to the left of", "right": "to the right of", "above": "above", "below": "below"}


def choose(
    desk: Desk, point: str, links: tuple[str, ...], pair: tuple[Points, Points]
) -> tuple[Points, Statement | None]:
    """The meeting point that fulfils the statements about this group, and the statement that decided; on paper for
    another position of the drive the one that is carried on.

    Raises AssemblyError when both or neither do: the text says which words would help.
    """
    first, second = (complex(nominal(p)) for p in pair)
    hair = HAIR * desk.mm(desk.mech.scale)
    if abs(first - second) < hair:
        raise DeadPointError(
            Words(
                f"构件 {'、'.join(links)}：{point} 的两个交点重合，此为死点或转折点位置；请另取原动件位置",
                f"links {' and '.join(links)}: the two meeting points for {point} coincide; this is a dead "
                "point or change point, choose another input position",
            )
        )
    drawn = {name: complex(nominal(p)) for name, p in desk.at.items()}
    trials = [_with_point(desk, drawn, point, links, at) for at in (first, second)]
    new = set(trials[0]) - set(drawn)
    about = [s for s in desk.mech.branches if set(s.letters) <= set(trials[0]) and set(s.letters) & new]
    near, key = nearer(*in_metres(desk, trials), 1e-6 * desk.mech.scale), (point, *links)
    if desk.sides.is_kept and (carried := desk.sides.carry(key, near)) is not None:
        return pair[carried], None
    holds, fits = _fulfilled(desk, about, trials, 1e-2 * hair)
    if all(fits) and near is not None:
        return pair[desk.sides.take(key, near)], None
    if not about or fits[0] == fits[1]:
        early = None if about else not_yet(desk.mech.branches, point, trials[0])
        raise AssemblyError(_which(point, links, desk, about, early))
    deciding = next(s for s, a, b in zip(about, *holds, strict=True) if a != b)
    return pair[desk.sides.take(key, 0 if fits[0] else 1)], deciding


def _fulfilled(
    desk: Desk, about: list[Statement], trials: list[dict[str, complex]], hair: float
) -> tuple[list[list[bool]], list[bool]]:
    """Which statements hold for either meeting point, and whether all do.

    Where they tell no difference the sheet may be off by an unsteady hand: of Peaucellier's rhombus one meeting point
    is B itself, which then seems to lie beside B. What is no farther off than the slack of the hand is on the line.
    """
    slack = desk.board.hand.slack
    margins = [[margin(s, trial) for s in about] for trial in trials]
    for least in (hair, slack, -slack) if slack else (hair,):
        holds = [[off > least for off in of_trial] for of_trial in margins]
        fits = [all(held) for held in holds]
        if fits[0] != fits[1]:
            return holds, fits
    holds = [[off > hair for off in of_trial] for of_trial in margins]
    return holds, [all(held) for held in holds]


def in_metres(
    desk: Desk, trials: list[dict[str, complex]]
) -> tuple[Mapping[str, complex], dict[str, complex], dict[str, complex]]:
    """The rough places of the problem, and where all letters lie with either meeting point."""
    one, two = ({name: at / desk.mm(1.0) for name, at in trial.items()} for trial in trials)
    return desk.mech.guesses, one, two


def said(statement: Statement | None, which: str = "点") -> Words:
    """The deciding statement in words; which: of what there are two, in Chinese."""
    match statement:
        case None:
            return Words(f"（取与题给装配形式相符的一{which}）", " (of the two, the one that fits the assembly given)")
        case SideOf(point=point, side=side):
            beside = side in (Side.LEFT, Side.RIGHT) and len(statement.ref) > 1  # of one point, in its direction
            ref = f"${''.join(statement.ref)}$"
            line = Words(f"有向线 {ref} ", f"the directed line {ref}") if beside else Words(f" {ref} ", ref)
            taken = (
                f"取位于{line.zh}{_SIDE[side]}的交点"
                if which == "点"
                else f"取 ${point}$ 在{line.zh}{_SIDE[side]}的一{which}"
            )
            return Words(f"（{taken}）", f" (of the two, ${point}$ {_EN[side]} {line.en})")
        case Shaped(form=form):
            corners = "".join(statement.corners)
            return Words(
                f"（取 ${corners}$ 为{form.words.zh}的一{which}）",
                f" (of the two, the one that makes ${corners}$ {form.words.en})",
            )
        case _:
            assert_never(statement)


def _with_point(
    desk: Desk, drawn: dict[str, complex], point: str, links: tuple[str, ...], at: complex
) -> dict[str, complex]:
    """All points that would be known if the group's point were there."""
    known = {**drawn, point: at}
    for name in links:
        body = desk.mech.link(name).points
        held = [p for p in body if p in known]
        if name != FRAME and point in held and len(held) > 1:
            p, q = held[0], held[1]
            turn = (known[q] - known[p]) / (body[q] - body[p])
            known |= {r: known[p] + turn * (local - body[p]) for r, local in body.items() if r not in known}
    return known


def _which(point: str, links: tuple[str, ...], desk: Desk, about: list[Statement], early: Words | None) -> Words:
    others = [p for name in links for p in desk.mech.link(name).points if p != point and p in desk.at][:2]
    line = "".join(others) if len(others) == 2 else (others[0] if others else "A")
    moving = [name for name in links if name in desk.mech.bodies]
    told = Words(
        f"构件 {'、'.join(moving)} 上的点 {point} 可装配在两侧，而",
        f"point {point} of links {', '.join(moving)} can be assembled on two sides, and ",
    )
    if early is None and about:
        early = Words(
            " branch 中的语句相互矛盾或未指明一侧", "the branch statements contradict each other or name no side"
        )
    elif early is None:
        early = Words(" branch 中的语句没有涉及它", "the branch statements say nothing of it")
    return (told + early) + Words(
        f"；请写 branch: [{point} left of {line}] 或 branch: [{point} right of {line}]",
        f"; write 'branch: [{point} left of {line}]' or 'branch: [{point} right of {line}]'",
    )
