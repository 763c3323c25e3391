"""Tables as CSV that spreadsheets open as they are."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from io import StringIO

from ...batch.forms.profile import guarded


def csv_bytes(rows: Sequence[Sequence[str | float]]) -> bytes:
    """With the mark of UTF-8, by which spreadsheets know it; no text is taken for a formula."""
    text = StringIO()
    writer = csv.writer(text, lineterminator="\r\n")
    for row in rows:
        writer.writerow(guarded(cell) if isinstance(cell, str) else f"{cell:g}" for cell in row)
    return text.getvalue().encode("utf-8-sig")
