"""What drawing a problem yields, before anything is compared with it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from ..board.construction import Construction, Reading
from .answers import Repeats


class Drawn(NamedTuple):
    """The construction; every asked answer by all hands; every one as an ideal hand, which neither rounds nor scatters, reads it."""

    construction: Construction
    repeats: Repeats
    ideal: Mapping[str, Reading]
