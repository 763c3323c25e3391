"""Lengths with which a wrong column becomes right, found by fit: computed with them throughout, or the rates alone."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial

import numpy as np

from ...errors import VecpolyError
from ...foundation.slotted import replace
from ...mechanism.model import FRAME, Mechanism
from ...oracle import Motion
from ...words import Words
from ..table.target import Reals
from ..table.truth import solved
from ..table.weigh import Column, Level, Weighing
from .explain import LOOSE, SURE, Explanation, Suspect
from .fit import Fit, Model, fits, polished, thinned, weighed
from .guess import Slip
from .rates import mixed


def lengths_found(columns: Sequence[Column], by: Suspect) -> list[list[tuple[Fit, Explanation]]]:
    """For each column the lengths, one at a time, with which it becomes right when all is computed with them."""
    return _found(columns, by, lambda q: partial(_solved, q), Slip.LENGTH)


def rates_found(columns: Sequence[Column], by: Suspect) -> list[list[tuple[Fit, Explanation]]]:
    """The same for rates alone: the angles as they are, velocities and accelerations with another length."""
    return _found(
        columns,
        by,
        lambda q: partial(mixed_or_none, (by.truth if q is by.truth.positions else by.thin).motion),
        Slip.RATES,
    )


def _solved(positions: Reals, mech: Mechanism) -> Motion | None:
    return solved(mech, positions)


def mixed_or_none(poses: Motion, mech: Mechanism) -> Motion | None:
    """Rates with the lengths of this mechanism at the angles of that motion; None where there are none."""
    try:
        return mixed(mech, poses)
    except (VecpolyError, ValueError, ArithmeticError):
        return None


def _found(
    columns: Sequence[Column], by: Suspect, model_at: Callable[[Reals], Model], slip: Slip
) -> list[list[tuple[Fit, Explanation]]]:
    """Fit every column, then all columns together that one length makes right, and try that value on every column."""
    part = thinned(len(by.truth.positions))
    thin = [replace(column, values=column.values[part], half=column.half[part]) for column in columns]
    narrow, wide = model_at(by.thin.positions), model_at(by.truth.positions)
    found: list[dict[tuple[str, float], tuple[Fit, Explanation]]] = []
    for column, best in zip(columns, fits(thin, by.thin, narrow, coarse=slip is Slip.RATES), strict=True):
        mine = [
            (fit, after)
            for one in best
            if _other(fit := polished([column], by.truth, one, wide))
            and (after := weighed(column, by.truth, fit, wide))
        ]
        found.append({_name(fit): (fit, explained_by(fit, after, slip)) for fit, after in mine})
    pool = {
        _name(fit): fit
        for fit in (
            *_together(columns, found, by, wide),
            *(fit for told in found for fit, one in told.values() if _fits(one.after)),
        )
    }
    for column, told in zip(columns, found, strict=True):
        for name, fit in pool.items():
            if name not in told and (after := weighed(column, by.truth, fit, wide)) is not None:
                told[name] = fit, explained_by(fit, after, slip)
    return [list(told.values()) for told in found]


def _together(
    columns: Sequence[Column],
    found: Sequence[Mapping[tuple[str, float], tuple[Fit, Explanation]]],
    by: Suspect,
    wide: Model,
) -> Iterator[Fit]:
    """For every length that makes several columns right, the one value with which they are right together."""
    names = dict.fromkeys(name for told in found for (name, _), (_, one) in told.items() if _fits(one.after))
    for name in names:
        right = [
            (column, fit)
            for column, told in zip(columns, found, strict=True)
            for fit, one in told.values()
            if fit.length.words.en == name and _fits(one.after)
        ]
        middle = float(np.median([fit.value for _, fit in right]))  # two signs may leave it at 0
        near = [one for one in right if abs(one[1].value - middle) < 0.05 * abs(middle)]
        if len(near) > 1 and _other(fit := polished([column for column, _ in near], by.truth, near[0][1], wide)):
            yield fit


def _fits(after: Weighing) -> bool:
    return after.level < Level.WRONG and (after.doubt <= SURE or after.spread <= 2 * LOOSE)


def _other(fit: Fit) -> bool:
    """Whether it is another value, and not on the other side of a link (that is another assembly)."""
    times = fit.value / fit.length.value
    return abs(times - 1) > 1e-6 and (times > 0 or fit.length.link == FRAME)


def _odd(fit: Fit) -> int:
    """Decimals of mm beyond those of the length that is given, and 0.1 mm."""
    usual, found = (len(f"{1e3 * value:.4f}".rstrip("0").partition(".")[2]) for value in (fit.length.value, fit.value))
    return max(found - max(min(usual, 2), 1), 0) + (2 if found > usual + 1 else 0)


def _name(fit: Fit) -> tuple[str, float]:
    return fit.length.words.en, round(fit.value, 9)


def explained_by(fit: Fit, after: Weighing, slip: Slip) -> Explanation:
    """A length that was found by fit, in words."""
    name, value, given = fit.length.words, f"{1e3 * fit.value:.6g}", f"{1e3 * fit.length.value:.6g}"
    if slip is Slip.LENGTH:
        words = Words(
            f"按 {name.zh} = {value} mm 计算（而不是 {given} mm）",
            f"computed with {name.en} = {value} mm (not {given} mm)",
        )
    else:
        words = Words(
            f"位置按 {name.zh} = {given} mm，速度和加速度却按 {name.zh} = {value} mm 计算",
            f"angles with {name.en} = {given} mm, but rates computed with {name.en} = {value} mm",
        )
    return Explanation(slip=slip, words=words, after=after, parameter=fit.value, length=name.en, odd=_odd(fit))
