"""How large a load is: by a table over the drive or over a travel, by a motor's characteristic."""

from __future__ import annotations

from ...foundation.slotted import dataclass
from .windows import During, Window


@dataclass(frozen=True, slots=True, kw_only=True)
class Travel:
    """The way of a point along a direction (rad), from where its stroke begins."""

    link: str
    point: str
    direction: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Table:
    """Sizes (N, or N·m) at places in increasing order, straight lines between them.

    over: the travel (m) that the places are of; None: the drive's own coordinate (rad, or m). back: places and sizes
    on the return stroke, of a card that is a loop; empty where they are those of the way there. period: rad after which
    the table begins again, 0 where it does not. name: of its file.
    """

    places: tuple[float, ...]
    sizes: tuple[float, ...]
    back: tuple[tuple[float, ...], tuple[float, ...]] = ((), ())
    over: Travel | None = None
    period: float = 0.0
    name: str = ""

    @property
    def greatest(self) -> float:
        """The size that is greatest in magnitude, with its sign."""
        return max((*self.sizes, *self.back[1]), key=abs)


@dataclass(frozen=True, slots=True, kw_only=True)
class Motor:
    """The characteristic of a motor, M = M_0 - b ω (N·m, N·m·s): M_0 has the sense in which the motor turns."""

    stall: float
    slope: float


Size = Table | Motor


@dataclass(frozen=True, slots=True, kw_only=True)
class Law:
    """When a load acts, if not always, and how large it is, if its own size is not all."""

    windows: tuple[Window, ...] = ()
    size: Size | None = None

    @property
    def needs_motion(self) -> bool:
        """Whether it asks which way something moves, or how fast."""
        loop = isinstance(self.size, Table) and bool(self.size.back[0])
        return loop or isinstance(self.size, Motor) or any(not isinstance(one, During) for one in self.windows)
