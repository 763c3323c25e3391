"""Two components written as one text."""

from __future__ import annotations

import re
from typing import Any


def pair_of(value: Any) -> Any:
    """Two components in one text, "(0 mm, 0 mm)" or 0 mm, 0 mm, as a list; anything else as it is."""
    found = (
        re.fullmatch(r"[(（\[]?([^,，()\[\]]+)[,，]([^,，()\[\]]+)[)）\]]?", value.strip())
        if isinstance(value, str)
        else None
    )
    return value if found is None else [found[1].strip(), found[2].strip()]
