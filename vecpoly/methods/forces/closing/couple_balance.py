"""A link that carries only a couple: its two reactions are equal, opposite and parallel, R = M / h."""

from __future__ import annotations

import numpy as np

from ....algebra.quantity import magnitude
from ....board.board import NO_LENGTH
from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....errors import EquilibriumError, LockedError
from ....mechanism.model import Revolute
from ....plane import Line, Points, Reals, foot, nominal
from ....words import Words
from ...registry import Stage, method
from ..couples import couples_on
from ..lines.letters import arm_about_point
from ..lines.links_of_group import Held
from ..lines.resultant import Resultant, resultant
from ..senses import pin_words
from ..state import Statics

_SOURCE = "机械原理, equilibrium of a link under a couple"


@method(
    stage=Stage.FORCE,
    group="link under a couple",
    source=_SOURCE,
    example="",
    title=Words("受力偶的构件：R = M / h", "Link under a couple: R = M / h"),
)
def balance_couple(st: Statics, about: tuple[Held, Line, str]) -> None:
    """R of `by` along its known line, −R of the parent tangent to the friction circle of its pin;
    R h balances the couple M.

    The line's sense is kept where friction counts: where the arm would have to change sides the link is locked. While
    the balancing load is on trial (`trial`) that only tells that the force has turned round, and the next trial knows.
    Raises LockedError there, EquilibriumError where the line passes through the pin.
    """
    held, line, by = about
    assert isinstance(held.joint, Revolute)
    link, pin = held.link, held.joint.point
    load = resultant(st, link)
    st.board.step(_taken(st, held, load, by), View.MECHANISM)
    moment, centre = load.couple, st.desk.at[pin]
    sense = st.moment_sense(pin, held.parent, link)
    u = line.along
    if st.ideal is None:  # the sense follows from the couple
        u = u * np.where(moment * (np.conj(line.at - centre) * u).imag > 0, -1, 1)
    at = st.touch(pin, -u, sense)
    st.board.remark(pin_words(st, pin, held.parent, link, at))
    across = foot(Line(line.at, u), at)
    turning = (np.conj(across - at) * u).imag  # of the couple that u at `across` and −u at `at` form, per mm of force
    _check(st, held, by, turning, moment)
    turned = np.where(turning * moment > 0, -1.0, 1.0)
    _close(st, (held, by), (Line(line.at, u * turned), at, across), sense, moment)


def _taken(st: Statics, held: Held, load: Resultant, by: str) -> Words:
    """What acts on the link, and so how its reactions lie."""
    number, one, two = st.mech.number(held.link), st.named(by, held.link), st.named(held.parent, held.link)
    only = (
        Words(
            f"构件 {number} 上的已知力 {load.symbols.zh} 合成为一力偶",
            f"On link {number} {load.symbols.en} join into a couple",
        )
        if load.forces
        else Words(f"构件 {number} 上只有力偶", f"Link {number} carries only a couple")
    )
    return Words(
        f"{only.zh}，故 ${one.symbol}$ 与 ${two.symbol}$ 等值、反向、平行，构成力偶与之平衡；"
        f"量得力臂 ${arm_about_point(one.symbol)}$。",
        f"{only.en}: ${one.symbol}$ and ${two.symbol}$ are equal, opposite and parallel, "
        f"and balance it; their arm ${arm_about_point(one.symbol)}$ is measured.",
    )


def _check(st: Statics, held: Held, by: str, turning: Reals, moment: Reals) -> None:
    """Refuse a line through the pin (EquilibriumError),
    or on the side where its force turns with the couple (LockedError)."""
    assert isinstance(held.joint, Revolute)
    number, pin, one = st.mech.number(held.link), held.joint.point, st.named(by, held.link)
    if abs(float(nominal(turning))) < NO_LENGTH:
        raise EquilibriumError(
            Words(
                f"构件 {number}：{one.key} 的作用线过 {pin}，不能平衡力偶；请另取原动件位置",
                f"link {number}: the line of {one.key} passes through {pin}, so it balances no couple; choose "
                "another input position",
            )
        )
    if float(nominal(turning * moment)) > 0 and not st.balanced:
        raise LockedError(
            Words(
                f"构件 {number}：考虑摩擦后 {one.key} 的作用线位于 {pin} 的另一侧，"
                "沿此线的力不能平衡该力偶；请减小 f 或 ρ",
                f"link {number}: with friction the line of {one.key} passes on the other side of {pin}; no "
                "force along it balances the couple; lower f or ρ",
            )
        )


def _couple_symbol(st: Statics, link: str) -> str:
    """The symbol of the only couple on the link; M of several together."""
    symbols = [symbol for symbol, size in couples_on(st, link) if nominal(size)]
    return symbols[0] if len(symbols) == 1 else "M"


def _close(st: Statics, who: tuple[Held, str], where: tuple[Line, Points, Points], sense: int, moment: Reals) -> None:
    """The arm measured, R computed, both reactions kept; no polygon: two equal and opposite forces."""
    (held, by), (line, at, across) = who, where
    board, link, named = st.board, held.link, st.named(by, held.link)
    letter = arm_about_point(named.symbol)
    arm = board.mu(View.MECHANISM) * board.measure(at, across, letter)
    size = board.compute(named.symbol, magnitude(_couple_symbol(st, link), np.abs(moment), "N·m") / arm, "N")
    vector = line.along * st.mm(size.value)
    board.join(View.MECHANISM, at, across, st.ruled(Role.CONSTRUCTION))
    board.plot(View.MECHANISM, (at + across) / 2, letter, Dot.NONE)
    board.join(View.MECHANISM, at - line.along * 16.0, at + line.along * 16.0, st.ruled(Role.DIRECTION))
    st.settle(by, link, vector, line.at, computed=size.value)
    st.settle(held.parent, link, -vector, at, None, sense, computed=size.value)
