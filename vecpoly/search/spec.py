"""What a search file holds: what is sought, its data, how many candidates are tried."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, model_validator

from ..designs.base import Quick
from ..designs.place import Fixed
from ..devices.base import Angle, Length
from ..errors import FaultError
from ..problem.load import locate
from ..problem.schema.faults import Faults
from ..problem.schema.fields import Text, YesNo
from ..problem.schema.models import Spec
from ..problem.schema.validate import validate
from ..problem.text.source import read
from ..units.reading import Quantity
from ..words import Words
from .base import Search
from .dwell import DwellSearch
from .path import PathSearch
from .transmission import TransmissionSearch

_GAMMA = Quantity(0.5235987755982988, "30 deg")
_RIGHT = 1.5707963267948966
LONG = 10.0  # cranks: of the longest side of a link that is found where the file says none


class _Data(BaseModel):
    """Base: unknown keys are faults."""

    model_config = ConfigDict(extra="forbid", frozen=True, defer_build=True)

    def search(self) -> Search:
        """What these data ask for."""
        raise NotImplementedError


class PathData(_Data):
    """Points of the curve that E is to run along, closed or not."""

    points: Annotated[list[Fixed], Field(min_length=4)]
    closed: YesNo = True
    gamma_min: Angle = _GAMMA
    longest: Length | None = None

    @model_validator(mode="after")
    def _is_a_curve(self) -> PathData:
        if len({one.at for one in self.points}) < 4:
            raise FaultError(
                Words("points 至少要有四个不同的点", "points must hold four different places at least"), code="missing"
            )
        _acute("gamma_min", self.gamma_min)
        return self

    def search(self) -> Search:
        """A four-bar."""
        longest = {} if self.longest is None else {"longest": self.longest.si}
        points = tuple(one.at for one in self.points)
        return PathSearch(points=points, closed=self.closed, gamma=self.gamma_min.si, **longest)


class DwellData(_Data):
    """How long the output rests (angle of the crank), how far it swings at least, the crank.

    longest: LONG times the crank where nothing is said, for an arc of so large a radius that it is nearly straight is
    easily found and gives a rod that nobody makes.
    """

    dwell: Angle
    swing: Angle
    AB: Length
    gamma_min: Angle = _GAMMA
    longest: Length | None = None

    @model_validator(mode="after")
    def _possible(self) -> DwellData:
        for name, angle, most in (("dwell", self.dwell, 4.72), ("swing", self.swing, 2.62)):
            if not 0.08 <= angle.si <= most:
                raise FaultError(
                    Words(
                        f"{name} = {angle.text} 应在 5° 与 {57.3 * most:.0f}° 之间",
                        f"{name} = {angle.text} must lie between 5 and {57.3 * most:.0f} deg",
                    ),
                    code="out-of-range",
                )
        _acute("gamma_min", self.gamma_min)
        return self

    def search(self) -> Search:
        """A six-bar."""
        longest = LONG * self.AB.si if self.longest is None else self.longest.si
        return DwellSearch(
            dwell=self.dwell.si, swing=self.swing.si, crank=self.AB.si, gamma=self.gamma_min.si, longest=longest
        )


class TransmissionData(_Data):
    """K, the range of the rocker's swing, the rocker."""

    K: Quick
    swing: tuple[Angle, Angle]
    CD: Length

    @model_validator(mode="after")
    def _is_a_range(self) -> TransmissionData:
        low, high = self.swing
        if not 0.08 <= low.si < high.si <= 2.9:
            raise FaultError(
                Words(
                    f"swing 应由小到大，在 5° 与 165° 之间；这里是 {low.text} 至 {high.text}，如写 [30 deg, 60 deg]",
                    f"swing goes from less to more, between 5 and 165 deg; here from {low.text} to {high.text}: write "
                    "e.g. [30 deg, 60 deg]",
                ),
                code="out-of-range",
            )
        return self

    def search(self) -> Search:
        """A crank-rocker."""
        low, high = (one.si for one in self.swing)
        return TransmissionSearch(ratio=self.K.si, swing=(low, high), rocker=self.CD.si)


KINDS: Mapping[str, type[_Data]] = {"path": PathData, "dwell": DwellData, "transmission": TransmissionData}


class SearchSpec(Spec):
    """A search file."""

    title: Text
    search: Literal["path", "dwell", "transmission"]
    data: dict[str, object]
    candidates: Annotated[int, Field(ge=1000, le=100_000_000)] = 200_000


def load_search(where: str | Path) -> tuple[Search, SearchSpec, Path]:
    """The search in this file; raises ProblemFileError with what is wrong in it."""
    path = locate(where)
    tree = read(path)
    faults = Faults(tree.name, tree.places)
    spec = validate(SearchSpec, tree.data, faults)
    return validate(KINDS[spec.search], spec.data, faults, "data").search(), spec, path


def _acute(name: str, angle: Quantity) -> None:
    if not 0 < angle.si < _RIGHT:
        raise FaultError(
            Words(f"{name} = {angle.text} 应在 0 与 90° 之间", f"{name} = {angle.text} must lie between 0 and 90 deg"),
            code="out-of-range",
        )
