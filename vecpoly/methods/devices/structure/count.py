"""Counting, as a lecturer counts: links, pairs, multiple joints,
rollers that turn idly, parts that repeat a constraint."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from ....devices.structure_pairs import Chain, Form, Pair
from .repeated import Repeated, repeated

SAME = 5e-5  # share of the sketch within which two places are one


@dataclass(frozen=True, slots=True, kw_only=True)
class Roller:
    """A link pinned once that touches once, its profile round about its pin:
    it may turn without anything else moving."""

    link: str
    pin: Pair
    contact: Pair

    @property
    def carrier(self) -> str:
        """The link on which it is pinned, to which it may be welded."""
        return next(link for link in self.pin.links if link != self.link)


@dataclass(frozen=True, slots=True, kw_only=True)
class Count:
    """What was found:
    in the chain as given, and the chain left when rollers are welded and repeated parts taken away."""

    given: Chain
    compound: tuple[Pair, ...]
    rollers: tuple[Roller, ...]
    repeated: tuple[Repeated, ...]
    reduced: Chain

    @property
    def redundant(self) -> int:
        """p′ of all repeated parts."""
        return sum(part.redundant for part in self.repeated)

    @property
    def freedom(self) -> int:
        """F = 3n − 2p_L − p_H − F′ + p′."""
        return freedom(self.given) - len(self.rollers) + self.redundant


def freedom(chain: Chain) -> int:
    """3n − 2p_L − p_H."""
    return 3 * len(chain.links) - 2 * chain.lower - chain.higher


def count(chain: Chain, drivers: tuple[str, ...] = ()) -> Count:
    """Count a chain as it is drawn; drivers are never taken for repeated parts."""
    rollers = tuple(_rollers(chain))
    welded = chain
    for roller in rollers:
        welded = _welded(welded, roller)
    parts: list[Repeated] = []
    reduced, near = welded, SAME * size(chain)
    while (part := repeated(reduced, near, drivers)) is not None:
        parts.append(part)
        reduced = part.rest
    compound = tuple(pair for pair in chain.pairs if pair.form is Form.R and pair.count > 1)
    return Count(given=chain, compound=compound, rollers=rollers, repeated=tuple(parts), reduced=reduced)


def size(chain: Chain) -> float:
    """The largest distance between two joints (m)."""
    return max((abs(p.at - q.at) for p in chain.pairs for q in chain.pairs), default=0.0) or 1.0


def _rollers(chain: Chain) -> Iterator[Roller]:
    """Every roller: the common normal passes through its pin, so that its turning moves nothing."""
    near = SAME * size(chain)
    for link in chain.links:
        pairs = chain.at(link)
        if sorted(pair.form.value for pair in pairs) != ["H", "R"]:
            continue
        pin, contact = sorted(pairs, key=lambda pair: pair.form is Form.H)
        centre = contact.about[contact.links.index(link)]
        if centre is not None and abs(centre - pin.at) < near:
            yield Roller(link=link, pin=pin, contact=contact)


def _welded(chain: Chain, roller: Roller) -> Chain:
    """The chain with the roller as one piece with its carrier."""
    links = tuple(roller.carrier if link == roller.link else link for link in roller.contact.links)
    contact = Pair(
        letter=roller.contact.letter, form=Form.H, links=links, at=roller.contact.at, about=roller.contact.about
    )
    touching = tuple(contact if pair.letter == contact.letter else pair for pair in chain.pairs)
    return Chain(chain.links, touching).without((roller.link,))
