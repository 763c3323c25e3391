"""Which figures the sheets hold: mechanism diagram, velocity and acceleration polygons, free bodies, force polygons."""

from __future__ import annotations

from ....board.construction import Construction
from ....words import Words, joined


def drawn_views(construction: Construction) -> Words:
    """Their names in the order in which they are drawn."""
    return joined([view.called for view in sorted({figure.view for figure in construction.figures})])
