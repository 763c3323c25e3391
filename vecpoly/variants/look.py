"""One drawing of a variant, looked at: what the gate goes by."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import asin, pi

import numpy as np
from numpy.typing import NDArray

from ..board.acts import (
    Act,
    Area,
    Compute,
    Follow,
    Image,
    Invert,
    Judge,
    LayOff,
    Locate,
    Measure,
    Meet,
    Parallel,
    Ray,
    Touch,
    Transfer,
)
from ..board.construction import Construction
from ..board.hand import hand, steady
from ..board.otherwise.amended import AS_DRAWN, Amended
from ..board.otherwise.possible import slips_of
from ..board.otherwise.slip import Slip
from ..figures import views
from ..foundation.slotted import replace
from ..grading.allowance import STUDENT
from ..grading.derive.keyed import TURNING, answer_key
from ..grading.key import AnswerKey, Graded, Kind
from ..mechanism.model import Mechanism
from ..methods.every_hand import by_every_hand
from ..methods.plan import drawn_roughly
from ..plane.geometry import cross
from ..problem.problem import Problem, Scales
from ..solution import constructed
from ..task import task_of

_WORK = (Locate, LayOff, Transfer, Parallel, Meet, Measure, Area, Judge, Compute, Image, Follow, Touch, Ray, Invert)
SURE, TINY = 1e-6, 1e-200
MEASURED = (Kind.VECTOR, Kind.SIGNED, Kind.SCALAR, Kind.PLACE)


@dataclass(frozen=True)
class Look:
    """A problem with the scales that it is drawn at; everything else is found when it is asked for."""

    problem: Problem
    sketch: Construction

    @cached_property
    def key(self) -> AnswerKey:
        """What is graded, with tolerances."""
        return answer_key(self.problem)

    @property
    def asked(self) -> tuple[Graded, ...]:
        """What is asked and has a size on paper, a sense, or a place there."""
        return tuple(one for one in self.key.quantities if one.asked and one.kind in MEASURED)

    @cached_property
    def slips(self) -> tuple[Slip, ...]:
        """Every mistake that can be made here."""
        return slips_of(self.sketch.acts)

    @cached_property
    def by_slips(self) -> Mapping[str, NDArray[np.complex128]]:
        """What is asked by the right drawing, and by every slip."""
        return _by_slips(self.problem, self.sketch, self.slips)

    @cached_property
    def places(self) -> NDArray[np.complex128]:
        """Each asked quantity (columns) over its tolerance T: of the right drawing (row 0), and of every slip; NaN
        where one does not close."""
        return self._over({one.key: one.allowed for one in self.asked})

    @property
    def finest(self) -> NDArray[np.complex128]:
        """The same over what T is at least, before it is known: no slip shows less."""
        return self._over({key: self._least(key) for key in self.by_slips})

    def _over(self, limits: Mapping[str, float]) -> NDArray[np.complex128]:
        count = len(self.slips) + 1
        with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
            columns = [np.broadcast_to(self.by_slips[key], (count,)) / limit for key, limit in limits.items()]
        return np.array(columns, dtype=np.complex128).reshape(-1, count).T

    def _least(self, key: str) -> float:
        """What nobody reads, or reckons, a vector, ω or α more finely than; of all else hardly anything."""
        one = self.sketch.readings.get(key)
        if one is None or one.unit == "m" or (one.vector is None and one.unit not in TURNING):
            return TINY
        mm = sizes_mm(self.problem, self.sketch).get(key, 0.0)
        read = STUDENT.floor * abs(one.scalar) / mm if mm else 0.0
        return (1 - SURE) * max(read, STUDENT.arithmetic * abs(one.scalar)) or TINY


def sketch_of(problem: Problem, like: Scales | None = None) -> Construction:
    """The construction by an exact hand; like: scales for a drawing of which only the proportions are of use."""
    if like is not None and isinstance(problem.subject, Mechanism):
        given = Scales({**like.given, **problem.scales.given})
        return drawn_roughly(replace(problem, scales=given), hand("exact"))
    return constructed(problem, hand("exact"), AS_DRAWN).construction


def work(acts: Sequence[Act]) -> tuple[tuple[str, str], ...]:
    """What is done, in order, without what only leaves ink: two variants with the same work are as hard as each
    other."""
    return tuple((type(act).__name__, act.key) for act in acts if isinstance(act, _WORK))


def least_meeting(acts: Sequence[Act]) -> float:
    """The smallest angle (rad) at which two ruled lines, two arcs, or a line and an arc meet."""
    return min((_angle(act, acts) for act in acts if isinstance(act, Meet)), default=pi / 2)


def _angle(meet: Meet, acts: Sequence[Act]) -> float:
    if meet.angle is not None:
        return meet.angle
    lines = [one.along for n in meet.inputs if isinstance(one := acts[n], Parallel)]
    if len(lines) != 2:
        return pi / 2
    return asin(min(1.0, abs(float(cross(lines[0], lines[1])))))


def sizes_mm(problem: Problem, sketch: Construction) -> Mapping[str, float]:
    """How long each asked vector is on paper, at the scales of the problem."""
    mu = {view.mu.symbol: value for view in views() if (value := problem.scales.of(view.mu))}
    return {
        key: abs(one.scalar) / scale
        for key, one in sketch.readings.items()
        if one.vector is not None and (scale := mu.get(one.scale)) and one.unit != "m"
    }


def _by_slips(problem: Problem, sketch: Construction, slips: Sequence[Slip]) -> Mapping[str, NDArray[np.complex128]]:
    by, amended = steady(len(slips)), Amended(each=tuple(slips))
    if isinstance(problem.subject, Mechanism):
        return {key: np.asarray(found) for key, found in by_every_hand(problem, by, sketch, amended).items()}
    repeats = task_of(problem).draw(by, amended).repeats
    return {key: np.asarray(found) for key, found in repeats.items()}
