"""The axes of an empty diagram: round numbers, lengths in mm, both sides where both are needed."""

from __future__ import annotations

import re

from tests.drawn_library import drawn
from tests.each import each
from vecpoly.board.paper.extent import extent
from vecpoly.board.paper.marks import Note, Segment, Vector
from vecpoly.report.question.framed.frames import frames

CAMS = ("cam-least-circle", "cam-roller-offset", "cam-flat-face", "cam-rocker", "two-stroke-flywheel")


def noted(name: str) -> list[str]:
    found = frames(drawn(name).construction, drawn(name).problem)[0].figures
    return [mark.words.en for figure in found for mark in figure.marks if isinstance(mark, Note)]


@each(CAMS)
def test_the_first_number_of_an_empty_axis_is_one_two_four_or_five_of_a_power_of_ten(name: str) -> None:
    sizes = [float(text.strip("−")) for text in noted(name) if re.fullmatch(r"−?[\d.]+", text) and text != "0"]
    assert float(f"{min(sizes):e}".partition("e")[0]) in (1.0, 2.0, 4.0, 5.0)


@each(("7-5", "press-flywheel", "two-stroke-flywheel"))
def test_zero_stands_at_an_axis_of_energies_that_goes_on_below_it(name: str) -> None:
    figures = frames(drawn(name).construction, drawn(name).problem)[0].figures
    energies = [figure for figure in figures if figure.scale is not None and figure.scale.symbol == "μ_E"]
    assert energies
    for figure in energies:
        written = {mark.words.en: mark.at for mark in figure.marks if isinstance(mark, Note)}
        assert written["0"].imag == 0.0 and any(text[:1] == "−" and text[1:2].isdigit() for text in written)


def test_the_loop_of_a_cam_has_an_axis_on_both_sides_for_rise_and_return() -> None:
    texts = noted("cam-least-circle")
    assert {"10", "20", "−10", "−20"} <= set(texts)
    loop = next(one for one in drawn("cam-least-circle").construction.figures if one.view.name == "loop")
    assert any(isinstance(mark, Vector) and mark.a.real < -20 < 20 < mark.b.real for mark in loop.marks)


def test_a_derivative_stands_in_brackets_before_its_unit_and_lengths_are_in_millimetres() -> None:
    texts = noted("cam-least-circle")
    assert "(d$s$/d$φ$)/mm" in texts and "$s$/mm" in texts and not any(text.endswith("/m") for text in texts)


def test_a_diagram_with_axes_may_have_a_frame_as_long_as_itself() -> None:
    """The displacement diagram of a cam stands over the cam, as on the sheet of the solution."""
    blank, sheets = frames(drawn("cam-flat-face").construction, drawn("cam-flat-face").problem)
    diagram = next(one for one in blank.figures if one.view.across is not None)
    wide, high = extent([mark for mark in diagram.marks if isinstance(mark, Segment)][:4])
    assert wide > 2.5 * high and not sheets[0].landscape and len(sheets[0].tops) == 2
