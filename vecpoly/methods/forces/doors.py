"""The doors of the methods of forces."""

from __future__ import annotations

from ...mechanism.groups.assur import Dyad, Group
from ...mechanism.loads import Load
from ...plane import Line
from ..registry import Door
from .lines.links_of_group import Held, TwoForce
from .state import Statics


def _moments(st: Statics, dyad: Dyad) -> None: ...


def _whole(st: Statics, group: Group) -> None: ...


def _line(st: Statics, two: TwoForce) -> Line:
    raise NotImplementedError


def _couple(st: Statics, about: tuple[Held, Line, str]) -> None: ...


def _driver(st: Statics, held: Held) -> None: ...


def _balancing(st: Statics, load: Load | None) -> None: ...


MOMENTS, WHOLE, LINES, COUPLES, DRIVERS, BALANCING = (
    Door(_moments),
    Door(_whole),
    Door(_line),
    Door(_couple),
    Door(_driver),
    Door(_balancing),
)
