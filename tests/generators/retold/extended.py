"""A problem of the library taken over by `extends`, some sizes its own: the same as the whole file written out."""

from __future__ import annotations

import json

import numpy as np

from vecpoly.solution import Solution

from ..family import family
from ..library import Data, over, problems, varied
from .original import Change, against, solved

_SHARES = {"input": 0.02, "links": 0.01, "loads": 0.5, "data": 0.05}


def _own(name: str, seed: int) -> Data:
    """What differs: one of the parts, its sizes changed a little."""
    rng, data = np.random.default_rng(seed), problems()[name]
    parts = [part for part in _SHARES if part in data]
    part = parts[int(rng.integers(len(parts)))]
    return {part: varied(rng, data[part], _SHARES[part])}


def as_written_out(solution: Solution) -> str:
    """The answers are those of the whole file."""
    name, seed = str(solution.problem.title.en).split()
    whole = over(problems()[name], _own(name, int(seed)))
    return against(solution, solved(json.dumps(whole, ensure_ascii=False)), Change())


@family("retold-extends", also=as_written_out, often=1, first=1)
def taken_over(rng: np.random.Generator) -> str:
    """`extends` and what differs."""
    name = list(problems())[int(rng.integers(len(problems())))]
    seed = int(rng.integers(10**6))
    text = {"id": "own", "title": f"{name} {seed}", "extends": name, **_own(name, seed)}
    return json.dumps(text, ensure_ascii=False, indent=1)
