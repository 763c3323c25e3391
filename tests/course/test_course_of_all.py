"""Whatever has a cycle of positions has a course report, or a refusal that says why not."""

from __future__ import annotations

import pytest

from tests.drawn_library import IDS, drawn
from tests.each import each
from tests.laws import soaking
from vecpoly.errors import NoMethodError, NotAskedError, VecpolyError
from vecpoly.report.document import report_bytes

# one position; a disc larger than all lengths; a change point; masses alone
BROKE = ("3-1f", "3-1c", "parallelogram-locomotive", "balance-slider-crank")
ALL = IDS if soaking() else BROKE[:1]


@pytest.mark.filterwarnings("error::RuntimeWarning")
@each(ALL)
def test_a_course_report_is_made_or_refused_with_its_reason(name: str) -> None:
    solution = drawn(name).solution
    try:
        assert report_bytes([solution], lang="en", style="course").startswith(b"%PDF")
    except VecpolyError as refused:
        assert name not in BROKE
        assert isinstance(refused, (NoMethodError, NotAskedError)) or refused.code == "cam-profile", refused
