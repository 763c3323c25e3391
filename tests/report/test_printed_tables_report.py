"""Printed tables named in a problem file are checked in its report."""

from __future__ import annotations

from pathlib import Path

import pytest
from pypdfium2 import PdfDocument

from tests.checked_tables import checked
from vecpoly import load, solve
from vecpoly.errors import ProblemFileError
from vecpoly.report import printed_tables


def text_of(path: Path) -> str:
    return "".join(page.get_textpage().get_text_range() for page in PdfDocument(path)).replace("\r\n", " ")


def test_the_report_of_a_16_says_that_the_printed_accelerations_are_wrong(tmp_path: Path) -> None:
    text = text_of(solve(load("A-16"), repeats=0, precise=False).report(tmp_path / "a.pdf", lang="en"))
    assert "The printed table of problem 16" in text
    assert "359 of 361" in text and "right only at 90°, 270°" in text


def test_the_report_of_b_24_says_which_two_crank_lengths_were_mixed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(printed_tables, "check_table", lambda problem, file: checked(problem.id, file.stem[:-8]))
    text = "".join(
        text_of(solve(load("B-24"), repeats=0, precise=False).report(tmp_path / "b.pdf", lang="zh")).split()
    )  # lines break anywhere
    assert "整张表不属于任何一个机构" in text and "24mm即方案B的尺寸，26.5mm即方案A的尺寸" in text
    assert "公式中3处差错（见上）" in text and "漏乘" in text and "照此计算，全部37行相符" in text


def test_a_table_that_is_not_there_is_one_error_with_its_place(tmp_path: Path) -> None:
    source = load("A-16").path
    assert source is not None
    file = tmp_path / "own.yaml"
    file.write_text(source.read_text(encoding="utf-8"), encoding="utf-8")
    with pytest.raises(
        ProblemFileError,
        match=r"own\.yaml, line \d+, column \d+: tables\[0\]: no table 'tables/A_p16_printed\.csv' beside this file",
    ):
        load(file)
