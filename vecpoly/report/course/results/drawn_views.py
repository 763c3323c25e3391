"""Which figures the sheets hold: mechanism diagram, velocity and acceleration polygons, free bodies, force polygons."""

from __future__ import annotations

from ....board.construction import Construction
from ....words import Words


def drawn_views(construction: Construction) -> Words:
    """Their names in the order in which they are drawn, the last joined by 和 / and."""
    names = [view.called for view in sorted({figure.view for figure in construction.figures})]
    if len(names) < 2:
        return names[0] if names else Words.same("")
    return Words(
        "、".join(w.zh for w in names[:-1]) + "和" + names[-1].zh,
        ", ".join(w.en for w in names[:-1]) + " and " + names[-1].en,
    )
