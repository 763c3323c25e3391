"""Random problems of every family: drawn, exact and differenced values agree, or the program declines in words.

A few members each, one where a member is dear, and not the dearest, of large kin every second family, and not fitted
to a sheet; `make soak` judges hundreds of every one, fitted, `python -m tests.generators` thousands.
"""

from __future__ import annotations

from collections import Counter
from itertools import chain

import pytest

from tests.generators.family import Family, families, member
from tests.generators.judge import Kind, judge
from tests.laws import few, soaking

FAMILIES = tuple(one for one in families() if not one.name.startswith("linkage"))  # test_generated_linkages.py
DEAR = ("elsewhere", "forces", "near-locking", "used", "any", "class-iii", "machine")  # kin whose members take longest
KIN = tuple(tuple(one for one in FAMILIES if one.name.startswith(name)) for name in DEAR)
TRIED = (*(one for one in FAMILIES if not one.name.startswith(DEAR)), *chain.from_iterable(few(kin, 2) for kin in KIN))


@pytest.mark.parametrize("one", TRIED, ids=[one.name for one in TRIED])
def test_random_problems_are_right_or_refused(one: Family) -> None:
    found = [(number, judge(member(one, 1, number), one.also, fitted=soaking())) for number in one.tried]
    bad = [
        f"{number}: {verdict.kind} {verdict.why}"
        for number, verdict in found
        if verdict.kind in (Kind.WRONG, Kind.BROKEN)
    ]
    assert not bad, f"python -m tests.generators --family {one.name} --seed 1 --only N\n" + "\n".join(bad)
    assert Counter(verdict.kind for _, verdict in found)[Kind.RIGHT] >= max(1, one.often // 4), (
        "hardly any member of this family is solved"
    )
