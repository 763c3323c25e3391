"""A long list stands in blocks beside each other; where a page break parts it, the first of it stand on the first
page."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from vecpoly.report.flow.results.blocked import BlockTable
from vecpoly.report.flow.table import DataTable

WIDTH = 480.0  # pt


def read(table: DataTable, blocks: int) -> list[str]:
    """The numbers as one reads them: down one block after another."""
    step = len(table.header) // blocks + (blocks > 1)
    columns = [[row[n * step] for row in table.rows] for n in range(blocks)]
    return [cell for column in columns for cell in column if cell]


@given(st.integers(1, 80), st.integers(1, 4), st.floats(40.0, 400.0), st.sampled_from(["zh", "en"]))
def test_a_list_is_read_in_order_on_every_page(count: int, blocks: int, height: float, lang: str) -> None:
    """Rows 0–4, 9–13, 18–22 stood on one page, and 5–8, 14–17, 23, 24 on the next."""
    items = [(str(n), f"{n / 7:.2f}") for n in range(count)]
    whole = BlockTable.of(["No.", "$s$/mm"], items, blocks, "dd", "zh" if lang == "zh" else "en")
    whole.wrap(WIDTH, height)
    parts = [part for part in whole.split(WIDTH, height) if isinstance(part, BlockTable)] or [whole]
    assert [text for part in parts for text in read(part, blocks)] == [number for number, _ in items]
    for part in parts[:-1]:
        assert part.wrap(WIDTH, height)[1] <= height and "" not in [row[0] for row in part.rows]
    assert len(parts) == 1 or parts[1].wrap(WIDTH, 1e6)[1] <= whole.wrap(WIDTH, 1e6)[1]
