"""The sketch of a chain: links, pairs with their letters, frame; the same with some links alone, taken apart."""

from __future__ import annotations

from dataclasses import replace

from ....board.board import Board
from ....board.construction import Pane, View
from ....board.paper.marks import Dot, Role
from ....devices.structure import Structure
from ....devices.structure_pairs import FRAME, Chain, Pair
from ....diagram.chains import Sketched
from ....diagram.profiles import profile_drawn
from ....diagram.single import number
from ....words import Words

FOOT = 7.0  # mm from a pivot to under its ground
TURNING, FIRST = 6.5, 0.6  # of a driver's arrow: radius (mm), direction of its foot (rad)
FLAT = 10.0  # mm: half of a flat profile for which a link stands


def pane(board: Board, view: View, name: str, title: Words) -> Pane:
    """A figure without a printed scale: a structural sketch shows how, not how long."""
    return board.open_pane(view, name, title, replace(board.scale_of(view), symbol=""))


def draw_chain(
    board: Board, place: Pane, device: Structure, chain: Chain, drivers: tuple[str, ...] = (), *, ringed: bool = True
) -> None:
    """All links and the frame, and the arrows of the drivers; ringed: whether compound hinges are marked."""
    scaled = _on_paper(board, place, chain)
    it = Sketched(scaled, device.number, ringed, _on_paper(board, place, device.chain))
    board.depict(place, *it.drawn(chain.links, frame=True))
    for link in drivers:
        _draw_driver(board, place, scaled.at(link))
    pivot = next((p for p in scaled.pairs if p.hinged and FRAME in p.links), None)
    if device.frame != FRAME and pivot is not None:
        board.depict(place, number(device.frame, pivot.at + FOOT * it.down(pivot), owner="frame"))


def ring_compound(board: Board, place: Pane, pair: Pair) -> None:
    """The sign of a compound hinge: a circle within a circle."""
    board.plot(place, float(board.to_paper(place, 1.0)) * pair.at, "", Dot.MULTIPLE)


def draw_apart(
    board: Board, place: Pane, device: Structure, chain: Chain, links: tuple[str, ...], frame: bool = False
) -> None:
    """These links alone, with the halves of the joints by which they hang on the rest;
    `frame`: drivers, with the frame where they stand on it and their arrows."""
    whole, scaled = _on_paper(board, place, device.chain), _on_paper(board, place, chain)
    it = Sketched(scaled, device.number, whole=whole)
    board.depict(place, *it.drawn(links, frame=frame))
    for link in links if frame else ():
        _draw_driver(board, place, scaled.at(link))


def draw_replaced(board: Board, place: Pane, device: Structure, pair: Pair) -> None:
    """The profiles for which a link stands, thin and dashed; pitch circles of gears."""
    (high,) = _on_paper(board, place, Chain(pair.links, (pair,))).pairs
    for link, centre in zip(high.links, high.about, strict=True):
        if centre is None:
            flat = FLAT * 1j * high.normal
            board.join(place, high.at - flat, high.at + flat, Role.HIDDEN)
        elif high.meshes:
            board.depict(place, profile_drawn(high, link))
        else:
            board.circle(place, centre, abs(high.at - centre), Role.HIDDEN)


def _on_paper(board: Board, place: Pane, chain: Chain) -> Chain:
    return chain.times(float(board.to_paper(place, 1.0)))


def _draw_driver(board: Board, place: Pane, pairs: tuple[Pair, ...]) -> None:
    """The arrow of a driver, about its fixed pivot."""
    pivot = next((p for p in pairs if p.hinged and FRAME in p.links), None)
    if pivot is not None:
        board.curved_arrow(place, pivot.at, TURNING, FIRST, True, "")
