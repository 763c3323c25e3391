"""Pages whose figures leave them white become plates, no larger than their figures."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from .pages import Page, plated, trimmed
from .paging import Drawn, even, lined, read_on
from .space import is_page


def on_plates(pages: Sequence[Page[Drawn]], bands: bool) -> Iterator[Page[Drawn]]:
    """What would be lost on a page on plates; the first sheets, about which the text runs, also on large ones that
    leave no bands white, if none may stay so. What comes behind a page stands at the end of the text."""
    first = not bands
    for group, layout in pages:
        made = plated(group, layout) if first else trimmed(group, layout)
        if made is not layout and not read_on(group, even(group, lined(group, made))):
            made = trimmed(group, layout)
        first = first and not is_page(made.page)
        yield group, made
