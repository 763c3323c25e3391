"""Springs and dampers as written: ``F_s: {spring: B-D, k: 5 N/mm, l_0: 80 mm}``, ``M_s: {damper: 1-4, c: 1 N*m*s}``."""

from __future__ import annotations

import re

from ....errors import FaultError
from ....foundation.indices import LETTER
from ....foundation.patterns import pattern
from ....mechanism.laws.springs import Coil, Elastic, Spring
from ....mechanism.model import FRAME
from ....units.reading import Dim, positive, read
from ....words import Words
from ...links.bodies import Bodies, frame_number
from ...links.guides import LINK
from ...schema.faults import meant
from ...schema.models import LoadSpec
from ..driven import Driven
from .windows import point_of

_POINTS = pattern(rf"({LETTER}\d*)\s*[-–,]\s*({LETTER}\d*)")
_LINKS = pattern(rf"({LINK})\s*[-–,]\s*({LINK})")
_ELSEWHERE = ("on", "at", "cylinder", "size", "direction", "between", "during", "motor", "role")


def read_spring(name: str, spec: LoadSpec, bodies: Bodies, driven: Driven) -> Elastic:
    """A spring, a damper, or both side by side; raises FaultError."""
    key = "spring" if spec.spring is not None else "damper"
    _refuse_others(spec, key)
    text = str(getattr(spec, key)).strip()
    damping, stiff = spec.c is not None, spec.k is not None
    if stiff != (key == "spring") or (key == "damper" and not damping):
        raise FaultError(
            Words(
                "弹簧要有刚度 k，阻尼器要有阻尼系数 c；"
                "如写 spring: B-D, k: 5 N/mm, l_0: 80 mm 或 damper: B-D, c: 50 N*s/m",
                "a spring needs its stiffness k, a damper its coefficient c; write e.g. spring: B-D, k: 5 N/mm, "
                "l_0: 80 mm, or damper: B-D, c: 50 N*s/m",
            ),
            code="missing",
        )
    if damping:
        driven.refuse_unrated(Words("阻尼力", "damping"))
    if (links := _LINKS.fullmatch(text)) is not None:
        return _coil(name, spec, _two_links(links, bodies, key))
    points = _POINTS.fullmatch(text)
    if points is None:
        raise FaultError(
            Words(
                f"“{text}”既不是两点也不是两构件；请写 {key}: B-D 或 {key}: 1-4",
                f"'{text}' is neither two points nor two links; write {key}: B-D, or {key}: 1-4",
            ),
            key,
            code="spelling",
        )
    return _straight(name, spec, points, bodies, key)


def _refuse_others(spec: LoadSpec, key: str) -> None:
    extra = [one for one in (*_ELSEWHERE, "while") if getattr(spec, one) is not None]
    if spec.spring is not None and spec.damper is not None:
        extra.append("damper")
    if extra:
        raise FaultError(
            Words(
                f"{key} 的力由其两端的位置和速度决定，始终作用；请删去 {'、'.join(extra)}（弹簧旁的阻尼只写 c）",
                f"what a {key} does follows from the places and speeds of its ends, at all times; leave out "
                f"{', '.join(extra)} (of a damper beside a spring only c is written)",
            ),
            extra[0],
            code="contradiction",
        )


def _straight(name: str, spec: LoadSpec, m: re.Match[str], bodies: Bodies, key: str) -> Spring:
    first, second = (_end(text, bodies, key) for text in m.groups())
    if (why := _keep_apart(m, first, second)) is not None:
        raise FaultError(why, key, code="contradiction")
    if spec.phi_0 is not None:
        raise _not_of("phi_0", Words("两点间的弹簧", "a spring between two points"), "l_0: 80 mm")
    if spec.k is not None and spec.l_0 is None:
        raise FaultError(
            Words(
                "缺少弹簧的自由长度；如写 l_0: 80 mm", "the free length of the spring is missing; write e.g. l_0: 80 mm"
            ),
            code="missing",
        )
    (link, point), (against, foot) = (first, second) if first[0] != FRAME else (second, first)
    return Spring(
        name=name,
        link=link,
        point=point,
        against=against,
        foot=foot,
        stiffness=_positive("k", spec.k, Dim.STIFFNESS),
        free=_positive("l_0", spec.l_0, Dim.LENGTH),
        preload=_value("preload", spec.preload, Dim.FORCE),
        damping=_positive("c", spec.c, Dim.DAMPING),
    )


def _keep_apart(m: re.Match[str], first: tuple[str, str], second: tuple[str, str]) -> Words | None:
    """Why the length between two ends (link, letter) is always the same; None where it changes."""
    if first[0] == second[0]:
        here = Words("都在机架上", "both on the frame") if first[0] == FRAME else Words.same(f"{first[0]}")
        return Words(
            f"{m[1]}、{m[2]} 在同一构件上（{here.zh}），距离不变；请把弹簧连在两个不同的构件之间",
            f"{m[1]} and {m[2]} are on one link ({here.en}) and keep their distance; a spring goes from one link to "
            "another",
        )
    if first[1] != second[1]:
        return None
    return Words(
        f"{m[1]}、{m[2]} 同在 {first[1]} 处，长度恒为 0，其力没有方向；请把弹簧连在两个不同的点之间",
        f"{m[1]} and {m[2]} are both at {first[1]}, so that its length is 0 and its force has no direction; a spring "
        "goes from one point to another",
    )


def _coil(name: str, spec: LoadSpec, links: tuple[str, str]) -> Coil:
    if spec.l_0 is not None:
        raise _not_of("l_0", Words("两构件间的扭簧", "a torsion spring between two links"), "phi_0: 30 deg")
    if spec.k is not None and spec.phi_0 is None:
        raise FaultError(
            Words(
                "缺少扭簧的自由角；如写 phi_0: 30 deg",
                "the free angle of the torsion spring is missing; write e.g. phi_0: 30 deg",
            ),
            code="missing",
        )
    first, second = links
    swap = first == FRAME
    return Coil(
        name=name,
        link=second if swap else first,
        against=first if swap else second,
        stiffness=_positive("k", spec.k, Dim.TWIST),
        free=_value("phi_0", spec.phi_0, Dim.ANGLE),
        preload=_value("preload", spec.preload, Dim.MOMENT),
        damping=_positive("c", spec.c, Dim.DRAG),
    )


def _two_links(m: re.Match[str], bodies: Bodies, key: str) -> tuple[str, str]:
    frame = frame_number(bodies)
    for link in m.groups():
        if link != frame and link not in bodies.numbers:
            raise FaultError(
                Words(f"构件“{link}”不存在", f"link '{link}' does not exist") + meant(link, (*bodies.numbers, frame)),
                key,
                code="unknown-name",
            )
    first, second = (FRAME if link == frame else bodies.draft(link).name for link in m.groups())
    if first == second:
        raise FaultError(
            Words(
                "扭簧应连在两个不同的构件之间，如 spring: 1-4", "a torsion spring goes from one link to another: 1-4"
            ),
            key,
            code="contradiction",
        )
    return first, second


def _end(text: str, bodies: Bodies, key: str) -> tuple[str, str]:
    """Link and letter of an end; FaultError where several moving links have the letter and none is named."""
    if text in bodies.frame:
        return FRAME, text
    carriers = [name for name in bodies.numbers if text in bodies.drafts[name].held]
    if len(carriers) > 1:
        raise FaultError(
            Words(
                f"点 {text} 处有构件 {'、'.join(carriers)}；请写明弹簧连在哪个构件上，如 {text}{carriers[0]}",
                f"links {', '.join(carriers)} meet at {text}; say on which the spring pulls, e.g. {text}{carriers[0]}",
            ),
            key,
            code="ambiguous",
        )
    return point_of(text, None, bodies, key)


def _not_of(key: str, what: Words, instead: str) -> FaultError:
    return FaultError(
        Words(f"{what.zh}没有 {key}；请写 {instead}", f"{what.en} has no {key}; write {instead}"),
        key,
        code="contradiction",
    )


def _positive(key: str, text: str | None, dim: Dim) -> float:
    try:
        return 0.0 if text is None else positive(text, dim).si
    except FaultError as fault:
        raise fault.under(key) from None


def _value(key: str, text: str | None, dim: Dim) -> float:
    try:
        return 0.0 if text is None else read(text, dim).si
    except FaultError as fault:
        raise fault.under(key) from None
