"""Design projects: what later parts take from earlier ones, loads of one stroke, the flywheel, the demands."""

from __future__ import annotations

import numpy as np
import pytest

from tests.laws import few
from tests.projects import NAMES, project
from vecpoly.project.flywheel import Balance
from vecpoly.project.part import Part
from vecpoly.project.positions import Position


def moving(name: str) -> Part:
    return next(part for part in project(name).parts if part.moves)


def even(part: Part) -> Balance:
    assert part.balance is not None
    return part.balance


@pytest.mark.parametrize("name", few(NAMES, 2))
def test_every_demand_of_the_library_is_met_and_nothing_is_suspect(name: str) -> None:
    assert len(project(name).demands) == 7
    assert all(one.holds for one in project(name).demands)
    assert project(name).warnings == ()
    assert all(part.solution.warnings == () for part in project(name).parts)


@pytest.mark.parametrize("name", few(NAMES, 2))
def test_the_mechanism_has_the_lengths_found_rounded(name: str) -> None:
    part = moving(name)
    assert part.base is not None
    found = part.base.solution.answers
    step = {"design-feeder": 0.5}.get(name, 1.0)
    crank = part.problem.mechanism.link("1").points
    assert 1e3 * abs(crank["B"] - crank["A"]) == pytest.approx(step * round(found["AB"].drawn / step), abs=1e-9)


@pytest.mark.parametrize("name", NAMES)
def test_the_load_of_one_stroke_takes_power_wherever_it_acts_and_nowhere_else(name: str) -> None:
    part = moving(name)
    force, acts = part.working.force, part.working.acts
    assert force is not None and force.size is not None
    speed = np.asarray(part.turn.column(f"v_{force.point}"), np.complex128)
    power = force.size * (speed * np.exp(-1j * force.direction)).real
    assert (power[acts] < 0).all()
    assert acts.any() and not acts.all()


@pytest.mark.parametrize("name", NAMES)
def test_on_the_idle_stroke_all_loads_act_but_the_one_that_works(name: str) -> None:
    working = moving(name).working
    loads, idle = working.loaded.loads, working.idle.loads
    assert working.force is not None and loads is not None and idle is not None
    there, left = ({one.name for one in some.forces if one.size is not None} for some in (loads, idle))
    assert there - left == {working.force.name} and left < there


@pytest.mark.parametrize("name", NAMES)
def test_the_mean_moment_does_the_work_of_the_load_over_a_cycle(name: str) -> None:
    """Weights and inertia forces do no work in a whole turn: 2π M_m is what the load takes, ∫ F ds."""
    part, force = moving(name), moving(name).working.force
    assert force is not None and force.size is not None
    place = np.asarray(part.turn.column(f"p_{force.point}"), np.complex128) * np.exp(-1j * force.direction)
    both = part.working.acts[1:] & part.working.acts[:-1]
    taken = -force.size * float(np.sum(np.diff(place.real)[both]))
    assert 2 * np.pi * even(part).mean == pytest.approx(taken, rel=0.01)


@pytest.mark.parametrize("name", NAMES)
def test_the_flywheel_keeps_the_speed_within_the_unevenness(name: str) -> None:
    """½ J (ω² of the fastest − ω² of the slowest) is the surplus; with ω ± δω/2 that is J ω² δ."""
    part, one = moving(name), even(moving(name))
    assert one.inertia is not None and part.unevenness is not None
    rate = abs(part.problem.mechanism.drive.rate)
    squared = rate**2 + 2 * (one.surplus - (one.surplus.max() + one.surplus.min()) / 2) / one.inertia
    fast, slow = np.sqrt(squared.max()), np.sqrt(squared.min())
    assert (fast - slow) / ((fast + slow) / 2) == pytest.approx(part.unevenness, rel=1e-3)
    assert one.surplus[-1] == pytest.approx(0.0, abs=1e-6 * one.stored)


@pytest.mark.parametrize("name", NAMES)
def test_without_the_load_the_moment_only_changes_the_energy(name: str) -> None:
    """M_d dφ = d(Σ ½ m v² + ½ J ω² + m g y), by differences of the columns of motion, where the load does not act."""
    part = moving(name)
    loads, turn = part.problem.loads, part.turn
    assert loads is not None
    energy = np.zeros(len(turn.phi))
    for mass in loads.masses:
        place, speed = (np.asarray(turn.column(f"{stem}_{mass.centre}"), np.complex128) for stem in "pv")
        energy += mass.mass * (np.abs(speed) ** 2 / 2 + 9.81 * place.imag)
        energy += mass.inertia * turn.real(f"omega_{mass.link}") ** 2 / 2
    slope = np.gradient(energy, turn.phi)
    idle = ~part.working.acts
    idle[[0, -1]] = False
    assert even(part).moment[idle] == pytest.approx(slope[idle], abs=2e-3 * float(np.abs(slope).max()))


@pytest.mark.parametrize("name", NAMES)
def test_every_position_is_drawn_as_the_oracle_has_it(name: str) -> None:
    for one in moving(name).positions:
        for answer in one.solution.answers.values():
            assert not answer.suspect, (one.phi, answer.key)


def test_a_position_beyond_the_working_stroke_is_drawn_without_the_load() -> None:
    given, other = moving("design-shaper").positions
    assert isinstance(other, Position) and given.acts and not other.acts
    loads = other.solution.problem.loads
    assert loads is not None and loads.forces == ()


def test_the_cam_of_the_feeder_takes_its_angles_from_the_linkage() -> None:
    by_name = {part.name: part for part in project("design-feeder").parts}
    theta = by_name["linkage"].solution.answers["theta"].drawn
    pieces = by_name["clamp"].problem.device.pieces  # type: ignore[attr-defined]
    assert [np.degrees(piece.angle) for piece in pieces] == pytest.approx([90 - theta / 2, 90 - theta / 2, 180 + theta])


def test_the_crank_of_the_shaper_turns_as_the_reducer_says() -> None:
    demand = project("design-shaper").demands[-1]
    rate = moving("design-shaper").problem.mechanism.drive.rate
    assert demand.asked.si == pytest.approx(rate) and demand.exact.si == pytest.approx(rate)


@pytest.mark.parametrize("name", few(NAMES, 2))
def test_the_extremes_of_the_driving_moment_are_no_points_of_a_grid(name: str) -> None:
    """They stand beside the greatest of the positions, and between two of these unless a load comes or goes there."""
    part = moving(name)
    found, acts = even(part), part.working.acts
    step = float(np.diff(found.phi)[0])
    for spot, way in ((found.highest, 1), (found.lowest, -1)):
        at = int(np.argmax(way * found.moment))
        rise = way * (spot.value - float(found.moment[at]))
        assert 0 <= rise < 1e-3 * np.ptp(found.moment)
        off = abs(np.exp(1j * spot.phi) - np.exp(1j * found.phi[at]))
        assert off < step
        if np.unique(acts[[at - 1, at, (at + 1) % len(found.phi)]]).size == 1:
            assert off > 1e-9 and rise > 0
