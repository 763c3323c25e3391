"""How much friction there is: ρ = f r of a pin, φ = arctan f of a slide or a contact."""

from __future__ import annotations

import math
from collections.abc import Callable

from ...errors import FaultError
from ...mechanism.groups.assur import hinges
from ...mechanism.model import Mechanism
from ...units.reading import Dim, Quantity, positive, pure, read
from ...words import Words
from ..problem import Datum
from ..schema.models import FrictionSpec


def pins_of(mech: Mechanism) -> tuple[str, ...]:
    """Letters of the pins that turn in a link;
    those of the substitutes of contacts do not exist, and one may only run in a slot."""
    thought = {*mech.substitutes, *mech.slot_pins}
    return tuple(letter for letter, names in hinges(mech).items() if len(set(names) - thought) > 1)


def friction_circle(name: str, spec: FrictionSpec, mech: Mechanism) -> tuple[Datum, float]:
    """ρ of a pin: given, or f r."""
    _only(spec, Words("转动副", "a pin"), Words("rho，或 f 和 r", "rho, or f and r"), "rho", "f", "f_v", "r")
    datum, radius = _given_circle(name, spec) if spec.rho is not None else _journal(name, spec)
    shortest, ends = _shortest(name, mech)
    if radius > shortest / 2:
        raise FaultError(
            Words(
                f"摩擦圆半径 {1e3 * radius:g} mm 大于 {ends} = {1e3 * shortest:g} mm 的一半；请检查两者",
                f"the friction circle's radius {1e3 * radius:g} mm is more than half of {ends} = "
                f"{1e3 * shortest:g} mm; check both",
            ),
            "r" if spec.rho is None else "rho",
            code="out-of-range",
        )
    return datum, radius


def _given_circle(name: str, spec: FrictionSpec) -> tuple[Datum, float]:
    if spec.f is not None or spec.f_v is not None or spec.r is not None:
        raise FaultError(
            Words(
                "rho 与 f 都给了，而 rho = f r；请去掉其一",
                "rho and f are both given, though rho = f r; leave out one of them",
            ),
            code="contradiction",
        )
    rho = _within("rho", lambda: _not_negative(spec.rho, Dim.LENGTH))
    return Datum(symbol=f"ρ_{name}", si=rho.si, text=rho.text), rho.si


def _journal(name: str, spec: FrictionSpec) -> tuple[Datum, float]:
    """ρ = f r."""
    f, sign = _coefficient(spec)
    if spec.r is None:
        raise FaultError(
            Words(
                "缺少轴颈半径；如写 {f: 0.1, r: 20 mm} 或 {rho: 2 mm}",
                "the radius of the pin is missing; write e.g. {f: 0.1, r: 20 mm}, or {rho: 2 mm}",
            ),
            code="missing",
        )
    r = _within("r", lambda: positive(spec.r))
    radius = f * r.si
    own = _own(sign, name)
    text = f"${own}$ = {f:g}，$r_{name}$ = {r.text}，$ρ_{name}$ = ${own} r_{name}$ = {1e3 * radius:.4g} mm"
    return Datum(words=Words(text, text.replace("，", ", "))), radius


def _own(sign: str, name: str) -> str:
    """The symbol of the coefficient at one place: f_A, f_{24}, f_{v24}; that of another may be another."""
    return f"f_{{{sign[2:]}{name}}}" if len(sign[2:] + name) > 1 else f"f_{name}"


def _shortest(name: str, mech: Mechanism) -> tuple[float, str]:
    """The shortest distance, on the moving links at a pin,
    from it to another pin or to the link's other first point."""
    pins, found = pins_of(mech), [(math.inf, "")]
    for link in (mech.link(one) for one in mech.links_at(name) if one in mech.bodies):
        base = (*[p for p in link.points if p in pins], *list(link.points)[:2])
        found += [
            (abs(link.points[p] - link.points[name]), f"{name}{p}") for p in base if link.points[p] != link.points[name]
        ]
    return min(found)


def _phi_alone(spec: FrictionSpec) -> None:
    """Raise FaultError where a coefficient or a groove stands beside an angle of friction."""
    if spec.f is not None or spec.f_v is not None:
        raise FaultError(
            Words(
                "phi 与 f 都给了，而 phi = arctan f；请去掉其一",
                "phi and f are both given, though phi = arctan f; leave out one of them",
            ),
            code="contradiction",
        )
    if spec.V is not None:
        raise FaultError(
            Words(
                "V 须与槽面的 f 同用（f_v = f / sin V）；请改写 f，或去掉 V",
                "V goes with the f of the groove's faces (f_v = f / sin V), not with phi; write f, or leave out V",
            ),
            code="contradiction",
        )


def friction_angle(name: str, spec: FrictionSpec) -> tuple[Datum, float]:
    """φ of a slide or a contact: given, or arctan f; in a V-groove of half angle V, f_v = f / sin V."""
    _only(
        spec,
        Words("移动副或接触点", "a slide or a contact"),
        Words("phi，或 f，或 f 和 V", "phi, or f, or f and V"),
        "phi",
        "f",
        "f_v",
        "V",
    )
    if spec.phi is not None:
        _phi_alone(spec)
        phi = _within("phi", lambda: _not_negative(spec.phi, Dim.ANGLE))
        if phi.si >= math.pi / 2 * (1 - 1e-12):
            raise FaultError(
                Words(
                    f"摩擦角 {phi.text} 对任何力都自锁；应小于 90 deg",
                    f"a friction angle of {phi.text} would hold against any force; it must be less than 90 deg",
                ),
                "phi",
                code="out-of-range",
            )
        return Datum(symbol=f"φ_{{{name}}}", si=phi.si, text=phi.text), phi.si
    f, sign = _coefficient(spec)
    own = _own(sign, name)
    text = f"${own}$ = {f:g}"
    if spec.V is not None:
        half = _within("V", lambda: _half_angle(spec.V))
        groove, equal = f"θ_{{{name}}}", _own("f_v", name)
        text += f"，${groove}$ = {half.text}，${equal}$ = ${own}$/sin ${groove}$ = {f / math.sin(half.si):.4g}"
        f, own = f / math.sin(half.si), equal
    angle = math.atan(f)
    text += f"，$φ_{{{name}}}$ = arctan ${own}$ = {math.degrees(angle):.4g} deg"
    return Datum(words=Words(text, text.replace("，", ", "))), angle


def _only(spec: FrictionSpec, what: Words, keys: Words, *allowed: str) -> None:
    given = [key for key in type(spec).model_fields if getattr(spec, key) is not None]
    if not given:
        raise FaultError(
            Words(f"摩擦多大？{what.zh}应给 {keys.zh}", f"how large is the friction? {what.en} takes {keys.en}"),
            code="missing",
        )
    if strange := [key for key in given if key not in allowed]:
        raise FaultError(
            Words(
                f"“{strange[0]}”不是{what.zh}的数据，其应给 {keys.zh}",
                f"'{strange[0]}' is no datum of {what.en}, which takes {keys.en}",
            ),
            strange[0],
            code="spelling",
        )


def _coefficient(spec: FrictionSpec) -> tuple[float, str]:
    if spec.f is not None and spec.f_v is not None:
        raise FaultError(
            Words("f 与 f_v 都给了；请去掉其一", "f and f_v are both given; leave out one of them"),
            code="contradiction",
        )
    key, text = ("f", spec.f) if spec.f is not None else ("f_v", spec.f_v)
    if text is None:
        raise FaultError(
            Words("缺少摩擦系数 f；如写 f: 0.1", "the coefficient f is missing; write e.g. f: 0.1"), code="missing"
        )
    try:
        f = pure(text, f"{key}: 0.1")
    except FaultError as fault:
        raise fault.under(key) from None
    if f < 0:
        raise FaultError(
            Words(
                f"{key} = {text}：摩擦系数不得为负；如写 {key}: 0.1",
                f"{key} = {text}: a coefficient of friction is not negative; write e.g. {key}: 0.1",
            ),
            key,
            code="out-of-range",
        )
    return f, key


def _half_angle(text: str | None) -> Quantity:
    half = positive(text, Dim.ANGLE)
    if half.si > math.pi / 2 * (1 + 1e-12):
        raise FaultError(
            Words(
                f"“{half.text}”大于 90 deg；V 为槽形半角，如 V: 45 deg",
                f"'{half.text}' is more than 90 deg; V is half the angle of the groove, e.g. V: 45 deg",
            ),
            code="out-of-range",
        )
    return half


def _not_negative(text: str | None, dim: Dim) -> Quantity:
    quantity = read(text, dim)
    if quantity.si < 0:
        raise FaultError(
            Words(
                f"“{text}”不得为负；如写 {'6 mm' if dim is Dim.LENGTH else '8 deg'}",
                f"'{text}' must not be negative; write e.g. {'6 mm' if dim is Dim.LENGTH else '8 deg'}",
            ),
            code="out-of-range",
        )
    return quantity


def _within(key: str, act: Callable[[], Quantity]) -> Quantity:
    try:
        return act()
    except FaultError as fault:
        raise fault.under(key) from None
