"""How far students' answers are apart: two of them must differ, so that nobody's sheet serves another."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..grading.key import AnswerKey, Graded
from .look import MEASURED

READINGS = 2  # in which two students differ
Row = tuple[float, ...]


@dataclass(frozen=True)
class Taken:
    """The graded answers (SI) of those who have their values, with the tolerances; least: how many T two students
    differ by."""

    least: float
    keys: tuple[str, ...] = ()
    sizes: tuple[Row, ...] = ()
    allowed: tuple[Row, ...] = ()

    @cached_property
    def _tables(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        return np.array(self.sizes), np.array(self.allowed)

    def far_from(self, sizes: Row, allowed: Row | None = None) -> bool:
        """Whether these answers differ enough from everybody's; allowed: their own tolerances, where they are known
        already."""
        if not self.sizes or not self.least:
            return True
        theirs, limits = self._tables
        limit = self.least * (limits if allowed is None else np.maximum(limits, np.array(allowed)))
        differing = (np.abs(theirs - np.array(sizes)) > limit).sum(axis=1)
        return bool((differing >= min(READINGS, len(sizes))).all())

    def leaves(self, answers: Mapping[str, float]) -> bool:
        """The same of answers that the oracle told, before anything is drawn; where it did not tell all, nothing is
        decided."""
        return (
            not self.keys
            or any(key not in answers for key in self.keys)
            or self.far_from(tuple(answers[key] for key in self.keys))
        )


def compared(key: AnswerKey) -> list[Graded]:
    """What two students are compared by."""
    return [one for one in key.quantities if one.asked and one.kind in MEASURED and not one.demoted]


def answers(key: AnswerKey) -> tuple[Row, Row]:
    """Its answers (SI) with their tolerances."""
    asked = compared(key)
    return tuple(one.exact for one in asked), tuple(one.allowed for one in asked)


class Apart:
    """Those who have their values, one after another."""

    def __init__(self, least: float) -> None:
        self._least, self._keys = least, tuple[str, ...]()
        self._sizes: list[Row] = []
        self._allowed: list[Row] = []

    @property
    def taken(self) -> Taken:
        """Everybody so far."""
        return Taken(self._least, self._keys, tuple(self._sizes), tuple(self._allowed))

    def takes(self, key: AnswerKey) -> bool:
        """Whether this variant is far enough from all so far; if so it is one of them from now on."""
        self._keys = self._keys or tuple(one.key for one in compared(key))
        sizes, allowed = answers(key)
        if not self.taken.far_from(sizes, allowed):
            return False
        self._sizes.append(sizes)
        self._allowed.append(allowed)
        return True
