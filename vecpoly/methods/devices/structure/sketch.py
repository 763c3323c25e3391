"""The sketch of a chain: links, pairs with their letters, frame; the same with some links alone, taken apart."""

from __future__ import annotations

from math import pi

from ....board.board import Board
from ....board.construction import Pane, View
from ....board.paper.marks import Dot, Role
from ....devices.structure import Structure
from ....devices.structure_pairs import FRAME, Chain, Pair
from ....diagram.chains import Sketched
from ....diagram.profiles import profile_drawn
from ....diagram.single import number
from ....foundation.slotted import replace
from ....words import Words

TURNING, FIRST, RING = 6.5, 0.6, 4.0  # of a driver's arrow: radius (mm), direction of its foot (rad); to the next (mm)
OUTSIDE = 5.0  # mm from a ring to the arrow of its driving
FLAT = 10.0  # mm: half of a flat profile for which a link stands


def pane(board: Board, view: View, name: str, title: Words) -> Pane:
    """A figure without a printed scale: a structural sketch shows how, not how long."""
    return board.open_pane(view, name, title, replace(board.scale_of(view), symbol=""))


def draw_chain(
    board: Board, place: Pane, device: Structure, chain: Chain, drivers: tuple[str, ...] = (), *, ringed: bool = True
) -> None:
    """All links and the frame, and the arrows of the drivers; ringed: whether compound hinges are marked. The frame
    has its number, where it is given none of its own on the first diagram alone."""
    scaled = _on_paper(board, place, chain)
    it = Sketched(scaled, device.number, ringed, _on_paper(board, place, device.chain))
    board.depict(place, *it.drawn(chain.links, frame=True))
    _draw_drivers(board, place, device, scaled, drivers)
    pivots = [p for p in scaled.pairs if p.hinged and FRAME in p.links]
    free = [p for p in pivots if not p.touches(drivers)]
    if pivots and (device.frame != FRAME or chain == device.chain):
        lowest = min(free or pivots, key=lambda p: (p.at.imag, p.at.real))
        board.depict(place, number(device.number(FRAME), lowest.at, owner="frame"))


def ring_compound(board: Board, place: Pane, pair: Pair) -> None:
    """The sign of a compound hinge: a circle within a circle."""
    board.plot(place, float(board.to_paper(place, 1.0)) * pair.at, "", Dot.MULTIPLE)


def draw_apart(
    board: Board,
    place: Pane,
    device: Structure,
    chain: Chain,
    links: tuple[str, ...],
    *,
    left: tuple[str, ...] = (),
    frame: bool = False,
) -> None:
    """These links alone, with the halves of the joints by which they hang on what is left beside them; `frame`:
    drivers, with the frame where they stand on it and their arrows."""
    whole, scaled = _on_paper(board, place, device.chain), _on_paper(board, place, chain)
    it = Sketched(scaled, device.number, whole=whole, gone=frozenset(chain.links) - {*links, *left, FRAME})
    board.depict(place, *it.drawn(links, frame=frame))
    _draw_drivers(board, place, device, scaled, links if frame else ())


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


def _draw_drivers(board: Board, place: Pane, device: Structure, chain: Chain, drivers: tuple[str, ...]) -> None:
    """The arrows of drivers, about their fixed pivots; of those that share one each farther out, with its name."""
    pivots = [next((p for p in chain.at(link) if p.hinged and FRAME in p.links), None) for link in drivers]
    for n, (link, pivot) in enumerate(zip(drivers, pivots, strict=True)):
        if pivot is not None:
            inner, shared = pivots[:n].count(pivot), pivots.count(pivot) > 1
            label, ring = f"ω_{device.number(link)}" if shared else "", _ring(chain, link, pivot)
            radius = ring + OUTSIDE if shared and ring else TURNING + inner * RING
            board.curved_arrow(place, pivot.at, radius, FIRST + inner * pi, True, label)


def _ring(chain: Chain, link: str, pivot: Pair) -> float:
    """The pitch radius of a driver that is a ring about this pivot, inside which others turn; 0 of others."""
    radii = [(one, abs(p.at - pivot.at)) for p in chain.pairs if p.meshes for one in p.links]
    own = max((radius for one, radius in radii if one == link), default=0.0)
    return (
        own if own > max((radius for one, radius in radii if one in pivot.links and one != link), default=own) else 0.0
    )
