"""Printed answers: a value with its unit, or a length on paper with its scale."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from ...errors import FaultError
from ...foundation.patterns import pattern
from ...names import At, Key, Kind, Named, Rel
from ...units.names import unit_of
from ...units.reading import Dim, pure, read
from ...words import Words
from ..links.bodies import Bodies
from ..problem import Printed
from ..schema.models import PrintedSpec
from .wanted import read_any

_PERCENT = pattern(r"\s*([-+−]?[\d.]+)\s*[%％]\s*")
_DIM = {Kind.P: Dim.LENGTH, Kind.V: Dim.SPEED, Kind.OMEGA: Dim.OMEGA, Kind.ALPHA: Dim.ALPHA}
_MU = {Kind.P: Dim.MU_L, Kind.V: Dim.MU_V, Kind.OMEGA: Dim.MU_V}


def _is_length(text: str) -> bool:
    words = text.split()
    return bool(words) and unit_of(words[-1])[1] == Dim.LENGTH.dimension


def read_printed(spec: PrintedSpec, bodies: Bodies, named: Iterable[At], forces: Mapping[str, Named]) -> Printed:
    """One entry of `printed`: a value with its unit, or a length on paper with its scale."""
    rel = None if spec.symbol.startswith("l_") else read_any(spec.symbol, bodies, named, forces)
    return as_given(spec, rel)


def as_given(spec: PrintedSpec, rel: Key | None) -> Printed:
    """The printed value of this quantity (None: of a length on the diagram)."""
    kind = rel.kind if isinstance(rel, Rel) else Kind.P
    direction = _direction(spec, rel)
    if spec.scale is None:
        value = (
            _named_value(spec.value, rel) if isinstance(rel, Named) else read(spec.value, _DIM.get(kind, Dim.ACCEL)).si
        )
        paper, scale = None, None
    else:
        if not _is_length(spec.value):
            raise FaultError(
                Words(
                    f"“{spec.value}”不是图上长度，而又给了比例尺；如写 41.1 mm",
                    f"'{spec.value}' is no length on paper, though a scale is given; write e.g. 41.1 mm",
                ),
                "value",
                code="spelling",
            )
        paper = read(spec.value, Dim.LENGTH).si * 1e3
        scale = read(spec.scale, Dim.MU_F if isinstance(rel, Named) else _MU.get(kind, Dim.MU_A)).si
        value = paper * scale
    return Printed(
        symbol=spec.symbol,
        rel=rel,
        value=value,
        text=spec.value,
        kind=spec.kind,
        paper_mm=paper,
        scale=scale,
        direction=direction,
        figures=spec.figures,
        note=spec.note,
        lost=spec.lost,
    )


def _direction(spec: PrintedSpec, rel: Key | None) -> float | None:
    """The printed direction (rad) of a vector; FaultError for that of anything else."""
    if spec.direction is None:
        return None
    if rel is None or not rel.is_vector:
        raise FaultError(
            Words(
                f"{spec.symbol} 不是矢量，没有方向；请删去 direction（转向写在数值之后，如 2 rad/s cw）",
                f"{spec.symbol} is no vector and has no direction; leave it out (a sense is "
                "written behind the value, 2 rad/s cw)",
            ),
            "direction",
        )
    return read(spec.direction, Dim.ANGLE).si


def _named_value(text: str, named: Named) -> float:
    """A printed force, moment, length, angle, power or pure number, in the unit in which the quantity is kept."""
    if not named.unit:
        m = _PERCENT.fullmatch(text)
        try:
            return pure(m[1], "85 %") / 100 if m else pure(text, "0.85 (85 %)")
        except FaultError as fault:
            raise fault.under("value") from None
    factor, dimension = unit_of(named.unit.replace("·", "*").replace("^", "**"))
    dim = next(dim for dim in Dim if dim.dimension == dimension)
    return read(text, dim).si / factor
