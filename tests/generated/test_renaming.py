"""Renaming a problem for its twin takes numbers of links of two digits as whole numbers."""

from __future__ import annotations

import numpy as np
import pytest

from tests.generators.retold.renamed import Names

LINKS = {str(n): {"AB": "1 mm"} for n in range(1, 13)}


@pytest.mark.parametrize("seed", range(4))
def test_a_number_of_two_digits_is_renamed_as_one(seed: int) -> None:
    names = Names(np.random.default_rng(seed), {"frame": {"A": ["0 mm", "0 mm"]}, "links": LINKS})
    new = names.number
    assert sorted(new.values(), key=int) == list(LINKS)
    assert names.text("omega_12") == f"omega_{new['12']}" and names.text("F_I10") == f"F_I{new['10']}"
    for one, other in (("1", "2"), ("3", "11"), ("12", "4")):
        written = f"R_{one}{other}" if len(one + other) == 2 else f"R_{one}_{other}"
        both = (new[one], new[other])
        wanted = "R_" + ("" if len("".join(both)) == 2 else "_").join(both)
        assert names.text(written) == wanted and names.text(f"{written}_0") == f"{wanted}_0"
