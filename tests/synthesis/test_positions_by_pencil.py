"""Four positions drawn by a hand that scatters: what it loses is told, and what it finds is what it takes it for."""

from __future__ import annotations

import numpy as np
import pytest

import vecpoly
from tests.flat_positions import FLAT
from tests.laws import few
from vecpoly.check.designs.found_words import all_lost, ill_conditioned
from vecpoly.designs.verdict import Verdict
from vecpoly.errors import VecpolyError
from vecpoly.methods.synthesis.inversion.sheet import Stands
from vecpoly.methods.synthesis.inversion.trial import centre_places
from vecpoly.oracle.synthesis.inversion.burmester import centre_points
from vecpoly.oracle.synthesis.inversion.motions import Pose
from vecpoly.plane import Line
from vecpoly.solution import Solution

SEEDS = range(8)
POSES = ((0, 0, 0), (13, 19, 24), (42, 28, 35), (83, 15, 54))  # of the flat ones: mm, mm, deg


def by_pencil(name: str, seed: int) -> Solution | None:
    """The drawing, or None where it is refused."""
    try:
        return vecpoly.solve(vecpoly.load(name), by="pencil", seed=seed)
    except VecpolyError as refused:
        assert refused.code == "lost-by-hand"
        assert "ill-conditioned" in refused.words.en
        return None


@pytest.mark.parametrize("seed", few(SEEDS, 8))
def test_what_a_pencil_loses_is_suspect_and_named(seed: int) -> None:
    solution = by_pencil(FLAT, seed)
    if solution is None:
        return
    found = {one.number: one.verdict for one in solution.construction.candidates}
    warning = solution.construction.warning
    if found == dict.fromkeys((1, 2, 3), Verdict.VALID.name):
        assert warning is None or "candidates on paper" not in warning.en
        return
    assert solution.suspect and warning is not None
    named = [number for number in (1, 2, 3) if found.get(number) != Verdict.VALID.name]
    assert f"candidate {', '.join(map(str, named))}: " in warning.en


def test_a_well_conditioned_task_is_found_by_every_pencil() -> None:
    for seed in few(SEEDS, 4):
        solution = by_pencil("four-positions-b", seed)
        assert solution is not None and not solution.suspect, seed


def test_the_expected_error_holds_the_wandering_of_the_centre_points() -> None:
    drawn = vecpoly.load(FLAT).solve()
    gap = drawn.answers["AD"]
    assert gap.expected_error > 0.05 * gap.exact  # two centre points nearly fall together
    told = [words.en for one in drawn.verification if (words := ill_conditioned(one, alone=False)) is not None]
    assert any("vanishes in" in words for words in told)
    firm = vecpoly.load("four-positions-b").solve().answers["AD"]
    assert firm.expected_error < 0.02 * firm.exact


def test_what_some_hands_miss_in_several_solutions_is_said_of_all_at_once() -> None:
    (lost,) = all_lost(vecpoly.load(FLAT).solve().verification)
    assert "lack solutions 1, 2 and 3." in lost.en and "得不到解 1、2、3。" in lost.zh


def _stands(scatter: np.ndarray) -> list[Stands]:
    turns = [np.exp(1j * np.radians(phi + scatter)) for _, _, phi in POSES]
    return [
        Stands(start=complex(x, y) + 0 * turn, end=complex(x, y) + 30 * turn)
        for (x, y, _), turn in zip(POSES, turns, strict=True)
    ]


def test_the_trial_finds_the_roots_of_the_determinant_cubic() -> None:
    poses = [Pose(at=complex(x, y), turn=complex(np.exp(1j * np.radians(phi)))) for x, y, phi in POSES]
    exact = [point.fixed.real for point in centre_points(poses, -50j, 1 + 0j)]
    found = centre_places(Line(np.complex128(-50j), np.complex128(1)), _stands(np.float64(0.0)))  # type: ignore[arg-type]
    assert [float(at) for at in found] == pytest.approx(exact, abs=1e-9)


def test_each_hand_has_the_places_of_its_own_sheet() -> None:
    stands = _stands(np.zeros(3))
    stands[1] = Stands(start=stands[1].start + np.array([0.0, 0.5, 2.0]), end=stands[1].end + np.array([0.0, 0.5, 2.0]))
    line = Line(np.complex128(-50j), np.complex128(1))
    found = np.array(centre_places(line, stands))
    for hand in range(3):
        alone = [Stands(start=np.asarray(at.start)[hand], end=np.asarray(at.end)[hand]) for at in stands]
        mine = sorted(float(at) for at in centre_places(line, alone))
        assert sorted(x for x in found[:, hand] if np.isfinite(x)) == pytest.approx(mine[: len(found)], abs=1e-6)
