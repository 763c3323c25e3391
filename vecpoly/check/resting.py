"""What is said of links that stand still: in this mechanism, or where the drive is."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .. import oracle
from ..errors import VecpolyError
from ..foundation.slotted import replace
from ..mechanism.groups.resting import Resting, resting
from ..mechanism.model import Mechanism
from ..oracle.motion import Motion
from ..problem.problem import Problem
from ..words import Words

NOTHING = 1e-9  # of the fastest link's rates
STEP = 1e-3  # rad of the drive, or sizes of the mechanism: so far to either side a link is looked at


def at_rest(problem: Problem) -> tuple[Words, ...]:
    """A remark on every group of links that always rests, and on every other link that does here, with the reason."""
    if not isinstance(mech := problem.subject, Mechanism):
        return ()
    groups = resting(mech)
    always = {name for group in groups for name in group.links}
    try:
        here = tuple(_here(mech, always))
    except VecpolyError:  # what cannot be assembled is refused where it is solved
        here = ()
    return (*map(_always, groups), *here)


def _always(group: Resting) -> Words:
    pins = [f"${pin}$" for pin in group.pins]
    on_zh = "、".join([*pins, *(["导路"] if group.slides else [])])
    on_en = ", ".join([*pins, *(["a guide"] if group.slides else [])])
    zh, en = "、".join(group.links), ", ".join(group.links)
    stands, their = ("link {} stands", "its") if len(group.links) == 1 else ("links {} stand", "their")
    return Words(
        f"构件 {zh} 始终静止：所在杆组只与不动的 {on_zh} 相联，输入运动传不到；其速度、加速度恒为零",
        f"{stands.format(en)} still wherever the input is, for {their} group hangs on what does not move ({on_en}); "
        f"{their} velocities and accelerations are zero",
    )


def _here(mech: Mechanism, always: set[str]) -> Iterator[Words]:
    if any(drive.rate == 0 for drive in mech.drives):
        return
    motion = oracle.solve(mech, order=1)
    rates = {name: _rates(motion, name, mech.scale) for name in mech.numbered}
    fastest = max((abs(rate).sum() for rate in rates.values()), default=0.0)
    for name in mech.numbered:
        if name not in always and abs(rates[name]).sum() <= NOTHING * fastest:
            yield _momentarily(mech, name)


def _rates(motion: Motion, name: str, size: float) -> np.ndarray:
    """Of a link: the velocity of its origin, and ω times the size of the mechanism (m/s)."""
    body = motion.moving(name)
    velocity, turning = complex(np.ravel(body.velocity)[0]), float(np.ravel(body.omega)[0])
    return np.array([velocity.real, velocity.imag, turning * size])


def _momentarily(mech: Mechanism, name: str) -> Words:
    """A link turns back, goes on after a pause, or dwells."""
    step = STEP * (mech.scale if mech.drive.slide else 1.0)
    try:
        before, after = (_rates(oracle.solve(_moved(mech, way * step), order=1), name, mech.scale) for way in (-1, 1))
    except VecpolyError:
        return Words(
            f"构件 {name} 在此位置静止，其速度为零", f"link {name} is at rest in this position: its velocities are zero"
        )
    if not before.any() or not after.any():
        return Words(
            f"构件 {name} 在此位置停歇，其速度为零", f"link {name} dwells in this position: its velocities are zero"
        )
    if float(before @ after) < 0:
        return Words(
            f"构件 {name} 在此位置处于极限位置，正要换向，其速度为零",
            f"link {name} is in a limit position, where it turns back: its velocities are zero",
        )
    return Words(
        f"构件 {name} 在此位置速度为零，随后沿原方向继续运动",
        f"link {name} pauses in this position and goes on the same way: its velocities are zero",
    )


def _moved(mech: Mechanism, step: float) -> Mechanism:
    """The drive a little farther on; of several drives the first."""
    first, *others = mech.drives
    return replace(mech, drives=(replace(first, position=first.position + step), *others))
