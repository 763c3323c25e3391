"""Roots of a function of the drive's position, many brackets at once."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Reals = NDArray[np.float64]
ROUNDS = 60
PARTS, CUTS = 16, 11  # a bracket into so many parts, so often: to 1e-10 of its width with few calls of the function
ENOUGH = 1e-13  # of the values at the bracket's ends: then the root is known to this part of the bracket


def ridders(f: Callable[[Reals], Reals], a: Reals, b: Reals) -> Reals:
    """The root in each bracket a..b by Ridders' method:
    x = m + (m - a) f_m / √(f_m² - f_a f_b) on falling f, halving at least.

    NaN where f has no sign change there, or jumps through it (a pole).
    """
    a, b = np.array(a, np.float64), np.array(b, np.float64)
    if not a.size:
        return a
    fa, fb = f(a), f(b)
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        sound = fa * fb <= 0
        start = np.maximum(np.abs(fa), np.abs(fb))
        for _ in range(ROUNDS):
            a, b, fa, fb = _halved(f, a, b, fa, fb)
            open_ = (np.abs(b - a) > 4e-16 * (1 + np.abs(a))) & (np.minimum(np.abs(fa), np.abs(fb)) > ENOUGH * start)
            if not (sound & open_).any():
                break
        x = np.where(np.abs(fa) < np.abs(fb), a, b)
        left = np.minimum(np.abs(fa), np.abs(fb))
    return np.where(sound & (left <= 1e-4 * start + 1e-300), x, np.nan)


def _halved(f: Callable[[Reals], Reals], a: Reals, b: Reals, fa: Reals, fb: Reals) -> tuple[Reals, Reals, Reals, Reals]:
    """A bracket of at most half the width, by its middle and by the exponential false position."""
    m = (a + b) / 2
    fm = f(m)
    root = np.sqrt(fm * fm - fa * fb)
    x = np.where(root > 0, m + (m - a) * np.sign(fa - fb) * fm / root, m)
    x = np.where(np.isfinite(x), np.clip(x, np.minimum(a, b), np.maximum(a, b)), m)
    fx = f(x)
    left, right, fl, fr = np.minimum(m, x), np.maximum(m, x), np.where(m <= x, fm, fx), np.where(m <= x, fx, fm)
    low, middle = fa * fl <= 0, fl * fr <= 0
    return (
        np.where(low, a, np.where(middle, left, right)),
        np.where(low, left, np.where(middle, right, b)),
        np.where(low, fa, np.where(middle, fl, fr)),
        np.where(low, fl, np.where(middle, fr, fb)),
    )


def highest(f: Callable[[Reals], Reals], a: Reals, b: Reals) -> Reals:
    """The place of the greatest value in each bracket a..b with one top, smooth or sharp: the two parts beside the
    highest of the places between are the next bracket."""
    for _ in range(CUTS):
        part = (b - a) / PARTS
        places = a[:, None] + part[:, None] * np.arange(1, PARTS)
        values = f(places.ravel()).reshape(places.shape)
        top = np.argmax(np.where(np.isnan(values), -np.inf, values), axis=1)
        a, b = a + part * top, a + part * (top + 2)
    return np.asarray((a + b) / 2)
