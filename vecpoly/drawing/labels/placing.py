"""Lettering finds its places: each label moves about what it names until it stands on nothing; if it must
it goes farther off, on a leader. It never shrinks: one figure has one size of type."""

from __future__ import annotations

from collections.abc import Mapping

from ..spared import relieved
from ..weighing.placed import Placed
from ..weighing.prices import Around
from ..weighing.table import MANY, Table

CROWDS = (0.0, 12.0, 25.0, 40.0)  # mm about a label in trouble within which labels may go farther off, if need be


def place(around: Around) -> Mapping[int, Placed]:
    """A place for each label, by its number; the same input always gives the same places. What a crowd spares is left
    out first; what is still crowded goes farther off."""
    table = Table.of(around)
    while (left := _relieved(table, farther=False)) is not table:
        table = left
    while (left := _relieved(there := _farther(table), farther=True)) is not there:
        table = left
    return there.placed(there.standing)


def _relieved(table: Table, *, farther: bool) -> Table:
    """Without what a crowd spares; farther: once the others have gone farther off."""
    placed = table.placed(table.standing if farther else table.tried)
    left_out, brief = relieved(placed, polygon=table.around.polygon, farther=farther)
    return table.without(left_out, brief) if left_out or brief else table


def _farther(table: Table) -> Table:
    """With longer leaders in crowds: first for those in trouble, then also for those about them."""
    for around in CROWDS:
        crowded = table.crowded(table.tried)
        if not crowded:
            break
        reach = CROWDS[-1] if len(crowded) > MANY * len(table.rows) else around
        sooner = {i for i in table.about(crowded, reach) if not table.rows[i].want.farther}
        if sooner:
            table = table.eased(sooner)
    return table
