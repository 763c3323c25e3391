"""Claims about the rough assembly that Newton starts from, and the grid on which a cycle is looked through."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from tests.texts import CLASS_III, CLASS_IV, CRANK, SLIDER_CRANK
from vecpoly import oracle
from vecpoly.cycle.grid import CLOSE, FAIR, STEPS, places
from vecpoly.mechanism.groups.assur import decompose
from vecpoly.mechanism.model import Mechanism
from vecpoly.oracle.iterated.assemblies import placed
from vecpoly.oracle.iterated.guess import first_guess
from vecpoly.problem.load import load, loads

TEXTS = {
    "class III": CLASS_III,
    "class IV": CLASS_IV,
    "slider-crank": SLIDER_CRANK
    + "branch: [C right of A]\ninput: {link: 1, phi: 40 deg, omega: 10 rad/s ccw}\nfind: [v_C]\n",
}


@cache
def mechanism(name: str) -> Mechanism:
    return (loads(TEXTS[name]) if name in TEXTS else load(name)).mechanism


@pytest.mark.parametrize(
    "name",
    [
        *TEXTS,
        "3-9",
        "3-12",
        "A-27",
        "oldham-coupling",
        "3-13",
        "whitworth-quick-return",
        "elliptic-trammel",
        "class-iii-slides",
        "swinging-block-offset-rod",
        "inclined-cross-slide",
        "crank-rack-pinion",
        "stephenson-valve-gear",
        "three-legged-plate",
        "planet-drive",
        "hypocycloid-drive",
    ],
)
def test_links_laid_through_their_true_places_are_the_true_assembly(name: str) -> None:
    mech = mechanism(name)
    motion = oracle.solve(mech, order=0)
    at = {p: complex(np.ravel(motion.position(p))[0]) for link in mech.links for p in link.points}
    for group in decompose(mech):
        known = {n: body for n, body in motion.bodies.items() if n not in group.links}
        guess = first_guess(mech, group, known, at)[0]
        for letter, place in placed(mech, group, guess).items():
            assert place == pytest.approx(at[letter], abs=1e-9 * mech.scale), (group, letter)


@pytest.mark.parametrize("name", ["class III", "class IV"])
def test_links_laid_through_rough_places_stand_in_their_middle_and_lie_along_them(name: str) -> None:
    mech = mechanism(name)
    (group,) = (one for one in decompose(mech) if len(one.links) > 2)
    known = {n: body for n, body in oracle.solve(mech, order=0).bodies.items() if n not in group.links}
    guess = first_guess(mech, group, known)[0]
    at, told = placed(mech, group, guess), dict(mech.guesses)
    told |= {
        p: complex(np.ravel(body.point(local))[0])
        for n, body in known.items()
        for p, local in mech.link(n).points.items()
    }
    for link, pose in zip(group.links, guess, strict=True):
        letters = [p for p in mech.link(link).points if p in told]
        assert len(letters) > 1
        local = np.array([mech.link(link).points[p] for p in letters])
        origin, unit = complex(*pose[:2]), np.exp(1j * pose[2])
        off = [origin + unit * z - told[p] for z, p in zip(local, letters, strict=True)]
        assert (
            abs(sum(off)) < 1e-12
            and abs(sum((np.conj(z - local.mean()) * d * np.conj(unit)).imag for z, d in zip(local, off, strict=True)))
            < 1e-12
        )
    assert set(at) >= set(mech.guesses)


def test_a_whole_turn_is_looked_through_in_quarters_of_a_degree_off_the_round_ones() -> None:
    mech = loads(CRANK).mechanism
    grid = places(mech, 0.0, 2 * np.pi, True)
    assert np.degrees(grid[:3]) == pytest.approx([0.4142 / 4, 1.4142 / 4, 2.4142 / 4]) and len(grid) == STEPS + 2
    assert grid[-1] - grid[1] == pytest.approx(2 * np.pi)


def test_a_range_is_looked_through_ever_finer_towards_its_ends_which_belong_to_it() -> None:
    mech = loads(CRANK).mechanism
    grid = places(mech, 0.2, 1.7, False)
    steps = np.diff(grid)
    assert (grid[0], grid[-1]) == (0.2, 1.7) and (steps > 0).all()
    assert grid[1] - 0.2 > 1.5 * CLOSE and 1.7 - grid[-2] > 1.5 * CLOSE and grid[1] - 0.2 < 20 * 1.5 * CLOSE
    middle = len(steps) // 2
    assert steps[middle] > 20 * steps[2] and steps[middle] > 20 * steps[-3] and steps[middle] < 2e-3


def test_beside_a_nearly_folded_group_the_grid_is_so_fine_that_a_cubic_will_do() -> None:
    mech = loads(CRANK.replace("BC: 100 mm", "BC: 30.03 mm")).mechanism
    grid = places(mech, 0.0, 2 * np.pi, True)
    folded = np.flatnonzero(np.abs(grid - np.pi / 2) < 0.02)
    assert len(grid) > STEPS + 2 and np.diff(grid)[folded].min() < 0.2 * np.radians(0.25) and (np.diff(grid) > 0).all()
    even = (grid[:-1] + grid[1:]) / 2
    values, between = (np.real(oracle.solve(mech, phi, order=0).position("C")) for phi in (grid, even))
    for k in range(2, len(grid) - 3, 7):
        x, y = grid[k - 1 : k + 3], values[k - 1 : k + 3]
        cubic = sum(y[i] * np.prod([(even[k] - x[j]) / (x[i] - x[j]) for j in range(4) if j != i]) for i in range(4))
        assert abs(cubic - between[k]) < 2 * FAIR * np.ptp(values)
