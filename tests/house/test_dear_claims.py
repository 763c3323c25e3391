"""Claims that are dear are tried in turns, and every one has its turn."""

from __future__ import annotations

from pathlib import Path

from tests.dear import TURNS, listed, resting, state

ROOT = Path(__file__).parents[2]
NAMES = tuple(f"tests/some/test_claims.py::test_claim[{n}]" for n in range(900))


def test_every_name_on_the_list_is_that_of_a_test() -> None:
    lost = [name for name in sorted(listed()) if not _is_test(name)]
    assert not lost, lost


def _is_test(name: str) -> bool:
    file, _, function = name.partition("::")
    return (ROOT / file).is_file() and f"def {function}(" in (ROOT / file).read_text(encoding="utf-8")


def test_a_sixteenth_is_tried_in_each_state_of_the_code_and_each_in_one_of_few() -> None:
    tried = [set(NAMES) - resting(NAMES, f"state {n}", TURNS) for n in range(150)]
    assert all(len(NAMES) / TURNS / 2 < len(one) < len(NAMES) / TURNS * 1.5 for one in tried)
    assert set().union(*tried) == set(NAMES)
    assert not resting(NAMES, "state 1", 1)


def test_the_same_code_is_tried_by_the_same_claims_and_other_code_by_others(tmp_path: Path) -> None:
    file = tmp_path / "vecpoly" / "board.py"
    file.parent.mkdir()
    file.write_text("SCALE = 1", encoding="utf-8")
    before = state(tmp_path)
    assert state(tmp_path) == before
    file.write_text("SCALE = 2", encoding="utf-8")
    assert resting(NAMES, state(tmp_path), TURNS) != resting(NAMES, before, TURNS)
