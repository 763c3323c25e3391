"""mypy as `make test` runs it: without Python's collector of rubbish, which takes a fifth of its time and finds what is
given back a minute later anyway."""

from __future__ import annotations

import gc
from unittest.mock import patch

from mypy.__main__ import console_entry

if __name__ == "__main__":
    gc.disable()
    with patch.object(gc, "enable"):  # mypy switches it on again once it has read all files
        console_entry()
