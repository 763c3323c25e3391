"""Torsion springs and rotary dampers: the angle by the protractor, the couple against it."""

from __future__ import annotations

import numpy as np

from ....algebra.quantity import Expr, Quantity, Sum, magnitude, number
from ....board.construction import Reading, View
from ....board.said.protractor import degrees_told
from ....diagram.springs.torsion import coil_symbol
from ....mechanism.asked.forces import spring_named
from ....mechanism.laws.springs import Coil
from ....mechanism.loads import Moment
from ....mechanism.model import FRAME
from ....plane import Reals, nominal
from ....problem.loads.laws.law_data import angle_of
from ....words import Words
from ..acting import OTHER_END
from .off_paper import OffPaper
from .pull import Pull


def turned(at: OffPaper, coil: Coil) -> tuple[tuple[Moment, ...], dict[str, Pull]]:
    """The couple of a torsion spring on its link, and the opposite one on the other if that moves."""
    board, named = at.desk.board, spring_named(coil)
    _say(at, coil)
    terms: list[tuple[Expr, int]] = []
    if coil.preload:
        terms.append((magnitude("M_{0}", abs(coil.preload), "N·m"), -1 if coil.preload > 0 else 1))
    if coil.stiffness:
        wound = at.turned(coil)
        _tell_angle(at, coil, wound)
        terms.append(_against(magnitude("k", coil.stiffness, "N·m/rad"), "Δφ", wound, "rad"))
    if coil.damping:
        rate = f"ω_{coil.link}" if coil.against == FRAME else f"ω_{coil.link} − ω_{coil.against}"
        board.remark(Words(f"相对角速度 $ω_r = |{rate}|$。", f" The relative angular velocity is $ω_r = |{rate}|$."))
        terms.append(_against(magnitude("c", coil.damping, "N·m·s"), "ω_{r}", at.turning(coil), "rad/s"))
    total = sum(sign * float(nominal(term.value)) for term, sign in terms)
    way, turn = (1, Words("逆", "counter-clockwise")) if total >= 0 else (-1, Words("顺", "clockwise"))
    board.remark(
        Words(f"它对构件 {coil.link} 的力矩为{turn.zh}时针方向。", f" Its moment on link {coil.link} is {turn.en}.")
    )
    whole = Sum(tuple(term for term, _ in terms), tuple(way * sign for _, sign in terms))
    size = way * board.compute(named.symbol, whole, "N·m").value
    value = float(nominal(size))
    board.keep(Reading(key=named.key, symbol=named.symbol, unit="N·m", scalar=value), size)
    moment = Moment(name=coil.name, link=coil.link, size=value)
    if coil.against == FRAME:
        return (moment,), {coil.name: Pull(size=size)}
    back = Moment(name=f"{coil.name}{OTHER_END}", link=coil.against, size=-value)
    board.remark(
        Words(
            f"构件 {coil.against} 受反向的力偶 ${back.name} = {coil.name}$。",
            f" On link {coil.against} acts the opposite couple, ${back.name} = {coil.name}$.",
        )
    )
    return (moment, back), {moment.name: Pull(size=size), back.name: Pull(size=-size)}


def _say(at: OffPaper, coil: Coil) -> None:
    """The step: between which links it is; its symbol on the diagram."""
    board = at.desk.board
    other = (
        Words("机架", "the frame") if coil.against == FRAME else Words(f"构件 {coil.against} ", f"link {coil.against}")
    )
    what = Words("扭簧", "torsion spring") if coil.stiffness else Words("转动阻尼器", "rotary damper")
    board.step(
        Words(
            f"{what.zh} ${coil.name}$ 在构件 {coil.link} 与{other.zh}之间。",
            f"The {what.en} ${coil.name}$ joins link {coil.link} and {other.en}.",
        ),
        View.MECHANISM,
    )
    for pin in at.desk.mech.shared(coil.link, coil.against)[:1]:
        board.depict(View.MECHANISM, coil_symbol(at.desk.at[pin]))


def _tell_angle(at: OffPaper, coil: Coil, wound: Reals) -> None:
    """The angle that the protractor shows, and what it is from the free one."""
    board = at.desk.board
    gone, angle = (degrees_told(board.acts, np.degrees(one)) for one in (np.abs(wound), wound + coil.free))
    which, free = angle_of(coil, at.desk.mech), number(float(np.degrees(coil.free)))
    said = f"$Δφ = |φ − φ_0|$ = {gone}° = {number(abs(float(nominal(wound))))} rad"
    board.remark(
        Words(
            f"用量角器量得 $φ$ = {angle}°{which.zh}，$φ_0$ = {free}°，故 {said}。",
            f" The protractor shows $φ$ = {angle}°{which.en}; with $φ_0$ = {free}°, {said}.",
        )
    )


def _against(factor: Quantity, symbol: str, value: Reals, unit_text: str) -> tuple[Expr, int]:
    """A term that turns against an angle, or a rate: its size, and its sign."""
    sense = 1 if float(nominal(value)) >= 0 else -1
    return factor * magnitude(symbol, sense * value, unit_text), -sense
