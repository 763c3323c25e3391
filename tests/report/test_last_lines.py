"""Claims about where the lines of running text end: equations stay whole, no word or symbol is left alone."""

from __future__ import annotations

import pytest

from tests.each import each
from vecpoly.report.flow.cells import Cell, cells
from vecpoly.report.flow.text.breaks import break_lines
from vecpoly.typeset.box import MM

EM = 10.5 / MM
MEASURE = 160.0
LEAST = 3.4  # em: three characters and a stop
EN = "Measure the length and find the angular velocity; placing the relative velocity there shows its sense. "
ZH = "量取图上长度，求角速度，将相对速度移至该点，可知其方向为逆时针方向。"


def _broken(text: str, chinese: bool) -> list[str]:
    lines = break_lines(cells(text, EM, chinese), MEASURE, EM)
    return ["".join(_said(cell) for cell in line.cells) for line in lines]


def _said(cell: Cell) -> str:
    return " " * cell.spaced + (cell.source.piece if cell.source else cell.text)


@each(["$ω_3$ = $ω_4$", "0.379 − 1 = −0.621 rad/s", "$δ = (ω_max − ω_min)$", "$ω_21$ = $ω_2$ − $ω_1$"])
def test_a_short_equation_stands_on_one_line(equation: str) -> None:
    for text, chinese in ((EN, False), (ZH, True)):
        for count in range(90):
            lines = _broken(f"{(text * 3)[:count].strip()} {equation}. {text * 2}", chinese)
            ends = [line.rstrip()[-1] for line in lines[:-1]]
            assert not {"=", "−", "+"} & {*ends}, lines
            assert not any(line.lstrip().startswith(("= ", "− ", "+ ")) for line in lines), lines


@each(["en", "zh"])
def test_a_last_line_is_more_than_a_word_or_a_symbol(lang: str) -> None:
    text = (EN if lang == "en" else ZH) * 3
    for count in range(100, len(text)):
        if lang == "en" and not text[count].isspace():
            continue
        lines = break_lines(cells(f"{text[:count].strip('，。; .')} $b_3$.", EM, lang == "zh"), MEASURE, EM)
        assert (len(lines) > 1 and lines[-1].width >= LEAST * EM - 1e-9) or len(lines) == 1


def test_where_the_lines_before_cannot_spare_a_word_the_last_one_is_left_as_it_is() -> None:
    words = " ".join(["W" * 24] * 4)
    lines = break_lines(cells(f"{words} $b_3$", EM, False), MEASURE, EM)
    assert lines[-1].width == pytest.approx(lines[-1].cells[-1].box.width) or len(lines[-1].cells) > 1
