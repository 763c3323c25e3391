"""What stands over the part of a table on a later page."""

from __future__ import annotations

import re

from ....words import Lang, Words

CONTINUED = Words("续表", "(continued)")  # over a table without a caption of its own
_NUMBER = re.compile(r"(?:续?表|Table) ?([\dA-Z]+-\d+)")  # at the head of a caption


def continued(caption: str, lang: Lang) -> str:
    """续表 5-2, Table 5-2 (continued); "" of a caption without a number."""
    number = _NUMBER.match(caption)
    if number is None:
        return ""
    return f"续表 {number[1]}" if lang == "zh" else f"Table {number[1]} (continued)"
