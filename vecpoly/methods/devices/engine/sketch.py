"""A crankshaft as it is drawn: along its axis, and as two stars of cranks, at α and at 2α."""

from __future__ import annotations

from cmath import rect
from math import cos

from ....board.construction import View
from ....board.paper.marks import Dot, Lump, Role
from ....board.place import Pane
from ....devices.balancing.engine import InlineEngine
from ....diagram.single import disc, outline, rod
from ....words import Words
from ..bench import Bench
from ..rotor.scales import AXIS, END_VIEW, LUMP
from ..rotor.views.along import RUN, SHAFT

LONG, TALL = 105.0, 15.0  # mm: along the shaft; a crank as drawn, where the scale of the shaft makes it too short
ABOVE, BELOW = 7.0, 4.0  # mm: numbers of the cylinders over the highest crank; their planes under the lowest


def crankshaft(bench: Bench, engine: InlineEngine) -> None:
    """Every crank in its plane, by its projection; the middle plane dashed."""
    board, view = bench.board, View.MECHANISM
    mm = board.scale_of(view).value
    board.section(Words("曲轴简图", "The crankshaft"))
    high = max(engine.r.si / mm, TALL)
    board.step(
        Words(
            "按 $μ_l$ 画出曲轴的轴向简图（缸心线向上，曲柄画其投影，半径方向不按比例），点画线为各缸平面，"
            "虚线为中间平面。",
            "Draw the crankshaft along its axis to the scale $μ_l$ (cranks by their projections, radial "
            "dimensions not to scale); chain lines are the planes of the cylinders, the dashed one the middle plane.",
        ),
        view,
    )
    ends = engine.z[0] / mm - RUN, engine.z[-1] / mm + RUN
    corners = (complex(x, y) for x, y in ((ends[0], -SHAFT), (ends[1], -SHAFT), (ends[1], SHAFT), (ends[0], SHAFT)))
    board.depict(view, outline("shaft", *corners))
    board.join(view, complex(ends[0] - AXIS, 0), complex(ends[1] + AXIS, 0), Role.CENTRE)
    board.join(view, -1j * (high + ABOVE), 1j * (high + ABOVE), Role.HIDDEN)
    for i, (z, crank) in enumerate(zip(engine.z, engine.cranks, strict=True), 1):
        foot, up = complex(z / mm, 0), 1j * high * cos(crank.si)
        if abs(up) > SHAFT + LUMP:
            way = up / abs(up)
            board.depict(view, rod(f"crank {i}", foot + way * SHAFT, foot + up - way * LUMP))
        board.depict(view, disc(f"crank {i}", foot + up, LUMP, Lump.OWN))
        board.join(view, foot - 1j * (high + BELOW), foot + 1j * (high + ABOVE), Role.CENTRE)
        board.plot(view, foot + 1j * (high + ABOVE), str(i), Dot.NONE)


def stars(bench: Bench, engine: InlineEngine) -> None:
    """The cranks from the end, and the second star with all angles doubled."""
    for times, name, title in (
        (1, "I", Words("曲柄星形图 $α$", "Star of the cranks, $α$")),
        (2, "II", Words("二阶星形图 $2α$", "Star of second order, $2α$")),
    ):
        place = bench.board.open_pane(END_VIEW, name, title)
        bench.board.step(
            Words(
                "画出曲柄星形图。" if times == 1 else "把各曲柄的方向角加倍，画出二阶星形图。",
                "Draw the star of the cranks." if times == 1 else "Double all angles for the star of second order.",
            ),
            place,
        )
        _star(bench, engine, place, times)


def _star(bench: Bench, engine: InlineEngine, place: Pane, times: int) -> None:
    board = bench.board
    away = engine.r.si / board.scale_of(place).value
    for way in (1, 1j):
        board.join(place, -way * (away + AXIS), way * (away + AXIS), Role.CENTRE)
    board.plot(place, 0j, "", Dot.JOINT)
    there: dict[tuple[float, float], list[str]] = {}
    for i, crank in enumerate(engine.cranks, 1):
        at = rect(away, times * crank.si)
        there.setdefault((round(at.real, 6), round(at.imag, 6)), []).append(str(i))
    for (x, y), names in there.items():
        board.depict(place, rod(f"crank {names[0]}", 0j, complex(x, y)))
        board.plot(place, complex(x, y), ",".join(names), Dot.POINT)
