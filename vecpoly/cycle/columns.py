"""What a cycle can tell, by key: the quantity's symbol, unit and words, and the key of its time derivative.

Beside the keys of `names` and of `mechanism.quantities`: ``phi_2`` angle of link 2; ``s_45``, ``v_45``, ``a_45`` travel
of block 4
along link 5, its speed and relative acceleration (links by printed numbers); ``gamma_23`` transmission angle of the
dyad of links 2
and 3; ``d_45`` distance of the outer pins of an RPR dyad. A vector's parts: ``v_E.x``, ``v_E.y``, ``v_E.abs``,
``v_E.arg``. Of masses ``shaking_F``, ``shaking_M``: what their inertia does to the frame.
"""

from __future__ import annotations

import re
from itertools import chain

from ..errors import EquilibriumError, UnknownNameError
from ..foundation.slotted import replace
from ..mechanism.asked.forces import pairs, press_named, quantities, slide_named
from ..mechanism.asked.machine import reduced_quantities
from ..mechanism.groups.assur import Dyad, decompose, ends
from ..mechanism.loads import Loads
from ..mechanism.model import FRAME, Mechanism, Prismatic
from ..mechanism.rams import driver_words
from ..names import Kind, Named, Rel, parse_rel, subscripted
from ..problem.text.spelling import did_you_mean
from ..words import Words
from .column import Column, of_loads, of_reduced, part_words
from .counted import counted_from
from .shaking import SHAKING

PARTS = ("x", "y", "abs", "arg")


def slides(mech: Mechanism) -> dict[str, Prismatic]:
    """Every sliding joint by the printed numbers of block and guide: 45."""
    return {
        slide_named(mech, joint): joint
        for joint in mech.joints
        if isinstance(joint, Prismatic) and {joint.block, joint.guide} <= {*mech.bodies, FRAME}
    }


def dyads(mech: Mechanism) -> dict[str, Dyad]:
    """Every dyad by its links: 23; a pin in a slot by its letter: 2B."""
    return {group.label: group.dyad for group in decompose(mech) if group.dyad is not None}


def moving_points(mech: Mechanism) -> tuple[str, ...]:
    """Letters that move, in the order of the links; not the centre of curvature of a cam's profile, which is another
    point of the cam in each position."""
    letters = chain.from_iterable(mech.link(name).points for name in mech.bodies)
    others = {*mech.frame, *(cam.centre for cam in mech.cams)}
    return tuple(letter for letter in dict.fromkeys(letters) if letter not in others)


def catalogue(mech: Mechanism, loads: Loads | None, points: tuple[str, ...] | None = None) -> tuple[Column, ...]:
    """The columns of a whole-cycle table:
    links, points, slides, transmission angles, what balances and what presses."""
    keys = [f"{stem}_{name}" for name in mech.numbered for stem in ("phi", "omega", "alpha")]
    keys += [
        f"{stem}_{letter}" for letter in (moving_points(mech) if points is None else points) for stem in ("p", "v", "a")
    ]
    keys += [f"{stem}_{pair}" for pair in slides(mech) for stem in ("s", "v", "a")]
    keys += [f"gamma_{pair}" for pair, dyad in dyads(mech).items() if "G" not in dyad.kind]
    if loads is not None and not loads.balancing:
        keys += [key for key in ("J_e", "M_e") if key in reduced_quantities(mech)]
    elif loads is not None:
        keys += [loads.unknown.name, *(["eta"] if loads.friction else [])]
        keys += [load.name for load in loads.all if load.law is not None]
        keys += [spring.name for spring in loads.springs]
        keys += [press_named(mech, a, b).key for a, b in pairs(mech)]
    return tuple(column_of(mech, loads, key) for key in keys)


def column_of(mech: Mechanism, loads: Loads | None, key: str) -> Column:
    """The column with this key; UnknownNameError where there is none."""
    base, dot, part = key.partition(".")
    if dot:
        return _part(column_of(mech, loads, base), part)
    stem, _, rest = key.partition("_")
    if stem == "phi" and rest in mech.numbered:
        return Column(
            key=key,
            symbol=f"φ_{{{rest}}}",
            unit="rad",
            words=_angle_words(mech, rest),
            rate=f"omega_{rest}",
            turns=True,
        )
    if stem in ("s", "v", "a") and rest in slides(mech):
        return _slide(key, stem, rest, *(mech.number(name) for name in reversed(ends(slides(mech)[rest]))))
    if stem == "gamma" and rest in dyads(mech):
        return Column(key=key, symbol=f"γ_{{{rest}}}", unit="rad", words=_gamma_words(mech, rest))
    if stem == "d" and rest in dyads(mech):
        return Column(
            key=key,
            symbol=f"d_{{{rest}}}",
            unit="m",
            words=Words(f"杆组 {rest} 两外接副的距离", f"distance of the outer pins of dyad {rest}"),
        )
    if loads is not None and loads.masses and key in SHAKING:
        return SHAKING[key]
    if loads is not None and (named := loaded_quantities(mech, loads).get(key)) is not None:
        return of_reduced(named) if named.is_reduced else of_loads(named)
    if (loads is None or not loads.balancing) and re.fullmatch(r"(R|M|F|h|eta|Q)(_\w+)?", key):
        raise EquilibriumError(
            Words(
                f"题目没有载荷，不能求 {key}；题目中须有 loads",
                f"there are no loads, so {key} cannot be asked for; the problem needs `loads`",
            )
        )
    return _kinematic(mech, key)


def loaded_quantities(mech: Mechanism, loads: Loads) -> dict[str, Named]:
    """What a mechanism has on which these loads act: what balances them, and its equivalents."""
    return (quantities(mech, loads) if loads.balancing else {}) | reduced_quantities(mech)


def drive_column(mech: Mechanism) -> Column:
    """The drive's position: φ_1, or s_1 of a sliding input; between two links φ_23 of a motor, s_23 of a cylinder."""
    drive = mech.drive
    if drive.between:
        which, words = f"{drive.link}{drive.on}", driver_words(mech)
        travel, angle = Words("的长度", "length of "), Words("的转角", "angle of ")
    else:
        which, words = drive.link, Words(f"原动件 {drive.link} ", f"the driving link {drive.link}")
        travel, angle = Words("的位移", "travel of "), Words("的转角", "angle of ")
    (stem, letter, unit), what = (("s", "s", "m"), travel) if drive.slide else (("phi", "φ", "rad"), angle)
    told = Words(words.zh + what.zh, what.en + words.en) + counted_from(mech)
    return Column(key=f"{stem}_{which}", symbol=f"{letter}_{{{which}}}", unit=unit, words=told, zero=drive.lead)


def _part(whole: Column, part: str) -> Column:
    if not whole.is_vector or part not in PARTS:
        raise UnknownNameError(
            Words(
                f"没有 {whole.key}.{part}；矢量的分量有 {', '.join(PARTS)}",
                f"there is no {whole.key}.{part}; a vector has the parts {', '.join(PARTS)}",
            )
        )
    key, rate = f"{whole.key}.{part}", f"{whole.rate}.{part}" if whole.rate and part in "xy" else ""
    stem, sub = whole.symbol.partition("_")[0], whole.symbol.partition("_")[2].strip("{}")
    if part in "xy":
        symbol = f"{part}_{{{sub}}}" if stem == "r" else f"{stem}_{{{sub}{part}}}"
        return replace(
            whole, key=key, symbol=symbol, is_vector=False, rate=rate, words=part_words(whole, part, sub, symbol)
        )
    if part == "abs":
        return replace(whole, key=key, is_vector=False, rate="", words=whole.words + Words("的大小", ", magnitude"))
    return Column(
        key=key,
        symbol=f"θ_{{{stem}{sub}}}",
        unit="rad",
        words=whole.words + Words("的方向角", ", direction"),
        turns=True,
    )


def _slide(key: str, stem: str, pair: str, block: str, guide: str) -> Column:
    zh, en = {"s": ("位移", "travel"), "v": ("相对速度", "speed"), "a": ("相对加速度", "relative acceleration")}[stem]
    unit, rate = {"s": ("m", f"v_{pair}"), "v": ("m/s", f"a_{pair}"), "a": ("m/s^2", "")}[stem]
    words = Words(f"构件 {block} 沿构件 {guide} 的{zh}", f"{en} of link {block} along link {guide}")
    return Column(key=key, symbol=f"{stem}_{{{pair}}}", unit=unit, words=words, rate=rate)


def _gamma_words(mech: Mechanism, name: str) -> Words:
    """Of a dyad; of the contact whose replacing link is in it."""
    if len(mech.contacts) == 1 and not {dyads(mech)[name].link_j, dyads(mech)[name].link_k} <= {*mech.bodies}:
        letter = mech.contacts[0].point
        return Words(f"高副 ${letter}$ 的传动角", f"transmission angle at contact ${letter}$")
    return Words(f"杆组 {name} 的传动角", f"transmission angle of dyad {name}")


def _angle_words(mech: Mechanism, name: str) -> Words:
    letters = mech.link(name).axis
    parts = (subscripted(letter).partition("_") for letter in letters)
    bar = "".join(f"{letter}_{{{index}}}" if index else letter for letter, _, index in parts)
    said = f"${bar}$" if len(letters) == 2 else ""
    return Words(
        f"构件 {name} 的转角" + (f"（{said} 的方向）" if said else ""),
        f"angle of link {name}" + (f" (direction {said})" if said else ""),
    )


_WORDS = {
    Kind.P: Words("位置", "position"),
    Kind.V: Words("速度", "velocity"),
    Kind.A: Words("加速度", "acceleration"),
    Kind.AN: Words("法向加速度", "normal acceleration"),
    Kind.AT: Words("切向加速度", "tangential acceleration"),
    Kind.AK: Words("哥氏加速度", "Coriolis acceleration"),
    Kind.AR: Words("相对加速度", "relative acceleration"),
    Kind.OMEGA: Words("角速度", "angular velocity"),
    Kind.ALPHA: Words("角加速度", "angular acceleration"),
}
_RATES = {Kind.P: "v", Kind.V: "a", Kind.OMEGA: "alpha"}


def _read(key: str) -> Rel:
    try:
        return parse_rel(key)
    except UnknownNameError as error:
        raise UnknownNameError(error.words + did_you_mean(key), code="unknown-symbol") from None


def _kinematic(mech: Mechanism, key: str) -> Column:
    rel = _read(key)
    if not rel.is_vector and rel.to.link not in mech.numbered:
        raise UnknownNameError(
            Words(
                f"没有构件 {rel.to.link}；已有：{', '.join(mech.numbered)}",
                f"there is no link {rel.to.link}; known: {', '.join(mech.numbered)}",
            )
        )
    if rel.is_vector:
        _refuse_unknown_points(mech, rel)
    rate = f"{_RATES[rel.kind]}_{key.partition('_')[2]}" if rel.kind in _RATES and rel.ref is None else ""
    return Column(key=key, symbol=rel.symbol, unit=rel.unit, words=_told(rel), is_vector=rel.is_vector, rate=rate)


def _refuse_unknown_points(mech: Mechanism, rel: Rel) -> None:
    letters = {*mech.frame, *(p for link in mech.links for p in link.points), *(c.point for c in mech.contacts)}
    known = {*letters, *(getattr(joint, "point", "") for joint in mech.joints)}
    for at in (rel.to, rel.ref):
        if at and not {at.point, at.point.rstrip("0123456789"), str(at)} & known:
            raise UnknownNameError(
                Words(
                    f"没有点 {at}；已有：{', '.join(sorted(letters))}",
                    f"there is no point {at}; known: {', '.join(sorted(letters))}",
                )
            )


def _told(rel: Rel) -> Words:
    """构件 2 的角速度 / angular velocity of link 2."""
    what = _WORDS[rel.kind]
    if not rel.is_vector:
        return Words(f"构件 {rel.to.link} 的{what.zh}", f"{what.en} of link {rel.to.link}")
    name = subscripted(str(rel.to))
    if rel.ref and (ref := subscripted(str(rel.ref))):
        return Words(f"点 ${name}$ 相对 ${ref}$ 的{what.zh}", f"{what.en} of ${name}$ relative to ${ref}$")
    return Words(f"点 ${name}$ 的{what.zh}", f"{what.en} of point ${name}$")
