"""Units as they are read out: "metres per second squared", 「米每二次方秒」."""

from __future__ import annotations

import re
from functools import lru_cache

from ..words import Lang

_NAMES = {
    "m": ("米", "metres", "metre"), "mm": ("毫米", "millimetres", "millimetre"),
    "cm": ("厘米", "centimetres", "centimetre"), "km": ("千米", "kilometres", "kilometre"),
    "s": ("秒", "seconds", "second"), "ms": ("毫秒", "milliseconds", "millisecond"),
    "min": ("分", "minutes", "minute"), "h": ("小时", "hours", "hour"),
    "rad": ("弧度", "radians", "radian"), "°": ("度", "degrees", "degree"), "r": ("转", "turns", "turn"),
    "N": ("牛", "newtons", "newton"), "kN": ("千牛", "kilonewtons", "kilonewton"),
    "kg": ("千克", "kilograms", "kilogram"), "g": ("克", "grams", "gram"), "t": ("吨", "tonnes", "tonne"),
    "J": ("焦耳", "joules", "joule"), "kJ": ("千焦", "kilojoules", "kilojoule"), "W": ("瓦", "watts", "watt"),
    "kW": ("千瓦", "kilowatts", "kilowatt"), "Pa": ("帕", "pascals", "pascal"),
    "MPa": ("兆帕", "megapascals", "megapascal"), "Hz": ("赫兹", "hertz", "hertz"),
    "%": ("百分比", "per cent", "per cent"), "deg": ("度", "degrees", "degree"),
}  # fmt: skip
_PART = re.compile(r"(?P<unit>[A-Za-z°%]+)(?:\^?(?P<power>[23²³]))?")
_POWERS = {"2": ("二次方", "squared"), "²": ("二次方", "squared"), "3": ("三次方", "cubed"), "³": ("三次方", "cubed")}


@lru_cache(maxsize=1024)
def unit_said(text: str, lang: Lang) -> str | None:
    """The unit in words; None where it is none: ``N·m``, ``m/s^2``, ``(m/s)/mm``."""
    below = text.rstrip(".,;").replace("(", "").replace(")", "").split("/")
    parts = [_product(part, lang, over) for over, part in enumerate(below)]
    if any(part is None for part in parts):
        return None
    joint = "每" if lang == "zh" else " per "
    return joint.join(part for part in parts if part is not None)


def _product(text: str, lang: Lang, over: int) -> str | None:
    parts = text.split("·")
    factors = [_factor(part, lang, plural=not over and part is parts[-1]) for part in parts]
    if not all(factors):
        return None
    return ("" if lang == "zh" else " ").join(one for one in factors if one)


def _factor(text: str, lang: Lang, *, plural: bool) -> str | None:
    match = _PART.fullmatch(text)
    if match is None or match["unit"] not in _NAMES:
        return None
    zh, many, one = _NAMES[match["unit"]]
    power = _POWERS.get(match["power"] or "")
    if lang == "zh":
        return (power[0] if power else "") + zh
    return (many if plural else one) + (f" {power[1]}" if power else "")
