"""Lines at the head of a frame on which the vector equations of its figure are written: each has the name of its kind
and the number of its rows, and says nothing else."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...board.construction import Construction, Figure
from ...board.paper.marks import Mark, Note, Role, Segment
from ...board.place import Pane, Place
from ...words import Words

KEY = "equation"  # of a mark that belongs to such a line
_ROW, _EDGE, _RAISED = 8.0, 4.0, 2.4  # mm: a line; from the frame to its ends; its name stands over it
_NAMES = {
    "velocity": Words("速度方程", "Velocity equation"),
    "acceleration": Words("加速度方程", "Acceleration equation"),
    "force": Words("力平衡方程", "Equilibrium of forces"),
}
_ANY = Words("矢量方程", "Vector equation")


def numbers(construction: Construction, figure: Figure) -> tuple[int, ...]:
    """The numbers of the equations that are drawn in this figure, counted through the whole solution."""
    places = [step.view for step in construction.steps if step.equation is not None]
    return tuple(n for n, place in enumerate(places, 1) if place is not None and _is(place, figure))


def _is(place: Place, figure: Figure) -> bool:
    view, name = (place.view, place.name) if isinstance(place, Pane) else (place, "")
    return (view, name) == (figure.view, figure.name)


def named(place: Place | None) -> Words:
    """What an equation is called that is drawn there."""
    view = place.view if isinstance(place, Pane) else place
    return _ANY if view is None else _NAMES.get(view.name, _ANY)


def band(equations: Sequence[int]) -> float:
    """How high so many lines are (mm)."""
    return len(equations) * _ROW + _EDGE / 2 if equations else 0.0


def lines(figure: Figure, equations: Sequence[int], corner: complex, width: float) -> Iterator[Mark]:
    """The lines under the upper left corner of a frame of this width."""
    name = named(figure.view)
    for row, number in enumerate(equations, 1):
        start = corner + _EDGE - 1j * row * _ROW
        words = Words(f"({number})　{name.zh}", f"({number}) {name.en}")
        yield Segment(a=start, b=start + width - 2 * _EDGE, role=Role.CONSTRUCTION, step=1, key=KEY)
        yield Note(at=start + 1j * _RAISED, words=words, side=1 + 0j, step=1, key=KEY)
