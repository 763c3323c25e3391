"""A linkage is checked with lengths that were found: with given ones it would be held against itself."""

from __future__ import annotations

import re

from tests.drawn_library import LIBRARY, drawn, given
from tests.each import Later, each
from vecpoly.designs.base import Design
from vecpoly.report.verification.table import as_moved

DESIGNS = Later(lambda: [name for name in LIBRARY if isinstance(given(name).subject, Design)])
LENGTH = re.compile(r"[A-Z]{2}|[eh]")  # of a bar, an offset: no stroke H


@each(DESIGNS)
def test_a_linkage_is_checked_by_its_measured_lengths_only_where_a_length_is_measured(name: str) -> None:
    readings = drawn(name).construction.readings
    table, said = as_moved(drawn(name).solution, "zh")
    measured = {key.split("_")[0] for key, one in readings.items() if one.mm is not None and one.unit in ("m", "mm")}
    assert not (table or said) or any(LENGTH.fullmatch(key) for key in measured), (said, sorted(measured))
