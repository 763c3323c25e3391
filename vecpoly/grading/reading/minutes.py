"""Degrees, minutes and seconds of arc: 63°12′30″ is 63.20833°."""

from __future__ import annotations

import re

_PART = r"(\d{1,2}(?:\.\d+)?)"
_ARC = re.compile(
    rf"(?P<sign>[+-]?)\s*(?P<deg>\d+)\s*(?:°|度)\s*(?P<min>{_PART})\s*(?:'(?!')|分)(?:\s*(?P<sec>{_PART})\s*(?:''|[\"”″]|秒))?"
)
SIXTY, DIGITS = 60.0, 4  # decimals of a degree: a third of a second


def in_degrees(text: str) -> str:
    """The text with minutes and seconds as a decimal part of the degrees; as it stands where they are not below 60."""
    return _ARC.sub(_decimal, text)


def beyond_sixty(text: str) -> bool:
    """Whether there are minutes or seconds of 60 and more: 35°60′ is nobody's 36°."""
    found = _ARC.search(text)
    return found is not None and _decimal(found) == found[0]


def _decimal(found: re.Match[str]) -> str:
    minutes, seconds = float(found["min"]), float(found["sec"] or 0)
    if minutes >= SIXTY or seconds >= SIXTY:
        return found[0]
    return f"{found['sign']}{float(found['deg']) + (minutes + seconds / SIXTY) / SIXTY:.{DIGITS}f}°"
