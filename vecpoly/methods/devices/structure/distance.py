"""Redundant constraints of bars between two points that keep their distance without them (距离不变),
and of links that stand twice."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from ....devices.structure_pairs import FRAME, Chain, Form, Pair
from ....names import subscripted
from ....words import Words
from .parallel import Bar, Found, bars


def twins(chain: Chain, near: float, drivers: tuple[str, ...]) -> Iterator[Found]:
    """A link beside another: joined to the same links in the same places."""
    for one, two in combinations(chain.links, 2):
        if two in drivers:
            one, two = two, one
        mine, its = list(chain.at(one)), chain.at(two)
        if two in drivers or len(its) > len(mine):
            continue
        likes = [next((pair for pair in mine if _beside(pair, twin, one, two, near)), None) for twin in its]
        if len(its) > 1 and all(likes) and len(set(map(id, likes))) == len(its):
            yield (
                (two,),
                Words(
                    f"构件 {two} 与构件 {one} 并列，在相同的位置连接同样的构件，为改善受力而重复设置，"
                    "对运动不起独立的约束作用",
                    f"link {two} stands beside link {one} and joins the same links in the same "
                    "places: it is there to share the load, and adds nothing to the motion",
                ),
            )


def _beside(pair: Pair, twin: Pair, one: str, two: str, near: float) -> bool:
    """Whether two lower pairs are one joint of the same third link."""
    if pair.form is not twin.form or not pair.form.is_lower or abs(pair.at - twin.at) > near:
        return False
    level = pair.form is Form.R or (
        abs((pair.along.conjugate() * twin.along).imag) < 1e-4 and pair.links.index(one) == twin.links.index(two)
    )
    return level and bool({*pair.links} & {*twin.links} - {one, two})


def kept(chain: Chain, near: float, drivers: tuple[str, ...]) -> Iterator[Found]:
    """A bar between two points of one link, or along the third side of a parallelogram."""
    for bar in reversed(bars(chain)):
        if bar.link in drivers:
            continue
        start, end = bar.ends
        here, there = (_resting(chain, hinge, bar.link, near) for hinge in bar.ends)
        shared = [link for link in here if link in there]
        a, b = subscripted(start.letter), subscripted(end.letter)
        if shared:
            which = (
                Words("机架", "the frame") if shared[0] == FRAME else Words(f"构件 {shared[0]}", f"link {shared[0]}")
            )
            yield (
                (bar.link,),
                Words(f"${a}$、${b}$ 是", f"${a}$ and ${b}$ are points of ")
                + which
                + Words(
                    f"上的两点，其间距离本来不变，用双转动副构件 {bar.link} 连接这两点不起独立的约束作用",
                    f", which keep their distance without bar {bar.link}",
                ),
            )
        yield from _third_sides(chain, bar, near)


def _resting(chain: Chain, hinge: Pair, but: str, near: float) -> list[str]:
    """The links of which the place of a hinge is a point: those that it joins, and those that another hinge in the same
    place joins to these."""
    found = [link for link in hinge.links if link != but]
    alike = [
        pair for pair in chain.pairs if pair.form is Form.R and pair is not hinge and abs(pair.at - hinge.at) < near
    ]
    while new := [
        link for pair in alike if {*pair.links} & {*found} for link in pair.links if link not in (*found, but)
    ]:
        found += dict.fromkeys(new)
    return found


def _third_sides(chain: Chain, bar: Bar, near: float) -> Iterator[Found]:
    """Its links p and q are joined already by two others, parallel and equal to it: they turn alike."""
    start, end = bar.ends
    for p in start.links:
        for q in end.links:
            sides = _sides(chain, p, q, bar, near) if len({p, q, bar.link}) == 3 else []
            apart = [(one, two) for one, two in combinations(sides, 2) if abs(one[0].at - two[0].at) > near]
            if apart:
                lines = [subscripted(i.letter) + subscripted(j.letter) for i, j in (*apart[0], bar.ends)]
                a, b = subscripted(start.letter), subscripted(end.letter)
                yield (
                    (bar.link,),
                    Words(
                        f"${' ∥ '.join(lines)}$ 且 ${' = '.join(lines)}$，${a}$、${b}$ 两点之间的距离始终不变，"
                        f"用双转动副构件 {bar.link} 连接这两点不起独立的约束作用",
                        f"since ${' ∥ '.join(lines)}$ and ${' = '.join(lines)}$ the points ${a}$ and ${b}$ "
                        f"always keep their distance, and bar {bar.link} between them adds "
                        "nothing to the motion",
                    ),
                )


def _sides(chain: Chain, p: str, q: str, bar: Bar, near: float) -> list[tuple[Pair, Pair]]:
    """Hinges on p and q of one more link, which lie as the bar's do."""
    hinges = [pair for pair in chain.pairs if pair.form is Form.R]
    return [
        (i, j)
        for i in hinges
        for j in hinges
        if p in i.links
        and q in j.links
        and abs(j.at - i.at - bar.span) < near
        and any(link in j.links and link not in (p, q, bar.link) for link in i.links)
    ]
