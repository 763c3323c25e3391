"""One sentence of a step behind another."""

from __future__ import annotations

from ...words import Words

_COLONS = {"：": "。", ":": "."}
_STOPS = ".,;: "
_GOES_ON = tuple(" ,.;:)")  # before these stands no blank, or one already


def behind(said: Words, more: Words) -> Words:
    """The sentence behind what is said: that ends where it would lead to the formulas by a colon, and the two are
    parted by a blank in English, by none in Chinese but before a symbol. What is said already is not said again."""
    zh, en = more.zh.lstrip(" "), more.en.lstrip(" ")
    if en.strip(_STOPS) and en in said.en and zh in said.zh:  # a stop alone is none
        return said
    if en.startswith("(") or en[:1].isupper():
        said = Words(_ended(said.zh), _ended(said.en))
    blank = " " if en and said.en and (more.en != en or not en.startswith(_GOES_ON)) else ""
    return Words(said.zh + (more.zh if zh.startswith("$") else zh), f"{said.en.rstrip(' ')}{blank}{en}")


def _ended(text: str) -> str:
    return text[:-1] + _COLONS[text[-1]] if text[-1:] in _COLONS else text
