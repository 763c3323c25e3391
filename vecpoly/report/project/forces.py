"""A chapter on the forces of a mechanism: kinetostatics of the positions drawn, the driving moment over the cycle."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...algebra.quantity import number
from ...cycle import Cycle
from ...cycle import table as columns
from ...project.flywheel import Balance
from ...project.part import Part
from ...words import Words
from ..course.numbering import SMALL
from ..course.results.tabled import laid_out
from ..steps.sections import sections
from .binder import Binder
from .motion import pressing, readings

_STEP = 10.0  # degrees between the rows of the table
_WIDE = (150.0, 60.0)  # mm


def chapter(part: Part, binder: Binder) -> dict[str, Any]:
    """What acts where, the steps, the readings, tables and curves of the cycle, motor and flywheel."""
    drawn, press = binder.drawn[part.name], binder.press
    title = Words("图解值与精确值：力和力矩", "Drawn and exact values: forces and moments")
    reactions = _reactions(part)
    turn = part.working.merged([*reactions, *_free(part)])
    return {
        "where": drawn[0].where,
        "works": _works(part).of(binder.lang),
        "sections": sections(pressing(part.solution), binder.lang, press.objects),
        "results": readings(binder, drawn, False, title),
        "moment": _moment(part, turn, binder) if part.balance else "",
        "reactions": [_reaction_curves(turn, reactions, binder)] if reactions else [],
        "cycle": laid_out(
            columns(turn, (*_free(part), *(f"{key}.abs" for key in reactions)), turn.rows(np.radians(_STEP))),
            press,
            Words("平衡力矩和运动副反力", "The balancing moment and the reactions"),
            SMALL,
        ),
        "even": None if part.balance is None else _even(part, part.balance),
        "symbol": turn.drive.symbol,
    }


def _free(part: Part) -> tuple[str, ...]:
    assert part.problem.loads is not None
    return (part.problem.loads.unknown.name,)


def _reactions(part: Part) -> list[str]:
    """The reactions asked for, those of one size everywhere once."""
    found: list[str] = []
    sizes: list[Any] = []
    for key in (ask.rel.key for ask in part.problem.asks if ask.rel.key.startswith("R_") and ask.rel.key[-2:] != "_0"):
        size = part.working.real(key)
        if not any(np.allclose(size, other, rtol=1e-9, atol=1e-9, equal_nan=True) for other in sizes):
            found.append(key)
            sizes.append(size)
    return found


def _works(part: Part) -> Words:
    """Over which range of the drive the load of one stroke acts."""
    force = part.working.force
    if force is None:
        return Words.same("")
    ranges = [f"{part.turn.drive.told(a):.1f}°～{part.turn.drive.told(b):.1f}°" for a, b in part.working.stretches]
    symbol = part.turn.drive.symbol
    return Words(
        f"${force.name}$ 只在 ${symbol}$ = {'、'.join(ranges)} 内作用，其余位置不计。",
        f"${force.name}$ acts at ${symbol}$ = {', '.join(ranges).replace('～', ' to ')} only.",
    )


def _moment(part: Part, turn: Cycle, binder: Binder) -> str:
    """The curve of the driving moment, its mean dashed."""
    from ...curves import curves
    from ...curves.style import PENS, line

    assert part.balance is not None
    made = curves(turn, (part.balance.key,), binder.lang, width=_WIDE[0], panel=_WIDE[1])
    sign = np.sign(turn.mech.drive.rate)
    ends = [turn.drive.told(turn.phi[0]), turn.drive.told(turn.phi[-1])]
    line(made.figure.axes[0], ends, [sign * part.balance.mean] * 2, PENS[1])
    symbol = turn.info(part.balance.key).symbol
    title = Words(
        f"平衡力矩 ${symbol}$ 的变化曲线（虚线为其平均值）", f"The balancing moment ${symbol}$; dashed: its mean"
    )
    return binder.press.figure(made.scene, title)


def _reaction_curves(turn: Cycle, keys: list[str], binder: Binder) -> str:
    from ...curves import curves

    made = curves(turn, tuple(keys[:4]), binder.lang, width=_WIDE[0], panel=_WIDE[1], marks=False)
    return binder.press.figure(made.scene, Words("运动副反力的变化曲线", "The reactions over the cycle"))


def _even(part: Part, even: Balance) -> dict[str, str]:
    """The numbers of motor and flywheel."""
    return {
        "symbol": part.turn.info(even.key).symbol,
        "max": number(even.highest.value),
        "max_at": part.study.where(even.highest.phi),
        "min": number(even.lowest.value),
        "min_at": part.study.where(even.lowest.phi),
        "mean": number(even.mean),
        "power": number(1e-3 * even.power),
        "omega": number(abs(part.problem.mechanism.drive.rate)),
        "stored": number(even.stored),
        "delta": "" if part.unevenness is None else number(part.unevenness),
        "inertia": "" if even.inertia is None else number(even.inertia),
    }
