"""The search itself: random candidates in blocks over all processes, the best of them refined by evolution.

The seed of a block is that of the search and its number, so that the same seed finds the same linkage on however many
processes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import MissingPackageError, VecpolyError
from ..foundation.running.spread import spread
from ..problem.problem import Problem
from ..problem.values.made import problem as made
from ..words import Words
from .base import Measure, Search

Reals = NDArray[np.float64]
BLOCK, SLICE = 50_000, 2_500  # candidates of a job; at a time, so that they stay in the processor's cache
KEPT, ROUNDS = 48, 400  # candidates that are refined; generations of them
Watch = Callable[[Sequence[Any]], Iterable[Any]]


@dataclass(frozen=True, slots=True)
class Block:
    """A job: so many candidates with this seed."""

    search: Search
    count: int
    seed: tuple[int, int]


@dataclass(frozen=True, slots=True, kw_only=True)
class Found:
    """What a search found: the linkage as a problem, what it does, how many candidates were scored."""

    problem: Problem
    measures: tuple[Measure, ...]
    tried: int
    first: float  # score of the best candidate
    refined: float  # and after the evolution


def run(
    search: Search, name: str, title: Words, *, count: int, seed: int = 0, jobs: int = 1, watch: Watch = iter
) -> Found:
    """Search among so many candidates. Raises VecpolyError where none of them is a linkage that does it at all."""
    blocks = [Block(search, min(BLOCK, count - at), (seed, i)) for i, at in enumerate(range(0, count, BLOCK))]
    kept = [one() for one, _ in zip(spread(scored, blocks, jobs), watch(blocks), strict=True)]
    scores, places = (np.concatenate(parts) for parts in zip(*kept, strict=True))
    order = np.argsort(scores, kind="stable")[:KEPT]
    if not len(order) or not np.isfinite(scores[order[0]]):
        raise VecpolyError(
            Words(
                f"{name}：{count} 个候选中没有一个能满足条件；请放宽要求，或增加候选数",
                f"{name}: none of {count} candidates fulfils what is asked; ask for less, or try more of them",
            ),
            code="none-found",
        )
    best, score = refined(search, places[order[np.isfinite(scores[order])]], seed)
    data = {"id": name, "title": title, **search.built(best)}
    measures = search.measured(made(data))
    problem = made({"id": name, "title": title, "statement": _said(measures, count), **search.built(best)})
    return Found(problem=problem, measures=measures, tried=count, first=float(scores[order[0]]), refined=score)


def _said(measures: Sequence[Measure], count: int) -> Words:
    """What stands in the file that was found."""
    signs = [" = " if one.name.zh[-1].isascii() else " " for one in measures]  # behind a symbol: K = 1.3
    zh = "，".join(f"{one.name.zh}{sign}{_size(one)}" for one, sign in zip(measures, signs, strict=True))
    en = ", ".join(f"{one.name.en}{sign}{_size(one)}" for one, sign in zip(measures, signs, strict=True))
    return Words(f"由 {count} 个候选中搜索得到：{zh}。", f"Found among {count} candidates: {en}.")


def _size(one: Measure) -> str:
    return f"{one.value:.4g}°" if one.unit == "deg" else f"{one.value:.4g} {one.unit}".rstrip()


def scored(block: Block) -> tuple[Reals, Reals]:
    """The best candidates of a block: scores and parameters."""
    random = np.random.default_rng(block.seed)
    scores, places = np.empty(0), np.empty((0, len(block.search.box[0])))
    left = block.count
    while left:
        x = candidates(block.search, min(left, SLICE), random)
        left -= len(x)
        scores = np.concatenate([scores, block.search.score(x)])
        places = np.concatenate([places, x])
        best = np.argsort(scores, kind="stable")[:KEPT]
        scores, places = scores[best], places[best]
    return scores, places


def candidates(search: Search, count: int, random: np.random.Generator) -> Reals:
    """So many that are linkages of the kind, evenly out of the box."""
    low, high = search.box
    found = np.empty((0, len(low)))
    for _ in range(1000):
        x = low + (high - low) * random.random((4 * count, len(low)))
        found = np.concatenate([found, x[search.possible(x)]])
        if len(found) >= count:
            return found[:count]
    raise VecpolyError(
        Words("几乎没有符合条件的机构；请放宽要求", "hardly any linkage is of the kind asked for; ask for less"),
        code="none-found",
    )


def refined(search: Search, places: Reals, seed: int) -> tuple[Reals, float]:
    """The best place after an evolution that begins with these."""
    evolution = _evolution()
    low, high = search.box
    start = places if len(places) >= 5 else np.repeat(places, 5, axis=0)
    worst = 1e9

    def cost(x: Reals) -> Reals:
        return np.minimum(np.nan_to_num(search.score(np.atleast_2d(x.T)), nan=worst, posinf=worst), worst)

    found = evolution(
        cost, list(zip(low, high, strict=True)), init=start, maxiter=ROUNDS, tol=1e-10, seed=seed, polish=False,
        vectorized=True, updating="deferred", mutation=(0.3, 0.9), recombination=0.8,
    )  # fmt: skip
    first = search.score(places[:1])[0]
    return (found.x, float(found.fun)) if found.fun < first else (places[0], float(first))


def _evolution() -> Any:
    """Scipy's differential evolution; raises MissingPackageError."""
    try:
        from scipy.optimize import differential_evolution
    except ImportError:
        raise MissingPackageError(
            Words("搜索需要 scipy；请 pip install vecpoly[search]", "a search needs scipy; pip install vecpoly[search]")
        ) from None
    return differential_evolution
