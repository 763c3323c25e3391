"""Redundant constraints by the textbook's marks:
a part that only repeats what others see to already, as long as the sizes are exact.

p′ = 2p_L′ + p_H′ − 3n′ of the part: as many constraints as it brings beyond the freedoms of its own links.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations

from ....devices.structure_pairs import FRAME, Chain, Form, Pair
from ....names import subscripted
from ....words import Words
from .distance import kept, twins
from .groups import distance
from .mirror import mirrored
from .parallel import parallel
from .tracks import trammel


@dataclass(frozen=True, slots=True, kw_only=True)
class Repeated:
    """A part that repeats constraints: its links, the letters of its pairs, why, and the chain without it."""

    links: tuple[str, ...]
    letters: tuple[str, ...]
    why: Words
    before: Chain
    rest: Chain

    @property
    def lower(self) -> int:
        """p_L′."""
        return self.before.lower - self.rest.lower

    @property
    def higher(self) -> int:
        """p_H′."""
        return self.before.higher - self.rest.higher

    @property
    def redundant(self) -> int:
        """p′ = 2p_L′ + p_H′ − 3n′."""
        return 2 * self.lower + self.higher - 3 * len(self.links)


def repeated(chain: Chain, near: float, drivers: tuple[str, ...]) -> Repeated | None:
    """The first part that repeats constraints, without a driver;
    None where nothing does. near: places closer than this (m) are one."""
    for pair, why in _twice(chain, near):
        return Repeated(
            links=(),
            letters=(pair.letter,),
            why=why,
            before=chain,
            rest=Chain(chain.links, tuple(p for p in chain.pairs if p is not pair)),
        )
    for links, why in (
        found
        for pattern in (twins, _copies, parallel, kept, trammel, mirrored)
        for found in pattern(chain, near, drivers)
    ):
        rest = chain.without(links)
        part = Repeated(
            links=links,
            letters=tuple(p.letter for p in chain.pairs if p.touches(links)),
            why=why,
            before=chain,
            rest=rest,
        )
        if part.redundant > 0:
            return part
    return _common(chain, near, drivers)


def _twice(chain: Chain, near: float) -> Iterator[tuple[Pair, Words]]:
    """Two pairs of a kind between the same two links:
    guides with one direction, hinges with one axis, contacts with one normal."""
    for one, two in combinations(chain.pairs, 2):
        if set(one.links) != set(two.links) or one.form is not two.form or len(one.links) > 2:
            continue
        a, b = subscripted(one.letter), subscripted(two.letter)
        if one.form is Form.P and _level(one.along, two.along):
            yield (
                two,
                Words(
                    f"移动副 ${a}$、${b}$ 连接同样两个构件且导路平行，只有一个起独立约束作用",
                    f"prismatic joints ${a}$ and ${b}$ join the same two links, and their guides are "
                    "parallel: only one of them constrains",
                ),
            )
        if one.form is Form.R and abs(one.at - two.at) < near:
            yield (
                two,
                Words(
                    f"转动副 ${a}$、${b}$ 连接同样两个构件且轴线重合，只有一个起独立约束作用",
                    f"revolute joints ${a}$ and ${b}$ join the same two links on one axis: only one of them constrains",
                ),
            )
        if one.form is Form.H and _level(one.normal, two.normal) and _same_profiles(one, two, near):
            yield (
                two,
                Words(
                    f"高副 ${a}$、${b}$ 连接同样两个构件且公法线重合，只有一个起独立约束作用",
                    f"higher pairs ${a}$ and ${b}$ join the same two links with one common normal: "
                    "only one of them constrains",
                ),
            )


def _same_profiles(one: Pair, two: Pair, near: float) -> bool:
    """Whether two contacts are of profiles about the same centres, or of opposite flat faces:
    a cam of constant breadth."""
    pairs = [(one.about[one.links.index(link)], two.about[two.links.index(link)]) for link in one.links]
    return all((a is None and b is None) or (a is not None and b is not None and abs(a - b) < near) for a, b in pairs)


def _slides_round(chain: Chain) -> tuple[Pair, ...]:
    """The slides that close a ring of slides: without one of them the others still keep its links from turning."""
    slides = tuple(pair for pair in chain.pairs if pair.form is Form.P)
    return tuple(
        pair
        for pair in slides
        if pair.links[1] in _reached(pair.links[0], [other.links for other in slides if other is not pair])
    )


def _reached(start: str, edges: list[tuple[str, ...]]) -> set[str]:
    found = {start}
    while new := {link for edge in edges if found & set(edge) for link in edge} - found:
        found |= new
    return found


def _common(chain: Chain, near: float, drivers: tuple[str, ...]) -> Repeated | None:
    """A ring of slides alone (a pair of wedges):
    no link of it turns, and one of the slides, far from the driver, need not see to it."""
    far = distance(chain, drivers) | {FRAME: len(chain.links)}
    pair = max(_slides_round(chain), key=lambda pair: min(far[link] for link in pair.links), default=None)
    if pair is None:
        return None
    eased = Pair(
        letter=pair.letter,
        form=Form.H,
        links=pair.links,
        at=pair.at,
        about=(pair.at + 200 * near * 1j * pair.along, None),
    )
    d = subscripted(pair.letter)
    why = Words(
        f"移动副 ${d}$ 与其他移动副组成只含移动副的封闭形，各构件的转动已被其他移动副限制，"
        "它对转动的限制是重复的（公共约束）",
        f"prismatic joint ${d}$ closes a loop of prismatic joints alone: the others keep its links from turning "
        "already, and it need only keep them on the line",
    )
    return Repeated(
        links=(),
        letters=(pair.letter,),
        why=why,
        before=chain,
        rest=Chain(chain.links, tuple(eased if p is pair else p for p in chain.pairs)),
    )


def _copies(chain: Chain, near: float, drivers: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], Words]]:
    """A link with higher pairs that does what another does: a second planet between the same wheels."""
    for one, two in combinations(chain.links, 2):
        mine, its = chain.at(one), chain.at(two)
        spare = sum(pair.count for pair in its) == len(its)  # nothing else is pinned where it is pinned
        if (
            two not in drivers
            and len(mine) == len(its)
            and spare
            and any(not p.form.is_lower for p in its)
            and _matched(mine, its, one, two, near)
        ):
            yield (
                (two,),
                Words(
                    f"构件 {two} 与构件 {one} 连接同样的构件，且尺寸相同、位置对称，为传力均衡而重复设置，"
                    "对运动不起独立的约束作用",
                    f"link {two} joins the same links as link {one}, with the same sizes: it is "
                    "there to share the load, and adds nothing to the motion",
                ),
            )


def _matched(mine: tuple[Pair, ...], its: tuple[Pair, ...], one: str, two: str, near: float) -> bool:
    """Whether every pair of one link has its like on the other."""
    free = list(its)
    for pair in mine:
        twin = next((p for p in free if _alike(pair, p, one, two, near)), None)
        if twin is None:
            return False
        free.remove(twin)
    return True


def _alike(pair: Pair, twin: Pair, one: str, two: str, near: float) -> bool:
    """The same kind of pair with the same third link; gears with the same radii about the same far centre."""
    if pair.form is not twin.form or not {*pair.links} - {one} & {*twin.links} - {two}:
        return False
    if pair.form is not Form.G:
        return pair.form is Form.R
    return abs(_radius(pair, one) - _radius(twin, two)) < near and abs(_centre(pair, one) - _centre(twin, two)) < near


def _radius(pair: Pair, link: str) -> float:
    return abs(pair.at - (pair.about[pair.links.index(link)] or 0j))


def _centre(pair: Pair, link: str) -> complex:
    """The centre of the wheel that meshes with the link's."""
    return pair.about[1 - pair.links.index(link)] or 0j


def _level(u: complex, v: complex) -> bool:
    return abs((u.conjugate() * v).imag) < 1e-4


def brings(part: Repeated) -> Words:
    """What the part consists of; a slide that is eased counts as a higher pair afterwards."""
    if part.higher < 0:
        return Words(
            "。它只须起一个高副的作用，虚约束数为：",
            ". It need do no more than a higher pair; the number of its redundant constraints is:",
        )
    one = Words("，是虚约束。", ": redundant. ")
    if not part.links:
        return one + Words("虚约束数为：", "The number of its redundant constraints is:")
    return one + Words(
        f"这部分有 {len(part.links)} 个构件、{part.lower} 个低副、{part.higher} 个高副，虚约束数为：",
        f"It has {len(part.links)} link{'s' * (len(part.links) != 1)}, {part.lower} lower "
        f"and {part.higher} higher pairs; the number of its redundant constraints is:",
    )
