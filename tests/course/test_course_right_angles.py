"""How often a transmission angle is 90° in a turn, and which dimensions change a quantity not at all."""

from __future__ import annotations

import re

import pytest

from tests.studies import course_words, studied
from vecpoly.findings.transmission import transmission


@pytest.mark.parametrize(("name", "often"), [("pinion-drives-rack", "once a"), ("A-26", "twice a")])
def test_a_curve_that_does_not_close_after_a_turn_is_not_carried_on_from_its_end_to_its_start(
    name: str, often: str
) -> None:
    study = studied(name)
    assert often in transmission(study, study.facts.transmissions).en


def test_what_does_not_change_the_acceleration_is_not_passed_over_where_the_least_effect_is_told() -> None:
    """x_D moves the output, and changes its acceleration by nothing."""
    text, _ = course_words("guided-couple", "en")
    (said,) = re.findall(r"\$x_\{D\}\$ does not change[^<]*", text)
    assert "the others are compared" in said and "the least that" in text.partition(said)[2]
