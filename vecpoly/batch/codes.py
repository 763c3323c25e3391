"""Codes that people read, and no names in them."""

from __future__ import annotations

from ..foundation.short import short

SCHEME = "VP1"


def sheet_id(assignment: str, salt: str, number: str) -> str:
    """The eight letters of a student's sheet, from which nobody reads the student's number."""
    return short(f"{SCHEME}|sheet|{assignment}|{salt}|{number}", 8)


def page_code(assignment: str, sheet: str, page: int, layout: str) -> str:
    """What the QR code of a page says: scheme, assignment, sheet, page, layout; also printed in letters."""
    return f"{SCHEME}-{short(assignment, 4)}-{sheet}-{page}-{layout}"
