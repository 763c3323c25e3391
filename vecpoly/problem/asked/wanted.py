"""What is asked and what was printed."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from ...errors import FaultError, UnknownNameError
from ...foundation.indices import LETTER
from ...foundation.patterns import pattern
from ...mechanism.asked.machine import RUN_KEYS
from ...mechanism.model import FRAME
from ...names import At, Key, Named, Rel, parse_rel
from ...units.reading import Dim, read
from ...words import Words
from ..links.bodies import Bodies, frame_number
from ..links.draft import letters_of
from ..schema.faults import meant
from ..schema.models import FindSpec
from ..text.spelling import did_you_mean, intended, plain
from .asks import Ask, AskCoriolis, AskNamed, AskPoint, AskRel
from .untouched import refuse_untouched
from .written import named_by

_POINT = pattern(rf"({LETTER})(\d+)")
_FORCES = pattern(r"[A-Z]\w*_?\w*|eta|[hm](?:_\w+)?")  # what may be meant for a quantity of the loads
CURVED = pattern(r"(?:Wr?|U)_\d|delta_\d|lambda_\d|rho_[A-Z]|p_O[A-Z]")  # how what curvatures give is written
CENTRAL = pattern(r"P_\d|v_P\d|omega_ratio_|phi_[A-Z]")  # how what instant centres give is written


def read_find(spec: str | FindSpec, bodies: Bodies, named: Iterable[At], forces: Mapping[str, Named]) -> Ask:
    """One entry of `find`; `named` are points the problem itself names, such as M2;
    `forces` what may be asked of its loads."""
    if isinstance(spec, str):
        key = read_any(spec, bodies, named, forces)
        return AskNamed(rel=key) if isinstance(key, Named) else AskRel(rel=key)
    if spec.coriolis is not None:
        refuse_beside(spec, "coriolis", ())
        return AskCoriolis(rel=read_key(f"ak_{spec.coriolis}", bodies, named))
    return read_point(spec, bodies)


def refuse_beside(spec: FindSpec, key: str, own: tuple[str, ...]) -> None:
    """Raise FaultError for what does not belong to this entry beside its own keys."""
    given = [one for one in FindSpec.model_fields if getattr(spec, one) is not None]
    if beside := [one for one in given if one != key and one not in own]:
        raise FaultError(
            Words(
                f"{key} 不能与 {'、'.join(beside)} 并用；请分写成两项",
                f"{key} does not go together with {', '.join(beside)}; write them as two entries",
            ),
            beside[0],
        )


def read_point(spec: FindSpec, bodies: Bodies) -> AskPoint:
    """{point: M2, on: 2, velocity: 0}."""
    m = _POINT.fullmatch(spec.point or "")
    if m is None:
        raise FaultError(
            Words(
                "请写 v_E 之类的符号，或 {point: M2, on: 2, velocity: 0}，或 {coriolis: B3B2}",
                "write a symbol such as v_E, or {point: M2, on: 2, velocity: 0}, or {coriolis: B3B2}",
            ),
            code="spelling",
        )
    refuse_beside(spec, "point", ("on", "velocity", "acceleration", "slowest"))
    link = spec.on or m[2]
    bodies.draft(link)
    if link != m[2]:
        raise FaultError(
            Words(
                f"点 {spec.point} 应在构件 {m[2]} 上，而 on 写的是 {link}",
                f"point {spec.point} would be on link {m[2]}, but 'on' says {link}",
            )
        )
    if [spec.velocity, spec.acceleration, spec.slowest].count(None) != 2:
        raise FaultError(
            Words(
                "请给出该点的速度或加速度，或给出它在其上速度最小的直线（slowest: BC），三者取一",
                "give either the velocity or the acceleration of the point, or the line of which it is the "
                "slowest point (slowest: BC)",
            )
        )
    return AskPoint(
        name=m[0],
        link=link,
        slowest=None if spec.slowest is None else _line(spec.slowest, bodies.draft(link).points, link),
        velocity=_vector(spec.velocity, Dim.SPEED),
        acceleration=_vector(spec.acceleration, Dim.ACCEL),
    )


def _line(text: str, points: Iterable[str], link: str) -> tuple[str, str]:
    """Two letters of a link: BC."""
    first, second = letters_of(text)
    if first == second or not {first, second} <= set(points):
        raise FaultError(
            Words(
                f"“{text}”不是过构件 {link} 上两点的直线（{', '.join(points)}）；如写 slowest: BC",
                f"'{text}' names no line through two points of link {link} ({', '.join(points)}); write e.g. "
                "slowest: BC",
            ),
            "slowest",
            code="unknown-name",
        )
    return first, second


def _vector(value: tuple[str, str] | str | None, dim: Dim) -> complex | None:
    if value is None:
        return None
    if isinstance(value, str):
        if read(value, dim).si != 0:
            raise FaultError(
                Words(
                    f"请写出两个分量，如 [{dim.example}, {dim.example}]，或写 0",
                    f"write both components, e.g. [{dim.example}, {dim.example}], or 0",
                ),
                code="spelling",
            )
        return 0j
    return complex(read(value[0], dim).si, read(value[1], dim).si)


def read_any(text: str, bodies: Bodies, named: Iterable[At], forces: Mapping[str, Named]) -> Key:
    """A key of motion (v_E) or of forces (R_12); raises FaultError."""
    if (meant_so := named_by(text, forces)) is not None:
        return meant_so
    if CENTRAL.match(text) and text[0] != "v":
        raise FaultError(
            Words(
                f"“{text}”不是两构件的瞬心（用构件号表示，机架号最大）",
                f"'{text}' names no instant centre of two links by their numbers (the frame has the last)",
            )
            + meant(text, [k for k in forces if k[0] == text[0]])
        )
    curved = [key for key, named in forces.items() if named.is_curved]
    if curved and CURVED.match(text):
        raise FaultError(
            Words(
                f"“{text}”不是机构中某构件或其上一点的曲率", f"'{text}' is no curvature of a link, or of a point, here"
            )
            + meant(text, curved),
            code="unknown-name",
        )
    _refuse_running(text, forces)
    loads = [key for key, named in forces.items() if not (named.is_central or named.is_curved or named.is_pressure)]
    if loads:
        refuse_untouched(plain(text), bodies, loads)
    if _FORCES.fullmatch(text) and (loads or intended(text) is None):
        raise FaultError(
            Words(f"“{text}”不是这些载荷下可求的量", f"'{text}' is no quantity of these loads") + meant(text, loads)
            if loads
            else Words(
                f"求“{text}”需要载荷；请在 loads 中写出作用于机构的载荷",
                f"'{text}' needs loads; say under 'loads' what acts on the mechanism",
            ),
            code="missing",
        )
    return read_key(text, bodies, named)


def _refuse_running(text: str, forces: Mapping[str, Named]) -> None:
    """Raise FaultError for what only a machine that runs has."""
    if RUN_KEYS.fullmatch(text):
        raise FaultError(
            Words(
                f"求“{text}”须说明机器如何运转；如写 machine: {{n: 60 r/min, delta: 0.05}}",
                f"'{text}' needs to know how the machine runs; write e.g. machine: {{n: 60 r/min, delta: 0.05}}",
            )
            + meant(text, [key for key, named in forces.items() if named.is_reduced]),
            code="missing",
        )


def read_key(text: str, bodies: Bodies, named: Iterable[At] = ()) -> Rel:
    """A key whose letters and links exist."""
    try:
        rel = parse_rel(plain(text))
    except UnknownNameError as error:
        no_symbol = Words(f"“{text}”不是可识别的符号", f"'{text}' is no symbol")
        raise FaultError(
            no_symbol + did_you_mean(text) if intended(text) else error.words, code="unknown-symbol"
        ) from None
    rel = Rel(rel.kind, _lettered(rel.to, bodies), _lettered(rel.ref, bodies) if rel.ref else None)
    for at in (rel.to, *([rel.ref] if rel.ref else [])):
        if at not in named and rel.key not in {f"p_{at}" for at in named}:
            _known(at, text, bodies)
    return rel


def _lettered(at: At, bodies: Bodies) -> At:
    """S2 is the letter S2 where there is one, not a point S thought on link 2;
    the frame has the number after the highest."""
    if str(at) in bodies.letters():
        return At(str(at))
    return At(at.point, FRAME, at.link) if at.point and at.link == frame_number(bodies) else at


def _known(at: At, text: str, bodies: Bodies) -> None:
    if at.link and at.link != FRAME and at.link not in bodies.numbers:
        raise FaultError(
            Words(f"{text}：构件“{at.link}”不存在", f"{text}: link '{at.link}' does not exist")
            + meant(at.link, bodies.numbers),
            code="unknown-name",
        )
    letters = (*bodies.letters(), *bodies.pitch)
    if at.point and at.point not in letters:
        raise FaultError(
            Words(f"{text}：点“{at.point}”不存在", f"{text}: point '{at.point}' does not exist")
            + meant(at.point, letters),
            code="unknown-name",
        )
    if at.point in bodies.pitch and not at.link and text.startswith("a"):
        raise FaultError(
            Words(
                f"{text}：{at.point} 处两构件的加速度不同；请写明构件号，如 {text}{next(iter(bodies.drafts))}",
                f"{text}: at {at.point} the two links have different accelerations; write whose, e.g. "
                f"{text}{next(iter(bodies.drafts))}",
            )
        )
