"""Greatest and least values to full accuracy, and where they occur."""

from __future__ import annotations

from math import floor, log10

import numpy as np

from ....cycle import Spot
from ....findings.study.study import Study
from ....words import Words
from ..analysis import force_words
from ..numbering import Press
from .tabled import decimal

_AWAY = 50.0  # times what nine tenths of the values stay below
_EXTREMES = {
    "zh": ["量", "单位", "最大值", "位置", "最小值", "位置"],
    "en": ["Quantity", "Unit", "Greatest", "At", "Least", "At"],
}


def extremes(study: Study, press: Press) -> str:
    """Greatest and least values to full accuracy, and where they occur."""
    keys = [f"{stem}_{link}" for link in study.links for stem in ("omega", "alpha")]
    keys += [key for letter in study.points for key in (f"p_{letter}.x", f"p_{letter}.y", f"v_{letter}", f"a_{letter}")]
    keys += list(study.forces)
    rows = []
    for key in keys:
        found, info = study.extremes(key), study.whole.info(key)
        if found.highest is None or found.lowest is None or found.is_constant or not study.varies(key):
            continue
        top = max(abs(found.highest.value), abs(found.lowest.value))
        spots = [
            text
            for spot in (found.highest, found.lowest)
            for text in (
                ("∞" if spot.value > 0 else "−∞")
                if _unbounded(study, key, spot)
                else _exact(info.factor * spot.value, info.factor * top),
                _placed(study, spot.phi) + ("*" if force_words.is_limit(study, key, spot) else ""),
            )
        ]
        symbol = f"$|{info.symbol}|$" if info.is_vector else f"${info.symbol}$"
        rows.append((symbol, info.shown_unit.replace("^2", "²") or "—", *spots))
    if not rows:
        return ""
    drive = study.turn.drive
    header = [text if i not in (3, 5) else f"${drive.symbol}$" for i, text in enumerate(_EXTREMES[press.lang])]
    return press.table(Words("极值及其位置", "Extreme values and where they occur"), header, rows, "lcrrrr")


def _unbounded(study: Study, key: str, spot: Spot) -> bool:
    """Whether the value runs away at an end of the drive's range."""
    return spot.end and bool(abs(spot.value) > _AWAY * float(np.nanpercentile(np.abs(study.turn.real(key)), 90)))


def _placed(study: Study, phi: float) -> str:
    """The drive's position with two decimals."""
    drive = study.turn.drive
    return decimal(drive.factor * study.reduced(phi), 2) + ("°" if drive.shown_unit == "°" else f" {drive.shown_unit}")


def _exact(value: float, top: float) -> str:
    """Five significant digits; zero for what rounding leaves beside the largest value."""
    if abs(value) < 1e-9 * top:
        return "0"
    return decimal(value, int(min(6, max(0, 4 - floor(log10(abs(value)))))))
