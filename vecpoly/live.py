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
from .methods.plan import drawn_alone
from .problem.problem import Problem
from .solution import Solution, scales_of, solve
from .words import Lang

Name = tuple[str, str]  # of a figure: its kind, and which of several


@dataclass(frozen=True, slots=True, kw_only=True)
class Redrawn:
    """What stands on the paper now: the problem, its construction,
    the scene of each figure (mm), and where its letters stand.

    Nothing here has been weighed against exact values: `check` does that.
    """

    problem: Problem
    construction: Construction
    scenes: tuple[Scene, ...]
    letters: Mapping[Name, Mapping[Label, int]]
    lang: Lang

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
        last.letters if isinstance(last, Redrawn) and last.lang == lang else _placed(last.construction.figures, lang)
    )
    scenes: list[Scene] = []
    letters: dict[Name, Mapping[Label, int]] = {}
    for figure in construction.figures:
        name = (figure.view.name, figure.name)
        follower = Follower(lang, choice=dict(before.get(name, {})))
        scene = Scene.of(follower.lettered(figure))
        scenes.append(scene + Scene.of(caption_items(figure, scene.extents, lang)))
        letters[name] = FrozenMap(follower.choice)
    return Redrawn(
        problem=problem, construction=construction, scenes=tuple(scenes), letters=FrozenMap(letters), lang=lang
    )


def _constructed(last: Construction, problem: Problem) -> Construction:
    if not isinstance(problem.subject, Mechanism):
        return solve(problem, by=last.hand, repeats=0, precise=False).construction
    return drawn_alone(replace(problem, scales=scales_of(last)), hand(last.hand, repeats=0))


def _placed(figures: tuple[Figure, ...], lang: Lang) -> dict[Name, Mapping[Label, int]]:
    """Where letters stand that were placed all together, as on paper."""
    found: dict[Name, Mapping[Label, int]] = {}
    for figure in figures:
        follower = Follower(lang)
        follower.lettered(figure)
        found[figure.view.name, figure.name] = follower.choice
    return found
