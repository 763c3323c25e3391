"""Against which motion friction acts: relative turning at a pin,
relative sliding in a guide or at a contact, read off the velocity polygon."""

from __future__ import annotations

import numpy as np

from ...algebra.columns import significant
from ...algebra.quantity import magnitude, number
from ...algebra.rounding import places_of, read_back
from ...algebra.worked import figures_for
from ...board.construction import View
from ...board.said.sides import side_of
from ...errors import NoSlipSenseError, bilingual
from ...mechanism.model import FRAME, Prismatic
from ...names import omega
from ...plane import Points, dot, nominal
from ...words import Words
from ..kinematics.image import known_tips
from .friction import STILL
from .state import Statics

TURN = {1: Words("逆时针", "counter-clockwise"), -1: Words("顺时针", "clockwise")}


def told_by_powers(powers: Words, positive: bool, symbols: tuple[str, str], sense: int, *, along: bool) -> Words:
    """Which way a moment turns, by the sum of these powers: along or against the ω beside it. symbols: of both."""
    sign = Words("正", "positive") if positive else Words("负", "negative")
    beside = Words("同向", "turns with") if along else Words("反向", "turns against")
    moment, turns = symbols
    return Words(
        f"{powers.zh}之和为{sign.zh}，故 ${moment}$ 与 ${turns}$ {beside.zh}，为{TURN[sense].zh}方向：",
        f" {powers.en} sum to a {sign.en} value, so ${moment}$ {beside.en} ${turns}$ and is {TURN[sense].en}:",
    )


def pin_words(st: Statics, point: str, by: str, on: str, touch: Points) -> Words:
    """Why the reaction touches the friction circle on its side, and which side that is:
    ω of the one link against the other, and the moment against it; touch: where the line touches the circle."""
    sense = st.moment_sense(point, by, on)
    if not sense:
        return Words.same("")
    symbol, way, against = st.named(by, on).symbol, TURN[-sense], TURN[sense]
    side = side_of(complex(nominal(touch - st.desk.at[point])))
    rate, turns = relative_omega(st, by, on)
    return Words(
        f"{rate}，为{way.zh}；${symbol}$ 对 ${point}$ 之矩与 ${turns}$ 转向相反，为{against.zh}，"
        f"故 ${symbol}$ 切于 ${point}$ 处摩擦圆{side.zh}侧。",
        f" Here {rate}, {way.en}; the moment of ${symbol}$ about ${point}$ opposes ${turns}$ and is "
        f"{against.en}, so ${symbol}$ is tangent to the friction circle at ${point}$ on its {side.en} side.",
    )


def relative_omega(st: Statics, by: str, on: str) -> tuple[str, str]:
    """ω_21 = ω_2 − ω_1 with its numbers (rad/s, counter-clockwise positive), and its symbol."""
    i, j = st.mech.number(by), st.mech.number(on)
    if by == FRAME:
        return f"$ω_{{{j}{i}}}$ = $ω_{j}$", f"ω_{{{j}{i}}}"
    if on == FRAME:
        return f"$ω_{{{j}{i}}}$ = −$ω_{i}$", f"ω_{{{j}{i}}}"
    one, two = st.turning(on, FRAME), st.turning(by, FRAME)
    if not two:  # a slider
        return f"$ω_{{{j}{i}}}$ = $ω_{j}$ = {_as_answered(one)} rad/s", f"ω_{{{j}{i}}}"
    return f"$ω_{{{j}{i}}}$ = $ω_{j}$ − $ω_{i}$ = {_difference(one, two)} rad/s", f"ω_{{{j}{i}}}"


def _difference(one: float, two: float) -> str:
    """Two rates with the figures of answers, three and four after a leading 1, and what these give; with more figures
    where they would be told as one."""
    first, second = map(_as_answered, (one, two))
    gap = read_back(first)[0] - read_back(second)[0]
    places = max(map(places_of, (first, second)))
    if not gap:
        digits = figures_for(magnitude("ω_1", one, "rad/s") - magnitude("ω_2", two, "rad/s"))
        first, second, told = number(one, digits), number(two, digits), number(one - two)
    else:
        told = f"{gap:.{places}f}".replace("-", "−")
    return f"{first} − {f'({second})' if two < 0 else second} = {told}"


def _as_answered(rate: float) -> str:
    """With three figures, four after a leading 1; a round number, such as that of the drive, as it is."""
    figures = 3 + f"{abs(rate):e}".startswith("1")
    plain = number(rate, figures)
    return plain if number(rate, 9) == plain else significant(rate, figures)


def velocity_of(st: Statics, link: str, place: Points) -> Points:
    """Velocity (mm on the velocity polygon) of the point of a link that is at this place of the diagram,
    from a drawn tip and ω."""
    desk = st.desk
    if link == FRAME:
        return 0j
    _, at = known_tips(desk, View.VELOCITY, link)[0]
    turn = desk.turns[omega(link)]
    per_mm = st.board.scales[View.MECHANISM].value / st.board.scales[View.VELOCITY].value
    return desk.tip(View.VELOCITY, at) + 1j * turn.value * (place - desk.where(at)) * per_mm


def leaning(st: Statics, normal: Points, slip: Points, phi: float, what: Words | str, *, key: str) -> Points:
    """Direction of the reaction of this key with normal part along `normal`:
    turned by φ from it, against the sliding of the link it acts on.

    Raises NoSlipSenseError where nothing slides.
    """
    if not phi:
        return normal
    along = float(nominal((np.conj(1j * normal) * slip).real))
    if abs(along) * st.board.scales[View.VELOCITY].value <= STILL * st.speed:
        raise NoSlipSenseError(
            bilingual(what)
            + Words(
                "：在此位置无相对滑动，摩擦力方向不定；请另取原动件位置，或去掉此处摩擦",
                ": nothing slides in this position, so friction has no sense; choose another input position, or "
                "leave out this friction",
            )
        )
    return st.board.leaned(normal, -phi * float(np.sign(along)), key=key)


def inclined(st: Statics, joint: Prismatic, by: str, on: str) -> Points:
    """Direction of R_by,on in a slide: the normal of the guide, inclined by φ against the sliding of `on` past `by`.

    It presses on the side that the pass before found; in the first pass either side will do.
    """
    desk, before = st.desk, st.pushed_before(by, on)
    normal = 1j * desk.guide_line(joint).along
    if before is not None:
        normal = normal * np.where(dot(normal, before) < 0, -1, 1)
    at = desk.at[joint.pin]
    slip = velocity_of(st, on, at) - velocity_of(st, by, at)
    i, j = st.mech.number(by), st.mech.number(on)
    between = Words(f"构件 {i} 与 {j} 间的移动副", f"the slide of links {i} and {j}")
    return leaning(st, normal, slip, st.phi(joint), between, key=st.named(by, on).key)


def slide_words(st: Statics, joint: Prismatic, by: str, on: str) -> Words:
    """Why the reaction of a slide leans as it does."""
    i, j, symbol = st.mech.number(by), st.mech.number(on), st.named(by, on).symbol
    if not st.phi(joint):
        return Words(
            f"${symbol}$ 垂直于构件 {i}、{j} 间的导路。",
            f" The reaction ${symbol}$ is normal to the guide of links {i} and {j}.",
        )
    way, phi = sliding_way(st, joint, by, on), st.phi_symbol(joint)
    return Words(
        f"由速度多边形，构件 {j} 相对构件 {i} 沿导路{way.zh}滑动（$v_{{{j}{i}}}$），摩擦力与之反向，"
        f"故 ${symbol}$ 自导路法线偏转 ${phi}$ 角，与 $v_{{{j}{i}}}$ 成 90° + ${phi}$。",
        f" By the velocity polygon link {j} slides {way.en} along link {i} ($v_{{{j}{i}}}$); "
        f"friction opposes it, so ${symbol}$ is inclined at ${phi}$ to the normal of the guide and "
        f"makes 90° + ${phi}$ with $v_{{{j}{i}}}$.",
    )


def at_normal(st: Statics, joint: Prismatic) -> Words:
    """What is known of the direction of a slide's reaction."""
    phi = st.phi_symbol(joint)
    return Words(f"与法线成 ${phi}$", f"at ${phi}$ to the normal") if st.phi(joint) else Words("⊥导路", "⊥guide")


def sliding_way(st: Statics, joint: Prismatic, by: str, on: str) -> Words:
    """向左, to the left: the way in which `on` slides past `by`, as the velocity polygon shows."""
    at = st.desk.at[joint.pin]
    return way_of(complex(nominal(velocity_of(st, on, at) - velocity_of(st, by, at))))


def way_of(slip: complex) -> Words:
    """向左, to the left: the way in which a velocity points."""
    if abs(slip.real) >= abs(slip.imag):
        return Words("向右", "to the right") if slip.real > 0 else Words("向左", "to the left")
    return Words("向上", "upwards") if slip.imag > 0 else Words("向下", "downwards")
