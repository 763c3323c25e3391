"""A drawing that follows its problem while somebody drags it about:
scales are held, and letters carried on from where they stood."""

from __future__ import annotations

from collections.abc import Mapping

from .board.construction import Construction, Figure
from .board.hand import hand
from .drawing.figure import caption_items
from .drawing.labels.following import Follower
from .drawing.labels.following import Name as Label
from .drawing.scene import Scene
from .foundation.frozen import FrozenMap
from .foundation.slotted import dataclass, replace
from .mechanism.model import Mechanism
from .methods.plan import drawn_roughly
from .problem.problem import Problem
from .solution import Solution, scales_of, solve
from .words import Lang

Name = tuple[str, str]  # of a figure: its kind, and which of several


@dataclass(frozen=True, slots=True, kw_only=True)
class Redrawn:
    """What stands on the paper now: the problem, its construction,
    the scene of each figure (mm), and where its letters and supports stand.

    Nothing here has been weighed against exact values, and no lines are worked out in the steps: `check` does that.
    """

    problem: Problem
    construction: Construction
    scenes: tuple[Scene, ...]
    followers: Mapping[Name, Follower]
    lang: Lang

    @property
    def letters(self) -> Mapping[Name, Mapping[Label, int]]:
        """Which of its places each letter of a figure has."""
        return {name: follower.choice for name, follower in self.followers.items()}

    def check(self) -> Solution:
        """The solution of the same problem by the same hand, at the same scales, with the exact values beside it."""
        return solve(replace(self.problem, scales=scales_of(self.construction)), by=self.construction.hand)


def redraw(last: Solution | Redrawn, problem: Problem, *, lang: Lang = "zh") -> Redrawn:
    """Draw a problem that differs a little from the one drawn last:
    at its scales, by its hand, with its letters where they were if they may stay.

    Of a problem with another structure only the scales are held. Raises AssemblyError, DeadPointError, NoMethodError as
    `solve` does; what
    was drawn last is untouched, so that one can go on from it.
    """
    construction = _constructed(last.construction, problem)
    before = (
        last.followers if isinstance(last, Redrawn) and last.lang == lang else _placed(last.construction.figures, lang)
    )
    scenes: list[Scene] = []
    followers: dict[Name, Follower] = {}
    for figure in construction.figures:
        name = (figure.view.name, figure.name)
        follower = followers[name] = before[name].again() if name in before else Follower(lang)
        scene = Scene.of(follower.lettered(figure))
        scenes.append(scene + Scene.of(caption_items(figure, scene.extents, lang)))
    return Redrawn(
        problem=problem, construction=construction, scenes=tuple(scenes), followers=FrozenMap(followers), lang=lang
    )


def _constructed(last: Construction, problem: Problem) -> Construction:
    if not isinstance(problem.subject, Mechanism):
        return solve(problem, by=last.hand, repeats=0, precise=False).construction
    return drawn_roughly(replace(problem, scales=scales_of(last)), hand(last.hand, repeats=0))


def _placed(figures: tuple[Figure, ...], lang: Lang) -> dict[Name, Follower]:
    """How letters stand that were placed all together, as on paper."""
    found: dict[Name, Follower] = {}
    for figure in figures:
        follower = found[figure.view.name, figure.name] = Follower(lang)
        follower.lettered(figure)
    return found
