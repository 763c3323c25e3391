"""One load as written: a force, a moment, the thrust of a cylinder."""

from __future__ import annotations

import re

from ...errors import FaultError
from ...foundation.patterns import pattern
from ...mechanism.laws.springs import Elastic
from ...mechanism.loads import Constant, Force, Load, Moment
from ...mechanism.model import FRAME
from ...units.names import plain, unit_of
from ...units.reading import Dim, Quantity, read
from ...words import Words
from ..links.bodies import Bodies, frame_number
from ..links.draft import Draft
from ..schema.faults import meant, not_on_link
from ..schema.models import LoadSpec, TableSpec
from .driven import Driven
from .laws.lawful import CONSTANT, lawful, read_constant, read_motor
from .laws.springs import read_spring
from .thrusts import read_thrust
from .ways import read_way

_NAME = pattern(r"[A-Z][a-z]?(?:_[A-Za-z0-9]+)?")
# keys of reactions, inertia forces and couples, inertias, instant centres, equivalents
_TAKEN = pattern(r"R_\w+|[FM]_I\w+|J_\w+|P_\d\w*|[FM]_e(?:\d\w*)?")
UNKNOWN = "?"
WIDE_UNKNOWN = "？"  # of a Chinese keyboard: between quotes there is no doubt what is meant


def _check_name(name: str) -> None:
    if not _NAME.fullmatch(name):
        raise FaultError(
            Words(
                f"“{name}”不是载荷名；请写 F、Q、F_r 或 M_1", f"'{name}' is no name of a load; write F, Q, F_r or M_1"
            ),
            code="spelling",
        )
    if _TAKEN.fullmatch(name):
        raise FaultError(
            Words(
                f"“{name}”是反力、惯性力、瞬心或等效量的符号；载荷请写 F、Q、F_r 或 M_1",
                f"'{name}' is the name of a reaction, of an inertia force, of an instant centre or of an equivalent; "
                "call the load F, Q, F_r or M_1",
            )
        )


def read_load(name: str, spec: LoadSpec, bodies: Bodies, driven: Driven) -> Load | Elastic | Constant:
    """One entry of `loads`; raises FaultError."""
    _check_name(name)
    if isinstance(spec.size, str) and spec.size.strip() in (UNKNOWN, WIDE_UNKNOWN):
        spec = spec.model_copy(update={"size": UNKNOWN})
    if spec.spring is not None or spec.damper is not None:
        return read_spring(name, spec, bodies, driven)
    if spec.cylinder is not None:
        return lawful(read_thrust(name, spec, bodies), spec, bodies, driven)
    draft = _moving(spec, bodies)
    if spec.motor is not None:
        return lawful(read_motor(name, spec, draft, driven), spec, bodies, driven)
    if isinstance(spec.size, str) and spec.size.strip() in CONSTANT:
        return read_constant(name, spec, draft, driven)
    if spec.size is None:
        raise FaultError(
            Words(
                '缺少大小 size；如写 size: 1000 N；待求的平衡载荷写 size: "?"',
                'the size is missing; write e.g. size: 1000 N, or size: "?" for the load that balances',
            ),
            code="missing",
        )
    if _is_force(spec):
        return lawful(_force(name, spec, spec.size, draft, driven), spec, bodies, driven)
    own = Moment(name=name, link=draft.name, size=_size(spec.size, Dim.MOMENT), role=spec.role or "")
    return lawful(own, spec, bodies, driven)


def _moving(spec: LoadSpec, bodies: Bodies) -> Draft:
    """The link on which it acts."""
    if spec.on is None:
        raise FaultError(
            Words(
                "缺少载荷所作用的构件；请写 on: 3（油缸推力则写 cylinder: 2-3）",
                "'on' is missing: on which link does the load act? write on: 3 (the thrust of a cylinder: "
                "cylinder: 2-3)",
            ),
            "on",
        )
    draft = bodies.drafts.get(spec.on) if spec.on in bodies.numbers else None
    if spec.on in (FRAME, frame_number(bodies)):
        raise FaultError(
            Words(
                f"构件 {spec.on} 是机架，其上的载荷不影响运动；请加在活动构件上，或去掉",
                f"link {spec.on} is the frame: a load there moves nothing; put it on a moving link or leave it out",
            ),
            "on",
        )
    if draft is None:
        raise FaultError(
            Words(f"构件“{spec.on}”不存在", f"link '{spec.on}' does not exist") + meant(spec.on, bodies.numbers),
            "on",
            code="unknown-name",
        )
    return draft


def _force(name: str, spec: LoadSpec, written: str | TableSpec, draft: Draft, driven: Driven) -> Force:
    if spec.at is None:
        raise FaultError(
            Words(
                f"力作用于构件 {spec.on} 的哪一点？如写 at: {next(iter(draft.points))}",
                f"at which point of link {spec.on} does the force act? write e.g. at: {next(iter(draft.points))}",
            ),
            code="missing",
        )
    if spec.at not in draft.held:
        raise not_on_link(spec.at, draft.name, draft.held, "at")
    size = _size(written, Dim.FORCE)
    if size is not None and size < 0:
        raise FaultError(
            Words(
                f"“{spec.size}”为负；请将方向转过 180 deg",
                f"'{spec.size}' is negative; turn the direction by 180 deg instead",
            ),
            "size",
            code="out-of-range",
        )
    way, along = read_way(spec, draft, driven)
    return Force(name=name, link=draft.name, point=spec.at, direction=way, size=size, role=spec.role or "", along=along)


def _is_force(spec: LoadSpec) -> bool:
    """A force has a point and a direction, a moment neither; raises where only one of them is written."""
    if spec.direction is not None:
        return True
    if isinstance(spec.size, TableSpec):
        return spec.at is not None
    turns = spec.size not in (None, UNKNOWN) and _dimension(str(spec.size)) == Dim.MOMENT.dimension
    if spec.at is not None and turns:
        raise FaultError(
            Words(
                f"力矩（{spec.size}）作用于整个构件；请去掉 at",
                f"a moment ({spec.size}) acts on the whole link; leave out 'at'",
            ),
            "at",
            code="contradiction",
        )
    if spec.at is not None:
        raise FaultError(
            Words(
                f"作用在 {spec.at} 的力要有方向，如 direction: 180 deg；力矩则不写 at",
                f"a force at {spec.at} needs its direction, e.g. direction: 180 deg; a moment has no 'at'",
            ),
            code="missing",
        )
    if spec.size != UNKNOWN and not turns and _dimension(str(spec.size)) == Dim.FORCE.dimension:
        raise FaultError(
            Words(
                f"力（{spec.size}）要有作用点和方向，如 at: C, direction: 180 deg；力矩写作 20 N*m ccw",
                f"a force ({spec.size}) needs its point and direction, e.g. at: C, direction: 180 deg; a moment "
                "is written 20 N*m ccw",
            ),
            code="missing",
        )
    return False


def _dimension(text: str) -> str:
    """The dimension of a written quantity; empty where it cannot be read (`read` will say why)."""
    m = re.search(r"[A-Za-z°牛千米].*$", re.sub(r"\s*(ccw|cw|逆时针|顺时针)(方向)?$", "", text))
    try:
        return unit_of(plain(m[0]))[1] if m else ""
    except FaultError:
        return ""


def _size(text: str | TableSpec, dim: Dim) -> float | None:
    """The size as written; of a table, which has its own, 0 for the time being."""
    if isinstance(text, TableSpec):
        return 0.0
    return None if text == UNKNOWN else _read("size", text, dim).si


def _read(key: str, text: str | None, dim: Dim) -> Quantity:
    try:
        return read(text, dim)
    except FaultError as fault:
        raise fault.under(key) from None
