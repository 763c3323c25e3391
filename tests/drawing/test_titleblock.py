"""What the strip of a sheet tells of the hand that drew it."""

from __future__ import annotations

import pytest

from tests.drawn_library import drafted, ids
from tests.drawn_sheets import laid
from vecpoly.board.acts.inkless import Measure
from vecpoly.devices.structure import Structure
from vecpoly.drawing.scene import TextBox
from vecpoly.problem.load import load
from vecpoly.typeset import Glyphs

STRUCTURES = [name for name in ids(mechanisms=False) if isinstance(load(name).subject, Structure)]


def printed(name: str) -> list[str]:
    """What each sheet says in its strip, without spaces."""
    boxes = [[one.box for one in sheet.furniture.items if isinstance(one, TextBox)] for sheet in laid(name)]
    said = ["".join(g.text for box in some for g in box.items if isinstance(g, Glyphs)) for some in boxes]
    return [text.replace(" ", "") for text in said]


@pytest.mark.parametrize("name", [*STRUCTURES[:3], "2-10"])
def test_sheets_on_which_nothing_is_measured_do_not_say_how_finely_they_are_read(name: str) -> None:
    assert all("仪器绘图" in text and "0.1" not in text for text in printed(name))


@pytest.mark.parametrize("name", ["3-9", "8-1"])
def test_sheets_that_are_measured_say_how_finely(name: str) -> None:
    solution = drafted(name)
    assert solution is not None and any(isinstance(act, Measure) for act in solution.construction.acts)
    assert all("读至0.1" in text for text in printed(name))
