"""What a statement asks in words has its sentence in the box of answers."""

from __future__ import annotations

import re

from tests.drawn_library import drafted, given, ids
from tests.each import each
from vecpoly.report.content import conclusions

OF_A_LINK = re.compile(r"\$([va]_\d)\$")
ASKING = tuple(name for name in ids() if OF_A_LINK.search(given(name).statement.zh))


@each(ASKING)
def test_the_motion_of_a_translating_link_is_told_under_its_own_symbol(name: str) -> None:
    solution = drafted(name)
    assert solution is not None
    for symbol in OF_A_LINK.findall(given(name).statement.zh):
        assert any(f"${symbol}$ = $" in text for text in conclusions(solution, "en")), symbol


def test_an_in_line_four_leaves_the_force_of_second_order() -> None:
    solution = drafted("engine-four")
    assert solution is not None
    (told,) = conclusions(solution, "en")
    assert told == "Left unbalanced is the force of second order $F_{II}$; the others are balanced."
    assert conclusions(solution, "zh") == ["未平衡的是二阶惯性力 $F_{II}$，其余各项均已平衡。"]
