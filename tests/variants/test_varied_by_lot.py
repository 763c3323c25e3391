"""Whatever number of a problem varies, its variants are right, or it is said why there are none."""

from __future__ import annotations

from collections import Counter

import numpy as np

from tests.laws import often
from tests.variants.by_lot import varied


def test_variants_of_any_number_of_any_problem_are_right_or_refused_with_a_reason() -> None:
    rng, ends = np.random.default_rng(30), Counter[str]()
    for _ in range(often(4, 400)):
        one = varied(rng)
        assert not one.wrong, f"{one.wrong}\n{one.text}"
        assert not one.refused or len(one.refused) > 30, one.text
        ends["refused" if one.refused else "drawn" if one.drawn else "none"] += 1
    assert ends["drawn"] > ends["none"] and ends["drawn"]
