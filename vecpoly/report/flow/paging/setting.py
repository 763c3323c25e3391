"""A story set more tightly, or more openly, and what is at fault with one that is laid out."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from typing import Any

from ..base import Block, Tightness
from ..doc import ReportDoc


def tightened(story: Sequence[Any], degree: Tightness) -> list[Any]:
    """The story set so; what it was made of is left as it is."""
    return [reset(item, degree) for item in story]


def reset(item: Any, degree: Tightness | None) -> Any:
    """A copy, set so where it is to be."""
    if not isinstance(item, Block):
        return item
    own = copy(item)
    if degree is not None:
        own.tighten(degree)
    return own


def faults_of(doc: ReportDoc) -> tuple[int, int]:
    """What there is to be mended on the pages, the worst first: boxes that open one, holes."""
    return len(doc.widows), doc.gaps
