"""What is printed of instant centres: places, velocities, ratios, angles, and lengths between centres (l_P12P24)."""

from __future__ import annotations

import re
from functools import cache

from ...errors import NotAskedError, UnknownNameError
from ...foundation.indices import LETTER
from ...mechanism.asked.centres import centre_quantities
from ...names import Named
from ...oracle.centres import Centres
from ...problem.asked.asks import AskPoint
from ...problem.problem import Printed, Problem
from ..truth import exact_values

_ENDS = re.compile(rf"l_(P\d+|{LETTER}\d*)(P\d+|{LETTER}\d*)")


class CentralTruth:
    """The exact values behind such printed answers; None for all others."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        self.named = centre_quantities(problem.mechanism) if self._spoken_of() else {}
        self.centres = Centres(problem.mechanism)
        self.slow = {
            key
            for ask in problem.asks
            if isinstance(ask, AskPoint) and ask.slowest is not None
            for key in (ask.rel.key, f"v_{ask.at}")
        }
        self.answers = cache(lambda: exact_values(problem))

    def _spoken_of(self) -> bool:
        return any(
            (isinstance(p.rel, Named) and p.rel.is_central) or (p.rel is None and "P" in p.symbol)
            for p in self.problem.printed
        )

    def __call__(self, printed: Printed) -> float | None:
        """The size of the exact value; None where the print is of something else."""
        if printed.rel is None:
            return self._length(printed.symbol)
        key = printed.rel.key
        if key in self.slow:
            found = self.answers().get(key)
            return None if found is None else abs(found)
        if key not in self.named:
            return None
        value = self.centres.value(key)
        return abs(value) if isinstance(value, complex) else value

    def _length(self, symbol: str) -> float | None:
        m = _ENDS.fullmatch(symbol)
        if m is None or not self.named:
            return None
        ends = [self._place(name) for name in m.groups()]
        return abs(ends[1] - ends[0]) if isinstance(ends[0], complex) and isinstance(ends[1], complex) else None

    def _place(self, name: str) -> complex | float | None:
        if (key := f"P_{name[1:]}") in self.named:
            return self.centres.value(key)
        if (key := f"p_{name}") in self.slow:
            return self.answers()[key]
        try:
            return complex(self.centres.motion.place(name)[0])
        except (UnknownNameError, NotAskedError):
            return None
