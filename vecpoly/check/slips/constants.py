"""Slips that are one constant: a factor (2π, r/min, ω of the drive,
two crank lengths), the sign, the zero of an angle."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees, pi

import numpy as np

from ...names import Kind
from ...oracle.run import wrapped
from ...words import Words
from ..table.target import Reals
from ..table.truth import Truth
from ..table.weigh import Column
from .fit import as_good
from .guess import Guess, Slip

CLOSE = 4.0  # standard errors within which a fitted factor is the one that is named
NEAR = 5e-3  # relative: near enough to the one that is named for it to be tried
UNITY = 1e-6  # relative: a drive with this rate is one of 1 rad/s
_FACTORS = (
    (2 * pi, Slip.FACTOR, Words("多乘 2π", "a factor 2π too many")),
    (1 / (2 * pi), Slip.FACTOR, Words("少乘 2π（把 r/s 当作 rad/s）", "2π left out (rev/s taken for rad/s)")),
    (4 * pi**2, Slip.FACTOR, Words("多乘 (2π)²", "a factor (2π)² too many")),
    (1 / (4 * pi**2), Slip.FACTOR, Words("少乘 (2π)²（把 r/s 当作 rad/s）", "(2π)² left out (rev/s taken for rad/s)")),
    (2 * pi / 60, Slip.UNIT, Words("多乘 2π/60", "multiplied by 2π/60 once too often")),
    (60 / (2 * pi), Slip.UNIT, Words("把 r/min 当作 rad/s（少乘 2π/60）", "r/min taken for rad/s (2π/60 left out)")),
    ((2 * pi / 60) ** 2, Slip.UNIT, Words("多乘 (2π/60)²", "multiplied by (2π/60)² once too often")),
    (
        (60 / (2 * pi)) ** 2,
        Slip.UNIT,
        Words("把 r/min 当作 rad/s（少乘 (2π/60)²）", "r/min taken for rad/s ((2π/60)² left out)"),
    ),
    (180 / pi, Slip.UNIT, Words("以度代替弧度", "degrees for radians")),
    (pi / 180, Slip.UNIT, Words("以弧度代替度", "radians for degrees")),
    (2.0, Slip.FACTOR, Words("多乘 2", "a factor 2 too many")),
    (0.5, Slip.FACTOR, Words("少乘 2", "a factor 2 left out")),
    *(
        (
            10.0**n,
            Slip.UNIT,
            Words(
                f"差 {10.0**n:g} 倍（单位）",
                f"{10.0**n:g} times too large (units)" if n > 0 else f"{10.0**-n:g} times too small (units)",
            ),
        )
        for n in (-6, -3, -2, -1, 1, 2, 3, 6)
    ),
)

_OF_PLACES = (2.0, 0.5, *(10.0**n for n in (-6, -3, -2, -1, 1, 2, 3, 6)))


def constants(column: Column, truth: Truth) -> Iterator[Guess]:
    """Every constant that may lie between the column and the exact values."""
    exact = truth.of(column.target)
    if column.target.is_angle:
        yield from _zeros(column, exact)
        yield from _angle_units(exact)
        yield from _quadrant(column, exact)
        return
    found = _ratio(column, exact)
    if found is None:
        return
    factor, sigma = found
    if abs(factor + 1) < CLOSE * sigma:
        yield Guess(
            slip=Slip.SIGN, words=Words("符号（转向）相反", "opposite sign (sense)"), expected=-exact, parameter=-1.0
        )
        return
    hits = [one for one in _named(column, truth) if abs(abs(factor) - one[0]) < max(CLOSE * sigma, NEAR * one[0])]
    sign = Words("，且符号相反", ", and the sign reversed") if factor < 0 else Words.same("")
    for value, slip, words in hits:
        yield Guess(
            slip=slip,
            words=words + sign,
            expected=np.copysign(value, factor) * exact,
            parameter=float(np.copysign(value, factor)),
        )
    if all(abs(abs(factor) - value) > CLOSE * sigma for value, _, _ in hits) and abs(factor - 1) > CLOSE * sigma:
        yield _unnamed(column, truth, _round_number(factor, 2 * sigma))


def _named(column: Column, truth: Truth) -> list[tuple[float, Slip, Words]]:
    """The factors that have a name, and may lie on such a column: places know no ω, and of units the lengths' alone."""
    factors = (*_drive_factors(truth), *_FACTORS)
    if not column.target.is_place:
        return list(factors)
    return [one for one in factors if one[1] is not Slip.OMEGA and one[0] in _OF_PLACES]


def _unnamed(column: Column, truth: Truth, factor: float) -> Guess:
    """A factor that is none of the usual ones."""
    factor, ratio = _lengths_ratio(column, truth, factor)
    words = Words(f"差常数倍 {factor:.6g}", f"a constant factor {factor:.6g}") + ratio
    written = len(f"{abs(factor):.6g}".lstrip("0.").replace(".", ""))
    odd = 0 if ratio.en else max(written - 2, 0)
    expected = factor * truth.of(column.target)
    return Guess(slip=Slip.FACTOR, words=words, expected=expected, parameter=factor, odd=odd)


def _ratio(column: Column, exact: Reals) -> tuple[float, float] | None:
    """The factor by least squares, without the rows that lie far from it, and its standard error."""
    good = column.there & np.isfinite(exact) & (exact != 0)
    if good.sum() < 3:
        return None
    printed, true, half = column.values[good], exact[good], column.half[good]
    factor = float(np.median(printed / true))
    for _ in range(4):
        off = np.abs(printed - factor * true)
        kept = off <= np.maximum(3 * np.median(off), 2 * half)
        factor = float((printed[kept] * true[kept]).sum() / max(float((true[kept] ** 2).sum()), 1e-300))
    power = float((true[kept] ** 2).sum())
    scatter = float(np.sqrt(np.mean(np.maximum(np.abs(printed - factor * true)[kept], half[kept] / 2) ** 2)))
    largest = float(np.abs(true[kept]).max())
    # equal numbers are all rounded one way
    alike = float(np.median(half[kept])) / largest if np.ptp(np.abs(true[kept])) < 1e-6 * largest else 0.0
    return (factor, max(scatter / np.sqrt(power), alike)) if factor and power else None


def _round_number(value: float, within: float) -> float:
    """With as few digits as the error leaves."""
    rounded = (float(f"{value:.{n}g}") for n in range(1, 8))
    return next((one for one in rounded if abs(one - value) <= within), value)


def _drive_factors(truth: Truth) -> Iterator[tuple[float, Slip, Words]]:
    """ω of the drive left out, or taken once too often: of importance where it is not 1."""
    if truth.mech.drive.slide:
        return
    rate, symbol = abs(truth.mech.drive.rate), f"$ω_{{{truth.mech.drive.link}}}$"
    if not rate or abs(rate - 1) < UNITY:
        return
    yield 1 / rate, Slip.OMEGA, Words(f"漏乘 {symbol}", f"{symbol} left out")
    yield rate, Slip.OMEGA, Words(f"多乘一次 {symbol}", f"{symbol} taken once too often")
    yield 1 / rate**2, Slip.OMEGA, Words(f"漏乘 {symbol} 的平方", f"the square of {symbol} left out")
    yield rate**2, Slip.OMEGA, Words(f"多乘 {symbol} 的平方", f"the square of {symbol} taken once too often")


def _lengths_ratio(column: Column, truth: Truth, factor: float) -> tuple[float, Words]:
    """At given angles all velocities go with the crank's length:
    a factor that is no round number may be 26.5/24, and is that then."""
    length = next((one for one in truth.lengths if one.link == truth.mech.drive.link), None)
    rel = column.target.rel
    if length is None or rel is None or rel.kind not in (Kind.OMEGA, Kind.V) or float(f"{factor:.3g}") == factor:
        return factor, Words.same("")
    here, there = 1e3 * length.value, 1e3 * length.value * abs(factor)
    if abs(round(there, 1) - there) > 1e-4 * there:
        return factor, Words.same("")
    exact, other = truth.of(column.target), float(np.copysign(round(there, 1) / here, factor))
    plain, named = (float(np.nanmedian(np.abs(column.values - times * exact))) for times in (factor, other))
    if named > max(1.1 * plain, float(np.nanmedian(column.half))):
        return factor, Words.same("")
    ratio = f"{round(there, 1):g}/{here:.6g}"
    words = Words(
        f" = {ratio}，即 {length.words.zh} 的两个取值之比", f" = {ratio}, the ratio of two values of {length.words.en}"
    )
    return other, words


def _zeros(column: Column, exact: Reals) -> Iterator[Guess]:
    """The angle from another zero, or counted the other way round."""
    for sign, zh, en in ((1.0, "", ""), (-1.0, "按顺时针计量", "counted clockwise")):
        shift = _middle(wrapped(column.values - sign * exact)[column.there])
        if shift is None:
            continue
        shift = _round_angle(shift, column, sign * exact)
        if not shift and sign > 0:
            continue
        deg = f"{degrees(shift):+.6g}°".replace("-", "−")
        zero = Words(f"角度零位差 {deg}", f"the zero of the angle shifted by {deg}") if shift else Words.same("")
        words = Words("，".join(filter(None, (zh, zero.zh))), ", ".join(filter(None, (en, zero.en))))
        yield Guess(
            slip=Slip.ZERO if shift else Slip.SIGN,
            words=words,
            expected=sign * exact + shift,
            parameter=shift if shift else -1.0,
        )


def _quadrant(column: Column, exact: Reals) -> Iterator[Guess]:
    """The principal value of an arctangent: all within half a turn, some rows 180° off."""
    turns = np.round(np.nan_to_num(column.values - exact) / pi)
    if (
        np.ptp((column.values + column.turned)[column.there]) <= pi * (1 + 1e-3)
        and (turns % 2).any()
        and (turns[column.there] % 2 == 0).any()
    ):
        words = Words(
            "反正切只取主值，未判别象限（部分行差 180°）",
            "the principal value of an arctangent, its quadrant not looked at (180° off in some rows)",
        )
        yield Guess(slip=Slip.QUADRANT, words=words, expected=exact + turns * pi)


def _middle(angles: Reals) -> float | None:
    """The angle about which most of these lie."""
    known = angles[np.isfinite(angles)]
    if not len(known):
        return None
    near = np.abs(wrapped(known[:, None] - known[None, :]))
    best = known[int(np.argmin(np.median(near, axis=1)))]
    off = wrapped(known - best)
    return float(best + np.median(off[np.abs(off) <= np.median(np.abs(off)) * 3 + 1e-15]))


def _round_angle(angle: float, column: Column, exact: Reals) -> float:
    """The roundest number of degrees that fits as well; 0 for whole turns."""
    deg = degrees(float(wrapped(np.array([angle]))[0]))
    half = np.maximum(column.half, 1e-300)
    best = np.abs(wrapped(column.values - exact - angle) / half)[column.there]
    near = best <= max(5 * float(np.median(best)), 3.0)
    for one in (round(deg / 5) * 5.0, round(deg), round(deg, 1), round(deg, 2)):
        if as_good(
            (wrapped(column.values - exact - np.radians(one)) / half)[column.there][near], np.maximum(best[near], 0.5)
        ):
            return float(np.radians(one))
    return float(np.radians(deg))


def _angle_units(exact: Reals) -> Iterator[Guess]:
    """Degrees in a column of radians, or the other way, in any of the ways to count whole turns."""
    for turned in (wrapped(exact), exact % (2 * pi), np.unwrap(exact)):
        yield Guess(
            slip=Slip.UNIT,
            words=Words("以度代替弧度", "degrees for radians"),
            expected=turned * 180 / pi,
            parameter=180 / pi,
            whole_turns=False,
        )
        yield Guess(
            slip=Slip.UNIT,
            words=Words("以弧度代替度", "radians for degrees"),
            expected=turned * pi / 180,
            parameter=pi / 180,
            whole_turns=False,
        )
