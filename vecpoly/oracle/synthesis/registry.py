"""The solutions of a task of synthesis: a function registered by `synthesizes`; adding the file adds it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from ...designs.base import Design, numbered
from ...designs.verdict import Verdict
from ...errors import AssemblyError, NoMethodError, NotAskedError
from ...foundation.frozen import FrozenMap
from ...foundation.plugins import load_modules
from ...words import Words, bare


@dataclass(frozen=True, slots=True, kw_only=True)
class Linkage:
    """One linkage that fits the data: what is asked of it, its pins (m) in its positions, and whether it is any use.

    values: by the key of a quantity without a number, lengths in mm and angles in deg. order: by what it is numbered.
    """

    values: Mapping[str, float]
    pins: Mapping[str, complex]
    verdict: Verdict
    order: tuple[float, ...]

    def __post_init__(self) -> None:
        object.__setattr__(self, "values", FrozenMap(dict(self.values)))
        object.__setattr__(self, "pins", FrozenMap(dict(self.pins)))


Exact = Callable[[Any], Iterable[Linkage]]
_EXACT: dict[type[Design], Exact] = {}
SAME = 1e-9  # of its size: two numbers by which candidates are ordered


def synthesizes(design: type[Design]) -> Callable[[Exact], Exact]:
    """Register the closed solution of a task: data → every candidate, valid or not."""

    def register(exact: Exact) -> Exact:
        if design in _EXACT:
            raise ValueError(f"two oracles answer for the synthesis {design.kind}")
        _EXACT[design] = exact
        return exact

    return register


@lru_cache(maxsize=256)
def linkages(design: Design) -> tuple[Linkage, ...]:
    """Every candidate in the order of its number: the valid ones first, by AB, BC, AD, x of A.

    Raises AssemblyError where there is none that is valid, NoMethodError where no oracle is on file.
    """
    load_modules("vecpoly.oracle.synthesis")
    if type(design) not in _EXACT:
        raise NoMethodError(
            Words(f"解析法不能求解综合题型 {design.kind}", f"the oracle knows no synthesis {design.kind}")
        )
    found = sorted(_EXACT[type(design)](design), key=lambda one: (one.verdict is not Verdict.VALID, *_rounded(one)))
    if not any(one.verdict is Verdict.VALID for one in found):
        raise _none_valid(found)
    return tuple(found)


def _rounded(one: Linkage) -> tuple[float, ...]:
    return tuple(float(f"{value:.9g}") if abs(value) > SAME else 0.0 for value in one.order)


def _none_valid(found: list[Linkage]) -> AssemblyError:
    zh = "；".join(f"候选解 {n}：{_plain(one.verdict.value.zh)}" for n, one in enumerate(found, 1))
    en = "; ".join(f"candidate {n}: {_plain(one.verdict.value.en)}" for n, one in enumerate(found, 1))
    return AssemblyError(
        Words(
            f"按所给数据没有可用的机构：{zh}。请改动数据",
            f"no linkage with these data is any use: {en}. Change the data",
        ),
        code="no-solution",
        numbers={"candidates": len(found)},
    )


def _plain(text: str) -> str:
    """A sentence without the signs of its symbols: C1C2."""
    return bare(text).translate(str.maketrans("", "", "_{}"))


def design_answers(design: Design) -> Mapping[str, float]:
    """The exact value of everything that may be asked: of the solution taken, and of each by its number.

    Raises NotAskedError where the solution taken does not exist.
    """
    valid = [one for one in linkages(design) if one.verdict is Verdict.VALID]
    if design.take > len(valid):
        raise NotAskedError(
            Words(
                f"take: {design.take}：可用的解只有 {len(valid)} 个；请写 1 至 {len(valid)}",
                f"take: {design.take}: there are only {len(valid)} valid solutions; write 1 to {len(valid)}",
            ),
            code="no-solution",
            numbers={"take": design.take, "solutions": len(valid)},
        )
    found = dict(valid[design.take - 1].values)
    for n, one in enumerate(valid, 1):
        found |= {numbered(named, n).key: one.values[named.key] for named in design.quantities()}
    return found
