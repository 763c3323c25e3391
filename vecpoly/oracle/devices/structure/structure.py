"""Exact answers about a structure: n, p_L, p_H from the shape of the Jacobian,
F, F′, p′ from its rank, groups by matching."""

from __future__ import annotations

from ....devices.structure import Structure
from ....devices.structure_named import (
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
    class_,
    groups,
)
from ....devices.structure_pairs import Chain, Form, Pair
from ....errors import MobilityError
from ....words import Words
from ..registry import Values, answers
from .lower import without_high_pairs
from .match import assur, rank_of
from .rank import Ranks, dependent, determined, ranks
from .redundant import removable


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
    """How many constraints are redundant by rank; the pairs whose constraints depend on each other;
    links that may go without the motion changing."""
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
