"""What of the words behind `vecpoly check` is an answer, in whatever characters it is typed."""

from __future__ import annotations

import pytest

from vecpoly.cli.classes.claims import claims_among
from vecpoly.grading.student import parted


@pytest.mark.parametrize("text", ["ｖ＿Ｄ＝０．４９", "v_D≈0.49", "v_D：0.49", "ω５＝４．７２ 逆时针", "\\omega_5=4.7"])
def test_an_answer_in_full_width_signs_is_no_problem_of_that_name(text: str) -> None:
    """Beside it two problems were counted."""
    assert claims_among(["3-12", text]) == [text] and all(parted(text))


@pytest.mark.parametrize("text", ["C:\\work\\a.yaml", "３-12", "a.yaml"])
def test_a_problem_or_a_file_is_no_answer(text: str) -> None:
    assert not claims_among([text])
