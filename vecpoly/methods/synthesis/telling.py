"""What is told of candidates: how far hands scatter about one, how far two lie apart, that none is of use."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ...board.hand import scatter
from ...plane import Points, Reals, nominal
from ...plane.traced import bare
from ...words import Words


def no_use(count: int) -> Words:
    """What is concluded where every candidate is rejected."""
    if count == 1:
        return Words(
            "唯一的候选解已舍去：没有机构满足所给条件。",
            "The only candidate is rejected: no linkage satisfies the conditions.",
        )
    zh, en = ("两", "Both") if count == 2 else (f"{count} ", f"All {count}")
    return Words(
        f"{zh}个候选解均已舍去：没有机构满足所给条件。",
        f"{en} candidates are rejected: no linkage satisfies the conditions.",
    )


def lost(at: Points) -> float:
    """The share of the repeated hands that do not find a pin."""
    repeated = np.ravel(bare(at))[1:]
    return float(np.mean(~np.isfinite(repeated))) if repeated.size else 0.0


def gap(pins: Mapping[str, Points], of: Mapping[str, Points]) -> float:
    """How far pins lie beside those of another candidate."""
    return sum(abs(complex(nominal(at)) - complex(nominal(of[letter]))) for letter, at in pins.items())


def spread(values: Reals) -> float:
    """3σ of the repeated hands; of none 0."""
    repeated = np.asarray(values, dtype=float)
    others = repeated[1:][np.isfinite(repeated[1:])] if repeated.ndim else np.empty(0)
    return 3.0 * scatter(others) if others.size else 0.0
