"""Whether a sheet is saved at the cost of a construction on the mechanism, whose letters find no room then."""

from __future__ import annotations

from ....board.construction import Construction, View

SMALLER = 1.3  # times: a construction is not drawn so much smaller to save a sheet


def cramped(one: Construction, other: Construction) -> bool:
    """Whether a mechanism on which centres or curvatures are found is drawn much smaller than in the other drawing."""
    here, there = (min(_scales(each), default=0.0) for each in (one, other))
    return here > SMALLER * there > 0.0


def _scales(construction: Construction) -> list[float]:
    """Of the diagrams that are drawn once more to be constructed on."""
    figures = (one for one in construction.figures if one.view is View.MECHANISM and one.name)
    return [one.scale.value for one in figures if one.scale.symbol]
