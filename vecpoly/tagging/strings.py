"""Texts as the language of PDF writes them."""

from __future__ import annotations

from codecs import BOM_UTF16_BE
from functools import lru_cache

_ESCAPED = str.maketrans({"\\": r"\\", "(": r"\(", ")": r"\)"})


@lru_cache(maxsize=4096)
def pdf_string(text: str) -> str:
    """A text string: as it stands where it is ASCII, else UTF-16 in hexadecimal."""
    if text.isascii() and text.isprintable():
        return f"({text.translate(_ESCAPED)})"
    return f"<{(BOM_UTF16_BE + text.encode('utf-16-be')).hex().upper()}>"
