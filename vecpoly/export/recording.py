"""A drawing that follows its driving link:
the recorded sheet, the range in which it was proved, what does not follow."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import isfinite, pi

from ..board import acts as done
from ..board.acts.inkless import FOUND_ON
from ..board.construction import Scale, View
from ..board.hand import hand
from ..board.otherwise.amended import AS_DRAWN
from ..board.place import view_of
from ..errors import NoMethodError, VecpolyError
from ..foundation.slotted import replace
from ..mechanism.model import Drive, Mechanism
from ..mechanism.profiles import refuse_profiles
from ..methods.desk import Desk
from ..methods.plan import drawn_exactly, scale_symbols
from ..names import Sort
from ..problem.asked.asks import AskNamed
from ..problem.problem import Problem
from ..solution import constructed
from ..words import Words
from .ink import stale
from .parts import Numbers
from .terms import Term, values

PLACES = 24  # on either side of the given position, at which the recorded drawing is compared with one drawn anew
BEFORE = 0.37  # of a step: where it is tried, so that round angles, at which vectors may vanish, are not met
TRAVEL = 0.6  # of the mechanism's size: how far a sliding input is tried to either side
CLOSE = 1e-8  # of the largest coordinate: nearer than this two points are one


_OF_LOADS = (Sort.PLAIN, Sort.REDUCED, Sort.BALANCE)
_STANDING = Words(
    "此题没有随原动件运动的机构，没有 GeoGebra 文件；可用 vecpoly draw 或 vecpoly play，凸轮廓线可写成 .dxf 或 .csv",
    "this problem has no mechanism that follows a driving link, so there is no GeoGebra file of it; take vecpoly draw "
    "or vecpoly play, for the profile of a cam .dxf or .csv",
)
_OTHERWISE_DRIVEN = Words(
    "GeoGebra 文件须有且只有一个相对机架转动或移动的原动件，此题的原动件不止一个，或在两个活动构件之间；"
    "可用 vecpoly draw 或 vecpoly play",
    "a GeoGebra file needs one link, and no other, that is driven against the frame, and here more are, or one "
    "is driven against another that moves; take vecpoly draw or vecpoly play",
)
_BY_TRIAL = Words(
    "此题的作图过程不能随原动件连续变动（如用试作法定位，或在此位置有矢量为零），不能写成 GeoGebra 文件；"
    "可另取原动件位置，或用 vecpoly play",
    "this construction does not follow its driving link (a point is found by trial, or a vector vanishes in this "
    "position), so there is no GeoGebra file of it; choose another position, or take vecpoly play",
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Recording:
    """The drawing; the input's name and the range (rad or m) over which it was proved; the answers that follow."""

    problem: Problem
    desk: Desk
    terms: Numbers
    variable: str
    low: float
    high: float
    follow: tuple[done.Answer, ...]
    left_out: tuple[str, ...]  # keys of what is asked and does not follow
    loads: tuple[str, ...]  # keys of what is asked of loads, which are left away
    stale: frozenset[int]  # numbers of the acts whose ink does not follow

    @property
    def drive(self) -> Drive:
        """The input."""
        return self.problem.mechanism.drive


def record(problem: Problem) -> Recording:
    """Draw by an exact hand, remembering how every number was computed, and prove the result by drawing anew.

    Raises NoMethodError for a device, for an input between moving links, and where the drawing does not follow.
    """
    asked, problem = problem.asks, moving(problem)
    refuse_profiles(
        problem.mechanism.cams, Words("随原动件运动的 GeoGebra 图", "a GeoGebra drawing that follows its drive")
    )
    drive, scales = problem.mechanism.drive, scales_of(problem)
    desk, terms = drawn_exactly(problem, scales, recorded=True), Numbers()
    name = f"{'s' if drive.slide else 'phi'}_{drive.link}"
    proof = _Proof(problem, scales, terms, name, desk.board.acts)
    low, high = proof.range()
    follow = tuple(act for act in desk.board.acts if isinstance(act, done.Answer) and act.key not in proof.fails)
    return Recording(
        problem=problem,
        desk=desk,
        terms=terms,
        variable=name,
        low=low,
        high=high,
        follow=follow,
        left_out=tuple(sorted(proof.fails)),
        loads=tuple(ask.rel.key for ask in asked if ask not in problem.asks),
        stale=frozenset(proof.stale),
    )


def moving(problem: Problem) -> Problem:
    """The problem without its loads: what moves."""
    if not isinstance(problem.subject, Mechanism):
        raise NoMethodError(_STANDING, code="export-device")
    if len(problem.mechanism.drives) != 1 or problem.mechanism.drive.between:
        raise NoMethodError(_OTHERWISE_DRIVEN, code="export-drive")
    asks = tuple(ask for ask in problem.asks if not (isinstance(ask, AskNamed) and ask.rel.sort in _OF_LOADS))
    return replace(problem, loads=None, machine=None, counterweights=None, asks=asks)


def scales_of(problem: Problem) -> dict[View, Scale]:
    """The scales of the sheet by an exact hand."""
    drawn = constructed(problem, hand("exact"), AS_DRAWN).construction
    return {**scale_symbols(), **{figure.view: figure.scale for figure in reversed(drawn.figures)}}


def _spots(acts: Sequence[done.Act]) -> dict[tuple[str, str], complex]:
    return {(act.figure, act.key): act.at for act in acts if isinstance(act, done.Locate) and not _is_aside(act)}


def _is_aside(act: done.Act) -> bool:
    """Whether it is done on a figure beside the diagram and the polygons, or is found by a construction on the diagram,
    such as a centre."""
    place = act.head.place
    return act.head.owner == FOUND_ON or (place is not None and view_of(place) is not place)


def _answers(acts: Sequence[done.Act]) -> dict[tuple[str, str], complex]:
    return {("", act.key): act.value for act in acts if isinstance(act, done.Answer)}


class _Proof:
    """The recorded drawing beside drawings made anew; fails, stale: the answers, and the acts, that do not follow."""

    def __init__(
        self, problem: Problem, scales: dict[View, Scale], terms: Numbers, name: str, acts: Sequence[done.Act]
    ) -> None:
        self.problem, self.scales, self.name, self.acts = problem, scales, name, acts
        spots, answers = _spots(acts), _answers(acts)
        self.spots, self.answers = tuple(spots), tuple(answers)
        self.arrows = tuple(act for act in acts if isinstance(act, done.Arrow))
        ways = (act.b - act.a for act in self.arrows)
        every = (*spots.values(), *answers.values(), *ways)
        self.roots: list[Term] = [part for value in every for part in terms.parts(value)]
        self.fails: set[str] = set()
        self.stale: set[int] = {act.number for act in acts if isinstance(act, done.Locate) and _is_aside(act)}

    def range(self) -> tuple[float, float]:
        """How far to either side the drawing is right: whole turns, or as far as it was found to be."""
        drive = self.problem.mechanism.drive
        step = TRAVEL * self.problem.mechanism.scale / PLACES if drive.slide else pi / PLACES
        if not all(self._holds(drive.position + by) for by in (0.0, 1e-3 * step, -1e-3 * step)):
            raise NoMethodError(_BY_TRIAL, code="export-trial")
        up, down = self._reach(drive.position, step), self._reach(drive.position, -step)
        if not drive.slide and up == down == PLACES:
            return 0.0, 2 * pi
        return drive.position - down * step, drive.position + up * step

    def _reach(self, start: float, step: float) -> int:
        """The number of steps until the drawing is no longer right."""
        return next((n - 1 for n in range(1, PLACES + 1) if not self._holds(start + (n - BEFORE) * step)), PLACES)

    def _holds(self, position: float) -> bool:
        """Whether every lettered point is where it is when drawn anew for this position of the input."""
        drive = self.problem.mechanism.drive
        moved = replace(self.problem.mechanism, drives=(replace(drive, position=position),))
        try:
            acts = drawn_exactly(replace(self.problem, subject=moved), self.scales).board.acts
        except VecpolyError:
            return False
        numbers = values(self.roots, {self.name: position})
        mine = [complex(*pair) for pair in zip(numbers[::2], numbers[1::2], strict=True)]
        spots, answers = _spots(acts), _answers(acts)
        if spots.keys() != set(self.spots) or not _same(mine, [spots[key] for key in self.spots]):
            return False
        first, last = len(self.spots), len(self.spots) + len(self.answers)
        self.stale |= {*stale(self.acts, acts), *self._turned_back(mine[last:], acts)}
        self.fails |= set(self._unlike(mine[first:last], answers))
        return True

    def _turned_back(self, mine: Sequence[complex], there: Sequence[done.Act]) -> Iterator[int]:
        """The arrows that point the other way when drawn anew, such as that of a velocity on the return stroke."""
        anew = [act.b - act.a for act in there if isinstance(act, done.Arrow)]
        if len(anew) == len(mine):
            yield from (
                act.number
                for act, a, b in zip(self.arrows, mine, anew, strict=True)
                if (a.conjugate() * b).real < -CLOSE * abs(b) ** 2
            )

    def _unlike(self, mine: Sequence[complex], there: dict[tuple[str, str], complex]) -> Iterator[str]:
        for key, value in zip(self.answers, mine, strict=True):
            if key not in there or not abs(value - there[key]) <= CLOSE * max(abs(there[key]), 1.0):
                yield key[1]


def _same(mine: Sequence[complex], there: Sequence[complex]) -> bool:
    size = max(map(abs, there), default=1.0)
    return all(isfinite(abs(a)) and abs(a - b) <= CLOSE * size for a, b in zip(mine, there, strict=False))
