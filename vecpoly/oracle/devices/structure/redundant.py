"""The parts of a chain that bring redundant constraints, found by trial: what may go without the freedom changing."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain as every
from itertools import combinations

from ....devices.structure_pairs import FRAME, Chain, Form, Pair
from .rank import ranks

PART = 4  # links of a part that may be redundant


def removable(chain: Chain, surplus: int, drivers: set[str]) -> Chain:
    """The chain without what brings its surplus of constraints:
    pairs that repeat another between the same links, then parts of joined links.

    The smallest parts that bring a share of it, else parts that bring all;
    at last single pairs. As it is where none does.
    """
    if surplus == 0:
        return chain
    freedom = ranks(chain).freedom
    for rest in every(
        _without_double(chain),
        _without_share(chain, surplus, drivers),
        _without_part(chain, surplus, drivers),
        _without_pair(chain, surplus, drivers),
    ):
        found = ranks(rest)
        if found.freedom == freedom and found.redundant < surplus:
            return removable(rest, found.redundant, drivers)
    return chain


def _without_double(chain: Chain) -> Iterator[Chain]:
    """A pair less, of several between the same two links."""
    for pair in reversed(chain.pairs):
        if any(set(pair.links) == set(other.links) for other in chain.pairs if other is not pair):
            yield Chain(chain.links, tuple(other for other in chain.pairs if other is not pair))


def _without_part(chain: Chain, surplus: int, drivers: set[str]) -> Iterator[Chain]:
    """Joined links less, which bring the whole surplus:
    of bars as many as do, with those that only follow; else the smallest part."""
    free = [link for link in chain.links if link not in drivers]
    bars = [link for link in free if len(chain.at(link)) == 2 and all(pair.form is Form.R for pair in chain.at(link))]
    for links, counts in ((bars, range(PART, 0, -1)), (free, range(1, PART + 1))):
        for part in (part for count in counts for part in combinations(links, count)):
            rest = chain.without(part)
            if (
                _brought(chain, rest) - 3 * len(part) == surplus
                and _hangs(chain, part)
                and _sound(rest)
                and _whole(chain, part)
            ):
                yield rest


def _without_share(chain: Chain, surplus: int, drivers: set[str]) -> Iterator[Chain]:
    """Joined links less, which bring a share of the surplus; the smallest part first."""
    for count in range(1, PART + 1):
        for part in combinations([link for link in chain.links if link not in drivers], count):
            rest = chain.without(part)
            if (
                0 < _brought(chain, rest) - 3 * count < surplus
                and _hangs(chain, part)
                and _sound(rest)
                and _whole(chain, part)
            ):
                yield rest


def _without_pair(chain: Chain, surplus: int, drivers: set[str]) -> Iterator[Chain]:
    """A pair less; then a slide that no longer keeps its links from turning, the furthest from the drivers first."""
    for pair in chain.pairs:
        if (2 if pair.form.is_lower else 1) * pair.count <= surplus:
            yield Chain(chain.links, tuple(other for other in chain.pairs if other is not pair))
    far = _steps(chain, drivers)
    slides = [pair for pair in chain.pairs if pair.form is Form.P and not set(pair.links) <= {*drivers, FRAME}]
    for pair in sorted(slides, key=lambda pair: -min(far[link] for link in pair.links if link != FRAME)):
        on_line = Pair(
            letter=pair.letter,
            form=Form.H,
            links=pair.links,
            at=pair.at,
            about=(pair.at + 1j * pair.along * 1e-3, None),
        )
        yield Chain(chain.links, tuple(on_line if other is pair else other for other in chain.pairs))


def _brought(chain: Chain, rest: Chain) -> int:
    """How many constraints the rest has less."""
    return 2 * (chain.lower - rest.lower) + chain.higher - rest.higher


def _steps(chain: Chain, drivers: set[str]) -> dict[str, int]:
    """Pairs between each link and the nearest driver."""
    far, step = dict.fromkeys(drivers, 0), 0
    while (
        new := {link for pair in chain.pairs if far.keys() & set(pair.links) for link in pair.links}
        - far.keys()
        - {FRAME}
    ):
        step += 1
        far |= dict.fromkeys(new, step)
    return {link: far.get(link, len(chain.links)) for link in chain.links}


def _whole(chain: Chain, part: tuple[str, ...]) -> bool:
    """Whether no links of the part could go by themselves,
    as an Assur group that the surplus has nothing to do with."""
    for count in range(2, len(part), 2):
        for some in combinations(part, count):
            rest = chain.without(some)
            if 2 * (chain.lower - rest.lower) + chain.higher - rest.higher == 3 * count and _sound(rest):
                return False
    return True


def _sound(chain: Chain) -> bool:
    """No link hangs by a single pair."""
    return all(len(chain.at(link)) > 1 for link in chain.links)


def _hangs(chain: Chain, part: tuple[str, ...]) -> bool:
    """Whether the links of the part are joined among themselves,
    and not by slides alone (a wedge repeats nothing but what keeps it from turning)."""
    if all(pair.form is Form.P for pair in chain.pairs if pair.touches(part)):
        return False
    reached = {part[0]}
    for _ in part:
        reached |= {link for pair in chain.pairs if reached & set(pair.links) for link in pair.links if link in part}
    return reached == set(part)
