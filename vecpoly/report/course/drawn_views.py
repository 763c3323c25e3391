"""Which figures the sheets hold: mechanism diagram, velocity and acceleration polygons, free bodies, force polygons."""

from __future__ import annotations

from ...board.construction import Construction, View
from ...words import Words

_NAMES = {
    View.MECHANISM: Words("机构位置图", "the diagram"), View.VELOCITY: Words("速度多边形", "the velocity polygon"),
    View.ACCELERATION: Words("加速度多边形", "the acceleration polygon"), View.BODY: Words("各构件的受力图", "the free bodies"),
    View.FORCE: Words("力多边形", "the force polygons"),
}


def drawn_views(construction: Construction) -> Words:
    """Their names in the order in which they are drawn, the last joined by 和 / and."""
    views = {figure.view for figure in construction.figures}
    names = [words for view, words in _NAMES.items() if view in views]
    if len(names) < 2:
        return names[0] if names else Words.same("")
    return Words("、".join(w.zh for w in names[:-1]) + "和" + names[-1].zh, ", ".join(w.en for w in names[:-1]) + " and " + names[-1].en)
