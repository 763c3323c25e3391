"""From the moments over a period to the flywheel: areas measured on paper, one above the other on the bar."""

from __future__ import annotations

from ....algebra.quantity import Quantity
from ....devices.dynamics.flywheel import Flywheel
from ....devices.dynamics.given import Torques
from ....words import Words
from ..bench import Bench
from ..registry import device_method
from .bar import energy_bar
from .inertia import mean_speed, moment_of_inertia
from .pieces import Pieces, given_areas
from .rim import rim_of
from .scales import flywheel_scales
from .torque import measured_areas


@device_method(
    Flywheel,
    title=Words("最大盈亏功与飞轮（面积法、能量指示图）", "Maximum surplus of work and flywheel, by areas"),
    source="机械原理, 机械的运转: areas between M_d and M_r, energy indicator bar, J_F = 900 ΔW / (π² n² δ)",
    example="7-5",
    scales=flywheel_scales,
)
def draw_flywheel(bench: Bench, wheel: Flywheel) -> None:
    """Diagram of moments and areas, or areas as given; the bar; the flywheel; its rim."""
    omega = mean_speed(bench, wheel)
    pieces = _pieces(bench, wheel, omega)
    swing = energy_bar(bench, pieces)
    inertia = moment_of_inertia(bench, wheel, swing, omega)
    if wheel.rim is not None and inertia is not None:
        rim_of(bench, wheel.rim, inertia, omega)


def _pieces(bench: Bench, wheel: Flywheel, omega: Quantity) -> Pieces:
    load = wheel.load
    return measured_areas(bench, wheel, load, omega) if isinstance(load, Torques) else given_areas(bench, load)
