"""Quantities that are found a second time, to check the first."""

from __future__ import annotations

from collections.abc import Collection

BY_SINES = "_sine"


def is_check(key: str, asked: Collection[str]) -> bool:
    """Whether an asked quantity is another one by the sine rule, F_sine beside F, and so no question of its own."""
    return key.endswith(BY_SINES) and key.removesuffix(BY_SINES) in asked
