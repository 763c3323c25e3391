"""One sentence of a step behind another."""

from __future__ import annotations

from ...words import Words

_COLONS = {"：": "。", ":": "."}
_STOPS = ".,;: "
_GOES_ON = tuple(" ,.;:)")  # before these stands no blank, or one already


def behind(said: Words, more: Words) -> Words:
    """The sentence behind what is said: that ends where it would lead to the formulas by a colon, and the two are
    parted by a blank in English, by none in Chinese but before a symbol. What is said already is not said again.
    A sentence in brackets goes before one that only leads to the formulas ("Read it off:")."""
    zh, en = more.zh.lstrip(" "), more.en.lstrip(" ")
    if en.strip(_STOPS) and en in said.en and zh in said.zh:  # a stop alone is none
        return said
    if en.startswith("(") and (parts := _parted(said)) is not None:
        before, lead = behind(parts[0], more), parts[1]
        return Words(before.zh + lead.zh, f"{before.en} {lead.en}")
    if en.startswith("(") or en[:1].isupper():
        said = Words(_ended(said.zh), _ended(said.en))
    blank = " " if en and said.en and (more.en != en or not en.startswith(_GOES_ON)) else ""
    return Words(said.zh + (more.zh if zh.startswith("$") else zh), f"{said.en.rstrip(' ')}{blank}{en}")


def _parted(said: Words) -> tuple[Words, Words] | None:
    """What is said, and the sentence behind it that leads to the formulas; None where there are not both."""
    zh, en = said.zh.rfind("。") + 1, said.en.rfind(". ") + 1
    if not (zh and en and said.zh.endswith("：") and said.en.endswith(":")):
        return None
    return Words(said.zh[:zh], said.en[:en]), Words(said.zh[zh:], said.en[en:].lstrip())


def _ended(text: str) -> str:
    return text[:-1] + _COLONS[text[-1]] if text[-1:] in _COLONS else text
