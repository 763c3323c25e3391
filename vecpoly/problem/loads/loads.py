"""Loads as written: forces ``F: {on: 3, at: C, size: 1000 N, direction: 180 deg}``, moments ``M_1: {on: 1, size:
"?"}``."""

from __future__ import annotations

import re

from ...errors import FaultError
from ...mechanism.loads import Force, Load, Loads, Mass, Moment
from ...mechanism.model import FRAME
from ...units.names import unit_of
from ...units.reading import Dim, Quantity, read
from ...words import Words
from ..joints.motion import sense_only
from ..links.bodies import Bodies
from ..problem import Datum
from ..schema.faults import Faults, meant
from ..schema.models import LoadSpec, ProblemSpec
from .thrusts import read_thrust

_NAME = re.compile(r"[A-Z][a-z]?(?:_[A-Za-z0-9]+)?")
_TAKEN = re.compile(
    r"R_\w+|[FM]_I\w+|J_\w+|P_\d\w*"
)  # keys of reactions, inertia forces and couples, inertias, instant centres
_ACTING = ("loads", "masses", "friction", "weight")
UNKNOWN = "?"


def written(text: str) -> str:
    """A unit as a book prints it: N*m → N·m, kg/m^3 → kg/m³."""
    return text.replace("**", "^").replace("*", "·").replace("^2", "²").replace("^3", "³")


def frame_number(bodies: Bodies) -> str:
    """The frame's number as printed: one more than the highest of the links."""
    return str(1 + max(int(m[0]) for name in (*bodies.drafts, *bodies.welded) if (m := re.match(r"\d+", name))))


def acts(spec: ProblemSpec) -> bool:
    """Whether the file speaks of forces at all."""
    return any(getattr(spec, key) for key in _ACTING)


def read_loads(spec: ProblemSpec, bodies: Bodies, masses: tuple[Mass, ...], faults: Faults) -> Loads | None:
    """All that acts but friction; None where the file knows no loads. Exactly one load is unknown, and something must
    act."""
    found: list[Load] = []
    for name, load in spec.loads.items():
        with faults.at("loads", name):
            found.append(_load(name, load, bodies))
    _masses_meant(spec, faults)
    if not acts(spec) or faults.found:
        return None
    if spec.masses and spec.inertia and sense_only(spec):
        with faults.at("input"):
            raise FaultError(
                Words(
                    "计算惯性力需要角速度的数值，如 omega: 10 rad/s ccw；或写 inertia: no",
                    "inertia forces need the angular velocity as a number, e.g. omega: 10 rad/s ccw; or write "
                    "inertia: no",
                ),
                code="spelling",
            )
    with faults.at(next(key for key in _ACTING if getattr(spec, key))):
        _one_unknown(found, bodies)
        loads = Loads(
            forces=tuple(x for x in found if isinstance(x, Force)),
            moments=tuple(x for x in found if isinstance(x, Moment)),
            masses=masses,
            weight=spec.weight,
            inertia=spec.inertia,
        )
        _something_acts(loads)
        return loads
    return None


def _masses_meant(spec: ProblemSpec, faults: Faults) -> None:
    """Weight and inertia forces are those of masses: without any, `weight` and `inertia` would be ignored."""
    for key in ("weight", "inertia"):
        if (
            not spec.masses
            and key in spec.model_fields_set
            and getattr(spec, key) != ProblemSpec.model_fields[key].default
        ):
            with faults.at(key):
                raise FaultError(
                    Words(
                        f"没有构件给出质量，{key} 不起作用；请在 masses 中给出质量，或删去 {key}",
                        f"no link has a mass, so that '{key}' would be ignored; give masses, or leave it out",
                    ),
                    code="contradiction",
                )


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
                f"“{name}”是反力、惯性力或瞬心的符号；载荷请写 F、Q、F_r 或 M_1",
                f"'{name}' is the name of a reaction, of an inertia force or of an instant centre; call the "
                "load F, Q, F_r or M_1",
            )
        )


def _load(name: str, spec: LoadSpec, bodies: Bodies) -> Load:
    _check_name(name)
    if spec.cylinder is not None:
        return read_thrust(name, spec, bodies)
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
    if spec.size is None:
        raise FaultError(
            Words(
                '缺少大小 size；如写 size: 1000 N；待求的平衡载荷写 size: "?"',
                'the size is missing; write e.g. size: 1000 N, or size: "?" for the load that balances',
            ),
            code="missing",
        )
    role = spec.role or ""
    if not _is_force(spec):
        return Moment(name=name, link=spec.on, size=_size(spec.size, Dim.MOMENT), role=role)
    if spec.at is None:
        raise FaultError(
            Words(
                f"力作用于构件 {spec.on} 的哪一点？如写 at: {next(iter(draft.points))}",
                f"at which point of link {spec.on} does the force act? write e.g. at: {next(iter(draft.points))}",
            ),
            code="missing",
        )
    if spec.at not in draft.points:
        raise FaultError(
            Words(f"点“{spec.at}”不在构件 {spec.on} 上", f"point '{spec.at}' is not on link {spec.on}")
            + meant(spec.at, draft.points),
            "at",
            code="unknown-name",
        )
    size = _size(spec.size, Dim.FORCE)
    if size is not None and size < 0:
        raise FaultError(
            Words(
                f"“{spec.size}”为负；请将方向转过 180 deg",
                f"'{spec.size}' is negative; turn the direction by 180 deg instead",
            ),
            "size",
            code="out-of-range",
        )
    return Force(
        name=name,
        link=spec.on,
        point=spec.at,
        direction=_read("direction", spec.direction, Dim.ANGLE).si,
        size=size,
        role=role,
    )


def _is_force(spec: LoadSpec) -> bool:
    """A force has a point and a direction, a moment neither; raises where only one of them is written."""
    if spec.direction is not None:
        return True
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
        return unit_of(m[0].replace("^", "**").replace("·", "*"))[1] if m else ""
    except FaultError:
        return ""


def _size(text: str, dim: Dim) -> float | None:
    return None if text == UNKNOWN else _read("size", text, dim).si


def _read(key: str, text: str | None, dim: Dim) -> Quantity:
    try:
        return read(text, dim)
    except FaultError as fault:
        raise fault.under(key) from None


def _one_unknown(found: list[Load], bodies: Bodies) -> None:
    unknown = [load.name for load in found if load.size is None]
    if len(unknown) > 1:
        raise FaultError(
            Words(
                f"有 {len(unknown)} 个载荷待求（{', '.join(unknown)}），而平衡只能求出一个；请给出其余载荷的大小",
                f"{len(unknown)} loads are unknown ({', '.join(unknown)}), but equilibrium finds one; give the "
                "size of the others",
            )
        )
    if not unknown:
        link = next(iter(bodies.drafts))
        raise FaultError(
            Words(
                f'没有待求的载荷，其余载荷无从平衡；请添加，如 M_{link}: {{on: {link}, size: "?"}}',
                f"no load is unknown, so nothing could balance the others; add e.g. M_{link}: {{on: {link}, "
                'size: "?"}',
            )
        )


def _something_acts(loads: Loads) -> None:
    pushed = any(load.size for load in loads.all) or (loads.masses and (loads.weight or loads.inertia))
    if not pushed:
        raise FaultError(
            Words(
                "除待求载荷外机构不受力，它与各反力均为零；请给出力、力矩或质量",
                "nothing acts on the mechanism but the unknown load: it and all reactions are zero; give a "
                "force, a moment or masses",
            )
        )


def data_of_loads(spec: ProblemSpec, loads: Loads) -> tuple[Datum, ...]:
    """The loads for 已知, and whether weights and inertia forces count."""
    data = [
        _told(load, written(str(spec.loads[load.name].size)), spec.loads[load.name].direction or "")
        for load in loads.all
    ]
    if loads.weight:
        data.append(Datum(words=Words("计各构件重力，$g$ = 9.81 m/s²", "the links' weights count, $g$ = 9.81 m/s²")))
    if loads.masses and not loads.inertia:
        data.append(Datum(words=Words("不计惯性力", "inertia forces are neglected")))
    return tuple(data)


_ROLE = {"": Words("", ""), "driving": Words("驱动", "driving "), "resisting": Words("阻", "resisting ")}


def _told(load: Load, size: str, direction: str) -> Datum:
    role = _ROLE[load.role]
    if isinstance(load, Force) and load.against:
        zh = f"为油缸 {load.against}-{load.link} 的推力，使其伸长者为正"
        en = f"as the thrust of the cylinder {load.against}-{load.link}, positive where it lengthens it"
        name = Words(f"{role.zh}力" if role.zh else "力", f"{role.en}force")
    elif isinstance(load, Force):
        zh = f"作用于构件 {load.link} 的 ${load.point}$ 点，方向角 {direction}"
        en = f"on link {load.link} at ${load.point}$, direction {direction}"
        name = Words(f"{role.zh}力" if role.zh else "力", f"{role.en}force")
    else:
        zh, en = f"作用于构件 {load.link}", f"on link {load.link}"
        name = Words(f"{role.zh}力矩" if role.zh else "力矩", f"{role.en}moment")
    if load.size is None:
        return Datum(
            words=Words(f"待求的{name.zh} ${load.name}$ {zh}", f"the unknown {name.en} ${load.name}$ acts {en}")
        )
    told = Words(f"{name.zh} ${load.name}$ = {{}}，{zh}", f"{name.en} ${load.name}$ = {{}} {en}")
    return Datum(symbol=load.name, si=load.size, text=size, words=told)
