"""The input's motion and the branch, in a lecturer's words."""

from __future__ import annotations

import cmath
from collections.abc import Iterable

from ...errors import FaultError
from ...mechanism.model import FRAME, Drive, Joint, Prismatic
from ...mechanism.travel import travel_words
from ...names import Kind
from ...units.reading import Dim, Quantity, read
from ...words import Words
from ..asked.asks import Ask, AskCoriolis, AskNamed, AskPoint, AskRel
from ..links.bodies import Bodies
from ..links.draft import Draft
from ..problem import Datum, Shape
from ..schema.models import InputSpec, ProblemSpec
from ..values.seen import counted
from .between import is_between, read_between
from .rays import placed, ray_of, read_angle

_CCW, _CW = (1.0, Words("逆时针", "counter-clockwise")), (-1.0, Words("顺时针", "clockwise"))
_TURNS = {
    **dict.fromkeys(("ccw", "counter-clockwise", "counterclockwise", "逆时针"), _CCW),
    **dict.fromkeys(("cw", "clockwise", "顺时针"), _CW),
}


def read_input(spec: InputSpec, bodies: Bodies, joints: Iterable[Joint]) -> tuple[Drive, tuple[Datum, ...]]:
    """One drive, and its data as written."""
    if is_between(spec):
        return read_between(spec, bodies, joints)
    if spec.link is None:
        raise FaultError(
            Words(
                "缺少原动件；请写 link: 1（或油缸 cylinder: 2-3）",
                "the driving link is missing; write link: 1 (or cylinder: 2-3)",
            )
        )
    if spec.length is not None:
        raise FaultError(
            Words(
                "length 只用于油缸；请写 cylinder: 2-3，或以 s 表示位移",
                "'length' belongs to a cylinder; write cylinder: 2-3, or give the travel as s",
            ),
            "length",
        )
    try:
        draft = bodies.draft(spec.link)
    except FaultError as fault:
        raise fault.under("link") from None
    turning = [key for key in ("phi", "omega", "alpha") if getattr(spec, key) is not None]
    sliding = [key for key in ("s", "v", "a") if getattr(spec, key) is not None]
    if turning and sliding:
        raise FaultError(
            Words(
                f"原动件或转动（phi、omega、alpha）或移动（s、v、a），不能兼有；这里给了 {', '.join(turning)} "
                f"和 {', '.join(sliding)}",
                f"an input turns (phi, omega, alpha) or slides (s, v, a), not both: {', '.join(turning)} and "
                f"{', '.join(sliding)} are given",
            ),
            code="contradiction",
        )
    return _sliding(spec, draft, joints) if sliding else _turning(spec, draft, bodies, joints)


def sense_only(spec: ProblemSpec) -> bool:
    """Whether an input has only a sense of rotation (omega: ccw), and so no angular velocity as a number."""
    inputs = spec.input if isinstance(spec.input, list) else [spec.input]
    return any(one.omega in _TURNS for one in inputs)


def numbered(ask: Ask, spec: ProblemSpec) -> Ask:
    """The question, unless it asks for a rate of a motion of which only the sense is given; raises FaultError."""
    rate = (
        isinstance(ask, AskPoint | AskCoriolis)
        or (isinstance(ask, AskRel) and ask.rel.kind is not Kind.P)
        or (isinstance(ask, AskNamed) and ask.rel.unit == "m/s")
    )
    if rate and sense_only(spec):
        raise FaultError(
            Words(
                f"求 {ask.rel.key} 需要角速度的数值，而输入只给了转向；如写 omega: 10 rad/s ccw",
                f"{ask.rel.key} needs the angular velocity as a number, but the input gives only its sense; "
                "write e.g. omega: 10 rad/s ccw",
            ),
            code="missing",
        )
    return ask


def _rate(name: str, text: str | None) -> tuple[float, Datum]:
    """ω of the input: a number, or its sense alone, which is taken as 1 rad/s."""
    if text in _TURNS:
        sign, words = _TURNS[text]
        return sign, Datum(words=Words(f"$ω_{name}$ {words.zh}", f"$ω_{name}$ {words.en}"))
    rate = _read("omega", text, Dim.OMEGA)
    return rate.si, Datum(symbol=f"ω_{name}", si=rate.si, text=rate.text)


def _floating(draft: Draft, bodies: Bodies) -> Words:
    """That a link without a pin on the frame is no crank; which link is one, or how a motor between two is written."""
    named = (
        (name, [letter for letter in other.points if letter in bodies.frame])
        for name, other in bodies.drafts.items()
        if name in bodies.numbers
    )
    cranks = [(name, letters[0]) for name, letters in named if letters]
    zh, en = "、".join(f"{n}（{at}）" for n, at in cranks), ", ".join(f"{n} (at {at})" for n, at in cranks)
    return Words(
        f"构件 {draft.name} 不绕固定铰链转动：其上的点 {', '.join(draft.points)} 都不在机架"
        f"（{', '.join(bodies.frame)}）上；"
        + (f"请改为驱动绕固定铰链转动的构件 {zh}；" if cranks else "")
        + "若由装在另一运动构件上的电机驱动，请注明该构件，如 on: 1",
        f"link {draft.name} turns about no fixed pivot: its points {', '.join(draft.points)} are not on the frame "
        f"({', '.join(bodies.frame)}); "
        + (f"drive a link that does: {en}; " if cranks else "")
        + "or, where a motor on another moving link drives it, name that link, as on: 1",
    )


def _turning(spec: InputSpec, draft: Draft, bodies: Bodies, joints: Iterable[Joint]) -> tuple[Drive, tuple[Datum, ...]]:
    # other links may be pinned there too
    pivot = next((letter for letter in draft.points if letter in bodies.frame), None)
    if pivot is None:
        raise FaultError(_floating(draft, bodies), "link")
    if spec.phi is None or spec.omega is None:
        raise FaultError(
            Words(
                "转动输入要有 phi 和 omega，如 phi: 60 deg, omega: 10 rad/s ccw",
                "a turning input needs phi and omega, e.g. phi: 60 deg, omega: 10 rad/s ccw",
            ),
            code="missing",
        )
    phi, zero, line = read_angle(spec.phi, bodies.frame)
    (rate, told), accel = _rate(draft.name, spec.omega), _read("alpha", spec.alpha, Dim.ALPHA)
    to, end = next((one for one in draft.points.items() if one[0] != pivot), ("", draft.points[pivot] + 1))
    barred = draft.shape in (Shape.BAR, Shape.GEAR)  # else x lies along the line
    lean = cmath.phase(end - draft.points[pivot]) if barred else 0.0
    name = draft.name
    ray = ray_of(to if barred else "", lean, line, zero)
    data = [placed(name, phi, ray), told]
    if spec.alpha is not None:
        data.append(Datum(symbol=f"α_{name}", si=accel.si, text=accel.text))
    if spec.omega in _TURNS and spec.alpha is not None:
        raise FaultError(
            Words(
                f"omega: {spec.omega} 只给出转向，alpha: {spec.alpha} 便无从使用；请给出角速度的数值，或删去 alpha",
                f"omega: {spec.omega} gives the sense alone, and alpha: {spec.alpha} has no "
                "use then; give the angular velocity as a number, or leave out alpha",
            ),
            "alpha",
        )
    position, in_turns = phi.si + zero - lean, "r/min" in told.text
    return Drive(link=name, position=position, rate=rate, accel=accel.si, ray=ray, in_turns=in_turns), tuple(data)


def _sliding(spec: InputSpec, draft: Draft, joints: Iterable[Joint]) -> tuple[Drive, tuple[Datum, ...]]:
    guide = next((j for j in joints if isinstance(j, Prismatic) and j.guide == FRAME and j.block == draft.name), None)
    if guide is None:
        raise _on_no_fixed_guide(draft.name, joints)
    if spec.s is None or spec.v is None:
        raise FaultError(
            Words(
                "移动输入要有 s 和 v，如 s: 120 mm, v: 0.5 m/s",
                "a sliding input needs s and v, e.g. s: 120 mm, v: 0.5 m/s",
            ),
            code="missing",
        )
    travel, rate, accel = (_read("s", spec.s, Dim.LENGTH), _read("v", spec.v, Dim.SPEED), _read("a", spec.a, Dim.ACCEL))
    name = draft.name
    data = [
        Datum(symbol=f"s_{name}", si=travel.si, text=travel.text),
        Datum(words=travel_words(name, guide), seen=counted(name, guide)),
        Datum(symbol=f"v_{name}", si=rate.si, text=rate.text),
    ]
    if spec.a is not None:
        data.append(Datum(symbol=f"a_{name}", si=accel.si, text=accel.text))
    return Drive(link=name, position=travel.si, rate=rate.si, accel=accel.si, slide=True), tuple(data)


def _on_no_fixed_guide(name: str, joints: Iterable[Joint]) -> FaultError:
    """What to write instead: a cylinder where the link slides on a moving one."""
    pair = next(
        (
            j
            for j in joints
            if isinstance(j, Prismatic) and name in (j.guide, j.block) and FRAME not in (j.guide, j.block)
        ),
        None,
    )
    if pair is not None:
        both = f"{pair.guide}-{pair.block}"
        return FaultError(
            Words(
                f"构件 {name} 只在活动构件上移动；若由油缸驱动，请写 input: {{cylinder: {both}, length: 800 mm, v: "
                "0.1 m/s}",
                f"link {name} slides on a moving link only; if a cylinder drives it, write "
                f"input: {{cylinder: {both}, length: 800 mm, v: 0.1 m/s}}",
            ),
            "link",
        )
    return FaultError(
        Words(
            f"构件 {name} 不在固定导路上移动；请写运动副“{name} slides on y = 0 mm”",
            f"link {name} slides on no fixed guide; write a joint '{name} slides on y = 0 mm'",
        ),
        "link",
    )


def _read(key: str, text: str | None, dim: Dim) -> Quantity:
    try:
        return read(text or "0", dim)
    except FaultError as fault:
        raise fault.under(key) from None
