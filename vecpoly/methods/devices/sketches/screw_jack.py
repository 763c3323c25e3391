"""How a screw jack is drawn: the thread unrolled, the nut by itself,
the nut under the load alone, the ring of the collar."""

from __future__ import annotations

from math import pi

from ....board.construction import Pane
from ....board.paper.marks import Dot, Role
from ....diagram.single import rod
from ....plane import Line, Points, Reals, lines_meet, nominal, unit
from ..bench import Bench
from ..inclined import Press, between, body, concur, cone, press, pull
from .dimensions import dimension

NUT = 10.0  # mm: half the length of the nut as sketched


def unrolled(bench: Bench, place: Pane, mean: float, lead: float, rise: str) -> Points:
    """Draw the unrolled thread (mean diameter and lead in mm) to scale with the nut on it:
    the direction of the slope as drawn."""
    board = bench.board
    base, height = (board.to_paper(place, mm / 1e3) for mm in (pi * mean, lead))
    foot = board.lay_off(0j, 1 + 0j, base)
    top = board.lay_off(foot, 1j, height)
    along, under, end = unit(top), -24j, complex(nominal(foot))
    body(bench, place, "thread", 0j, foot, top)
    dimension(bench, place, under, end + under, "π d_2")
    for edge in (0j, foot):
        board.join(place, edge, edge + under, Role.CONSTRUCTION)
    board.plot(place, (foot + top) / 2, rise, Dot.NONE)
    between(bench, place, 0j, 1 + 0j, along, 0.2 * float(nominal(base)), "α")
    at, normal = 0.65 * top, 1j * along
    body(bench, place, "nut", *(at + NUT * z for z in (-along, along, along + normal, normal - along)))
    return along


def nut_apart(
    bench: Bench, place: Pane, along: Points, lean: Points, angle: str, symbols: tuple[str, str, str]
) -> None:
    """The nut by itself under load, push and reaction, whose lines meet in one point."""
    load, push, reaction = symbols
    normal = 1j * along
    body(bench, place, "nut", *(1.4 * NUT * z for z in (-along, along, along + normal, normal - along)))
    meeting = 0.7 * NUT * normal
    foot = lines_meet(Line(meeting, lean), Line(0j, along))
    side = lines_meet(Line(meeting, 1 + 0j), Line(-1.4 * NUT * along, normal))
    top = lines_meet(Line(meeting, 1j), Line(1.4 * NUT * normal, along))
    press(
        bench, place, Press(symbol=reaction, at=foot, normal=normal, along=lean, angle=angle, slides=along, speed="v")
    )
    pull(bench, place, side, 1 + 0j, push)
    pull(bench, place, top, -1j, load)
    concur(bench, place, meeting, foot, side, top)


def nut_in_cone(bench: Bench, place: Pane, along: Points, phi: Reals, angle: str) -> None:
    """The nut under the load alone: the reaction against it, beside the friction cone (φ in deg)."""
    normal = 1j * along
    body(bench, place, "nut", *(NUT * z for z in (-along, along, along + normal, normal - along)))
    bench.board.depict(place, rod("thread", -2.4 * NUT * along, 2.4 * NUT * along))
    cone(bench, place, 0j, -normal, phi, 42.0, "n", angle)
    pull(bench, place, 1j * NUT / along.real, -1j, "Q")
    bench.board.arrow(place, -26j, 0j, Role.RESULT, label="R")


def collar_ring(bench: Bench, place: Pane, outer: float, inner: float) -> None:
    """The ring on which the load rests, with its diameters (radii in mm on paper)."""
    for radius, level, symbol in ((outer, -outer - 7, "D"), (inner, 0, "d_0")):
        bench.board.circle(place, 0j, radius, Role.GIVEN)
        dimension(bench, place, complex(-radius, level), complex(radius, level), symbol)
    for x in (-outer, outer):
        bench.board.join(place, complex(x, 0), complex(x, -outer - 9), Role.CONSTRUCTION)
