"""A chain of links by its pairs alone, where no dimensions are given: structural sketches and Assur groups apart.

The same bars, plates, blocks, guides and pivots as of a mechanism that is posed.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Protocol

from ..board.paper.marks import Block, Dot, Ground, LinkNumber, Mark, Point, Role, Segment, Weld
from ..board.paper.symbols import Symbol
from ..mechanism.joints import FRAME
from ..names import subscripted
from ..plane import nearest_between
from .bars import bar, hull
from .guides import HALF_BLOCK, bush, rail_under, through
from .owners import FIXED, joint
from .owners import link as owner
from .pins import lines_of, passing, welds
from .posed import Way
from .profiles import FACE, Touching, is_hollow, profile, round_of

NEAR = 0.3  # mm: places closer than this are one
BEYOND, HALF_GUIDE, HALF_WAY = 13.0, 11.0, 14.0  # mm: a rod goes on past its block; half a fixed guide, a way alone
INWARD = 2.0  # mm from the end of a fixed guide, beside which its letter stands
NEXT = 6.5  # mm from the middle of a block: there a rod has the letter of the pair, just outside the block
Rod = Segment | Weld  # a rod, the arms beside it, and the marks of their rigid corners
DOWNS = (-1j, 1j, 1 + 0j, -1 + 0j)


class Joined(Touching, Protocol):
    """One pair of the chain on paper (mm). links: of a hinge all that are pinned; of a slide the block, its guide."""

    @property
    def letter(self) -> str: ...

    @property
    def hinged(self) -> bool: ...

    @property
    def slides(self) -> bool: ...

    @property
    def along(self) -> complex: ...


class Chained(Protocol):
    """Pairs between links and the frame."""

    @property
    def pairs(self) -> Sequence[Joined]: ...

    def at(self, link: str) -> Sequence[Joined]:
        """The pairs of a link."""
        ...


@dataclass(frozen=True, slots=True)
class Sketched:
    """A chain on paper (mm), and the numbers of its links as printed; ringed: whether compound hinges are marked.

    whole: the chain that was given, where this is what is left of it: each guide has the side that it has there.
    gone: links that were taken off before: a place where one of them alone was pinned is a point of its link.
    """

    chain: Chained
    number: Callable[[str], str]
    ringed: bool = False
    whole: Chained | None = None
    gone: frozenset[str] = frozenset()

    def drawn(self, links: tuple[str, ...], *, frame: bool) -> Iterator[Symbol]:
        """These links with their joints, and with the frame where they stand on it."""
        for link in links:
            yield Symbol.of(owner(link), self._body(link))
        for pair in self.chain.pairs:
            if set(pair.links) & set(links):
                yield from self._joint(pair, frame)
                yield from self._rigid(pair, links, frame)

    def down(self, pair: Joined) -> complex:
        """The side of a pivot on which fewest links lie; below where it does not matter."""
        links = (link for link in pair.links if link != FRAME)
        ways = [p.at - pair.at for link in links for p in self.chain.at(link) if p.hinged or p.slides]
        units = [w / abs(w) for w in ways if abs(w) > NEAR]
        free = [down for down in DOWNS if all((down.conjugate() * u).real < 0.8 for u in units)]
        return free[0] if free else DOWNS[0]

    # -- links --------------------------------------------------------------------------------------------------

    def _body(self, link: str) -> Iterator[Mark]:
        """A moving link with its number: what joins its hinges, its profiles, and its guide."""
        pairs = self.chain.at(link)
        profiles = [pair for pair in pairs if not (pair.hinged or pair.slides)]
        for pair in profiles:
            yield from profile(pair, link)
        points = _points(pairs, link)
        rods = [rod for pair in pairs if pair.slides and pair.links[1] == link for rod in _rod(pair, points)]
        rods += [rod for pair in profiles if round_of(pair, link)[0] is None for rod in _face(pair, points)]
        yield from rods or (bar(points) if len(points) > 1 else ())
        yield self._numbered(link, points, rods, profiles)

    def _numbered(self, link: str, points: list[complex], rods: list[Rod], profiles: list[Joined]) -> LinkNumber:
        """Its number beside its longest line; within its profile or beside its block where it has no line."""
        number, block = self.number(link), self._pinned_block(link)
        if block is not None:
            return LinkNumber(a=block, b=block, number=number)
        lines = [(rod.a, rod.b) for rod in rods if isinstance(rod, Segment)]
        if not lines and len(points) > 1:
            corners = hull(points) if len(points) > 2 else tuple(points)
            lines = list(zip(corners, corners[1:] + corners[:1], strict=True))
        if lines:
            a, b = max(lines, key=lambda ab: abs(ab[1] - ab[0]))
            return LinkNumber(a=a, b=b, number=number)
        if profiles:
            centre, radius = max((round_of(pair, link) for pair in profiles), key=lambda cr: cr[1])
            at = (centre or 0j) + (0.55 * radius if radius > 8 else 0.0) * cmath.rect(1.0, -2.2)
            return LinkNumber(a=at, b=at, number=number)
        return LinkNumber(a=points[0], b=points[0], number=number)

    def _pinned_block(self, link: str) -> complex | None:
        """Where another link is pinned in a block of the link: there the number is needed, not along the bar."""
        pairs = self.chain.at(link)
        blocks = [pair.at for pair in pairs if pair.slides and pair.links[0] == link]
        return next((at for at in blocks if any(p.hinged and abs(p.at - at) < NEAR for p in pairs)), None)

    # -- joints -------------------------------------------------------------------------------------------------

    def _joint(self, pair: Joined, frame: bool) -> Iterator[Symbol]:
        own = joint(pair.letter)
        if pair.slides:
            yield from self._slide(pair, frame)
            yield Symbol.of(own, (Point(at=self._lettered(pair, frame), label=subscripted(pair.letter), dot=Dot.NONE),))
            return
        if frame and FRAME in pair.links:
            ground = (Ground(at=pair.at, down=self.down(pair)),)
            yield Symbol.of(FIXED, ground if pair.hinged else profile(pair, FRAME))
        dot = (Dot.MULTIPLE if self.ringed and len(pair.links) > 2 else Dot.JOINT) if self._held(pair) else Dot.POINT
        yield Symbol.of(own, (Point(at=pair.at, label=subscripted(pair.letter), dot=dot),))

    def _held(self, pair: Joined) -> bool:
        """Whether a pin still joins links."""
        return pair.hinged and len({*pair.links} - self.gone) > 1

    def _lettered(self, pair: Joined, frame: bool) -> complex:
        """Where a sliding pair has its letter: at the block; where that has a pin, at the free end of a fixed guide or
        of its line, on a rod just outside the block."""
        pinned = [p for p in self.chain.pairs if p.hinged and abs(p.at - pair.at) < NEAR]
        links = {link for p in pinned for link in p.links if link not in (FRAME, *pair.links)}
        ways = sum((p.at - pair.at for link in links for p in self.chain.at(link)), 0j)
        ahead = -1 if (pair.along.conjugate() * ways).real > 0 else 1
        if not pinned or pair.links[1] != FRAME or not frame:
            off = (HALF_WAY if pair.links[1] == FRAME else NEXT) if pinned else 0.0
            return pair.at + off * ahead * pair.along
        aside = 1j * pair.along * HALF_BLOCK * (1 if self._leans_right(pair) else -1)
        return pair.at + ahead * pair.along * (HALF_GUIDE - INWARD) + aside

    def _slide(self, pair: Joined, frame: bool) -> Iterator[Symbol]:
        """A block on a fixed guide, a sleeve on a rod, a rod in a fixed sleeve."""
        block, guide = pair.links
        if block == FRAME:
            yield Symbol.of(FIXED, bush(pair.at, pair.along) if frame else ())
            return
        if guide == FRAME:
            along = -pair.along if frame and self._leans_right(pair) else pair.along
            yield Symbol.of(FIXED, (rail_under(pair.at, along, HALF_GUIDE) if frame else _way(pair),))
        yield Symbol.of(owner(block), (_block(pair),))

    # -- what is one link ---------------------------------------------------------------------------------------

    def _rigid(self, pair: Joined, links: tuple[str, ...], frame: bool) -> Iterator[Symbol]:
        """Where a link of these runs on past the pin; where its bars leave its block."""
        seen = [link for link in pair.links if link in links or (frame and link == FRAME)]
        for link in (link for link in seen if link != FRAME and (self._held(pair) or pair.slides)):
            lines = tuple(lines_of(self._body(link)))
            if pair.hinged:
                others = [other for other in seen if other != link]
                ways = [p.at - pair.at for other in others if other != FRAME for p in self.chain.at(other)]
                ways += [self.down(pair)] * (FRAME in others)
                yield Symbol.of(owner(link), passing(pair.at, lines, ways))
            elif link == pair.links[0]:
                yield Symbol.of(owner(link), welds((_block(pair),), lines))

    def _leans_right(self, pair: Joined) -> bool:
        """Whether what hangs on the block lies to the right of its guide, where the hatching would be."""
        given = next((p for p in self.whole.pairs if p.letter == pair.letter), None) if self.whole else None
        chain, pair = (self.whole, given) if self.whole and given else (self.chain, pair)
        block = pair.links[0]
        beside = [p.at for p in chain.at(block)]
        pinned = (p for p in chain.at(block) if p.hinged and abs(p.at - pair.at) < NEAR)
        beside += [
            q.at for p in pinned for link in p.links if link not in (FRAME, block) for q in chain.at(link) if q is not p
        ]
        away = ((z - pair.at) / max(abs(z - pair.at), 1.0) for z in beside)
        return sum((pair.along.conjugate() * z).imag for z in away) < 0


def _block(pair: Joined) -> Block:
    return Block(at=pair.at, along=pair.along, on_rod=pair.links[1] != FRAME)


def _way(pair: Joined) -> Segment:
    """The way of a block whose fixed guide is not drawn."""
    return Segment(a=pair.at - pair.along * HALF_WAY, b=pair.at + pair.along * HALF_WAY, role=Role.CENTRE)


def _rod(pair: Joined, points: list[complex]) -> Iterator[Rod]:
    return through(Way(pair.at, pair.along), pair.at, BEYOND, points)


def _face(pair: Joined, points: list[complex]) -> Iterator[Rod]:
    return through(Way(pair.at, 1j * pair.normal), pair.at, FACE, points)


def _points(pairs: Sequence[Joined], link: str) -> list[complex]:
    """The places that the link's lines join, each once."""
    found: list[complex] = []
    solid = [p.at for p in pairs if p.hinged or p.slides or (not p.meshes and round_of(p, link)[0] is None)]
    for pair in pairs:
        if pair.hinged or (pair.slides and pair.links[0] == link):
            found.append(pair.at)
        elif not pair.slides and not pair.meshes:
            centre, radius = round_of(pair, link)
            if centre is None:
                continue
            if is_hollow(pair, link):
                found.append(pair.at)
            elif not _on_body(centre, radius, solid):
                found.append(centre)
    return _once(found)


def _on_body(centre: complex, radius: float, solid: list[complex]) -> bool:
    """Whether a disc holds a joint of its link, or a part of the line between two."""
    lines = ((a, b) for a in solid for b in solid if abs(b - a) > NEAR)
    held = any(abs(h - centre) < radius for h in solid)
    return held or any(abs(centre - nearest_between(a, b, centre)) < radius for a, b in lines)


def _once(places: list[complex]) -> list[complex]:
    kept: list[complex] = []
    for place in places:
        if all(abs(place - other) > NEAR for other in kept):
            kept.append(place)
    return kept
