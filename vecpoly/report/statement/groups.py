"""Quantities by kinds, for lists that are too long to be read in one piece: velocities, accelerations, forces."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass
from typing import TypeVar

from ...words import Lang, Words

_MOBILITY, _LOWER_PAIRS = "F", "p_l"  # keys
_LOW = "equivalent lower-pair linkage"
LONG = 7  # quantities that are told by kinds, where there are so many


@dataclass(frozen=True, slots=True)
class Group:
    """A kind of quantity: by which keys it is known, and what one and several of it are called."""

    keys: str
    zh: str
    one: str
    many: str
    named: Words | None = None  # what heads them in a sentence where each has its name there

    def heads(self, count: int, lang: Lang) -> str:
        """What heads so many in a sentence."""
        return self.called(count, lang) + " " if self.named is None else self.named.of(lang)

    def called(self, count: int, lang: Lang) -> str:
        """The name at the head of so many."""
        return self.zh if lang == "zh" else self.many if count > 1 else self.one


GROUPS = (
    Group(
        r"(n|p_l|p_h|F_local|p_redundant|F)$",
        "构件数、运动副数和自由度",
        "links, joints and mobility",
        "links, joints and mobility",
        named=Words.same(""),
    ),
    Group(r"(n|p_l|F)_low$", "高副低代后", _LOW, _LOW, named=Words("高副低代后：", f"{_LOW}: ")),
    Group(r"P_\w+$", "瞬心", "instant centre", "instant centres"),
    Group(r"v_", "速度", "velocity", "velocities"),
    Group(r"omega_\d+$", "角速度", "angular velocity", "angular velocities"),
    Group(r"a[nktr]?_[A-Z]", "加速度", "acceleration", "accelerations"),
    Group(r"alpha_\d+$", "角加速度", "angular acceleration", "angular accelerations"),
    Group(r"m_\d$|J_S", "质量和转动惯量", "mass", "masses and moments of inertia"),
    Group(r"(F|M)_I\w*$|h_\d$", "惯性力、惯性力矩和力臂", "inertia force", "inertia forces, couples and arms"),
    Group(r"R[nt]?'*_", "运动副反力", "joint reaction", "joint reactions"),
)
T = TypeVar("T")


def group_of(key: str, beside: Collection[str]) -> Group | None:
    """The kind of a quantity by its key; None of what stands for itself: F is a mobility beside p_l, else a force."""
    if key == _MOBILITY and _LOWER_PAIRS not in beside:
        return None
    return next((group for group in GROUPS if re.match(group.keys, key)), None)


def parted(keys: Sequence[str]) -> bool:
    """Whether these quantities are so many, and of so many kinds, that they are told by kinds."""
    kinds = {group_of(key, keys) for key in keys} - {None}
    return len(keys) >= LONG and len(kinds) > 1


def by_groups(things: Iterable[T], key: Callable[[T], str]) -> list[tuple[Group | None, list[T]]]:
    """The things by their kinds, these as they follow from each other; what is of no kind comes last."""
    found: dict[Group | None, list[T]] = {}
    every = list(things)
    keys = {key(one) for one in every}
    for one in every:
        found.setdefault(group_of(key(one), keys), []).append(one)
    return [(kind, found[kind]) for kind in (*GROUPS, None) if kind in found]
