"""Decimal commas and coordinates in braces: what YAML takes for several values, and what the writer meant by them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ...foundation.patterns import pattern
from ...words import Words

_WHOLE = pattern(r"[+\-−]?\d+")
_NUMBER = pattern(r"[+\-−]?\.?\d")


def parted(value: Any, key: Any) -> str | None:
    """`{AB: 30,5 mm}` is read as AB: 30 and a key '5 mm': the number as it was written, 30,5 mm; None where no number
    was parted.

    The nodes of a value and of the key behind it, which no space parts.
    """
    if {value.id, key.id} != {"scalar"} or value.style or key.style or key.start_mark.index - value.end_mark.index != 1:
        return None
    return f"{value.value},{key.value}" if _WHOLE.fullmatch(value.value) and key.value[:1].isdigit() else None


def is_braced(node: Any) -> bool:
    """Whether a mapping is a pair in the wrong brackets, {0 mm, 0 mm}: keys that are numbers, and no values."""
    return bool(node.flow_style and node.value) and all(
        item.id == "scalar" and item.value == "" and key.id == "scalar" and _NUMBER.match(key.value)
        for key, item in node.value
    )


def bracketed(texts: Sequence[str]) -> str:
    """The pair as it should be written: ('100', '5 mm', '0 mm') is [100.5 mm, 0 mm]."""
    whole = list[str]()
    for text in texts:
        if len(texts) > 2 and whole and _WHOLE.fullmatch(whole[-1]) and text[:1].isdigit():
            whole[-1] += f".{text}"
        else:
            whole.append(text)
    return f"[{', '.join(whole)}]"


def braced(texts: Sequence[str]) -> Words:
    """How coordinates are written."""
    right = bracketed(texts)
    return Words(f"坐标写在方括号内；请写 {right}", f"coordinates stand in square brackets; write {right}")


def with_points(texts: Sequence[str]) -> Words | None:
    """What is said of three or four values where two belong, if decimal commas made them; None otherwise."""
    right = bracketed(texts)
    if right.count(",") != 1:
        return None
    written = right[1:-1].replace(".", ",")
    return Words(f"“{written}”中用逗号作小数点；请写 {right}", f"'{written}' has decimal commas; write {right}")


def cut_short(text: str) -> bool:
    """Whether a text closes a bracket that it did not open: what YAML cut at a comma inside of it."""
    opened = 0
    for sign in text:
        opened += (sign == "(") - (sign == ")")
        if opened < 0:
            return True
    return False


def torn(text: str) -> Words:
    """What is said of such a key."""
    quoted = 'A: "R(0, 1) at (0, 0)"'
    return Words(
        f"“{text}”是在逗号处断开的文本的后半；含逗号的文本写在花括号中时要加引号，如 {quoted}，或各占一行",
        f"'{text}' is the end of a text that was cut at its comma; inside braces a text with a comma goes between "
        f"quotes, as {quoted}, or each stands on a line of its own",
    )
