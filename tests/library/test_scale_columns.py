"""What stands in the column of scales, times the length read, is the value in the same row."""

from __future__ import annotations

from math import degrees, isclose

from tests.drawn_library import IDS, drawn
from tests.each import each

IN_SI = {"mm": 1e3, "deg": degrees(1.0), "r/min": 1.0}


@each(IDS)
def test_length_times_scale_is_the_value_unless_a_factor_stands_before_the_scale(name: str) -> None:
    solution = drawn(name).solution
    scales = {figure.scale.right.symbol: figure.scale.right.value for figure in solution.construction.figures}
    scales |= {figure.scale.symbol: figure.scale.value for figure in solution.construction.figures}
    for answer in solution.answers.values():
        reading = answer.reading
        if reading.mm is None or reading.scale not in scales:
            continue
        size, in_si = reading.mm * scales[reading.scale], IN_SI.get(reading.unit, 1.0)
        same = any(isclose(one, abs(reading.scalar), rel_tol=2e-3, abs_tol=1e-9) for one in (size, size * in_si))
        assert same or reading.factor, f"{reading.key}: {reading.mm} mm × {reading.scale} is {size}"


def test_a_velocity_read_by_centres_has_the_angular_velocity_before_its_scale() -> None:
    reading = drawn("class-iii").solution.answers["v_L"].reading
    assert (reading.factor, reading.scale) == ("ω_4", "μ_l′")
