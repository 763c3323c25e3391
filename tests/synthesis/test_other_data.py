"""A number among the data of a synthesis with another in its place: that number is the other, and no other is."""

from __future__ import annotations

import pytest

from vecpoly.designs.base import Design
from vecpoly.problem.library import library
from vecpoly.problem.load import load

DESIGNS = {one.id: subject for one in library() if isinstance(subject := load(one.id).subject, Design)}


@pytest.mark.parametrize("name", [name for name, design in DESIGNS.items() if any(design.varied())])
def test_each_datum_is_put_in_its_own_place(name: str) -> None:
    data = list(DESIGNS[name].varied())
    for n, datum in enumerate(data):
        value = datum.value * 1.01 + 1e-3
        again = list(datum.put(value).varied())
        assert [one.name for one in again] == [one.name for one in data]
        assert again[n].value == pytest.approx(value, rel=1e-9), datum.name
        rest = [(one.value, other.value) for i, (one, other) in enumerate(zip(data, again, strict=True)) if i != n]
        assert all(one == pytest.approx(other, rel=1e-9, abs=1e-12) for one, other in rest), datum.name


def test_of_the_library_more_than_ten_tasks_of_synthesis_have_data_that_vary() -> None:
    assert sum(any(design.varied()) for design in DESIGNS.values()) > 10
