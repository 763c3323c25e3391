"""Exact answers about a structure: n, p_L, p_H from the shape of the Jacobian, F, F′, p′ from its rank, groups by matching."""

from __future__ import annotations

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
from .registry import Values, answers
from .structure_match import assur, rank_of
from .structure_rank import Ranks, determined, ranks

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
        values[class_(drivers).key] = float(max((rank_of(low, part) for part in parts), default=1)) if parts is not None else 0.0
    return values


def _counts(chain: Chain, found: Ranks) -> dict[str, complex | float]:
    higher = sum(not pair.form.is_lower for pair in chain.pairs)
    return {N.key: found.coordinates / 3, P_L.key: (found.constraints - higher) / 2, P_H.key: float(higher),
            F_LOCAL.key: float(len(found.idle)), P_REDUNDANT.key: float(found.redundant), F.key: float(found.freedom)}


def reduced(chain: Chain, found: Ranks, drivers: set[str]) -> Chain:
    """The chain without idle rollers and without a part that is redundant."""
    for link in found.idle:
        chain = _welded(chain, link)
    return removable(chain, found.redundant, drivers)


def _welded(chain: Chain, link: str) -> Chain:
    """A roller as one piece with the link on which it is pinned."""
    carrier = next(other for pair in chain.at(link) if pair.form is Form.R for other in pair.links if other != link)
    pairs = []
    for pair in chain.pairs:
        links = tuple(carrier if one == link else one for one in pair.links) if not pair.form.is_lower else tuple(one for one in pair.links if one != link)
        if len(links) > 1:
            pairs.append(Pair(letter=pair.letter, form=pair.form, links=links, at=pair.at, along=pair.along, about=pair.about))
    return Chain(tuple(one for one in chain.links if one != link), tuple(pairs))


def removable(chain: Chain, surplus: int, drivers: set[str]) -> Chain:
    """The chain after the largest part of up to four joined links is taken away that brings the whole surplus of constraints, and no freedom."""
    if surplus == 0:
        return chain
    freedom = ranks(chain).freedom
    for count in range(PART, 0, -1):
        for part in combinations([link for link in chain.links if link not in drivers], count):
            rest = chain.without(part)
            brought = 2 * (chain.lower - rest.lower) + chain.higher - rest.higher
            if brought - 3 * count == surplus and _hangs(chain, part) and _sound(rest) and _whole(chain, part) and ranks(rest).freedom == freedom:
                return rest
    return _without_pair(chain, surplus, freedom, drivers)


def _without_pair(chain: Chain, surplus: int, freedom: int, drivers: set[str]) -> Chain:
    """The same with a single pair, or a single constraint of a slide after the other; the chain as it is where that does not do either."""
    for pair in chain.pairs:
        rest = Chain(chain.links, tuple(other for other in chain.pairs if other is not pair))
        if (2 if pair.form.is_lower else 1) * pair.count == surplus and ranks(rest).freedom == freedom:
            return rest
    for pair in chain.pairs:
        if pair.form is Form.P and not set(pair.links) <= {*drivers, FRAME}:
            on_line = Pair(letter=pair.letter, form=Form.H, links=pair.links, at=pair.at, about=(pair.at + 1j * pair.along * 1e-3, None))
            rest = Chain(chain.links, tuple(on_line if other is pair else other for other in chain.pairs))
            if ranks(rest).freedom == freedom:
                return rest if surplus == 1 else _without_pair(rest, surplus - 1, freedom, drivers)
    return chain


def _whole(chain: Chain, part: tuple[str, ...]) -> bool:
    """Whether no links of the part could go by themselves, as an Assur group that the surplus has nothing to do with."""
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
    """Whether the links of the part are joined among themselves."""
    reached = {part[0]}
    for _ in part:
        reached |= {link for pair in chain.pairs if reached & set(pair.links) for link in pair.links if link in part}
    return reached == set(part)


def without_high_pairs(chain: Chain) -> Chain:
    """Every high pair as a link with two lower pairs, at the centres of curvature; of gears on the line of action at 20°."""
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
        centre += away * (0.9396926207859084 + 0.3420201433256687j) * 0.9396926207859084  # r cos 20° on the radius turned by 20°
    return Pair(letter=letter, form=Form.R, links=(pair.links[end], name), at=centre)
