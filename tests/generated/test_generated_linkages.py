"""Random linkages of every joint form: drawing, oracle and central differences agree, and none is refused."""

from __future__ import annotations

import pytest

from tests.generators.family import families, member
from tests.generators.judge import Kind, judge
from tests.laws import few, soaking

EACH = 4  # `make soak` judges hundreds


@pytest.mark.parametrize("name", few([one.name for one in families() if one.name.startswith("linkage")], 2))
def test_random_linkages_are_right(name: str) -> None:
    one = next(each for each in families() if each.name == name)
    found = {number: judge(member(one, 0, number), fitted=soaking()) for number in range(EACH)}
    assert {number: verdict for number, verdict in found.items() if verdict.kind is not Kind.RIGHT} == {}
