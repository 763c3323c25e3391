"""A kind of figure is a value: its scale, its hue, its title, its place on the sheet."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import ClassVar

from ..errors import UnknownNameError
from ..foundation.plugins import load_modules
from ..words import Words
from .hue import PLAIN, TONES, Hue
from .mu import Mu


@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class View:
    """A kind of figure on a sheet; each is one value, the same wherever it is met.

    Those of a mechanism's analysis are at hand by name. order: figures stand on sheets by it. mu: the scale, of both
    directions unless `across` has one of its own (an M–φ diagram: its areas are μ_M μ_φ). beside: a figure stands
    beside the one of this kind that has its name, as a force polygon beside its free body.
    """

    MECHANISM: ClassVar[View]
    VELOCITY: ClassVar[View]
    ACCELERATION: ClassVar[View]
    BODY: ClassVar[View]  # a link drawn apart, with the forces on it
    FORCE: ClassVar[View]  # a force polygon

    name: str  # in keys and on the command line: velocity
    order: int
    title: Words  # under a figure: 速度多边形
    called: Words  # in a sentence: the velocity polygon
    mu: Mu
    across: Mu | None = None
    ink: Hue = Hue.BLACK  # of its vectors
    tint: Hue = Hue.PLATE  # behind a link, or its image
    images: bool = False  # a polygon with images of links: its lines have its ink, its letters may crowd together
    bodies: bool = False  # links and blocks stand on it, and arrows are seen over them
    wide: bool = False  # has the width of a page
    beside: View | None = None
    letters: tuple[str, Words] | None = None  # of its points, and what they are

    def __repr__(self) -> str:
        return f"<{self.name}>"

    def __str__(self) -> str:
        return self.name

    def __reduce__(self) -> tuple[Callable[[str], View], tuple[str]]:
        return view_named, (self.name,)  # one value, also after pickle and copy

    def __lt__(self, other: View) -> bool:
        return self.order < other.order

    @property
    def is_polygon(self) -> bool:
        """Whether vectors are laid end to end on it: no links stand there, and no axes with scales of their own."""
        return not self.bodies and self is not View.MECHANISM and self.across is None

    @property
    def paired(self) -> bool:
        """Whether its figures stand in pairs with those of another kind."""
        return self.beside is not None or any(other.beside is self for other in _VIEWS.values())


_VIEWS: dict[str, View] = {}


def register(view: View) -> View:
    """Put a kind on file; raises ValueError where its name or its place is taken."""
    if any(view.name == other.name or view.order == other.order for other in _VIEWS.values()):
        raise ValueError(f"two kinds of figure have the name {view.name}, or the place {view.order}")
    _VIEWS[view.name] = view
    views.cache_clear()
    return view


@cache
def views() -> tuple[View, ...]:
    """Every kind of figure on file, in the order of a sheet."""
    load_modules("vecpoly.figures")
    return tuple(sorted(_VIEWS.values()))


def view_named(name: str) -> View:
    """The kind of this name; raises UnknownNameError."""
    if name not in _VIEWS:
        there = ", ".join(view.name for view in views())
        if name not in _VIEWS:
            raise UnknownNameError(
                Words(f"没有“{name}”这种图；已有：{there}", f"there is no kind of figure '{name}'; known: {there}")
            )
    return _VIEWS[name]


def scales() -> dict[str, Mu]:
    """Every μ by its key, those of one direction and of the other."""
    return {mu.key: mu for view in views() for mu in (view.mu, view.across) if mu is not None}


def hues() -> tuple[Hue, ...]:
    """Every ink: those of no kind, the tones of vectors, then those of the kinds."""
    return tuple(dict.fromkeys((*PLAIN, *TONES, *(hue for view in views() for hue in (view.ink, view.tint)))))
