"""What is asked of loads, centres and machines, however it is written: R_{12}, R₁₂, P_31."""

from __future__ import annotations

from collections.abc import Mapping

from ...foundation.patterns import pattern
from ...names import Named
from ..text.spelling import bare_letters, plain
from .untouched import joined

_TWO = pattern(r"(?P<stem>P|v_P)_?(?:(?P<a>\d)(?P<b>\d)|(?P<i>\d+)_(?P<j>\d+))")  # a centre is that of two links


def named_by(text: str, forces: Mapping[str, Named]) -> Named | None:
    """The quantity that is meant beyond doubt; None where there is none, or more than one."""
    key = joined(plain(text))
    for one in (key, _turned(key)):
        if one in forces:
            return forces[one]
    bare = bare_letters(text).replace("vP", "v_P")
    ways = {bare_letters(bare), bare_letters(_turned(bare))}
    alike = [named for name, named in forces.items() if bare_letters(name) in ways]
    return alike[0] if len(alike) == 1 else None


def names_centre(text: str) -> bool:
    """Whether it is that of two links, however it is set: P13, P_{13}, v_{P13}."""
    return _TWO.fullmatch(bare_letters(text).replace("vP", "v_P")) is not None


def _turned(key: str) -> str:
    """P_31 as P_13: the two links in the other order."""
    if (m := _TWO.fullmatch(key)) is None:
        return key
    apart, (a, b) = ("_", (m["i"], m["j"])) if m["i"] else ("", (m["a"], m["b"]))
    return f"{m['stem']}{'' if m['stem'][0] == 'v' else '_'}{b}{apart}{a}"
