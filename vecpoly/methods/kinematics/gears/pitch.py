"""The pitch point of two bodies that roll:
one velocity for both, and accelerations that differ only along the common normal.

With H of link k and H of link m, both at the pitch point, and C the centre of gear k,
    v_Hk = v_Hm,    a_Hk = a_Hm + a_HkHm,    a_HkHm = ω_km² ρ  from H towards C,
ω_km = ω_k - ω_m, and ρ = r_k r_m / (r_k + r_m) outside, r_k r_m / (r_m - r_k) inside a ring, r_k on a rack.
"""

from __future__ import annotations

from collections.abc import Iterable

from ....algebra.quantity import Expr, Quantity, magnitude
from ....board.construction import View
from ....mechanism.groups.assur import Group
from ....mechanism.model import FRAME, Circle, Joint, Rack, Rolling
from ....names import At, Kind, Rel, omega
from ....plane import Points, nominal
from ....vector.close import close
from ....vector.equation import UNKNOWN, Equation, Term
from ....words import Words
from ...desk import POLE, Desk
from ..image import imaged
from ..lengths import write_lengths
from ..terms import ABSENT, known
from .translated import letter_translated


def rolling_in(joints: Iterable[Joint]) -> tuple[Rolling, ...]:
    """The rolling pairs among these joints."""
    return tuple(joint for joint in joints if isinstance(joint, Rolling))


def rolling_of(group: Group) -> Rolling:
    """The (first) rolling pair of a gear or a rack with the link that drives it."""
    return rolling_in(outer.joint for outer in group.outer)[0]


def partner(joint: Rolling, link: str) -> str:
    """The link on which this one rolls."""
    return joint.on.link if joint.gear.link == link else joint.gear.link


def wheel(joint: Rolling, link: str) -> Circle | Rack:
    """The link's own pitch circle, or its pitch line."""
    return joint.gear if joint.gear.link == link else joint.on


def fixed_gear(joint: Rolling, link: str) -> Words:
    """What the link rolls on is called where it stands still: a ring gear about the link, or a gear."""
    mine, other = wheel(joint, link), wheel(joint, partner(joint, link))
    ring = joint.internal and isinstance(mine, Circle) and isinstance(other, Circle) and other.radius > mine.radius
    return Words("固定内齿轮", "fixed ring gear") if ring else Words("固定齿轮", "fixed gear")


def letter_pitch_points(desk: Desk, joints: Iterable[Joint]) -> None:
    """Find the pitch points on the diagram, and take the pitch radii over as lengths."""
    for joint in rolling_in(joints):
        desk.letter(joint.point, desk.contact(joint))
        for circle in (joint.gear, joint.on):
            if isinstance(circle, Circle):
                desk.lengths[frozenset((joint.point, circle.centre))] = _radius(circle, joint.point)


def pitch_velocity(desk: Desk, joint: Rolling, link: str) -> None:
    """The velocity of the pitch point from the body on which the link rolls."""
    h, other = joint.point, partner(joint, link)
    if other == FRAME:
        if h not in desk.centres:
            desk.centres.add(h)
            on = (
                Words("固定齿条", "a fixed rack")
                if isinstance(wheel(joint, other), Rack)
                else Words("", "a ") + fixed_gear(joint, link)
            )
            desk.board.step(
                Words(
                    f"齿轮 {link} 在{on.zh}上纯滚动，接触点 ${h}$ 的速度为零（绝对瞬心），${h.lower()}$ 与极点 $p$ "
                    "重合。",
                    f"Gear {link} rolls on {on.en}: its contact ${h}$ has no velocity "
                    f"(instant centre), and ${h.lower()}$ lies at the pole $p$.",
                ),
                View.VELOCITY,
            )
    elif not desk.has_tip(View.VELOCITY, At(h)):
        imaged(desk, View.VELOCITY, other, At(h))
        if desk.turns[omega(other)].never:
            letter_translated(desk, View.VELOCITY, other, At(h))


def normal_words(joint: Rolling) -> Words:
    """The line along which the accelerations at a pitch point differ:
    the line of centres, or the normal of a rack's pitch line."""
    if isinstance(joint.on, Rack):
        return Words("垂直于节线的", "perpendicular to the pitch line")
    return Words(
        f"沿连心线 ${joint.on.centre}{joint.gear.centre}$ 的",
        f"along the line of centres ${joint.on.centre}{joint.gear.centre}$",
    )


def pitch_acceleration(desk: Desk, joint: Rolling, link: str) -> None:
    """a_Hk = a_Hm + a_HkHm for the link's own point at the pitch point, from the body m on which it rolls."""
    h, other, view, board = joint.point, partner(joint, link), View.ACCELERATION, desk.board
    own = At(h, link)
    if desk.has_tip(view, own):
        return
    base = partner_acceleration(desk, joint, link)
    board.step(
        Words(
            f"啮合点 ${h}$ 处作纯滚动：构件 {link} 与{_called(other).zh}在 ${h}$ 处的加速度只相差"
            f"{normal_words(joint).zh}分量，其大小由相对角速度确定。",
            f"Pure rolling at ${h}$: the accelerations of link {link} and {_called(other).en} at "
            f"${h}$ differ only by a component {normal_words(joint).en}, whose size the relative "
            "angular velocity gives.",
        ),
        view,
    )
    term = rolling_term(desk, joint, link)
    rel = Rel(Kind.A, own)
    if base:
        eq = Equation(
            left=(Term(rel=rel, symbol=desk.symbol(rel), direction=UNKNOWN, magnitude="?"),), right=(*base, term)
        )
        board.equate(eq.table())
        closed = close(board, view, 0j, eq, to=desk.tip_label(view, own), of=own)
        write_lengths(desk, view, eq)
        tip = desk.reach_tip(view, own, closed.meeting)
    else:
        tip = desk.put_tip(view, own, board.lay_off(0j, _along(term), _mm(term), key=desk.key(rel)))
        size = desk.size(rel)
        if size is not None and term.magnitude != "0":
            board.write_length(view, f"{POLE[view]} {desk.tip_label(view, own)}", size)
        board.arrow_once(view, 0j, tip, key=desk.key(rel))
        desk.known_as[view, own] = (term.direction, term.magnitude)
    board.plot(view, tip, desk.tip_label(view, own))


def partner_acceleration(desk: Desk, joint: Rolling, link: str) -> tuple[Term, ...]:
    """a_Hm of the body on which the link rolls; nothing where that body is fixed."""
    other = partner(joint, link)
    if other == FRAME:
        return ()
    base = At(joint.point, other)
    if not desk.has_tip(View.ACCELERATION, base):
        imaged(desk, View.ACCELERATION, other, base)
        if desk.turns[omega(other)].never:
            letter_translated(desk, View.ACCELERATION, other, base)
    return (known(desk, View.ACCELERATION, base),)


def rolling_term(desk: Desk, joint: Rolling, link: str, tip: str = "") -> Term:
    """a_HkHm = ω_km² ρ, along the common normal: computed, then laid off to μ_a."""
    h, other, board = joint.point, partner(joint, link), desk.board
    rel = Rel(Kind.A, At(h, link), None if other == FRAME else At(h, other))
    sign = desk.symbol(rel)
    turning = _relative(desk, link, other)
    size = board.compute(sign, turning.squared() * _curved(joint), "m/s^2")
    vanishes = abs(nominal(size.value)) < 1e-12
    start, end = _normal(joint, link)
    return Term(
        rel=rel,
        symbol=sign,
        direction=ABSENT if vanishes else Words.same(f"${start}→{end}$"),
        magnitude="0" if vanishes else "✓",
        along=desk.towards(start, end),
        mm=board.to_paper(View.ACCELERATION, size.value),
        tip=tip,
    )


def along_normal(desk: Desk, joint: Rolling, link: str) -> Term:
    """a_HkHm along the common normal, its magnitude unknown."""
    other = partner(joint, link)
    rel = Rel(Kind.A, At(joint.point, link), None if other == FRAME else At(joint.point, other))
    c = joint.gear.centre
    name = f"∥$ {joint.point}{c}$" if isinstance(joint.on, Rack) else f"∥$ {joint.on.centre}{c}$"
    return Term(
        rel=rel, symbol=desk.symbol(rel), direction=Words.same(name), magnitude="?", along=desk.towards(joint.point, c)
    )


def _relative(desk: Desk, link: str, other: str) -> Quantity:
    """ω_km = ω_k - ω_m; ω_k itself on what does not turn."""
    own = magnitude(f"ω_{link}", desk.turns[omega(link)].value, "rad/s")
    if other == FRAME or desk.turns[omega(other)].never:
        return own
    if desk.turns[omega(link)].never:
        return magnitude(f"ω_{other}", desk.turns[omega(other)].value, "rad/s")
    desk.board.remark(Words("角速度以逆时针为正。", " Angular velocities are positive counter-clockwise."))
    return desk.board.compute(
        f"ω_{{{link}{other}}}", own - magnitude(f"ω_{other}", desk.turns[omega(other)].value, "rad/s"), "rad/s"
    )


def _curved(joint: Rolling) -> Expr:
    """ρ: r on a rack, r R / (R ± r) on a gear."""
    one = _radius(joint.gear, joint.point)
    if isinstance(joint.on, Rack):
        return one
    two = _radius(joint.on, joint.point)
    if not joint.internal:
        return one * two / (one + two)
    small, large = sorted((one, two), key=lambda r: float(nominal(r.value)))
    return one * two / (large - small)


def _normal(joint: Rolling, link: str) -> tuple[str, str]:
    """Two letters along the relative acceleration of the link's point:
    towards its own centre; of a ring or a rack away from the gear's."""
    mine, other = (joint.gear, joint.on) if joint.gear.link == link else (joint.on, joint.gear)
    if isinstance(mine, Circle) and (not joint.internal or isinstance(other, Rack) or mine.radius < other.radius):
        return joint.point, mine.centre
    assert isinstance(other, Circle)
    return other.centre, joint.point


def _radius(circle: Circle, point: str) -> Quantity:
    """By the number of its link; of a fixed wheel by its pitch point: there may be several."""
    named = f"r_{point}" if circle.link == FRAME else f"r_{circle.link}{circle.mark}"
    return magnitude(named, circle.radius, "m")


def _called(link: str) -> Words:
    return Words("机架", "the frame") if link == FRAME else Words(f"构件 {link} ", f"link {link}")


def _along(term: Term) -> Points:
    assert term.along is not None
    return term.along


def _mm(term: Term) -> float:
    assert term.mm is not None
    return term.mm  # type: ignore[return-value]
