"""A problem as loaded: the mechanism and everything else a solution and its report want to know."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from ..figures import Mu
from ..foundation.frozen import FrozenMap
from ..foundation.slotted import dataclass, replace
from ..foundation.stock import ANY_A4, FormatName, Paper, paper_of
from ..mechanism.asked.curvature import Curvature
from ..mechanism.counterweights import Counterweights
from ..mechanism.loads import Loads
from ..mechanism.machine import Machine
from ..mechanism.model import Mechanism
from ..names import Key
from ..words import Words
from .asked.asks import Ask
from .asked.target import Target
from .gate import Gate
from .ranges import Range
from .subject import Subject
from .text.held import Held
from .values.current import current
from .values.given import Datum, Given, Shape, as_printed
from .values.written import Written

if TYPE_CHECKING:
    from ..designs.base import Design
    from ..devices.base import Device  # not at once: pydantic, which checks its data, is slow to load

__all__ = ["Datum", "Given", "Printed", "Problem", "Scales", "Shape", "as_printed"]


@dataclass(frozen=True, slots=True)
class Scales:
    """Given scales in SI per mm on paper, each under the key of its μ (``mu_v``); the rest are auto.

    chosen: those of them that are only kept as a drawing chose them: its sheet is laid out as it was.
    """

    given: Mapping[str, float] = field(default_factory=lambda: FrozenMap({}))
    chosen: frozenset[str] = frozenset()

    def __post_init__(self) -> None:
        object.__setattr__(self, "given", FrozenMap(self.given))

    def of(self, mu: Mu) -> float | None:
        """The value of this scale; None: auto."""
        return self.given.get(mu.key)

    def wished(self, mu: Mu) -> float | None:
        """The value that somebody gave it; None where a drawing chose, or is to choose, one for each of its figures."""
        return None if mu.key in self.chosen else self.of(mu)

    def changed(self, mu: Mu, value: float) -> Scales:
        """These scales with another value of one."""
        return Scales({**self.given, mu.key: value}, self.chosen)

    def kept(self, drawn: Mapping[str, float]) -> Scales:
        """The scales of a drawing to these, those that it chose itself among them."""
        return Scales(drawn, frozenset(drawn) - frozenset(self.given))


@dataclass(frozen=True, slots=True, kw_only=True)
class Printed:
    """One printed answer: value in SI (signed where the print has a sign), as written, and its remarks.

    `paper_mm` and `scale` (SI per mm) are set where the print gives a length on paper. `rel` is None for
    the length of a link (`l_BC`). figures: to so many the book reckoned on the way. lost: it belongs to data that are
    lost, in whose place are our own, and is held only against the rest of the print.
    """

    symbol: str
    rel: Key | None
    value: float
    text: str
    kind: Literal["calculated", "graphical"] = "calculated"
    paper_mm: float | None = None
    scale: float | None = None
    direction: float | None = None  # rad
    figures: int | None = None
    note: Words | None = None
    lost: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Problem:
    """One exercise: what it is about (a mechanism with its loads, a device ...), what is asked and was printed."""

    id: str
    title: Words
    subject: Mechanism | Subject
    asks: tuple[Ask, ...]
    source: Words | None = None
    statement: Words = field(default_factory=lambda: Words.same(""))
    explain: tuple[Words, ...] = ()  # what is answered in words
    loads: Loads | None = None
    machine: Machine | None = None  # what acts on it as a machine, where anything is asked of that
    counterweights: Counterweights | None = None  # the masses that balance its inertia forces
    by_centres: bool = False  # velocities by instant centres instead of polygons
    curvature: Curvature | None = None  # that curvatures of paths are asked, and by which construction
    scales: Scales = field(default_factory=Scales)
    printed: tuple[Printed, ...] = ()
    errata: tuple[Words, ...] = ()
    tables: tuple[Path | Held, ...] = ()  # printed tables over the cycle
    given: Given = field(default_factory=Given)
    paper: Paper = ANY_A4  # of its drawings and reports
    path: Path | None = None
    text: str = ""  # the file as written, and the files it extends
    read: tuple[Path, ...] = ()  # these files
    ranges: tuple[Range, ...] = ()  # what may differ from student to student
    target: Target | None = None  # a curve beside which the path of a point is drawn
    gate: Gate = field(default_factory=Gate)  # what the drawing of every variant must be like
    warnings: tuple[Words, ...] = ()  # what is accepted but hardly meant
    written: Written | None = field(default=None, repr=False, compare=False)  # the values it was built from

    @property
    def files(self) -> tuple[Path, ...]:
        """All files that the problem was read from, and its printed tables."""
        return (
            *((self.path,) if self.path else ()),
            *self.read,
            *(table for table in self.tables if isinstance(table, Path)),
        )

    def on(self, paper: FormatName) -> Problem:
        """The same problem, drawn and printed on paper of this format: "A4", or "letter"."""
        return replace(self, paper=paper_of(paper, self.paper.way))

    def __post_init__(self) -> None:
        if isinstance(self.subject, Mechanism):
            object.__setattr__(self, "given", current(self.given, self.subject, self.acting))

    @property
    def acting(self) -> Loads | None:
        """What acts, whether anything balances it or not."""
        if self.loads is not None:
            return self.loads
        if self.machine is not None:
            return self.machine.loads
        return None if self.counterweights is None else self.counterweights.loads

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism; a problem about a device has none."""
        assert isinstance(self.subject, Mechanism), f"problem {self.id} is about a device"
        return self.subject

    @property
    def device(self) -> Device:
        """The device; a problem about anything else has none."""
        from ..devices.base import Device  # late: its data are checked by pydantic, which is slow to load

        assert isinstance(self.subject, Device), f"problem {self.id} is about no device"
        return self.subject

    @property
    def design(self) -> Design:
        """What is asked of the mechanism that is to be found; a problem about anything else has none."""
        from ..designs.base import Design  # late, likewise

        assert isinstance(self.subject, Design), f"problem {self.id} is about no synthesis"
        return self.subject
