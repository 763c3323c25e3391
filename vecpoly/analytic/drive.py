"""The driving link: it turns about its frame pivot, or slides on its frame guide."""

from __future__ import annotations

import cmath

from ..mechanism.groups.assur import ends, hinges
from ..mechanism.model import FRAME, Prismatic
from ..mechanism.rams import driver_words
from ..words import Words
from .equations import GroupModel, Part, Stage
from .expr import ONE, Const, Expr, Var
from .functions import cos, sin
from .points import points
from .stages import ACCELERATION, POSITION, VELOCITY
from .variables import Scope, both


def drive_symbols(scope: Scope) -> tuple[str, str, str]:
    """φ_1, ω_1, α_1, or s_1, v_1, a_1."""
    drive = scope.mech.drive
    name = scope.pair(drive.link, drive.on) if drive.between else scope.name(drive.link)
    stems = ("s", "v", "a") if scope.mech.drive.slide else ("φ", "ω", "α")
    return f"{stems[0]}_{{{name}}}", f"{stems[1]}_{{{name}}}", f"{stems[2]}_{{{name}}}"


def given_angles(scope: Scope) -> dict[str, float]:
    """The angles of all links at the given position, and the place of the drive as it is told, by their symbols."""
    told = {f"φ_{{{scope.name(link.name)}}}": scope.turned[link.name] for link in scope.mech.links}
    return told | {drive_symbols(scope)[0]: scope.mech.drive.position}


def driving(scope: Scope) -> GroupModel:
    """The driving link's points from its given motion."""
    link = scope.mech.drive.link
    name = scope.name(link)
    if scope.mech.drive.between:
        return _between(scope)
    if scope.mech.drive.slide:
        return _sliding(scope, link)
    pivot = next(p for p, names in hinges(scope.mech).items() if FRAME in names and link in names)
    scope.anchors[link] = pivot
    steady = not scope.mech.drive.accel
    word = Words("匀速", "uniformly") if steady else Words("", "with given acceleration")
    told = Words(f"，$α_{{{name}}}$ = 0", f", $α_{{{name}}}$ = 0") if steady else Words("", "")
    opening = Words(
        f"原动件 {name} 绕固定铰链 ${pivot}$ {word.zh}转动，$φ_{{{name}}}$、"
        f"$ω_{{{name}}}${'' if steady else f'、$α_{{{name}}}$'} 已知{told.zh}。",
        f"Link {name} rotates {word.en} about the fixed pivot ${pivot}$; $φ_{{{name}}}$, "
        f"$ω_{{{name}}}${'' if steady else f', $α_{{{name}}}$'} are given{told.en}.",
    )
    stages = points(scope, (link,))
    if not stages:
        opening += Words("其上没有其他待求的点。", " No other point is fixed on it.")
    return GroupModel(
        title=Words(f"原动件 {name}", f"The driving link {name}"), opening=opening, links=(link,), stages=stages
    )


def _between(scope: Scope) -> GroupModel:
    """A cylinder, or a motor in a hinge: what it gives is known, and found are the links only with their group."""
    words, (place, rate, accel) = driver_words(scope.mech), drive_symbols(scope)
    what = Words("相对位置、速度和加速度", "relative position, velocity and acceleration")
    return GroupModel(
        title=Words(words.zh.strip(), words.en[0].upper() + words.en[1:]),
        links=(),
        stages=(),
        opening=Words(
            f"{words.zh}给定两构件的{what.zh} ${place}$、${rate}$、${accel}$。",
            f"{words.en[0].upper()}{words.en[1:]} gives the {what.en} of its two links, "
            f"${place}$, ${rate}$, ${accel}$.",
        ),
    )


def _sliding(scope: Scope, link: str) -> GroupModel:
    """A link that translates along a frame guide."""
    mech, name = scope.mech, scope.name(link)
    joint = next(j for j in mech.joints if isinstance(j, Prismatic) and set(ends(j)) == {FRAME, link})
    block = joint.block == link
    lean = joint.direction if block else -joint.turn
    turned = joint.direction + joint.turn if block else -joint.direction - joint.turn
    scope.angles[link] = Const(f"φ_{{{name}}}", cmath.phase(cmath.rect(1.0, turned)), "rad")
    scope.still.add(link)
    first, *_ = mech.link(link).points
    scope.anchors[link] = first
    start = scope.at[first] - mech.drive.position * cmath.rect(1.0, lean)
    psi = Const(f"ψ_{{{name}}}", lean, "rad")
    s, v, a = (Var(symbol) for symbol in drive_symbols(scope))
    origin = Const("x_0", start.real), Const("y_0", start.imag)
    acceleration: Expr = a if mech.drive.accel else ONE - ONE
    rows = [
        both(scope.xy(first), (origin[0] + s * cos(psi), origin[1] + s * sin(psi))),
        both(scope.v(first), (v * cos(psi), v * sin(psi))),
        both(scope.a(first), (acceleration * cos(psi), acceleration * sin(psi))),
    ]
    scope.done.add(first)
    stages = [
        Stage(title, (Part(Words("", ""), row),))
        for title, row in zip((POSITION, VELOCITY, ACCELERATION), rows, strict=True)
    ]
    more = points(scope, (link,))
    joined = tuple(Stage(stage.title, stage.parts + (more[i].parts if more else ())) for i, stage in enumerate(stages))
    return GroupModel(
        title=Words(f"原动件 {name}", f"The driving link {name}"),
        links=(link,),
        stages=joined,
        opening=Words(
            f"原动件 {name} 沿固定导路移动，$s_{{{name}}}$、$v_{{{name}}}$ 已知。",
            f"Link {name} slides on a fixed guide; $s_{{{name}}}$, $v_{{{name}}}$ are given.",
        ),
    )


def given_rates(scope: Scope) -> tuple[tuple[str, float], ...]:
    """The symbols of the drive's rates with their values."""
    _, rate, accel = drive_symbols(scope)
    return (rate, scope.mech.drive.rate), (accel, scope.mech.drive.accel)
