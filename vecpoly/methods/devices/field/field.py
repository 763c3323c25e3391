"""A rotor balanced in place by trial weights: with phases by one vector triangle, without by arcs."""

from __future__ import annotations

from collections.abc import Mapping

from ....board.construction import Scale, View
from ....devices.balancing.field import FieldBalancing
from ....problem.problem import Scales
from ....words import Words
from ..bench import Bench
from ..registry import device_method
from ..rotor.scales import END_VIEW, WIDE, fitting
from .coefficient import by_coefficient
from .four_runs import by_arcs
from .view import vibrations

RADIUS, TRIANGLE = 42.0, 72.0  # mm: of the circle of the first reading; the longest vector


def field_scales(device: FieldBalancing, given: Scales) -> Mapping[View, Scale]:
    """As given, or round ones that fit."""
    view = vibrations(device)
    readings = [device.initial.size, *(trial.reading.size for trial in device.trials)]
    wanted = max(readings) / TRIANGLE if device.phased else device.initial.size / RADIUS
    far = max(device.correct.r.si, *(trial.r.si for trial in device.trials))
    radii = given.of(END_VIEW.mu) or fitting(2 * far / WIDE)
    return {view: Scale.of(view, given.of(view.mu) or fitting(wanted)), END_VIEW: Scale.of(END_VIEW, radii)}


@device_method(
    FieldBalancing,
    title=Words("现场平衡（影响系数法、三圆法）", "Field balancing: influence coefficient, four runs"),
    source="机械振动, field balancing: influence coefficient; four-run method without phase",
    example="field-four-runs",
    scales=field_scales,
)
def draw_field(bench: Bench, device: FieldBalancing) -> None:
    """By the triangle of vectors where phases are known, else by arcs."""
    if device.phased:
        by_coefficient(bench, device)
    else:
        by_arcs(bench, device)
