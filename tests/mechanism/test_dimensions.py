"""A dimension varied in the mechanism is one varied in the problem; what is printed as given is what it has."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from math import isclose, isnan

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.laws import often
from vecpoly import Problem, load
from vecpoly.errors import VecpolyError
from vecpoly.findings.given_lengths import given_dimensions
from vecpoly.mechanism.dimensions.set_out import stretched
from vecpoly.mechanism.dimensions.values import Bar, Coordinate, Dimension, Driven, Led, Part, Placed, Profile
from vecpoly.mechanism.dimensions.vary import dimensions, upright, value, varied
from vecpoly.mechanism.model import Circle, Mechanism, Prismatic, Rolling
from vecpoly.problem.library import library

FACTORS = st.floats(0.97, 1.03)
_OF_PLACED = {Part.ALONG: "at", Part.LEFT: "left", Part.ANGLE: "angle"}


@cache
def moving() -> tuple[Problem, ...]:
    """Problems in which only points and guides hang on a dimension: no rod's mass, no gears, no angle from a line."""
    found = (load(entry.path) for entry in library())
    return tuple(
        p
        for p in found
        if isinstance(p.subject, Mechanism) and " from " not in p.parameters.get("phi", "") and not _more(p)
    )


def _more(problem: Problem) -> bool:
    mech, text = problem.mechanism, str(problem.data["input"])
    return (
        " from " in text
        or any(isinstance(joint, Rolling) for joint in mech.joints)
        or bool(problem.loads and any(mass.rod for mass in problem.loads.masses))
    )


def name(mech: Mechanism, one: Dimension) -> str:
    """The name by which the problem knows it; empty where it has none."""
    match one:
        case Bar(link=link):
            return "".join(list(mech.link(link).points)[:2])
        case Coordinate(letter=letter, axis=axis):
            return f"{axis}_{letter}"
        case Driven(part=part):
            words = ("v", "a") if mech.drive.slide else ("omega", "alpha")
            return dict(zip((Part.RATE, Part.ACCEL), words, strict=True)).get(part, "")
        case Placed(link=link, places=(i,), part=part):
            placement = mech.link(link).placements[i]
            if part in _OF_PLACED:
                return f"{_OF_PLACED[part]}_{placement.point}"
            return f"{placement.base[part is Part.SECOND]}{placement.point}"
        case Led(joint=i, part=part):
            guide = mech.joints[i]
            assert isinstance(guide, Prismatic)
            stem = {Part.PLACE: "x" if upright(guide) else "y", Part.OFFSET: "e", Part.TURN: "turn"}.get(
                part, "direction"
            )
            return f"{stem}_{guide.block}"
        case Profile(link=link):
            return f"r_{link}"
    return ""


def known(problem: Problem) -> Iterator[tuple[Dimension, str]]:
    """The dimensions that the problem can vary too;
    not those of which two have one name, as at_E of a point of two links."""
    named = [(one, name(problem.mechanism, one)) for one in dimensions(problem.mechanism)]
    for one, called in named:
        alone = sum(called == other for _, other in named) == 1
        if alone and called in problem.parameters and value(problem.mechanism, one):
            yield one, called


@st.composite
def changes(draw: st.DrawFn) -> tuple[Problem, Dimension, str, float]:
    problem = draw(st.sampled_from(moving()))
    one, called = draw(st.sampled_from(list(known(problem))))
    return problem, one, called, value(problem.mechanism, one) * draw(FACTORS)


def other(problem: Problem, called: str, to: float) -> Problem:
    """The problem varied by the name; what no problem file may hold is left."""
    sign = -1 if called.startswith(("left", "e_")) and to < 0 else 1  # to the right it is told as a positive number
    try:
        return problem.vary(**{called: sign * to})
    except VecpolyError:
        assume(False)
        raise


@settings(max_examples=often(3, 240))
@given(changes())
def test_the_mechanism_and_the_file_vary_alike(change: tuple[Problem, Dimension, str, float]) -> None:
    problem, one, called, to = change
    filed = other(problem, called, to).mechanism
    assume(value(filed, one) * to > 0)
    direct = varied(problem.mechanism, one, to)
    for link in filed.links:
        assert all(abs(direct.link(link.name).points[letter] - at) < 1e-12 for letter, at in link.points.items())
    assert all(abs(direct.frame[letter] - at) < 1e-15 for letter, at in filed.frame.items())
    assert all(
        isclose(a.rate, b.rate) and isclose(a.accel, b.accel) and isclose(a.position, b.position)
        for a, b in zip(filed.drives, direct.drives, strict=True)
    )
    for a, b in zip(filed.joints, direct.joints, strict=True):
        if isinstance(a, Prismatic) and isinstance(b, Prismatic):
            assert (
                abs(a.origin - b.origin) < 1e-12
                and abs(a.offset - b.offset) < 1e-15
                and isclose(a.direction, b.direction, abs_tol=1e-12)
            )


@given(changes())
def test_what_is_given_is_what_the_mechanism_has(change: tuple[Problem, Dimension, str, float]) -> None:
    problem, one, called, to = change
    filed = other(problem, called, to)
    replaced = replace(problem, subject=varied(problem.mechanism, one, to))
    filed_data, own_data = (
        {d.symbol: d.si for d in (*p.given.lengths, *p.given.motion, *p.given.loads) if d.symbol}
        for p in (filed, replaced)
    )
    assert len(own_data) == len(
        [d for d in (*problem.given.lengths, *problem.given.motion, *problem.given.loads) if d.symbol]
    )
    assert all(
        isclose(own_data[symbol], si, rel_tol=1e-9, abs_tol=1e-12)
        for symbol, si in filed_data.items()
        if symbol in own_data
    )


def test_a_load_that_is_replaced_is_printed_as_it_is() -> None:
    problem = load("4-3a")
    assert problem.loads is not None
    loads = replace(problem.loads, forces=tuple(replace(force, size=1200.0) for force in problem.loads.forces))
    told = [datum.of("en") for datum in replace(problem, loads=loads).given.loads]
    assert any("1200 N" in text for text in told) and not any("1000 N" in text for text in told)


@given(changes())
def test_a_dimension_has_the_value_that_it_was_given(change: tuple[Problem, Dimension, str, float]) -> None:
    problem, one, _, to = change
    mech = varied(problem.mechanism, one, to)
    assert isclose(value(mech, one), to, rel_tol=1e-12)
    back = varied(mech, one, value(problem.mechanism, one))
    assert all(
        abs(back.link(link.name).points[letter] - at) < 1e-12
        for link in problem.mechanism.links
        for letter, at in link.points.items()
    )


def test_a_triangle_that_does_not_close_lies_nowhere() -> None:
    mech = load("jansen-leg").mechanism
    one = next(one for one in dimensions(mech) if isinstance(one, Placed) and one.part is Part.FIRST)
    link = varied(mech, one, 99.0).link(one.link)
    assert isnan(link.points[link.placements[one.places[0]].point].real)


@pytest.mark.parametrize("times", [0.5, 1.0, 2.0])
def test_a_stretched_side_is_so_long_and_the_other_letters_stay(times: float) -> None:
    link = next(link for link in load("B-24").mechanism.links if len(link.points) > 2)
    first, second, third = list(link.points)[:3]
    length = times * abs(link.points[second] - link.points[first])
    anew = stretched(link, first, second, length).points
    assert isclose(abs(anew[second] - anew[first]), length) and anew[first] == 0
    assert isclose(abs(anew[third] - anew[first]), abs(link.points[third] - link.points[first]))


@pytest.mark.parametrize("name", ["3-1c", "cam-roller", "4-4"])
def test_the_radius_of_every_disc_of_a_cam_is_among_the_given_lengths(name: str) -> None:
    mech = load(name).mechanism
    discs = {end for contact in mech.contacts for end in (contact.disc, contact.on) if isinstance(end, Circle)}
    found = {one.name.en: one for one in given_dimensions(mech)}
    for disc in discs:
        one = found[f"$r_{{{mech.disc_number(disc.link)}}}$"]
        assert one.size == disc.radius
        assert replace(disc, radius=disc.radius + 1e-3) in {
            end for contact in one.enlarged(1e-3).contacts for end in (contact.disc, contact.on)
        }
