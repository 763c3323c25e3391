"""Which sentence tells of a slip."""

from __future__ import annotations

import re
from collections.abc import Sequence
from contextlib import suppress

from ...board.otherwise.slip import TOLD_OF, Mistake, Slip
from ...errors import UnknownNameError
from ...foundation.greek import GREEK
from ...names import Kind, parse_rel
from ...words import Words
from .message import Message, message
from .named import Told

_RATIO = re.compile(r"omega_ratio_(\d+?)_?(\d+)")  # omega_ratio_13, omega_ratio_1_12
_POINT = re.compile(r"([A-Za-z])(\d+)('*)")
_SIDE = re.compile(r"_(left|right)$")  # of the two flanks of a groove, which bear alike
_GREEK = re.compile(rf"(?<![A-Za-z])(?:{'|'.join(GREEK)})(?![A-Za-z])")
SLIPS = (Told.SLIP, Told.EITHER, Told.CORIOLIS, Told.CORIOLIS_2)  # the sentences that tell of one
MOST = 3  # slips that one sentence tells
_SAID = {
    Mistake.REVERSED: Words("方向画反", "laid off the wrong way"),
    Mistake.DROPPED: Words("漏画", "left out"),
    Mistake.HALVED: Words("小了一半（如漏乘 2）", "half as large (a factor 2 left out)"),
    Mistake.DOUBLED: Words(
        "大了一倍（如漏除以 2，或以直径代半径）", "twice as large (a half forgotten, or a diameter for a radius)"
    ),
    Mistake.TURNED: Words("方向转过了 90°（⊥ 与 ∥ 混淆）", "turned by 90° (∥ for ⊥)"),
    Mistake.SCALED: Words("用错了比例尺", "laid off with another figure's scale"),
    Mistake.COINCIDENT: Words("取错了重合点", "taken of the wrong coincident point"),
    Mistake.OTHER_MEETING: Words("取了另一个交点", "found at the other intersection"),
    Mistake.TURNED_OVER: Words(
        "所在的影像（相似形）字母绕行顺序与构件上相反",
        "in an image whose letters run the other way round than on the link",
    ),
    Mistake.OTHER_CENTRE: Words("所在直线连错了瞬心", "on a line through the wrong two centres"),
    Mistake.OTHER_TANGENT: Words("切于摩擦圆的另一侧", "on the wrong side of the friction circle"),
    Mistake.COMPLEMENT: Words("取了余角（如以 θ 代 90° − θ）", "at the complementary angle (θ for 90° − θ, say)"),
    Mistake.OTHER_SIDE: Words("角作在了另一侧", "at the angle on the other side"),
    Mistake.SWAPPED: Words("与另一平面的分量互换了", "taken for the share of the other plane"),
    Mistake.FORWARDS: Words("反转的方向取反了", "carried on with the motion instead of turned back"),
    Mistake.DEGREES: Words("转角比例尺以度代弧度", "taken with degrees in place of radians"),
    Mistake.PER_MINUTE: Words("把转速 n（r/min）当作角速度", "the speed n in r/min, taken for rad/s"),
    Mistake.COUNTED: Words("把同号相邻的面积当作变号", "counted as a crossing, though the sign does not change"),
    Mistake.WITH_FRAME: Words("把机架计入活动构件", "counted with the frame among the moving links"),
    Mistake.AS_ONE: Words("把复合铰链 {of} 按一个转动副计", "counted with the multiple joint {of} as one revolute"),
    Mistake.OMITTED: Words("的算式中漏了 {of}", "worked without {of}"),
    Mistake.SIGN: Words("的算式中 {of} 的符号取反", "worked with the other sign of {of}"),
    Mistake.INVERTED: Words("的算式中 {of} 用了倒数", "worked with {of} upside down"),
    Mistake.UNSQUARED: Words("的算式中 {of} 漏了平方", "worked with {of}, not squared"),
    Mistake.COFUNCTION: Words("的算式中 {of} 的正弦与余弦取错", "worked with the other of sine and cosine in {of}"),
}


def told_of(slip: Slip, also: Sequence[Slip] = ()) -> Message:
    """The sentence of a slip, or of several that give the same numbers; the Coriolis term has words of its own."""
    if also:
        if len(dict.fromkeys(map(said_of, (slip, *also)))) == 1:  # two lines through the same wrong centres
            return message(Told.SLIP, what=symbol_of(slip.key.rpartition(":")[2]), mistake=_done(slip))
        return message(Told.EITHER, ways=either((slip, *also)))
    key = slip.key.rpartition(":")[2]
    if key.startswith("ak_") and slip.mistake in (Mistake.DROPPED, Mistake.HALVED):
        return message(Told.CORIOLIS if slip.mistake is Mistake.DROPPED else Told.CORIOLIS_2, what=symbol_of(key))
    return message(Told.SLIP, what=symbol_of(key), mistake=_done(slip))


def either(slips: Sequence[Slip]) -> Words:
    """One of these, of many the first."""
    ways = list(dict.fromkeys(map(said_of, slips)))
    zh, en = zip(*((said.zh, said.en) for said in ways[:MOST]), strict=True)
    more = ("等", ", or the like") if len(ways) > MOST else ("", "")
    return Words(f"“{'”或“'.join(zh)}”{more[0]}", f"{', or '.join(en)}{more[1]}")


def _done(slip: Slip) -> Words:
    """What was done wrongly, and within a formula with what."""
    said = _SAID[slip.mistake]
    if slip.mistake not in TOLD_OF:
        return said
    of = f"${slip.instead}$"
    return Words(said.zh.format(of=of), said.en.format(of=of))


def said_of(slip: Slip) -> Words:
    """$e$ is left out."""
    what, mistake = symbol_of(slip.key.rpartition(":")[2]), _done(slip)
    return Words(f"${what}$ {mistake.zh}", f"${what}$ is {mistake.en}")


def symbol_of(key: str) -> str:
    """A key as it is printed: ``a^k_{C2C3}``, ``R_{32}``, ``f_4'``, ``bc2``; the inversion of a cam is −ω."""
    if key == "inversion":
        return "−ω"
    if (point := _POINT.fullmatch(key)) is not None:
        return f"{point[1]}_{{{point[2]}}}{point[3]}"
    if (ratio := _RATIO.fullmatch(key)) is not None:
        return f"ω_{{{ratio[1]}}}/ω_{{{ratio[2]}}}"
    with suppress(UnknownNameError):
        if (rel := parse_rel(key)).kind is not Kind.P:  # p_L is a number of lower pairs
            return rel.symbol
    head, low, body = _SIDE.sub("", key).partition("_")
    head, body = (_GREEK.sub(lambda found: GREEK[found[0]], part) for part in (head, body))
    return f"{head}_{{{body}}}" if low and body else head
