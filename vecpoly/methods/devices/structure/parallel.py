"""Redundant constraints of parallel and equal links."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations

from ....devices.structure_pairs import FRAME, Chain, Form, Pair
from ....words import Words

MOST = 4  # links of a parallel part

Found = tuple[tuple[str, ...], Words]


@dataclass(frozen=True, slots=True)
class Bar:
    """A link with two hinges and nothing else."""

    link: str
    ends: tuple[Pair, Pair]

    @property
    def span(self) -> complex:
        """From the first hinge to the second."""
        return self.ends[1].at - self.ends[0].at


def bars(chain: Chain) -> tuple[Bar, ...]:
    """All links with two hinges and nothing else."""
    return tuple(
        Bar(link, (pairs[0], pairs[1]))
        for link in chain.links
        if len(pairs := chain.at(link)) == 2 and all(p.form is Form.R for p in pairs)
    )


def parallel(chain: Chain, near: float, drivers: tuple[str, ...]) -> Iterator[Found]:
    """Bars that move like other links, shifted by one and the same vector: the ends keep their distances without them.

    Every hinge of the part lies at the shift from a hinge of the rest; each of its bars is parallel and equal to a link
    of the rest, or lies along the shift; and where the part is pinned to the rest it is pinned to a link that never
    turns, which carries both hinges. The largest part comes first: with it go all links that only follow.
    """
    candidates = [bar for bar in bars(chain) if bar.link not in drivers and _has_twin(chain, bar, near)]
    for count in range(MOST, 0, -1):
        for part in reversed(list(combinations(candidates, count))):
            links = tuple(bar.link for bar in part)
            for shift in _shifts(part, chain, links):
                if abs(shift) > near and _shifted(chain, part, links, shift, near):
                    yield links, _why(chain, part, links, shift, near)
                    break


def _has_twin(chain: Chain, bar: Bar, near: float) -> bool:
    """Whether another link or the frame carries two hinges that lie as the bar's do."""
    for link in (FRAME, *chain.links):
        places = [pair.at for pair in chain.at(link) if pair.form is Form.R] if link != bar.link else []
        if any(abs(q - p - bar.span) < near for p in places for q in places):
            return True
    return False


def _shifts(part: tuple[Bar, ...], chain: Chain, links: tuple[str, ...]) -> Iterator[complex]:
    """Vectors from a hinge of the rest to the first hinge of the part."""
    first = part[0].ends[0]
    for pair in chain.pairs:
        if pair.form is Form.R and any(link not in links for link in pair.links):
            yield first.at - pair.at


def _shifted(chain: Chain, part: tuple[Bar, ...], links: tuple[str, ...], shift: complex, near: float) -> bool:
    """Whether the part, with this shift, only repeats."""
    rest = chain.without(links)
    still = never_turn(rest, near)
    hinges = {pair.letter: pair for bar in part for pair in bar.ends}
    moved = {letter for letter, pair in hinges.items() if _kept(pair, links, rest, still, shift, near)}
    return bool(moved) and all(_bar_kept(bar, rest, moved, shift, near) for bar in part)


def _kept(pair: Pair, links: tuple[str, ...], rest: Chain, still: tuple[str, ...], shift: complex, near: float) -> bool:
    """Whether the hinge, found at the shift from one of the rest, stays there without the part."""
    like = [p for p in rest.pairs if p.form is Form.R and abs(p.at + shift - pair.at) < near]
    holders = [link for link in pair.links if link not in links]
    if not holders:
        return bool(like)
    return any(link in still and any(link in p.links for p in like) for link in holders)


def _bar_kept(bar: Bar, rest: Chain, moved: set[str], shift: complex, near: float) -> bool:
    """Whether the bar's length is kept without it: it copies a link of the rest, or lies along the shift."""
    start, end = bar.ends
    if start.letter in moved and end.letter in moved:
        return any(
            _carries(rest, link, start.at - shift, near) and _carries(rest, link, end.at - shift, near)
            for link in rest.links
        )
    if start.letter not in moved and end.letter not in moved:
        return False
    far, root = (end, start) if end.letter in moved else (start, end)
    return abs(far.at - root.at - shift) < near and any(link in rest.links for link in root.links)


def _carries(chain: Chain, link: str, at: complex, near: float) -> bool:
    return any(p.form is Form.R and abs(p.at - at) < near for p in chain.at(link))


def never_turn(chain: Chain, near: float) -> tuple[str, ...]:
    """The frame, links that slide on one that never turns, couplers of parallelograms on one that never turns."""
    still = [FRAME]
    for _ in chain.links:
        for link in chain.links:
            if link not in still and (_slides(chain, link, still) or _on_equal_cranks(chain, link, still, near)):
                still.append(link)
    return tuple(still)


def _slides(chain: Chain, link: str, still: list[str]) -> bool:
    return any(p.form is Form.P and p.other(link) in still for p in chain.at(link))


def _on_equal_cranks(chain: Chain, link: str, still: list[str], near: float) -> bool:
    """Whether two parallel and equal cranks carry the link."""
    cranks = [span for crank in chain.links for span in _spans(chain, crank, link, still)]
    return any(abs(u - v) < near for u, v in combinations(cranks, 2))


def _spans(chain: Chain, crank: str, link: str, still: list[str]) -> Iterator[complex]:
    """The vectors of a crank from a link that never turns to this one."""
    if crank == link or crank in still:
        return
    hinges = [p for p in chain.at(crank) if p.form is Form.R]
    roots = [p for p in hinges if any(s in p.links for s in still)]
    tips = [p for p in hinges if link in p.links]
    yield from (tip.at - root.at for root in roots[:1] for tip in tips[:1])


def _why(chain: Chain, part: tuple[Bar, ...], links: tuple[str, ...], shift: complex, near: float) -> Words:
    """Which lines are parallel and equal."""
    rest = chain.without(links)
    letters = list(dict.fromkeys(pair.letter for bar in part for pair in bar.ends))
    places = {pair.letter: pair.at for bar in part for pair in bar.ends}
    twins = {
        letter: next(
            (p.letter for p in rest.pairs if p.form is Form.R and abs(p.at + shift - places[letter]) < near), ""
        )
        for letter in letters
    }
    lines = [twins[letter] + letter for letter in letters if twins[letter]]
    told = f"${' ∥ '.join(lines)}$"
    same = f"${' = '.join(lines)}$"
    return Words(
        f"{told} 且 {same}，去掉构件 {'、'.join(links)} 后，它们所连接的各点之间的距离仍保持不变，"
        "这部分对运动不起独立的约束作用",
        f"since {told} and {same}, without link{'s' * (len(links) > 1)} {', '.join(links)} the points "
        "that they join keep their distances all the same, and this part adds nothing to the "
        "motion",
    )
