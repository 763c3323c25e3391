"""The codes are those of segno, module by module."""

from __future__ import annotations

import segno
from hypothesis import given, settings
from hypothesis import strategies as st

from vecpoly.batch.sheet.qr import modules

LETTERS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ-"


@settings(max_examples=60, deadline=None)
@given(st.text(LETTERS, min_size=1, max_size=90))
def test_a_code_is_what_segno_makes_of_it(code: str) -> None:
    made = segno.make(code, error="q", micro=False, boost_error=False)
    assert modules(code) == tuple(bytes(row) for row in made.matrix)
