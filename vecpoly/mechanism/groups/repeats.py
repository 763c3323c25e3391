"""A crank beside two equal and parallel ones, as a locomotive's third axle: it moves, though the count says not."""

from __future__ import annotations

from ...words import Words
from ..model import Mechanism, Revolute
from .assur import ends

SAME = 1e-6  # lengths that differ by no more than this share of the mechanism are meant to be equal


def repeated(mech: Mechanism) -> Words | None:
    """That a bar may be left out, for it repeats what two equal and parallel ones enforce; None where none does.

    It has two hinges and brings 2·2 − 3 = 1 constraint more: p′ = 1 where the three bars are equal, and so are the
    distances of their pivots on the two links that they join: any two of them make a parallelogram with these.
    """
    driven = {drive.link for drive in mech.drives}
    for spare in (name for name in mech.bodies[::-1] if name not in driven):
        alike = [name for name in mech.bodies if name != spare and _alike(mech, name, spare)]
        if len(alike) > 1:
            one, other = alike[:2]
            return Words(
                f"：构件 {spare} 与构件 {one}、{other} 等长、平行，连接的又是相同的两构件，只起重复约束作用，"
                f"引入虚约束（p′ = 1），故计数少 1 而机构仍能运动；请去掉构件 {spare}（ω_{spare} = ω_{one}）",
                f": link {spare} is as long as links {one} and {other}, parallel to them, and joins the same two "
                f"links; it repeats what they enforce (a redundant constraint, p′ = 1), so that the mechanism moves "
                f"though the count is one less. Leave out link {spare} (ω_{spare} = ω_{one})",
            )
    return None


def _alike(mech: Mechanism, one: str, other: str) -> bool:
    """Whether two bars are opposite sides of a parallelogram of which the other sides lie on the links they join."""
    first, second = _hinges(mech, one), _hinges(mech, other)
    if len(first) != 2 or first.keys() != second.keys():
        return False
    spans = [_apart(mech, one, *first.values()), _apart(mech, other, *second.values())]
    sides = [_apart(mech, link, first[link], second[link]) for link in first]
    near = SAME * mech.scale
    return min(sides) > near and abs(spans[0] - spans[1]) < near and abs(sides[0] - sides[1]) < near


def _hinges(mech: Mechanism, name: str) -> dict[str, str]:
    """The links to which a bar is hinged, each with the letter; none of a link that has another joint."""
    if any(name in ends(joint) for joint in mech.joints if not isinstance(joint, Revolute)):
        return {}
    return {
        other: letter
        for letter in mech.link(name).points
        for other in mech.links_at(letter)
        if other != name and len(mech.links_at(letter)) == 2
    }


def _apart(mech: Mechanism, link: str, one: str, other: str) -> float:
    points = mech.link(link).points
    return abs(points[one] - points[other])
