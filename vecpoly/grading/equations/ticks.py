"""A row of ticks as it is typed from paper: ✓ where something is given, ? where it is unknown, term by term."""

from __future__ import annotations

import re
from collections.abc import Sequence

from ...words import Words

_GIVEN, _UNKNOWN = "✓✔√☑vVyY知", "?？xX×✗✘nN未"
_APART = re.compile(r"[\s,;，；、|]+")
BLANK = re.compile(r"[\s_—]*")


def ticks(raw: str, count: int) -> tuple[bool, ...] | Words:
    """Of each term whether it is ticked as given; why it cannot be read where it cannot.

    One sign a term, ``✓✓?``; or with blanks or commas between what stands in the cells, ``⊥BC, B→A, ?``.
    """
    parts: Sequence[str] = [part for part in _APART.split(raw.strip()) if part]
    if len(parts) == 1 and count != 1:
        parts = parts[0]
        strange = [sign for sign in parts if sign not in _GIVEN + _UNKNOWN]
        if strange:
            return Words(
                f"“{strange[0]}”既不是 ✓ 也不是 ?；每项写一个记号，或用空格隔开",
                f"'{strange[0]}' is neither ✓ nor ?; write one sign a term, or blanks between them",
            )
    if len(parts) != count:
        return Words(
            f"写了 {len(parts)} 项，方程有 {count} 项；请每项写一个记号",
            f"{len(parts)} terms are written, the equation has {count}; write one sign a term",
        )
    return tuple(part not in _UNKNOWN for part in parts)


def shown(known: Sequence[bool]) -> str:
    """As it is typed."""
    return "".join("✓" if one else "?" for one in known)
