"""What is set out along an axis is italic, its unit upright; a derivative has no unit."""

from __future__ import annotations

import pytest

from vecpoly.drawing.labels.points import piece
from vecpoly.drawing.style import Hue
from vecpoly.typeset.box import Glyphs
from vecpoly.typeset.fonts import Face


@pytest.mark.parametrize("unit", ["mm", "J", "(N·m)", "(kg·m^2)", "(m/s)", "s"])
def test_the_unit_of_an_axis_is_upright(unit: str) -> None:
    faces = [(item.text, item.font) for item in piece(f"M/{unit}", Hue.BLACK, 1).box.items if isinstance(item, Glyphs)]
    slanted = "".join(text for text, face in faces if face in (Face.ITALIC, Face.BOLD_ITALIC))
    assert slanted == "M"
    assert "".join(text for text, _ in faces).replace("/", "").startswith("M")


def test_of_a_derivative_the_letters_are_symbols() -> None:
    faces = [(item.text, item.font) for item in piece("ds/dφ", Hue.BLACK, 1).box.items if isinstance(item, Glyphs)]
    assert {text for text, face in faces if face == Face.ITALIC} == {"s", "φ"}
