"""A unit in any of its usual spellings: 米/秒, m·s⁻¹, m/s2, 转/分, N.m."""

from __future__ import annotations

import re
from typing import NamedTuple

from ...errors import FaultError
from ...units.names import unit_of

_CHINESE = (
    ("牛顿", "牛"),
    ("牛米", "牛*米"),
    ("公斤", "千克"),
    ("二次方秒", "秒^2"),
    ("平方秒", "秒^2"),
    ("每", "/"),
    ("平方", "^2"),
    ("二次方", "^2"),
    ("分钟", "分"),
)
_LATIN = (
    (r"rpm", "rpm"),
    (r"rev(?=/)", "r"),
    (r"1/s", "rad/s"),
    (r"deg\.", "deg"),
    (r"N\.?mm", "N*mm"),
    (r"N\.?m", "N*m"),
    (r"kN\.?m", "kN*m"),
)
_LARGE = re.compile(r"\bK(?=(?:N\.?m?|W|J|Pa|g)(?![a-z]))")  # KN, Kg
PERCENT = "%"


class Unit(NamedTuple):
    """A unit as written, what one of it is in SI, and its dimension in the words of `unit_names`."""

    text: str
    factor: float
    dimension: str


def unit(text: str) -> Unit | None:
    """The unit of this text; None where nobody knows it."""
    if text == PERCENT:
        return Unit(text, 0.01, "")
    for spelling in dict.fromkeys((_spelt(text), _spelt(text).lower())):
        try:
            factor, dimension = unit_of(spelling)
        except FaultError:
            continue
        return Unit(text, factor, dimension)
    return None


def _spelt(text: str) -> str:
    """As `unit_names` spells it."""
    found = text.strip().strip("()[]").replace("°", "deg")
    found = f"1{found}" if found.startswith("/") else found  # 4.7/s
    for chinese, plain in _CHINESE:
        found = found.replace(chinese, plain)
    found = re.sub(r"(?<=N)-(?=m)", "*", _LARGE.sub("k", found))  # N-m
    for pattern, latin in _LATIN:
        found = latin if re.fullmatch(pattern, found, re.I if latin == "rpm" else 0) else found
    found = re.sub(r"/sec(?![a-z])", "/s", found)
    power = "[2-4]" if "/" in found else "-?[1-4]"  # m/s2, m·s-1
    found = re.sub(rf"(?<=[A-Za-z秒米分])\s*({power})(?![\d.])", r"^\1", found)
    found = re.sub(r"\s*[·*.]\s*|(?<=[\w)])\s+(?=[\w(])", "*", found)
    return re.sub(r"(s|秒)/\1$", r"\1^2", found).replace(" ", "").replace("^", "**")  # m/s/s
