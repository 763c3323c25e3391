"""Loads as written: forces ``F: {on: 3, at: C, size: 1000 N, direction: 180 deg}``,
moments ``M_1: {on: 1, size: "?"}``, springs."""

from __future__ import annotations

from ...errors import FaultError
from ...foundation.slotted import replace
from ...mechanism.laws.sizes import Motor
from ...mechanism.laws.springs import Coil, Elastic, Spring
from ...mechanism.loads import Constant, Force, Load, Loads, Mass, Moment
from ...words import Words
from ..joints.motion import sense_only
from ..links.bodies import Bodies
from ..schema.faults import Faults
from ..schema.models import ProblemSpec, TableSpec
from .driven import Driven
from .drives import one_drive
from .laws.tables import turns_of
from .load import read_load
from .machine import needs_balance, reduces

BALANCING = "M_b"  # what balances on the driving link at a position, where nobody wrote it
MACHINE = "machine"  # in the place of what balances: of a machine nothing does
_ACTING = ("loads", "masses", "friction", "weight")


def acts(spec: ProblemSpec) -> bool:
    """Whether the file speaks of forces at all."""
    return any(getattr(spec, key) for key in _ACTING)


def read_loads(
    spec: ProblemSpec, bodies: Bodies, masses: tuple[Mass, ...], driven: Driven, faults: Faults
) -> Loads | None:
    """All that acts but friction; None where the file knows no loads.
    Exactly one load is unknown (none need be of a machine), and something must act."""
    found: list[Load | Elastic | Constant] = []
    driven = _over_turns(spec, driven)
    for name, load in spec.loads.items():
        with faults.at("loads", name):
            found.append(read_load(name, load, bodies, driven))
    _masses_meant(spec, faults)
    if not acts(spec) or faults.found:
        return None
    balances = any(isinstance(load, Force | Moment) and load.size is None for load in found)
    if spec.masses and spec.inertia and sense_only(spec) and (balances or not (reduces(spec) or spec.counterweights)):
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
        one_drive(spec, [load for load in found if isinstance(load, Force | Moment) and load.size is None])
        loads = _gathered(found, spec, masses, bodies)
        _something_acts(loads)
        return loads
    return None


def _over_turns(spec: ProblemSpec, driven: Driven) -> Driven:
    """The drive with as many turns as a table says: two, where one goes twice round."""
    tables = (load.size for load in spec.loads.values() if isinstance(load.size, TableSpec))
    return replace(driven, turns=max((turns_of(table) for table in tables), default=1))


def _gathered(
    found: list[Load | Elastic | Constant], spec: ProblemSpec, masses: tuple[Mass, ...], bodies: Bodies
) -> Loads:
    """The loads, with M_b on the driving link where nothing balances at a position but a motor drives, or a constant
    moment is sought."""
    known = [one for one in found if isinstance(one, Force | Moment)]
    constant = [one for one in found if isinstance(one, Constant)]
    motors = [one.link for one in known if one.law is not None and isinstance(one.law.size, Motor)]
    unknown = [one.name for one in known if one.size is None]
    if not unknown and (reduces(spec) or spec.counterweights) and not needs_balance(spec):
        unknown = [MACHINE]
    elif (constant or motors) and not unknown:
        if BALANCING in spec.loads:
            raise _taken()
        known.append(Moment(name=BALANCING, link=constant[0].link if constant else motors[0]))
    sought = [] if unknown == [MACHINE] else [one.name for one in constant]
    _one_unknown([*unknown, *sought] or [one.name for one in known if one.size is None], bodies)
    return Loads(
        forces=tuple(x for x in known if isinstance(x, Force)),
        moments=tuple(x for x in known if isinstance(x, Moment)),
        masses=masses,
        weight=spec.weight,
        inertia=spec.inertia,
        springs=tuple(x for x in found if isinstance(x, Spring | Coil)),
        constant=constant[0] if constant else None,
    )


def _taken() -> FaultError:
    return FaultError(
        Words(
            f"{BALANCING} 是原动件在各位置的平衡力矩的名称；请给此载荷另取名称",
            f"{BALANCING} is what balances on the driving link at a position; give the load another name",
        ),
        BALANCING,
        code="contradiction",
    )


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


def _one_unknown(unknown: list[str], bodies: Bodies) -> None:
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
    pushed = any(load.size for load in loads.all) or loads.springs or (loads.masses and (loads.weight or loads.inertia))
    if not pushed:
        raise FaultError(
            Words(
                "除待求载荷外机构不受力，它与各反力均为零；请给出力、力矩或质量",
                "nothing acts on the mechanism but the unknown load: it and all reactions are zero; give a "
                "force, a moment or masses",
            )
        )
