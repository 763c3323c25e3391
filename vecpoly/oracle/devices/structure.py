"""Exact answers about a structure: n, p_L, p_H from the shape of the Jacobian, F, F′, p′ from its rank, groups by
matching."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain as every
from itertools import combinations

from ...devices.structure import (
    DETERMINED,
    F_LOCAL,
    F_LOW,
    N_LOW,
    P_H,
    P_L,
    P_LOW,
    P_REDUNDANT,
    F,
    N,
    Structure,
    class_,
    groups,
)
from ...devices.structure_pairs import FRAME, Chain, Form, Pair
from ...errors import MobilityError
from ...words import Words
from .registry import Values, answers
from .structure_match import assur, rank_of
from .structure_rank import Ranks, dependent, determined, ranks

PART = 4  # links of a part that may be redundant


@answers(Structure)
def structure(device: Structure) -> Values:
    """Every count, class and number of groups."""
    chain = device.chain
    found = ranks(chain)
    values: dict[str, complex | float] = _counts(chain, found)
    if device.drivers:
        values[DETERMINED.key] = float(determined(chain, device.drive_sets[0]))
    low = without_high_pairs(reduced(chain, found, {link for drivers in device.drive_sets for link in drivers}))
    if device.touching:
        rows = ranks(low)
        values |= {N_LOW.key: rows.coordinates / 3, P_LOW.key: rows.constraints / 2, F_LOW.key: float(rows.freedom)}
    for drivers in device.drive_sets:
        parts = assur(low, drivers) if found.freedom == len(drivers) else None
        values[groups(drivers).key] = float(len(parts)) if parts is not None else 0.0
        values[class_(drivers).key] = (
            float(max((rank_of(low, part) for part in parts), default=1)) if parts is not None else 0.0
        )
    return values


def surplus(device: Structure) -> tuple[int, tuple[str, ...], tuple[str, ...]]:
    """How many constraints are redundant by rank; the pairs whose constraints depend on each other; links that may go
    without the motion changing."""
    found = ranks(device.chain)
    rest = reduced(device.chain, found, {link for drivers in device.drive_sets for link in drivers})
    gone = tuple(link for link in device.chain.links if link not in rest.links and link not in found.idle)
    return found.redundant, dependent(device.chain), gone


def _counts(chain: Chain, found: Ranks) -> dict[str, complex | float]:
    higher = sum(not pair.form.is_lower for pair in chain.pairs)
    return {
        N.key: found.coordinates / 3,
        P_L.key: (found.constraints - higher) / 2,
        P_H.key: float(higher),
        F_LOCAL.key: float(len(found.idle)),
        P_REDUNDANT.key: float(found.redundant),
        F.key: float(found.freedom),
    }


def reduced(chain: Chain, found: Ranks, drivers: set[str]) -> Chain:
    """The chain without idle rollers and without a part that is redundant."""
    for link in found.idle:
        chain = _welded(chain, link)
    return removable(chain, found.redundant, drivers)


def _welded(chain: Chain, link: str) -> Chain:
    """A roller as one piece with the link on which it is pinned."""
    carrier = next(
        (other for pair in chain.at(link) if pair.form is Form.R for other in pair.links if other != link), None
    )
    if carrier is None:
        raise MobilityError(
            Words(
                f"构件 {link} 能单独运动，却不是铰接在其他构件上的滚子；请用 R 副铰接，或去掉它",
                f"link {link} moves for itself, but is no roller pinned on another link: pin it with an R pair, "
                "or leave it out",
            )
        )
    pairs = []
    for pair in chain.pairs:
        links = (
            tuple(carrier if one == link else one for one in pair.links)
            if not pair.form.is_lower
            else tuple(one for one in pair.links if one != link)
        )
        if len(links) > 1:
            pairs.append(
                Pair(letter=pair.letter, form=pair.form, links=links, at=pair.at, along=pair.along, about=pair.about)
            )
    return Chain(tuple(one for one in chain.links if one != link), tuple(pairs))


def removable(chain: Chain, surplus: int, drivers: set[str]) -> Chain:
    """The chain without what brings its surplus of constraints: pairs that repeat another between the same links, then
    parts of joined links.

    The smallest parts that bring a share of it, else parts that bring all; at last single pairs. As it is where none
    does.
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
    """Joined links less, which bring the whole surplus: of bars as many as do, with those that only follow; else the
    smallest part."""
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
    """Whether no links of the part could go by themselves, as an Assur group that the surplus has nothing to do
    with."""
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
    """Whether the links of the part are joined among themselves, and not by slides alone (a wedge repeats nothing but
    what keeps it from turning)."""
    if all(pair.form is Form.P for pair in chain.pairs if pair.touches(part)):
        return False
    reached = {part[0]}
    for _ in part:
        reached |= {link for pair in chain.pairs if reached & set(pair.links) for link in pair.links if link in part}
    return reached == set(part)


def without_high_pairs(chain: Chain) -> Chain:
    """Every high pair as a link with two lower pairs, at the centres of curvature; of gears on the line of action at
    20°."""
    links, pairs = list(chain.links), []
    for i, pair in enumerate(chain.pairs):
        if pair.form.is_lower:
            pairs.append(pair)
            continue
        name = f"{pair.letter}*"
        links.append(name)
        pairs += [_end(pair, end, name, f"{pair.letter}{i}{end}") for end in (0, 1)]
    return Chain(tuple(links), tuple(pairs))


def _end(pair: Pair, end: int, name: str, letter: str) -> Pair:
    centre = pair.about[end]
    if centre is None:
        return Pair(letter=letter, form=Form.P, links=(name, pair.links[end]), at=pair.at, along=1j * pair.normal)
    if pair.form is Form.G:
        away = pair.at - centre
        centre += (
            away * (0.9396926207859084 + 0.3420201433256687j) * 0.9396926207859084
        )  # r cos 20° on the radius turned by 20°
    return Pair(letter=letter, form=Form.R, links=(pair.links[end], name), at=centre)
