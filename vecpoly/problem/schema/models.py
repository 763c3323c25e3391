"""What a problem file may hold: the pydantic models behind the checks and behind the JSON Schema for editors.

All scalars arrive as text; quantities are read later, by `units`, at their own place.
"""

from __future__ import annotations

from typing import Any, Literal

from pydantic import BaseModel, ConfigDict, Field, create_model

from ...figures import scales
from ...words import Words
from .fields import ID, Centre, Link, Name, Number, Pair, Text, YesNo
from .running import CounterweightSpec, MachineSpec


class Spec(BaseModel):
    """Base: unknown keys are faults."""

    model_config = ConfigDict(extra="forbid", frozen=True, defer_build=True)  # only what a file needs is built


class InputSpec(Spec):
    """The input: turning (phi, omega, alpha) or sliding (s, v, a), on the frame or a moving link; or a cylinder."""

    link: Name | None = None
    on: Name | None = Field(
        None, description="the moving link on which the link moves; the frame where nothing is said"
    )
    cylinder: Name | None = Field(
        None, description="2-3: the two links of a driven sliding pair; with length (or s), v, a"
    )
    length: Number | None = Field(None, description="of a cylinder: between its two pins")
    phi: Number | None = Field(None, description="60 deg, or 60 deg from AD")
    omega: Number | None = Field(None, description="10 rad/s ccw, 40 r/min 顺时针")
    alpha: Number | None = None
    s: Number | None = Field(None, description="travel along the guide from its origin")
    v: Number | None = None
    a: Number | None = None


class TableSpec(Spec):
    """A size by a table: its file beside this one, or columns and rows; a pressure with the area on which it acts."""

    table: str | None = Field(None, description="a CSV file beside this file: first column phi or s, then F, M or p")
    columns: Pair | None = Field(None, description="in the place of a file: [phi (deg), F (N)]")
    rows: list[Pair] | None = Field(None, description="in the place of a file: [[0, 100], [90, 250]]")
    area: Number | None = Field(None, description="of the piston on which a pressure acts: 5000 mm^2")
    bore: Number | None = Field(None, description="its diameter, in the place of the area: 80 mm")


_SENSE: dict[str, Any] = {
    "while": (str | None, Field(None, description="E moves left; E moves along 30 deg; 3 turns ccw"))
}
_While: Any = create_model("_While", __base__=Spec, **_SENSE)  # a keyword of Python is no name of a field


class LoadSpec(_While):  # type: ignore[misc]
    """A force (with point and direction) or a moment on a link, the thrust of a cylinder, a motor, a spring, a damper;
    the size of one load is '?'."""

    on: Name | None = None
    cylinder: Name | None = Field(
        None, description="2-3: the thrust of the cylinder between these links, positive where it lengthens it"
    )
    at: str | None = Field(None, description="the lettered point of the link at which a force acts")
    size: TableSpec | Number | None = Field(
        None,
        description="1000 N, 20 N*m ccw, ? for the load that balances, constant for the moment that is the same over "
        "the period, or {table: card.csv}",
    )
    direction: Number | None = Field(
        None, description="of a force, from the x axis: 180 deg; on the driving link also along AB"
    )
    role: Literal["driving", "resisting"] | None = None
    between: Pair | None = Field(None, description="with while: part of the stroke, [5 %, 95 %]")
    during: Pair | None = Field(None, description="part of the drive's turn, [60 deg, 150 deg]")
    motor: Pair | None = Field(None, description="of the driving link, M = a - b omega: [2400 N*m, 330 N*m*s]")
    spring: Name | None = Field(None, description="between two points, B-D, or two links, 1-4")
    damper: Name | None = Field(None, description="between two points, B-D, or two links, 1-4")
    k: Number | None = Field(None, description="stiffness of a spring: 5 N/mm, 2 N*m/rad")
    l_0: Number | None = Field(
        None, description="of a spring between two points, its length at which only preload acts"
    )
    phi_0: Number | None = Field(None, description="of a torsion spring, its angle at which only preload acts")
    preload: Number | None = Field(None, description="of a spring: 20 N (negative: compressed), 1 N*m")
    c: Number | None = Field(None, description="coefficient of damping: 50 N*s/m, 0.1 N*m*s")


class FrictionSpec(Spec):
    """Friction of a pin (rho, or f and r), of a slide (phi, or f, or f and V) or of a contact (phi or f)."""

    rho: Number | None = Field(None, description="radius of a pin's friction circle, 6 mm")
    f: Number | None = Field(None, description="coefficient of friction, 0.1")
    f_v: Number | None = Field(None, description="equivalent coefficient, in the place of f")
    r: Number | None = Field(None, description="radius of the pin, 20 mm; rho = f r")
    phi: Number | None = Field(None, description="friction angle, 8 deg")
    V: Number | None = Field(None, description="half the angle of a V-groove: f_v = f / sin V")


class RodSpec(Spec):
    """A round bar: mass and inertia follow from its section."""

    diameter: Number
    density: Number
    along: str | None = Field(None, description="two points of the link, its first two where nothing is said")


class MassSpec(Spec):
    """Mass, moment of inertia about the centre of mass, and that centre; or a round bar."""

    mass: Number | None = None
    inertia: Number | None = None
    centre: Centre = None
    rod: RodSpec | None = None


_FIELDS: dict[str, Any] = dict.fromkeys(scales(), (Number, "auto"))
_GivenScales: Any = create_model("_GivenScales", __base__=Spec, **_FIELDS)


class ScalesSpec(_GivenScales):  # type: ignore[misc]
    """Scales of the drawings: given, or auto; one for every μ of a kind of figure."""


class FindSpec(Spec):
    """A point with a given velocity or acceleration, the slowest point of a line,
    or the question for a Coriolis term."""

    point: str | None = None
    on: Name | None = None
    velocity: Pair | Number | None = None
    acceleration: Pair | Number | None = None
    coriolis: str | None = None
    slowest: str | None = Field(None, description="of a point: the slowest of the link on this line, BC")
    centrodes: Name | None = Field(None, description="the link whose two centrodes are drawn, with method: curvature")
    positions: Number | None = Field(None, description="of centrodes: through how many positions, 8 to 12")
    over: Pair | None = Field(None, description="of centrodes: first and last position of the input: [20 deg, 110 deg]")


class PrintedSpec(Spec):
    """A printed answer."""

    symbol: str
    value: Number
    scale: Number | None = Field(None, description="where value is a length on paper: its scale, 0.006 (m/s)/mm")
    direction: Number | None = None
    kind: Literal["calculated", "graphical"] = "calculated"
    figures: int | None = Field(
        None, ge=2, le=9, description="to how many figures the book reckoned on the way; it is held to no more"
    )
    note: Text | None = None
    lost: YesNo = False  # to data that are lost, in whose place ours stand: held only against the other answers


class SheetSpec(Spec):
    """The drawing sheet."""

    orientation: Literal["portrait", "landscape"] | None = None
    format: Literal["A4", "letter"] | None = None


class TargetSpec(Spec):
    """A curve beside which the path of a point is drawn."""

    point: str
    through: list[Pair] = Field(min_length=3)
    closed: YesNo = False


class GateSpec(Spec):
    """What the drawing of every variant must be like."""

    vectors: Number | None = None
    meetings: Number | None = None
    dead_point: Number | None = None
    deviation: Number | None = None
    slips: Number | None = None
    apart: Number | None = None
    alike: YesNo = True


class ProblemSpec(Spec):
    """A problem file."""

    id: str = Field(pattern=ID)
    title: Text
    extends: str | None = Field(None, description="id or path of a problem whose data are taken over")
    source: Text | None = None
    statement: Text = Words.same("")
    explain: list[Text] = []
    frame: dict[str, Pair]
    links: dict[str, Link] = Field(min_length=1)
    joints: list[str] = []
    input: InputSpec | list[InputSpec]
    branch: list[str] = []
    scales: ScalesSpec = ScalesSpec()
    find: list[str | FindSpec] = Field([], min_length=1)
    method: Literal["polygons", "centres", "curvature"] = Field(
        "polygons", description="velocities by vector polygons, or by instant centres; curvatures of paths"
    )
    construction: Literal["bobillier", "euler-savary", "hartmann", "aronhold"] | None = None
    printed: list[PrintedSpec] = []
    errata: list[Text] = []
    tables: list[str] = Field([], description="printed tables (CSV or XLSX) to be checked, as paths beside this file")
    sheet: SheetSpec | None = None
    guesses: dict[str, Pair] = {}
    pins: dict[str, str] = Field({}, description="which link carries the pin of a multiple joint: {C: 3}")
    loads: dict[str, LoadSpec] = {}
    friction: dict[str, FrictionSpec] = {}
    masses: dict[str, MassSpec] = {}
    weight: YesNo = False
    inertia: YesNo = True
    machine: MachineSpec | None = None
    counterweights: dict[str, CounterweightSpec] = {}
    target: TargetSpec | None = None
    vary: dict[str, Number] = {}
    gate: GateSpec = GateSpec()


class DataSpec(Spec):
    """A problem file whose givens all stand in `data`."""

    id: str = Field(pattern=ID)
    title: Text
    extends: str | None = None
    source: Text | None = None
    statement: Text = Words.same("")
    explain: list[Text] = []
    data: dict[str, Any] = {}
    scales: ScalesSpec = ScalesSpec()
    find: list[str] = Field([], min_length=1)
    printed: list[PrintedSpec] = []
    errata: list[Text] = []
    sheet: SheetSpec | None = None
    vary: dict[str, Number] = {}
    gate: GateSpec = GateSpec()


class DeviceSpec(DataSpec):
    """A problem file about a device: wedge, screw, clamp, train of machines."""

    device: str


class DesignSpec(DataSpec):
    """A problem file about a mechanism that is to be found."""

    synthesis: str
