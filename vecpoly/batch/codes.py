"""Codes that people read: no letter that looks like a digit, and no names in them."""

from __future__ import annotations

from hashlib import sha256

LETTERS = "0123456789ABCDEFGHJKMNPQRSTVWXYZ"  # Crockford's base 32: no I, L, O, U
SCHEME = "VP1"


def short(text: str, length: int) -> str:
    """So many letters of the digest of a text."""
    number = int.from_bytes(sha256(text.encode()).digest()[:16], "big")
    return "".join(LETTERS[number >> 5 * i & 31] for i in range(length))


def sheet_id(assignment: str, salt: str, number: str) -> str:
    """The eight letters of a student's sheet, from which nobody reads the student's number."""
    return short(f"{SCHEME}|sheet|{assignment}|{salt}|{number}", 8)


def page_code(assignment: str, sheet: str, page: int, layout: str) -> str:
    """What the QR code of a page says: scheme, assignment, sheet, page, layout; also printed in letters."""
    return f"{SCHEME}-{short(assignment, 4)}-{sheet}-{page}-{layout}"
