"""Assur groups taken off, on topology alone:
from the link furthest from the driver, two links at a time, more where two will not do."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations, pairwise

from ....devices.structure_pairs import FRAME, Chain, Form, Pair
from ....foundation.roman import chinese


@dataclass(frozen=True, slots=True, kw_only=True)
class Group:
    """An Assur group: its links, the pairs among them and those to the rest,
    its class, its letters (RRR ...; empty above class II)."""

    links: tuple[str, ...]
    inner: tuple[Pair, ...]
    outer: tuple[Pair, ...]
    rank: int
    kind: str

    @property
    def roman(self) -> str:
        """Its class as printed."""
        return chinese(self.rank)


@dataclass(frozen=True, slots=True)
class Taken:
    """The groups in the order in which they were taken off, and what was left:
    the drivers and the frame, if all is well."""

    groups: tuple[Group, ...]
    left: Chain

    @property
    def complete(self) -> bool:
        """Whether only drivers were left, each joined to the frame by one pair."""
        return bool(self.left.links) and self.left.lower == len(self.left.links)

    @property
    def rank(self) -> int:
        """The class of the mechanism: that of its highest group;
        drivers alone are class I; 0 where it could not be taken apart."""
        return max((group.rank for group in self.groups), default=1) if self.complete else 0


def take_apart(chain: Chain, drivers: tuple[str, ...]) -> Taken:
    """Take groups off a chain of lower pairs until none is found."""
    found: list[Group] = []
    while (group := next(_removable(chain, drivers), None)) is not None:
        found.append(group)
        chain = chain.without(group.links)
    alone = tuple(link for link in chain.links if link in drivers)
    return Taken(tuple(found), chain if alone == chain.links else Chain((), ()))


def _removable(chain: Chain, drivers: tuple[str, ...]) -> Iterator[Group]:
    """Groups that may come off next: the smallest first, of these the furthest from the driver."""
    far = distance(chain, drivers)
    links = sorted((link for link in chain.links if link not in drivers), key=lambda link: -far[link])
    for size in range(2, len(links) + 1, 2):
        for part in combinations(links, size):
            group = _group(chain, tuple(link for link in chain.links if link in part))
            if group is not None:
                yield group


def distance(chain: Chain, drivers: tuple[str, ...]) -> dict[str, int]:
    """How many pairs lie between a link and the nearest driver."""
    far = dict.fromkeys(drivers, 0)
    for step in range(1, len(chain.links) + 1):
        near = {
            link
            for pair in chain.pairs
            for link in pair.links
            if link != FRAME and any(other in far for other in pair.links if other != FRAME)
        }
        far |= {link: step for link in near if link not in far}
    return {link: far.get(link, len(chain.links)) for link in chain.links}


def _lost(chain: Chain, part: tuple[str, ...]) -> int:
    """How many pairs go with these links."""
    return chain.lower - chain.without(part).lower


def _group(chain: Chain, links: tuple[str, ...]) -> Group | None:
    """The group of just these links: 3k = 2p, hanging together, no part of it a structure or loose;
    None where it is not one."""
    if 2 * _lost(chain, links) != 3 * len(links):
        return None
    smaller = (part for count in range(1, len(links)) for part in combinations(links, count))
    if any(2 * _lost(chain, part) <= 3 * len(part) for part in smaller):
        return None
    inner, outer = _inside(chain, links), _outside(chain, links)
    if not _hang_together(links, inner) or all(pair.form is Form.P for pair in (*inner, *outer)):
        return None
    rank = 2 if len(links) == 2 else _class(links, inner)
    return Group(links=links, inner=inner, outer=outer, rank=rank, kind=_kind(inner, outer) if rank == 2 else "")


def _inside(chain: Chain, links: tuple[str, ...]) -> tuple[Pair, ...]:
    """The pairs with all their links in the group."""
    return tuple(pair for pair in chain.pairs if set(pair.links) <= set(links))


def _outside(chain: Chain, links: tuple[str, ...]) -> tuple[Pair, ...]:
    """The pairs with links in the group and links in the rest."""
    return tuple(pair for pair in chain.pairs if pair.touches(links) and not set(pair.links) <= set(links))


def _edges(inner: tuple[Pair, ...]) -> list[tuple[str, str]]:
    """The joined links two by two; a multiple joint in a row."""
    return [edge for pair in inner for edge in pairwise(pair.links)]


def _hang_together(links: tuple[str, ...], inner: tuple[Pair, ...]) -> bool:
    reached = {links[0]}
    for _ in links:
        reached |= {link for edge in _edges(inner) if reached & set(edge) for link in edge}
    return reached == set(links)


def _kind(inner: tuple[Pair, ...], outer: tuple[Pair, ...]) -> str:
    """Outer, inner, outer pair; R before P."""
    ends = sorted((pair.form.value for pair in outer), reverse=True)
    if len(ends) == 1:  # one multiple joint carries both links outside
        ends *= 2
    return f"{ends[0]}{inner[0].form.value}{ends[1]}" if inner and len(ends) == 2 else ""


def _class(links: tuple[str, ...], inner: tuple[Pair, ...]) -> int:
    """III where its pairs close no contour of links; else the sides of the longest one."""
    edges = _edges(inner)
    for sides in range(len(links), 3, -1):
        for loop in combinations(links, sides):
            if all(sum(link in edge and set(edge) <= set(loop) for edge in edges) == 2 for link in loop):
                return sides
    return 3
