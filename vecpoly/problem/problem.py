"""A problem as loaded: the mechanism and everything else a solution and its report want to know."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from ..mechanism.loads import Loads
from ..mechanism.model import Mechanism
from ..names import Key
from ..words import Words
from .asks import Ask
from .current import current
from .given import Datum, Given, Shape, as_printed

if TYPE_CHECKING:
    from ..devices.base import Device  # not at once: pydantic, which checks its data, is slow to load

__all__ = ["Datum", "Given", "Printed", "Problem", "Scales", "Shape", "as_printed"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Scales:
    """Given scales in SI per mm on paper; None is auto."""

    mu_l: float | None = None  # m/mm
    mu_v: float | None = None  # (m/s)/mm
    mu_a: float | None = None  # (m/s²)/mm
    mu_f: float | None = None  # N/mm


@dataclass(frozen=True, slots=True, kw_only=True)
class Printed:
    """One printed answer: value in SI (signed where the print has a sign), as written, and its remarks.

    `paper_mm` and `scale` (SI per mm) are set where the print gives a length on paper. `rel` is None for
    the length of a link (`l_BC`).
    """

    symbol: str
    rel: Key | None
    value: float
    text: str
    kind: Literal["calculated", "graphical"] = "calculated"
    paper_mm: float | None = None
    scale: float | None = None
    direction: float | None = None  # rad
    note: Words | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Problem:
    """One exercise: the mechanism (with its loads) or the device it is about, what is asked, how it was answered in print."""

    id: str
    title: Words
    subject: Mechanism | Device
    asks: tuple[Ask, ...]
    source: Words | None = None
    statement: Words = field(default_factory=lambda: Words.same(""))
    loads: Loads | None = None
    by_centres: bool = False  # velocities by instant centres instead of polygons
    scales: Scales = field(default_factory=Scales)
    printed: tuple[Printed, ...] = ()
    errata: tuple[Words, ...] = ()
    tables: tuple[Path, ...] = ()  # printed tables over the cycle
    given: Given = field(default_factory=Given)
    orientation: Literal["portrait", "landscape"] | None = None
    path: Path | None = None
    text: str = ""  # the file as written, and the files it extends
    read: tuple[Path, ...] = ()  # these files
    warnings: tuple[Words, ...] = ()  # what is accepted but hardly meant

    @property
    def files(self) -> tuple[Path, ...]:
        """All files that the problem was read from, and its printed tables."""
        return (*((self.path,) if self.path else ()), *self.read, *self.tables)

    def __post_init__(self) -> None:
        if isinstance(self.subject, Mechanism):
            object.__setattr__(self, "given", current(self.given, self.subject))

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism; a problem about a device has none."""
        assert isinstance(self.subject, Mechanism), f"problem {self.id} is about a device"
        return self.subject

    @property
    def device(self) -> Device:
        """The device; a problem about a mechanism has none."""
        assert not isinstance(self.subject, Mechanism), f"problem {self.id} is about a mechanism"
        return self.subject
