"""A force between two links that have no joint with each other: there is none."""

from __future__ import annotations

from collections.abc import Iterable

from ...errors import FaultError
from ...foundation.patterns import pattern
from ...words import Words
from ..links.bodies import Bodies, frame_number

_REACTION = pattern(r"R_(?:([1-9])([1-9])|([1-9]\d*)_([1-9]\d*))(?:_0)?")


def joined(key: str) -> str:
    """R_2_5 is R_25; only numbers of two digits have to stand apart."""
    m = _REACTION.fullmatch(key)
    return key if m is None or not m[3] or len(m[3] + m[4]) > 2 else key.replace(f"{m[3]}_{m[4]}", m[3] + m[4])


def refuse_untouched(text: str, bodies: Bodies, asked: Iterable[str]) -> None:
    """FaultError for the force between two links, both there, that are joined by nothing; with those that act on the
    second."""
    if (m := _REACTION.fullmatch(text)) is None:
        return
    by, on = (m[1] or m[3], m[2] or m[4])
    there = {*bodies.numbers, *bodies.welded, frame_number(bodies)}
    if by == on or not {by, on} <= there:
        return
    known = [key for key in asked if (k := _REACTION.fullmatch(key)) and on in (k[2], k[4]) and not key.endswith("_0")]
    zh, en = ("、".join(known), ", ".join(known))
    raise FaultError(
        Words(
            f"构件 {by} 与构件 {on} 之间没有运动副，不直接作用" + (f"；作用于构件 {on} 的有 {zh}" if known else ""),
            f"no joint joins links {by} and {on}, which do not act on each other"
            + (f"; on link {on} act {en}" if known else ""),
        ),
        code="unknown-name",
    )
