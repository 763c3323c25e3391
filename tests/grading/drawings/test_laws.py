"""Laws of grading a drawing: where it stands, how large it is drawn, and the order of its lines change nothing."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from typer.testing import CliRunner

from tests.grading.cases import key_of as sheet_key
from tests.grading.drawings.made import as_svg, drawn, key_of, marked, put, verdicts, with_slip
from tests.laws import few, often
from vecpoly.cli.app import app
from vecpoly.drawing.backends.pdf import to_pdf
from vecpoly.drawing.backends.svg import to_svg
from vecpoly.drawing.scene import Stroke
from vecpoly.drawing.style import Dash
from vecpoly.grading.drawings.grade import grade_drawing
from vecpoly.grading.drawings.overlay import overlay
from vecpoly.grading.marking.lines import paid_by_lines
from vecpoly.grading.rules import Rules
from vecpoly.words import Lang, bare

FEW = settings(max_examples=often(2))
places = st.complex_numbers(max_magnitude=5_000, allow_nan=False, allow_infinity=False)
WRONG = ("an_C2B reversed", "ak_C2C3 halved", "v_B turned")


@FEW
@given(places, st.sampled_from(WRONG))
def test_a_drawing_moved_anywhere_has_the_same_verdicts(by: complex, slip: str) -> None:
    key = key_of("3-9")
    drawing = drawn(with_slip(key, slip))
    moved, first = marked(key, put(drawing, lambda z: z + by)), marked(key, drawing)
    assert verdicts(moved) == verdicts(first) and moved.slips == first.slips


@FEW
@given(st.floats(0.5, 2.0), st.sampled_from(few(["3-9", "A-27", "4-3a"], 2)))
def test_ones_own_scale_changes_no_verdict(scale: float, problem: str) -> None:
    key = key_of(problem)
    mark = marked(key, put(drawn(key.exact), lambda z: scale * z))
    assert verdicts(mark) == verdicts(marked(key, drawn(key.exact))) and not mark.mirrored


@pytest.mark.parametrize("times", [0.667, 1.0, 1.13, 2.0])
def test_a_sheet_larger_than_its_scales_say_is_right_and_left_for_a_person(times: float) -> None:
    """A printer that enlarged it, or scales of one's own that nobody stated: the drawing does not tell."""
    key = key_of("3-9")
    scales = {shape.view.mu.key: shape.mu for shape in key.exact.shapes}
    mark = grade_drawing(key, put(drawn(key.exact), lambda z: times * z), scales=scales)
    assert mark.right and all(one.declared is (times == 1.0) for one in mark.figures)
    assert any("times its size" in said.en for said in mark.remarks) is (times != 1.0)
    lines = paid_by_lines(sheet_key("3-9"), mark, Rules())[1]
    doubts = {line.doubt.en.partition(":")[0] if line.doubt else "" for line in lines}  # and not that none is stated
    assert doubts == {"" if times == 1.0 else "the whole sheet is of another size than its scales say"}


@FEW
@given(st.randoms(use_true_random=False), st.sampled_from(WRONG))
def test_the_order_of_the_lines_in_a_file_changes_nothing(random: object, slip: str) -> None:
    key = key_of("3-9")
    drawing = drawn(with_slip(key, slip))
    lines = list(drawing.segments)
    random.shuffle(lines)  # type: ignore[attr-defined]
    shuffled = replace(drawing, segments=tuple(lines))
    assert verdicts(marked(key, shuffled)) == verdicts(marked(key, drawing))


@pytest.mark.parametrize("slip", WRONG)
def test_the_overlay_has_the_own_polygon_in_full_lines_over_the_exact_one_in_dashes(slip: str) -> None:
    key = key_of("3-9")
    mark = marked(key, drawn(with_slip(key, slip)))
    scenes = overlay(mark, key)
    assert len(scenes) == 2
    for scene, figure in zip(scenes, mark.figures, strict=True):
        strokes = [one for one in scene if isinstance(one, Stroke)]
        assert sum(one.dash is Dash.DASHED for one in strokes) == len(figure.vectors)
        assert sum(one.closed for one in strokes) == sum(one.own is not None for one in figure.vectors)
        assert to_svg(scene).startswith("<svg")
    assert to_pdf(*scenes).startswith(b"%PDF")


def test_a_drawing_is_checked_at_the_command_line_and_a_bad_one_does_not_stop_the_others(tmp_path: Path) -> None:
    key = key_of("3-9")
    good, wrong, bad = (tmp_path / name for name in ("good.svg", "wrong.svg", "bad.dxf"))
    good.write_bytes(as_svg(drawn(key.exact)))
    wrong.write_bytes(as_svg(drawn(with_slip(key, "ak_C2C3 reversed"))))
    bad.write_bytes(b"nothing")
    assert CliRunner().invoke(app, ["check", "3-9", str(good)]).exit_code == 0
    told = CliRunner().invoke(app, ["check", "3-9", str(wrong)])
    assert told.exit_code == 1 and "slip: ak_C2C3 reversed" in told.output
    both = CliRunner().invoke(app, ["check", "3-9", str(bad), str(good)])
    assert both.exit_code == 2 and "bad.dxf" in both.output and "a_E" in both.output


@pytest.mark.parametrize("lang", few(["zh", "en"], 2))
def test_what_is_told_of_a_whole_drawing_stands_on_the_terminal(tmp_path: Path, lang: Lang) -> None:
    key, file = key_of("3-9"), tmp_path / "mirrored.svg"
    file.write_bytes(as_svg(put(drawn(key.exact), lambda z: z.conjugate())))
    remarks = marked(key, put(drawn(key.exact), lambda z: z.conjugate())).remarks
    shown = CliRunner().invoke(app, ["check", "3-9", str(file), "--lang", lang]).output
    assert remarks and all(bare(words.of(lang)) in shown for words in remarks)
