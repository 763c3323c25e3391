"""The sketch of a chain: links, pairs with their letters, frame; the same with some links alone, taken apart."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from ....board.board import Board
from ....board.construction import Pane, View
from ....board.paper.marks import Arc, Block, Dot, FixedGuide, Ground, LinkNumber, Mark, Point, Role, Segment, TurnArrow
from ....devices.structure import Structure
from ....devices.structure_pairs import FRAME, Chain, Form, Pair
from ....names import subscripted
from ....words import Words
from .bodies import NEAR, Paper, body, profile

HALF_GUIDE, HALF_BLOCK, SLEEVE, FOOT = (
    11.0,
    2.5,
    1.6,
    7.0,
)  # mm: half a fixed guide; block and sleeve across; pivot to under its ground
DOWNS = (-1j, 1j, 1 + 0j, -1 + 0j)


def pane(board: Board, view: View, name: str, title: Words) -> Pane:
    """A figure without a printed scale: a structural sketch shows how, not how long."""
    return board.open_pane(view, name, title, replace(board.scale_of(view), symbol=""))


def paper_of(board: Board, place: Pane, device: Structure) -> Paper:
    """Places on this figure."""
    return Paper(lambda at: complex(board.to_paper(place, 1.0) * at), device.number)


def draw_chain(board: Board, place: Pane, device: Structure, chain: Chain, drivers: tuple[str, ...] = ()) -> None:
    """All links and the frame."""
    paper = paper_of(board, place, device)
    board.mark(
        place,
        *_all(chain, chain.links, paper, True),
        *(arrow for link in drivers for arrow in _driving(chain, link, paper)),
    )
    pivot = next((p for p in chain.pairs if p.form is Form.R and FRAME in p.links), None)
    if device.frame != FRAME and pivot is not None:
        foot = paper.mm(pivot.at) + FOOT * _down(chain, pivot, paper)
        board.mark(place, LinkNumber(a=foot, b=foot, number=device.frame))


def draw_apart(
    board: Board, place: Pane, device: Structure, chain: Chain, links: tuple[str, ...], frame: bool = False
) -> None:
    """These links alone, with the halves of the joints by which they hang on the rest;
    `frame`: with the frame where they stand on it."""
    board.mark(place, *_all(chain, links, paper_of(board, place, device), frame))


def _all(chain: Chain, links: tuple[str, ...], paper: Paper, frame: bool) -> Iterator[Mark]:
    for link in links:
        yield from body(chain, link, paper)
    for pair in chain.pairs:
        if pair.touches(links):
            yield from _joint(chain, pair, paper, frame)


def _joint(chain: Chain, pair: Pair, paper: Paper, frame: bool) -> Iterator[Mark]:
    at = paper.mm(pair.at)
    if pair.form is Form.P:
        yield from _slide(chain, pair, paper, frame)
        if not any(abs(paper.mm(p.at) - at) < NEAR for p in chain.pairs if p.form is Form.R):
            yield Point(at=at, label=subscripted(pair.letter), dot=Dot.NONE)
        return
    if frame and FRAME in pair.links:
        if pair.form is Form.R:
            yield Ground(at=at, down=_down(chain, pair, paper))
        else:
            yield from profile(pair, FRAME, paper)
    yield Point(at=at, label=subscripted(pair.letter), dot=Dot.JOINT if pair.form is Form.R else Dot.POINT)


def _slide(chain: Chain, pair: Pair, paper: Paper, frame: bool) -> Iterator[Mark]:
    """A block on a fixed guide, a sleeve on a rod, a rod in a fixed sleeve."""
    at, u = paper.mm(pair.at), pair.along
    if pair.links[0] == FRAME:
        for side in (1, -1) if frame else ():
            yield FixedGuide(a=at - side * (8 * u + 1j * u * SLEEVE), b=at + side * (8 * u - 1j * u * SLEEVE))
        return
    if pair.links[1] != FRAME:
        yield Block(at=at, along=u, on_rod=True)
        return
    if frame:
        if _leans_right(chain, pair, paper):
            u = -u
        yield FixedGuide(a=at - u * HALF_GUIDE - 1j * u * HALF_BLOCK, b=at + u * HALF_GUIDE - 1j * u * HALF_BLOCK)
    else:
        yield Segment(a=at - u * HALF_GUIDE, b=at + u * HALF_GUIDE, role=Role.CENTRE)
    yield Block(at=at, along=pair.along)


def _leans_right(chain: Chain, pair: Pair, paper: Paper) -> bool:
    """Whether what hangs on the block lies to the right of its guide, where the hatching would be."""
    at, u = paper.mm(pair.at), pair.along
    beside = [paper.mm(p.at) for p in chain.at(pair.links[0])]
    beside += [
        paper.mm(q.at)
        for p in chain.at(pair.links[0])
        if p.form is Form.R and abs(paper.mm(p.at) - at) < NEAR
        for link in p.links
        if link not in (FRAME, pair.links[0])
        for q in chain.at(link)
        if q is not p
    ]
    return sum((u.conjugate() * (z - at)).imag / max(abs(z - at), 1.0) for z in beside) < 0


def _down(chain: Chain, pair: Pair, paper: Paper) -> complex:
    """The side of the pivot on which fewest links lie; below where it does not matter."""
    at = paper.mm(pair.at)
    ways = [paper.mm(p.at) - at for link in pair.links if link != FRAME for p in chain.at(link) if p.form.is_lower]
    units = [w / abs(w) for w in ways if abs(w) > NEAR]
    free = [down for down in DOWNS if all((down.conjugate() * u).real < 0.8 for u in units)]
    return free[0] if free else DOWNS[0]


def _driving(chain: Chain, link: str, paper: Paper) -> Iterator[Mark]:
    """The arrow of a driver, about its fixed pivot."""
    pivot = next((p for p in chain.at(link) if p.form is Form.R and FRAME in p.links), None)
    if pivot is not None:
        yield TurnArrow(at=paper.mm(pivot.at), radius=6.5, start=0.6, ccw=True, label="")


def dashed_profiles(board: Board, place: Pane, device: Structure, pair: Pair) -> None:
    """The profiles for which a link stands, thin and dashed; pitch circles of gears."""
    paper, at = paper_of(board, place, device), pair.at
    for link, centre in zip(pair.links, pair.about, strict=True):
        if centre is None:
            t = 1j * pair.normal
            board.mark(place, Segment(a=paper.mm(at) - 10 * t, b=paper.mm(at) + 10 * t, role=Role.HIDDEN))
        elif pair.form is Form.G:
            board.mark(place, *profile(pair, link, paper))
        else:
            board.mark(
                place,
                Arc(
                    centre=paper.mm(centre),
                    radius=abs(paper.mm(at) - paper.mm(centre)),
                    start=0.0,
                    sweep=6.283185307179586,
                    role=Role.HIDDEN,
                ),
            )
