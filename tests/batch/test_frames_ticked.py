"""A frame to draw in has a tick every 10 mm on all four sides, each 2 mm long, within the frame."""

from __future__ import annotations

import pytest

from vecpoly.batch.sheet import blanks
from vecpoly.batch.sheet.layout import Frame

Line = tuple[tuple[float, float], tuple[float, float]]


class Nothing:
    """A canvas on which nothing is drawn."""

    def __getattr__(self, name: str) -> object:
        return lambda *_: None


@pytest.mark.parametrize("size", [(64.0, 35.0), (60.0, 40.0)])
def test_ticks_stand_every_ten_millimetres_inside_the_frame(
    size: tuple[float, float], monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn: list[Line] = []
    monkeypatch.setattr(blanks, "line", lambda _, a, b: drawn.append((a, b)))
    monkeypatch.setattr(blanks, "box", lambda *_: None)
    monkeypatch.setattr(blanks, "write", lambda *_, **__: None)
    x, y = 20.0, 30.0
    frame = Frame(figure="v", at=(x, y), size=size, pole=None, letter="", mu="μ_v", scale=0.01)
    blanks.draw_frame(Nothing(), frame, "t", "s", "en")
    wide, high = size
    across = [10.0 * i for i in range(1, 99) if 10.0 * i < wide - 1e-9]
    up = [10.0 * i for i in range(1, 99) if 10.0 * i < high - 1e-9]
    due = [((x + s, y), (x + s, y + 2.0)) for s in across]
    due += [((x + s, y + high), (x + s, y + high - 2.0)) for s in across]
    due += [((x, y + s), (x + 2.0, y + s)) for s in up]
    due += [((x + wide, y + s), (x + wide - 2.0, y + s)) for s in up]
    assert len(drawn) == len(due)
    for mine, other in zip(sorted(drawn), sorted(due), strict=True):
        assert [*mine[0], *mine[1]] == pytest.approx([*other[0], *other[1]])
