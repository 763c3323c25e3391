"""Tables of steps: a column has one count of decimals and one unit, which stands in its head; works and shares are
summed up."""

from __future__ import annotations

import re

from tests.drawn_library import IDS, drawn
from tests.each import each
from vecpoly.algebra.columns import TOTAL
from vecpoly.board.construction import Listing
from vecpoly.report.tables import listed

NUMBER = re.compile(r"−?\d+(?:\.(\d+))?")
UNIT = re.compile(r" /(?:°|\w+²?|\([^()]+(?:\([^()]*\))?\)(?:\^\{−1\})?)$")  # of a product in brackets


def listings(name: str) -> list[Listing]:
    """The tables of a problem's steps."""
    return [step.listing for step in drawn(name).construction.steps if step.listing is not None]


@each(IDS)
def test_numbers_under_each_other_have_one_count_of_decimals_or_of_figures(name: str) -> None:
    for one in listings(name):
        table = listed(one, "en")
        for head, cells in zip(table.header, zip(*table.rows, strict=True), strict=True):
            found = [match for match in map(NUMBER.fullmatch, cells) if match is not None]
            decimals = {len(match[1] or "") for match in found}
            figures = {len(re.sub(r"\D", "", match[0]).lstrip("0")) for match in found}
            assert len(decimals) <= 1 or figures == {4}, (head, cells)


@each(IDS)
def test_the_unit_of_a_column_stands_in_its_head_behind_a_stroke(name: str) -> None:
    for head in (head.en for one in listings(name) for head in one.head):
        units = re.sub(r"\$[^$]*\$", "", head)  # not ω_i/ω
        assert "/" not in units or UNIT.search(head), head


def test_works_and_shares_are_summed_up_from_the_numbers_that_stand_there() -> None:
    for name, columns in (("hoist", (3, 5)), ("engine-flywheel", (3, 4)), ("7-6", (2,)), ("press-flywheel", (2,))):
        tables = [one for one in listings(name) if one.rows[-1][0] == TOTAL]
        assert tables, name
        for one in tables:
            for n in range(1, len(one.head)) if len(one.head) < 4 else columns:
                *parts, total = (row[n].replace("−", "-") for row in one.rows)
                assert not total or abs(sum(map(float, parts)) - float(total)) < 1e-9, (name, one.head[n].en)
