"""What is missing of a rotor, seen from its end: a hole as a circle of its diameter, a keyway as a rectangle."""

from __future__ import annotations

from itertools import pairwise

from .....board.construction import Place
from .....board.paper.marks import Role
from .....devices.balancing.asked import hole_size
from .....devices.balancing.mass import RotorMass
from .....devices.balancing.plane import RotorPlane
from .....plane import nominal
from ...bench import Bench
from ..scales import END_VIEW, LUMP

LEAST = 1.2  # mm: half the width of a keyway, or of its depth, that can be seen


def void(bench: Bench, view: Place, at: complex, mass: RotorMass, role: Role) -> None:
    """The hole or keyway of a mass that is missing there; of another a ring."""
    if mass.keyway is None or mass.depth is None or not at:
        bench.board.circle(view, at, _radius(bench, 0.0 if mass.hole is None else mass.hole.si), role)
        return
    wide, deep = (max(size.si / 2 / _mm(bench), LEAST) for size in (mass.keyway, mass.depth))
    out = at / abs(at)
    corners = [at + out * complex(x * deep, y * wide) for x, y in ((1, 1), (1, -1), (-1, -1), (-1, 1), (1, 1))]
    for a, b in pairwise(corners):
        bench.board.join(view, a, b, role)


def drilled(bench: Bench, view: Place, at: complex, plane: RotorPlane, end: str) -> None:
    """A hole that is to be drilled there, with the drill that is given or the diameter that was found."""
    found = (bench.board.found.get(hole_size(name, True).key) for name in (end, ""))
    across = next((float(nominal(size)) * 1e-3 for size in found if size is not None), None)
    if across is None:
        across = 0.0 if plane.hole is None else plane.hole.si
    bench.board.circle(view, at, _radius(bench, across), Role.HIDDEN)


def _radius(bench: Bench, across: float) -> float:
    """Of a hole of this diameter on paper; no smaller than that of a mass."""
    return max(across / 2 / _mm(bench), LUMP)


def _mm(bench: Bench) -> float:
    return bench.board.scale_of(END_VIEW).value
