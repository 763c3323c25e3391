"""How inner joints hang the links of an Assur group together: its class by its closed contours."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations


def class_of(links: tuple[str, ...], edges: list[tuple[str, str]]) -> str:
    """III where the inner joints close no contour; else the number of sides of the longest closed contour."""
    sides = max((len(loop) for loop in _loops(links, edges)), default=3)
    return {3: "III", 4: "IV", 5: "V", 6: "VI"}.get(sides, str(sides))


def _loops(links: tuple[str, ...], edges: list[tuple[str, str]]) -> Iterator[tuple[str, ...]]:
    """Closed contours: sets of links in which every link meets exactly two others."""
    for size in range(3, len(links) + 1):
        for loop in combinations(links, size):
            degree = [sum(name in edge and set(edge) <= set(loop) for edge in edges) for name in loop]
            if all(d == 2 for d in degree):
                yield loop


def connected(links: tuple[str, ...], edges: list[tuple[str, str]]) -> bool:
    """Whether the edges hang all the links together."""
    reached, before = {links[0]}, 0
    while len(reached) != before:
        before = len(reached)
        reached |= {name for a, b in edges if a in reached or b in reached for name in (a, b)}
    return reached == set(links)
