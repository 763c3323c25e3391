"""What is asked and what was printed."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from ...errors import FaultError, UnknownNameError
from ...figures import Mu, scales
from ...figures.mu import LENGTH
from ...limits import PAPER
from ...mechanism.model import FRAME, Mechanism
from ...names import At, Key, Kind, Named, Rel, parse_rel
from ...units.names import unit_of
from ...units.reading import Dim, PerMm, pure, read
from ...words import Words
from ..links.bodies import Bodies
from ..links.draft import letters_of
from ..loads.loads import frame_number
from ..problem import Printed, Scales
from ..schema.faults import meant
from ..schema.models import FindSpec, PrintedSpec, ScalesSpec
from ..text.spelling import did_you_mean, intended, plain
from .asks import Ask, AskCoriolis, AskNamed, AskPoint, AskRel

_POINT = re.compile(r"([A-Z][a-z'′]?)(\d+)")
_FORCES = re.compile(r"[A-Z]\w*_?\w*|eta|[hm](?:_\w+)?")  # what may be meant for a quantity of the loads
CENTRAL = re.compile(r"P_\d|v_P\d|omega_ratio_|phi_[A-Z]")  # how what instant centres give is written
_PERCENT = re.compile(r"\s*([-+−]?[\d.]+)\s*[%％]\s*")
_DIM = {Kind.P: Dim.LENGTH, Kind.V: Dim.SPEED, Kind.OMEGA: Dim.OMEGA, Kind.ALPHA: Dim.ALPHA}
_MU = {Kind.P: Dim.MU_L, Kind.V: Dim.MU_V, Kind.OMEGA: Dim.MU_V}


def read_find(spec: str | FindSpec, bodies: Bodies, named: Iterable[At], forces: Mapping[str, Named]) -> Ask:
    """One entry of `find`; `named` are points the problem itself names, such as M2; `forces` what may be asked of its
    loads."""
    if isinstance(spec, str):
        key = read_any(spec, bodies, named, forces)
        return AskNamed(rel=key) if isinstance(key, Named) else AskRel(rel=key)
    if spec.coriolis is not None:
        if beside := [key for key in FindSpec.model_fields if key != "coriolis" and getattr(spec, key) is not None]:
            raise FaultError(
                Words(
                    f"coriolis 不能与 {'、'.join(beside)} 并用；请分写成两项",
                    f"coriolis does not go together with {', '.join(beside)}; write them as two entries",
                ),
                beside[0],
            )
        return AskCoriolis(rel=read_key(f"ak_{spec.coriolis}", bodies, named))
    return read_point(spec, bodies)


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
    if text in forces:
        return forces[text]
    if CENTRAL.match(text) and text[0] != "v":
        raise FaultError(
            Words(
                f"“{text}”不是两构件的瞬心（用构件号表示，机架号最大）",
                f"'{text}' names no instant centre of two links by their numbers (the frame has the last)",
            )
            + meant(text, [k for k in forces if k[0] == text[0]])
        )
    loads = [key for key, named in forces.items() if not named.is_central]
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
    """S2 is the letter S2 where there is one, not a point S thought on link 2; the frame has the number after the
    highest."""
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


def read_scales(spec: ScalesSpec) -> Scales:
    """Given scales; those that are auto are left out."""
    written = {key: (mu, getattr(spec, key, "auto")) for key, mu in scales().items()}
    return Scales({key: _scale(mu, text) for key, (mu, text) in written.items() if text not in ("auto", "自动")})


def _scale(mu: Mu, text: str) -> float:
    try:
        value = read(text, PerMm(mu.called, mu.unit, mu.example)).si
    except FaultError as fault:
        raise fault.under(mu.key) from None
    if value <= 0:
        raise FaultError(
            Words(
                f"“{text}”应大于零；如写 {mu.example} 或 auto",
                f"'{text}' must be greater than zero; write e.g. {mu.example} or auto",
            ),
            mu.key,
            code="out-of-range",
        )
    return value


def plottable(given: Scales, mech: Mechanism) -> None:
    """Raise FaultError where the mechanism would be a speck, or far larger than any paper."""
    per_mm = given.of(LENGTH)
    if per_mm is None:
        return
    size, (least, most) = mech.scale / per_mm, PAPER
    if not least <= size <= most:
        told = f"{size:.3g} mm"
        raise FaultError(
            Words(
                f"按此比例尺，机构在图纸上的尺寸为 {told}，无法作图（应在 {least:g} 至 {most:g} mm 之间）；"
                "请核对或写 auto",
                f"at this scale the mechanism would measure {told} on paper, which cannot be "
                f"drawn ({least:g} to {most:g} mm can); check it, or write auto",
            ),
            "mu_l",
        )


def _is_length(text: str) -> bool:
    words = text.split()
    return bool(words) and unit_of(words[-1])[1] == Dim.LENGTH.dimension


def read_printed(spec: PrintedSpec, bodies: Bodies, named: Iterable[At], forces: Mapping[str, Named]) -> Printed:
    """One entry of `printed`: a value with its unit, or a length on paper with its scale."""
    rel = None if spec.symbol.startswith("l_") else read_any(spec.symbol, bodies, named, forces)
    return as_given(spec, rel)


def as_given(spec: PrintedSpec, rel: Key | None) -> Printed:
    """The printed value of this quantity (None: of a length on the diagram)."""
    kind = rel.kind if isinstance(rel, Rel) else Kind.P
    direction = _direction(spec, rel)
    if spec.scale is None:
        value = (
            _named_value(spec.value, rel) if isinstance(rel, Named) else read(spec.value, _DIM.get(kind, Dim.ACCEL)).si
        )
        paper, scale = None, None
    else:
        if not _is_length(spec.value):
            raise FaultError(
                Words(
                    f"“{spec.value}”不是图上长度，而又给了比例尺；如写 41.1 mm",
                    f"'{spec.value}' is no length on paper, though a scale is given; write e.g. 41.1 mm",
                ),
                "value",
                code="spelling",
            )
        paper = read(spec.value, Dim.LENGTH).si * 1e3
        scale = read(spec.scale, Dim.MU_F if isinstance(rel, Named) else _MU.get(kind, Dim.MU_A)).si
        value = paper * scale
    return Printed(
        symbol=spec.symbol,
        rel=rel,
        value=value,
        text=spec.value,
        kind=spec.kind,
        paper_mm=paper,
        scale=scale,
        direction=direction,
        note=spec.note,
    )


def _direction(spec: PrintedSpec, rel: Key | None) -> float | None:
    """The printed direction (rad) of a vector; FaultError for that of anything else."""
    if spec.direction is None:
        return None
    if rel is None or not rel.is_vector:
        raise FaultError(
            Words(
                f"{spec.symbol} 不是矢量，没有方向；请删去 direction（转向写在数值之后，如 2 rad/s cw）",
                f"{spec.symbol} is no vector and has no direction; leave it out (a sense is "
                "written behind the value, 2 rad/s cw)",
            ),
            "direction",
        )
    return read(spec.direction, Dim.ANGLE).si


def _named_value(text: str, named: Named) -> float:
    """A printed force, moment, length, angle, power or pure number, in the unit in which the quantity is kept."""
    if not named.unit:
        m = _PERCENT.fullmatch(text)
        try:
            return pure(m[1], "85 %") / 100 if m else pure(text, "0.85 (85 %)")
        except FaultError as fault:
            raise fault.under("value") from None
    factor, dimension = unit_of(named.unit.replace("·", "*").replace("^", "**"))
    dim = next(dim for dim in Dim if dim.dimension == dimension)
    return read(text, dim).si / factor
