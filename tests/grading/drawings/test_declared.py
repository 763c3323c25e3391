"""A scale that stands on a drawing is read in whatever unit and signs it is told."""

from __future__ import annotations

import pytest

from vecpoly.grading.drawings.declared import stated
from vecpoly.grading.drawings.segment import Label


def said(text: str) -> dict[str, float]:
    return stated([Label(text=text, at=0j, height=4.0)])


@pytest.mark.parametrize(
    "text",
    [
        "μ_v = 0.004 (m/s)/mm",
        "μv＝0.004（m/s）／mm",
        "μ_{v} = 4 (mm/s)/mm",
        "μ_v = 0.004 m/s/mm",
        "μ_v = 4×10⁻³ m·s⁻¹/mm",
        "速度比例尺 μ_v=0.004 (m/s)/mm，加速度比例尺",
        "1 mm = 4 mm/s",
    ],
)
def test_a_scale_is_the_same_however_it_is_told(text: str) -> None:
    """Only (m/s)/mm was one: a drawing at a scale in mm/s was said not to be drawn at the scale that it states."""
    assert said(text)["mu_v"] == pytest.approx(0.004)


def test_several_scales_of_one_line_are_each_read() -> None:
    assert said("μ_l=1 mm/mm μ_v=0.004 (m/s)/mm; μ_a=0.1 (m/s²)/mm") == pytest.approx(
        {"mu_l": 0.001, "mu_v": 0.004, "mu_a": 0.1}
    )


@pytest.mark.parametrize(
    "text",
    ["μ_v = 0.004", "μ_v = 4 kg/mm", "μ_v = 0 (m/s)/mm", "μ_v = -1 (m/s)/mm", "μ_v = 0.004 (m/s)/mm²", "11 mm = 3 m/s"],
)
def test_what_is_no_scale_of_its_kind_states_none(text: str) -> None:
    assert not said(text)
