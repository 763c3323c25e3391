"""Slips that are another motion: other assembly, other position of the drive,
another quantity, a term left out, differences."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import pi

import numpy as np

from ...errors import VecpolyError
from ...names import At, Kind, Rel
from ...oracle import Motion
from ...words import Words
from ..table.target import Part, Reals, Target, others
from ..table.truth import Truth, solved
from ..table.weigh import Column
from .guess import Guess, Slip, Told
from .lengths import other_assemblies
from .rates import Loops


def other_motions(truth: Truth) -> list[Told]:
    """The mechanism in another assembly, and at other positions of its drive."""
    found: list[Told] = []
    for words, mech in other_assemblies(truth.mech):
        if (motion := solved(mech, truth.positions)) is not None:
            found.append((Slip.BRANCH, words, motion, truth.positions))
    for slip, words, positions in _positions(truth):
        if (motion := solved(truth.mech, positions)) is not None:
            found.append((slip, words, motion, positions))
    return found


def _positions(truth: Truth) -> Iterator[tuple[Slip, Words, Reals]]:
    q = truth.positions
    step = float(np.median(np.diff(q)))
    for sign in (1, -1):
        zh, en = ("后", "later") if sign > 0 else ("前", "earlier")
        yield (
            Slip.DRIVE,
            Words(f"整列错开一行（取{zh}一行的值）", f"the column shifted by one row (values of the row {en})"),
            q + sign * step,
        )
    if truth.mech.drive.slide:
        return
    yield (
        Slip.RADIANS,
        Words("把曲柄转角的度数当作弧度代入", "the crank angle in degrees was taken for radians"),
        np.degrees(q),
    )
    yield (
        Slip.RADIANS,
        Words("对已是弧度的曲柄转角又乘了 π/180", "the crank angle, already in radians, was multiplied by π/180 again"),
        np.radians(q),
    )


def at_other_motions(column: Column, motions: Sequence[Told]) -> Iterator[Guess]:
    """The column's quantity in each of these motions."""
    for slip, words, motion, _ in motions:
        yield Guess(slip=slip, words=words, expected=column.target.of(motion))


def swapped(column: Column, truth: Truth) -> Iterator[Guess]:
    """Another quantity of the same kind, or the difference of two."""
    exact = truth.of(column.target)
    for target, less in others(truth.mech, column.target):
        try:
            value = truth.of(target)
        except VecpolyError:
            continue
        symbol = f"${target.symbol}$"
        if less is not None:
            value, symbol = exact - truth.of(less), f"${target.symbol} - {less.symbol}$"
        words = Words(f"这一列是 {symbol}", f"this column is {symbol}")
        yield Guess(slip=Slip.SWAPPED, words=words, expected=value)


def terms(column: Column, truth: Truth, left_out: Sequence[tuple[Words, Motion]]) -> Iterator[Guess]:
    """A term left out of the acceleration equations, or of the point's own acceleration."""
    rel = column.target.rel
    if rel is None or rel.kind not in (Kind.ALPHA, Kind.A):
        return
    for words, motion in left_out:
        yield Guess(slip=Slip.TERM, words=words, expected=column.target.of(motion))
    if rel.kind is Kind.A and rel.ref is None:
        yield from _of_point(column.target, rel, truth)


def divisors(column: Column, undivided: Sequence[tuple[Kind, Words, Motion]]) -> Iterator[Guess]:
    """A rate of one dyad that was not divided by the dyad's determinant, and all that hangs on it."""
    rel = column.target.rel
    rate = (
        {Kind.OMEGA: Kind.OMEGA, Kind.V: Kind.OMEGA, Kind.ALPHA: Kind.ALPHA, Kind.A: Kind.ALPHA}.get(rel.kind)
        if rel
        else None
    )
    for kind, words, motion in undivided:
        if kind is rate:
            yield Guess(slip=Slip.DIVISOR, words=words, expected=column.target.of(motion))


def loops_without(truth: Truth) -> list[tuple[Words, Motion]]:
    """Motions with one term left out; none where links roll."""
    try:
        return list(Loops.of(truth.mech, truth.motion).without())
    except VecpolyError:
        return []


def _of_point(target: Target, rel: Rel, truth: Truth) -> Iterator[Guess]:
    """a_E = a_P + aⁿ_EP + aᵗ_EP with one of the parts missing, for every other point P of its link."""
    motion, name = truth.motion, str(rel.to)
    link, _ = motion.locate(rel.to)
    here = motion.position(rel.to)
    for letter in truth.mech.link(link).points:
        if letter == rel.to.point:
            continue
        base = At(letter, link)
        arm = here - motion.position(base)
        normal, tangential = -(motion.omega(link) ** 2) * arm, 1j * motion.alpha(link) * arm
        start = motion.acceleration(base)
        for part, less in (
            (f"a^n_{{{name}{letter}}}", start + tangential),
            (f"a^t_{{{name}{letter}}}", start + normal),
        ):
            yield Guess(
                slip=Slip.TERM, words=Words(f"漏掉 ${part}$", f"${part}$ left out"), expected=_number(target, less)
            )
        opposite = start - normal + tangential
        yield Guess(
            slip=Slip.TERM,
            words=Words(f"$a^n_{{{name}{letter}}}$ 反向", f"$a^n_{{{name}{letter}}}$ with the wrong sense"),
            expected=_number(target, opposite),
        )


def _number(target: Target, value: np.ndarray[tuple[int, ...], np.dtype[np.complex128]]) -> Reals:
    match target.part:
        case Part.X:
            return np.asarray(value.real)
        case Part.Y:
            return np.asarray(value.imag)
    return np.abs(value)


def differences(column: Column, columns: Sequence[Column], truth: Truth) -> Iterator[Guess]:
    """Differences of the printed column of which this one is the derivative by time:
    forward, backward, central; by the angle too."""
    before = integral(column.target)
    base = next((one for one in columns if one.target == before), None)
    drive = truth.mech.drive
    if base is None or before is None or not drive.rate:
        return
    symbol, exact = f"${base.target.symbol}$", truth.of(before)
    for zh, en, values in (("所列 ", "the printed ", base.values), ("", "", exact)):
        values = np.unwrap(values) if base.target.is_angle and np.isfinite(values).all() else values
        with np.errstate(divide="ignore", invalid="ignore"):
            slope = np.diff(values) / np.diff(truth.positions)
            central = (values[2:] - values[:-2]) / (truth.positions[2:] - truth.positions[:-2])
        ways = (
            ("向前差分", "forward", np.concatenate([slope, slope[-1:]])),
            ("向后差分", "backward", np.concatenate([slope[:1], slope])),
            ("中心差分", "central", np.concatenate([slope[:1], central, slope[-1:]])),
        )
        for way_zh, way, rate in ways:
            told = Words(f"由{zh}{symbol} 的{way_zh}得出", f"{way} differences of {en}{symbol}")
            yield Guess(slip=Slip.DIFFERENCE, words=told, expected=rate * drive.rate)
            if abs(drive.rate - 1) > 1e-9:
                yield Guess(
                    slip=Slip.DIFFERENCE,
                    expected=rate,
                    words=Words(
                        f"由{zh}{symbol} 对转角的{way_zh}得出，漏乘 $ω_{{{drive.link}}}$",
                        f"{way} differences of {en}{symbol} by the angle, $ω_{{{drive.link}}}$ left out",
                    ),
                )
            if not drive.slide:
                yield Guess(
                    slip=Slip.DIFFERENCE,
                    expected=rate * drive.rate * pi / 180,
                    words=Words(
                        f"由{zh}{symbol} 对度数的{way_zh}得出，少乘 180/π",
                        f"{way} differences of {en}{symbol} by degrees, 180/π left out",
                    ),
                )


def integral(target: Target) -> Target | None:
    """Of α: ω; of ω: φ; of a component of v or a: that of the place or of v."""
    rel = target.rel
    if rel is None:
        return None
    match rel.kind:
        case Kind.ALPHA:
            return Target(rel=Rel(Kind.OMEGA, rel.to))
        case Kind.OMEGA:
            return Target(link=rel.to.link)
        case Kind.A | Kind.V if target.part in (Part.X, Part.Y):
            return Target(rel=Rel(Kind.V if rel.kind is Kind.A else Kind.P, rel.to), part=target.part)
    return None
