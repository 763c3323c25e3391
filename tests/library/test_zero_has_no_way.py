"""What reads as zero has no direction and no sense, in the answers of any problem of the library."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tests.drawn_library import IDS, drawn
from tests.each import Later, each
from vecpoly.algebra.formula import plain
from vecpoly.printed.digits import drawn_number
from vecpoly.report.answers.line import short_line

WAY = re.compile(r"∠|[←→↑↓]|clockwise|时针|\((?:from|由)")


def _read_as_zero() -> Iterator[tuple[str, str]]:
    """Problems with the keys of what they find to be nothing."""
    for name in IDS:
        for key, answer in drawn(name).solution.answers.items():
            if not answer.is_place and not answer.undefined and not drawn_number(answer).strip("−0."):
                yield name, key


@each(Later(_read_as_zero))
def test_what_reads_as_zero_is_told_without_direction_or_sense(case: tuple[str, str]) -> None:
    name, key = case
    solution = drawn(name).solution
    for lang in ("zh", "en"):
        assert not WAY.search(plain(short_line(solution.answers[key], solution, lang)))


def test_what_does_not_vanish_keeps_its_direction() -> None:
    solution = drawn("3-9").solution
    assert WAY.search(plain(short_line(solution.answers["v_C2B"], solution, "en")))
