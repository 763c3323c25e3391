"""A torsion spring between links that swing: where it is wound by half a turn from φ_0, its angle would leap."""

from __future__ import annotations

from functools import lru_cache
from math import degrees, pi

import numpy as np

from ....errors import EquilibriumError
from ....mechanism.laws.springs import Coil
from ....mechanism.model import FRAME, Mechanism
from ....words import Words
from ...run import wrapped
from ...state import Reals
from .drives import drive_range, unit_drive
from .returning import over_a_period
from .stands import RANGE, Stands

STEPS = 720


def refuse_wound(coil: Coil, at: Stands) -> None:
    """Raise EquilibriumError where a whole range of positions is asked for, over which the angle leaps."""
    mech = at.mech
    if np.size(at.q) < RANGE or not _leaps(mech, coil):
        return
    here = _relative(unit_drive(mech), coil, np.array([mech.drive.position]))
    side = 1.0 if float(wrapped(here - coil.free)[0]) >= 0 else -1.0
    free, load = degrees(coil.free + side * pi), coil.preload + side * pi * coil.stiffness
    raise EquilibriumError(
        Words(
            f"扭簧 {coil.name}：一个周期内 φ − φ_0 越过 180°，此处力矩会跳变；φ 取在 φ_0 左右半周之内，"
            f"请改写为 phi_0: {free:.6g} deg, preload: {load:.6g} N*m（同一弹簧）",
            f"torsion spring {coil.name}: over the period φ − φ_0 passes 180°, where its moment would leap, as φ is "
            f"taken within half a turn of φ_0; write phi_0: {free:.6g} deg, preload: {load:.6g} N*m, which is the same "
            "spring",
        ),
        code="wound",
        numbers={"spring": coil.name, "phi_0": free, "preload": load},
    )


@lru_cache(maxsize=64)
def _leaps(mech: Mechanism, coil: Coil) -> bool:
    """Whether its links, which do not turn round each other, pass half a turn from φ_0 over the drive's range."""
    _, _, whole = drive_range(mech)
    relative = _relative(unit_drive(mech), coil, over_a_period(mech, STEPS))
    known = relative[np.isfinite(relative)]
    way = np.unwrap(known)
    round_about = whole and abs(float(way[-1] - way[0])) > pi
    return not round_about and bool(np.any(np.abs(np.diff(wrapped(known - coil.free))) > pi))


def _relative(mech: Mechanism, coil: Coil, q: Reals) -> Reals:
    from ... import solve

    motion = solve(mech, q, order=0, strict=False)
    units = [1.0 if link == FRAME else motion.body(link).unit for link in (coil.link, coil.against)]
    return np.broadcast_to(np.angle(units[0] * np.conj(units[1])), q.shape)
