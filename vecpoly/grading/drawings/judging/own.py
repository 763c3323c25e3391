"""What follows from a student's own lines: the same construction, gone on with from the points as drawn."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from ....board.otherwise.amended import Amended, plain_letters
from ....errors import VecpolyError
from ....foundation.frozen import FrozenMap
from ....mechanism.model import Mechanism
from ....methods.desk import Desk
from ....problem.problem import Problem
from ..expected import NOTHING, Expected, Shape, Vertex, expected
from ..matching.assign import Match, assigned
from ..matching.fit import Fit

REACH = 6.0  # mm: how far a joint of the diagram may lie off, and still be that joint
LIKELY = (0.2, 5.0)  # of the exact length: from other values nothing follows


@dataclass(slots=True)
class Own:
    """The own places of all points, by the number of the act that found them; what follows is drawn when asked."""

    problem: Problem
    exact: Expected
    sketch: Desk | None = None
    places: dict[int, tuple[str, complex]] = field(default_factory=dict)
    drawn: dict[int, Expected | None] = field(default_factory=dict)

    def diagram(self, fit: Fit) -> None:
        """The joints as they stand on the own diagram: where the lines end that end there on the exact one."""
        found: dict[int, tuple[Vertex, complex]] = {}
        for edge, line in assigned(fit, fit.shape).optional:
            back = abs(line.start - edge.b) + abs(line.end - edge.a)
            one = line.turned() if back < abs(line.start - edge.a) + abs(line.end - edge.b) else line
            for at, own in ((edge.a, one.start), (edge.b, one.end)):
                joint = fit.shape.vertex(at)
                if joint is not None and abs(own - at) < REACH:
                    found.setdefault(joint.act, (joint, own))
        shift = self._pivots_off(list(found.values()))
        for joint, own in found.values():
            self._place(fit.shape, joint, own - shift)

    def _pivots_off(self, found: Sequence[tuple[Vertex, complex]]) -> complex:
        """How far the fixed pivots lie off, from which the others are measured."""
        subject = self.problem.subject
        frame = subject.frame if isinstance(subject, Mechanism) else {}
        off = [own - joint.at for joint, own in found if any(letter in frame for letter in joint.letters)]
        return sum(off) / len(off) if off else 0j

    def polygon(self, shape: Shape, match: Match) -> Mapping[str, complex]:
        """Letter → own place: from the pole along the own vectors, in whatever order they were added."""
        known = {one.letters: 0j for one in shape.vertices if abs(one.at) < NOTHING}
        for edge in shape.edges:
            line = match.lines.get(edge.key)
            start, end = shape.vertex(edge.a), shape.vertex(edge.b)
            if line is None or start is None or end is None or end.letters in known or start.letters not in known:
                continue
            if LIKELY[0] < abs(line.along) / abs(edge.along) < LIKELY[1]:
                known[end.letters] = known[start.letters] + line.along
                self._place(shape, end, known[end.letters])
        return {letter: at for letters, at in known.items() for letter in letters}

    def _place(self, shape: Shape, vertex: Vertex, at: complex) -> None:
        if vertex.act < 0:
            return  # such a point is only lettered: nothing is found by it
        key = plain_letters(self.exact.construction.acts[vertex.act].key)
        self.places[vertex.act] = (f"{shape.name}:{key}", at)

    def should(self, shape: Shape, key: str) -> complex | None:
        """The vector as it follows from all own points found before its own; None where nothing follows."""
        edge = shape.edge(key)
        if edge is None:
            return None
        ends = [found.act for at in (edge.a, edge.b) if (found := shape.vertex(at)) is not None]
        number = max(ends, default=-1)
        world = self._drawn_before(number if number >= 0 else edge.act)
        there = None if world is None else world.shape(shape.name)
        follows = None if there is None else there.edge(key)
        return None if follows is None else follows.along

    def _drawn_before(self, number: int) -> Expected | None:
        points = {key: at for act, (key, at) in self.places.items() if act < number}
        if number not in self.drawn:
            self.drawn[number] = self._with(points) if points else None
        return self.drawn[number]

    def _with(self, points: Mapping[str, complex]) -> Expected | None:
        try:
            return expected(self.problem, Amended(points=FrozenMap(points)), self.sketch)
        except (VecpolyError, ValueError, ArithmeticError):
            return None  # from these points nothing can be drawn
