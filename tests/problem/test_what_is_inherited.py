"""What a problem has of its book does not fit what is built on it: the fault says how it is left out."""

from __future__ import annotations

from pathlib import Path

import pytest

from vecpoly.errors import ProblemFileError
from vecpoly.problem.assignment import load_assignment

TEXT = "title: {zh: 题, en: Task}\nproblems:\n  - {problem: 3-2, find: [P_13], vary: {AB: 50 mm .. 60 mm by 2 mm}"


def test_a_printed_value_that_a_narrower_task_does_not_have_is_left_out_by_null(tmp_path: Path) -> None:
    file = tmp_path / "a.yaml"
    file.write_text(TEXT + "}\n", encoding="utf-8")
    with pytest.raises(ProblemFileError, match="`printed: null` leaves it out") as told:
        load_assignment(file)
    assert "printed: null 即可去掉" in told.value.words.zh
    file.write_text(TEXT + ", printed: null}\n", encoding="utf-8")
    assert load_assignment(file).problems[0].printed == ()
