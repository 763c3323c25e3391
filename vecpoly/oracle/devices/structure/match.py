"""Assur groups by matching: every coordinate is given a constraint of its own;
coordinates that wait for each other are one group.

Unknowns are the links (3 each) and the hinge points (2 each). A pin gives two equations between a point and a link, a
slide two between two links. In a matching of equations to unknowns each unknown depends on those in its equations; the
strongly connected parts of that graph are the Assur groups (Dulmage and Mendelsohn).
"""

from __future__ import annotations

from collections.abc import Iterator

from ....devices.structure_pairs import FRAME, Chain, Form

Graph = dict[str, set[str]]


def assur(chain: Chain, drivers: tuple[str, ...]) -> tuple[tuple[str, ...], ...] | None:
    """The links of every group of a chain of lower pairs; None where drivers and pairs do not determine it."""
    known = {FRAME, *drivers}
    equations = [unknowns for unknowns in _equations(chain, known) if unknowns]
    needs = _needs(equations)
    if sum(needs.values()) != len(equations):
        return None
    owner = _matching(equations, needs)
    if owner is None:
        return None
    depends: Graph = {unknown: set() for unknown in needs}
    for unknowns, mine in zip(equations, owner, strict=True):
        depends[mine] |= set(unknowns) - {mine}
    parts = (tuple(link for link in chain.links if f"link {link}" in part) for part in _strong(depends))
    return tuple(sorted(part for part in parts if part))


def _equations(chain: Chain, known: set[str]) -> Iterator[tuple[str, ...]]:
    """The unknowns in every equation between links and points that the chain does not know from the start."""
    for pair in chain.pairs:
        free = [f"link {link}" for link in pair.links if link not in known]
        if pair.form is Form.R:
            point = [] if len(free) < len(pair.links) else [f"point {pair.letter}"]
            for link in free:
                yield from ((link, *point),) * 2
        else:
            yield from (tuple(free),) * 2


def _needs(equations: list[tuple[str, ...]]) -> dict[str, int]:
    """How many equations each unknown needs."""
    return {unknown: 3 if unknown.startswith("link") else 2 for unknowns in equations for unknown in unknowns}


def _matching(equations: list[tuple[str, ...]], needs: dict[str, int]) -> list[str] | None:
    """Which unknown each equation settles; None where it cannot be done."""
    owner: list[str | None] = [None] * len(equations)
    held: dict[str, list[int]] = {unknown: [] for unknown in needs}

    def seat(equation: int, seen: set[str]) -> bool:
        for unknown in equations[equation]:
            if unknown in seen:
                continue
            seen.add(unknown)
            if len(held[unknown]) < needs[unknown]:
                held[unknown].append(equation)
                owner[equation] = unknown
                return True
            for i, other in enumerate(held[unknown]):
                if seat(other, seen):
                    held[unknown][i] = equation
                    owner[equation] = unknown
                    return True
        return False

    for equation in range(len(equations)):
        if not seat(equation, set()):
            return None
    return [one for one in owner if one is not None]


def _strong(depends: Graph) -> list[set[str]]:
    """Strongly connected parts: unknowns that reach each other."""
    reach = {start: _reached(depends, start) for start in depends}
    parts: list[set[str]] = []
    for unknown in depends:
        if not any(unknown in part for part in parts):
            parts.append({other for other in depends if other in reach[unknown] and unknown in reach[other]})
    return parts


def _reached(depends: Graph, start: str) -> set[str]:
    found, rest = {start}, [start]
    while rest:
        new = depends[rest.pop()] - found
        found |= new
        rest += new
    return found


def rank_of(chain: Chain, links: tuple[str, ...]) -> int:
    """Class of a group: 2 of two links;
    else the sides of its longest contour without a chord, and 3 where there is none."""
    if len(links) == 2:
        return 2
    beside: Graph = {link: set() for link in links}
    for pair in chain.pairs:
        if set(pair.links) <= set(links):
            for a, b in zip(pair.links, pair.links[1:], strict=False):
                beside[a].add(b)
                beside[b].add(a)
    return max([3, *(len(path) for link in links for path in _contours(beside, (link,)))])


def _contours(beside: Graph, path: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    """Closed ways from the first link of the path, no link of which touches another but its neighbours."""
    for link in beside[path[-1]]:
        if link == path[0] and len(path) > 3:
            yield path
        elif link not in path and not any(link in beside[other] for other in path[1:-1]):
            if link in beside[path[0]] and len(path) > 1:
                if len(path) > 2:
                    yield (*path, link)
            else:
                yield from _contours(beside, (*path, link))
