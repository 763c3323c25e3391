"""Numbers drawn from names: SHA-256 in counter mode, the same on every machine and for ever."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from hashlib import sha256
from typing import TypeVar
from urllib.parse import quote

T = TypeVar("T")
SCHEME = "vecpoly-variant/1"
_BITS = 64


@dataclass(frozen=True, slots=True, kw_only=True)
class Seed:
    """Whose numbers: of which assignment and problem, of which student; salt: changed for another class, or another
    year."""

    assignment: str
    problem: str
    student: str
    salt: str = ""

    def stream(self, attempt: int) -> Stream:
        """The numbers of this attempt: ``vecpoly-variant/1|assignment|problem|student|salt|attempt``."""
        names = (self.assignment, self.problem, self.student, self.salt, str(attempt))
        return Stream("|".join((SCHEME, *(quote(name, safe=" /") for name in names))))


class Stream:
    """Whole numbers, one after another: the digests of the name with a counter behind it, eight bytes each."""

    def __init__(self, name: str) -> None:
        self._name = name.encode()
        self._count = 0

    def below(self, n: int) -> int:
        """A whole number from 0 to n − 1, each as likely as any other: what would favour some of them is drawn
        again."""
        most = (1 << _BITS) - (1 << _BITS) % n
        while (drawn := self._next()) >= most:
            pass
        return drawn % n

    def shuffled(self, items: Sequence[T]) -> list[T]:
        """The same things in another order (Fisher and Yates)."""
        left = list(items)
        for last in range(len(left) - 1, 0, -1):
            other = self.below(last + 1)
            left[last], left[other] = left[other], left[last]
        return left

    def _next(self) -> int:
        digest = sha256(self._name + b"|" + str(self._count).encode()).digest()
        self._count += 1
        return int.from_bytes(digest[: _BITS // 8], "big")
