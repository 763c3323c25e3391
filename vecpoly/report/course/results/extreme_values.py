"""Greatest and minimum values to full accuracy, and where they occur."""

from __future__ import annotations

from math import floor, isfinite, log10

from ....cycle import Extremes, Spot
from ....findings.shown import alike
from ....findings.study.study import Study
from ....words import Words
from ..analysis import force_words
from ..numbering import Press
from .circling import is_trivial
from .tabled import decimal

_DIGITS, _MOST = 4, 6  # significant digits; decimals
_TOLD = 2  # positions that are alike, of which the table has room
_EXTREMES = {
    "zh": ["量", "单位", "最大值", "位置", "最小值", "位置"],
    "en": ["Quantity", "Unit", "Maximum", "At", "Minimum", "At"],
}


def extremes(study: Study, press: Press) -> str:
    """Greatest and minimum values to full accuracy, and where they occur."""
    keys = [f"{stem}_{link}" for link in study.links for stem in ("omega", "alpha")]
    points = [letter for letter in study.points if not is_trivial(study, letter)]
    keys += [key for letter in points for key in (f"p_{letter}.x", f"p_{letter}.y", f"v_{letter}", f"a_{letter}")]
    keys += list(study.forces)
    rows = []
    for key in keys:
        found, info = study.extremes(key), study.whole.info(key)
        if found.highest is None or found.lowest is None or found.is_constant or not study.varies(key):
            continue
        both = (found.highest, found.lowest)
        top = max((abs(spot.value) for spot in both if isfinite(spot.value)), default=0.0)
        spots = [
            text
            for spot in both
            for text in (
                _exact(info.factor * spot.value, info.factor * top),
                _placed(study, found, spot, press) + ("*" if force_words.is_limit(study, key, spot) else ""),
            )
        ]
        symbol = f"$|{info.symbol}|$" if info.is_vector else f"${info.symbol}$"
        rows.append((symbol, info.shown_unit.replace("^2", "²") or "—", *spots))
    if not rows:
        return ""
    drive = study.turn.drive
    place = f"${drive.symbol}$ /{drive.shown_unit}"
    header = [text if i not in (3, 5) else place for i, text in enumerate(_EXTREMES[press.lang])]
    return press.table(Words("极值及其位置", "Extreme values and where they occur"), header, rows, "lcdrdr")


def _placed(study: Study, found: Extremes, spot: Spot, press: Press) -> str:
    """The drive's position to a tenth, of two that are alike both; of more the first, with a sign of more."""
    drive = study.turn.drive
    told = dict.fromkeys(decimal(drive.told(study.reduced(s.phi)), 1) for s in alike(study, found, spot))
    every = [*told]
    comma = "、" if press.lang == "zh" else ", "
    return comma.join(every[:_TOLD]) + ("…" if len(every) > _TOLD else "")


def exponent(value: float) -> int:
    """Of ten, of the value as it is rounded to these digits."""
    return floor(log10(abs(float(f"{value:.{_DIGITS - 1}e}"))))


def _exact(value: float, top: float) -> str:
    """Four significant digits, as beside the dots of the diagrams; zero for what rounding leaves beside the largest
    value; ±∞ for what runs away."""
    if not isfinite(value):
        return "∞" if value > 0 else "−∞"
    if abs(value) <= 1e-9 * top:
        return "0"
    return decimal(value, int(min(_MOST, max(0, _DIGITS - 1 - exponent(value)))))
