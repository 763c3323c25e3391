"""The solutions of a task of synthesis: a function registered by `synthesizes`; adding the file adds it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from ...designs.base import Design, numbered
from ...designs.verdict import Verdict
from ...errors import NoMethodError, NotAskedError, VecpolyError
from ...foundation.frozen import FrozenMap
from ...foundation.plugins import load_modules
from ...words import Words


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
Refusal = Callable[[Any], VecpolyError]
_EXACT: dict[type[Design], Exact] = {}
_REFUSALS: dict[type[Design], Refusal] = {}
SAME = 1e-9  # of its size: two numbers by which candidates are ordered


def synthesizes(design: type[Design], refused: Refusal | None = None) -> Callable[[Exact], Exact]:
    """Register the closed solution of a task: data → every candidate, valid or not; refused: what is said of data for
    which it finds none, where it does not raise that itself."""

    def register(exact: Exact) -> Exact:
        if design in _EXACT:
            raise ValueError(f"two oracles answer for the synthesis {design.kind}")
        _EXACT[design] = exact
        if refused is not None:
            _REFUSALS[design] = refused
        return exact

    return register


@lru_cache(maxsize=256)
def linkages(design: Design) -> tuple[Linkage, ...]:
    """Every candidate in the order of its number: the valid ones first, by AB, BC, AD, x of A; of no use where none is.

    Raises AssemblyError where nothing meets, NoMethodError where no oracle is on file.
    """
    found = candidates(design)
    if not found:
        raise _REFUSALS[type(design)](design)
    return tuple(sorted(found, key=lambda one: (one.verdict is not Verdict.VALID, *_rounded(one))))


def candidates(design: Design) -> tuple[Linkage, ...]:
    """The same as they are found; none where nothing meets."""
    load_modules("vecpoly.oracle.synthesis")
    if type(design) not in _EXACT:
        raise NoMethodError(
            Words(f"解析法不能求解综合题型 {design.kind}", f"the oracle knows no synthesis {design.kind}")
        )
    return tuple(_EXACT[type(design)](design))


def solvable(design: Design) -> bool:
    """Whether any linkage serves."""
    return any(one.verdict is Verdict.VALID for one in linkages(design))


def _rounded(one: Linkage) -> tuple[float, ...]:
    return tuple(float(f"{value:.9g}") if abs(value) > SAME else 0.0 for value in one.order)


def counted(valid: int) -> str:
    """How many solutions there are, in English."""
    return "there is only 1 valid solution" if valid == 1 else f"there are only {valid} valid solutions"


def design_answers(design: Design) -> Mapping[str, float]:
    """The exact value of everything that may be asked: of the solution taken, and of each by its number; where no
    linkage serves, what the data alone tell.

    Raises NotAskedError where the solution taken does not exist.
    """
    valid = [one for one in linkages(design) if one.verdict is Verdict.VALID]
    if not valid:
        return design.settled()
    if design.take > len(valid):
        raise NotAskedError(
            Words(
                f"take: {design.take}：可用的解只有 {len(valid)} 个；请写 1 至 {len(valid)}",
                f"take: {design.take}: {counted(len(valid))}; write 1 to {len(valid)}",
            ),
            code="no-solution",
            numbers={"take": design.take, "solutions": len(valid)},
        )
    found = dict(valid[design.take - 1].values)
    for n, one in enumerate(valid, 1):
        found |= {numbered(named, n).key: one.values[named.key] for named in design.quantities()}
    return found
