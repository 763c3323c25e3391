"""The Roman numerals of classes: Ⅲ in Chinese text, III in English."""

from __future__ import annotations

CLASS = "class_"  # what the keys of classes of mechanisms begin with: class_1, class_1+3
NUMERALS = {"I": "Ⅰ", "II": "Ⅱ", "III": "Ⅲ", "IV": "Ⅳ", "V": "Ⅴ", "VI": "Ⅵ"}  # English → Chinese, from one on


def latin(rank: int) -> str:
    """III; a number that has none here stays itself."""
    return dict(enumerate(NUMERALS, 1)).get(rank, str(rank))


def chinese(rank: int) -> str:
    """Ⅲ; likewise."""
    return dict(enumerate(NUMERALS.values(), 1)).get(rank, str(rank))
