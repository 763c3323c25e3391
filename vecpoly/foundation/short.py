"""Short codes that people read: no letter that looks like a digit."""

from __future__ import annotations

from hashlib import sha256

LETTERS = "0123456789ABCDEFGHJKMNPQRSTVWXYZ"  # Crockford's base 32: no I, L, O, U


def short(text: str, length: int) -> str:
    """So many letters of the digest of a text."""
    number = int.from_bytes(sha256(text.encode()).digest()[:16], "big")
    return "".join(LETTERS[number >> 5 * i & 31] for i in range(length))
