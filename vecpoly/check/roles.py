"""A load that is called driving gives power, one that is called resisting takes it:
P = F · v or M ω, in the position drawn."""

from __future__ import annotations

from cmath import rect
from typing import TYPE_CHECKING

from ..errors import EquilibriumError
from ..mechanism.loads import Force, Load, Loads
from ..names import At
from ..words import Words

if TYPE_CHECKING:
    from ..oracle import Motion
    from ..oracle.forces import Forces

ROLES = {"driving": Words("驱动力（矩）", "driving"), "resisting": Words("阻力（矩）", "resisting")}
NONE = 1e-9  # of the greatest power: no power at all


def refuse_wrong_roles(loads: Loads, balance: Forces) -> None:
    """Raise EquilibriumError where a load does not do what the problem says of it."""
    if not any(load.role for load in loads.all):
        return
    powers = {load.name: _size(load, balance) * _rate(load, balance.motion) for load in loads.all}
    greatest = max(map(abs, powers.values()))
    for load in loads.all:
        power = powers[load.name]
        if load.role and abs(power) > NONE * greatest and (power > 0) != (load.role == "driving"):
            other = "resisting" if load.role == "driving" else "driving"
            does = (
                Words("向机构输入功率", "gives power to") if power > 0 else Words("消耗机构的功率", "takes power from")
            )
            raise EquilibriumError(
                Words(
                    f"载荷 {load.name} 注明为{ROLES[load.role].zh}，但在此位置它{does.zh}；"
                    f"请改变其方向或运动的转向，或写 role: {other}",
                    f"load {load.name} is called {load.role}, but in this position it {does.en} the mechanism: "
                    f"turn round its direction or the motion, or write role: {other}",
                )
            )


def _size(load: Load, balance: Forces) -> float:
    return float(balance.value(load.name).real) if load.size is None or load.law is not None else load.size


def _rate(load: Load, motion: Motion) -> float:
    """What one newton, or one newton metre, of the load gives (m/s, rad/s)."""
    if isinstance(load, Force):
        speed = complex(motion.velocity(At(load.point, load.link)))
        if load.against:
            ray = complex(motion.position(load.point)) - complex(motion.position(load.foot))
            return ((speed - complex(motion.velocity(At(load.foot, load.against)))) * (ray / abs(ray)).conjugate()).real
        return (speed * rect(1.0, -load.direction)).real
    return float(motion.omega(load.link))
