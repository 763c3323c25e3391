"""The lecturer's rules and points, from a small YAML file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from ..batch.register import Register
from ..errors import VecpolyError
from ..grading.key import Points
from ..grading.rules import USUAL_RULES
from ..problem.text.source import read
from ..words import Words
from .work import Scheme

_SHARE = Field(default=None, ge=0.0, le=1.0)


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid")


class RulesSpec(_Strict):
    """What may be said of the rules; see `grading.rules.Rules`."""

    close: float | None = _SHARE
    own: float | None = _SHARE
    slip: float | None = _SHARE
    turned: float | None = _SHARE
    unit: float | None = Field(default=None, ge=0.0)
    printed: bool | None = None
    independent: tuple[str, ...] | None = None
    first: tuple[str, ...] | None = None
    reach: float | None = Field(default=None, gt=1.0)
    following: bool | None = None
    open: bool | None = None


class PointsSpec(_Strict):
    """Points of one quantity."""

    method: float = Field(default=0.0, ge=0.0)
    accuracy: float = Field(default=0.0, ge=0.0)
    sense: float = Field(default=0.0, ge=0.0)


class SchemeSpec(_Strict):
    """The file: rules; points by problem and quantity, which replace the usual ones; totals that must come out."""

    rules: RulesSpec = RulesSpec()
    points: dict[str, dict[str, PointsSpec]] = {}
    totals: dict[str, float] = {}


def read_scheme(path: Path | None, register: Register) -> Scheme:
    """The scheme of a file, or the usual one. Raises VecpolyError for what is not known, or other totals."""
    if path is None:
        return Scheme()
    try:
        spec = SchemeSpec.model_validate(read(path).data)
    except ValidationError as error:
        first = error.errors()[0]
        where = ".".join(map(str, first["loc"]))
        raise VecpolyError(
            Words(
                f"{path}：{where}：{first['msg']}；如写 points: {{3-9: {{v_E: {{method: 1, accuracy: 1}}}}}}",
                f"{path}: {where}: {first['msg']}; write e.g. points: {{3-9: {{v_E: {{method: 1, accuracy: 1}}}}}}",
            ),
            code="scheme",
        ) from None
    said = {name: value for name, value in spec.rules.model_dump().items() if value is not None}
    points = {
        problem: {key: Points(**one.model_dump()) for key, one in each.items()} for problem, each in spec.points.items()
    }
    scheme = Scheme(rules=replace(USUAL_RULES, **said), points=points)
    _checked(path, scheme, register, spec.totals)
    return scheme


def _checked(path: Path, scheme: Scheme, register: Register, totals: Mapping[str, float]) -> None:
    """Points stand for quantities that there are, and come to what is printed."""
    parts = {part.problem: part for part in register.sheets[0].parts} if register.sheets else {}
    for problem in (*scheme.points, *totals):
        register.exercise(problem)
        key = scheme.key(parts[problem])
        for name in scheme.points.get(problem, {}):
            _ = key[name]
        if problem in totals and abs(key.worth - totals[problem]) > 1e-6:
            raise VecpolyError(
                Words(
                    f"{path}：题 {problem} 各项分值之和为 {key.worth:g}，而 totals 写的是 "
                    f"{totals[problem]:g}；请改正其一",
                    f"{path}: the points of {problem} come to {key.worth:g}, totals says {totals[problem]:g}; mend one",
                ),
                code="totals",
                numbers={"points": key.worth, "total": totals[problem]},
            )
