"""Claims about where the arrow of a force stands at its point: one that pulls begins there, one that presses ends a
little before it, so that its head is seen beside the pin."""

from __future__ import annotations

import cmath

import pytest

from vecpoly.methods.forces.acting import Acting
from vecpoly.methods.forces.bodies.arrows import GAP, LENGTH, place_arrows
from vecpoly.names import Named

AT = 7 - 4j


def pulled(size: float, way: float) -> Acting:
    """A force at the one point of its body."""
    return Acting(named=Named(f"R_{size:g}", f"R_{size:g}", "N"), vector=cmath.rect(size, way), at=AT)


@pytest.mark.parametrize("way", [0.0, 1.1, 2.5, -0.7, -2.9])
@pytest.mark.parametrize("size", [5.0, 40.0])
def test_an_arrow_at_its_point_begins_there_or_ends_a_gap_before_it_and_points_along_the_force(
    way: float, size: float
) -> None:
    force, unit = pulled(size, way), cmath.rect(1.0, way)
    [pulls] = place_arrows([force], [AT], pulling={force.named.symbol})
    [presses] = place_arrows([force], [AT], pressing={force.named.symbol})
    assert (pulls.presses, pulls.far, presses.presses, presses.far) == (False, False, True, False)
    assert [(z - AT) / unit for z in (pulls.start, pulls.end)] == pytest.approx([0.0, LENGTH])
    assert [(z - AT) / unit for z in (presses.start, presses.end)] == pytest.approx([-LENGTH - GAP, -GAP])


@pytest.mark.parametrize("share", [0.05, 0.5, 0.8, 1.0])
def test_a_smaller_force_has_a_shorter_arrow_but_none_of_less_than_half_the_length(share: float) -> None:
    small, large = pulled(30.0 * share, 2.0), pulled(31.0, -1.0)
    arrows = {one.symbol: one for one in place_arrows([small, large], [AT])}
    one = arrows[small.named.symbol]
    assert abs(one.end - one.start) == pytest.approx(LENGTH * max(0.5, 30.0 * share / 31.0))
