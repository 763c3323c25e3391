"""Two lettered points of a link at which a couple's pair of forces can act."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

from ....errors import NoMethodError
from ....mechanism.model import FRAME, Prismatic
from ....names import omega
from ....plane import nominal
from ....words import Words
from ..state import Statics

APART = 1e-6  # of the mechanism's size: nearer points are one


@dataclass(frozen=True, slots=True, kw_only=True)
class Pair:
    """Points P and Q of a link."""

    link: str
    p: str
    q: str


def pair_of(st: Statics, link: str) -> Pair | None:
    """The first two lettered points of a link; None where the link never turns, so that a couple on it does no work.

    A link with one letter lends its couple to the link with which it forms a sliding pair:
    both turn alike. Raises NoMethodError where that has one letter too.
    """
    if link == FRAME or st.desk.turns[omega(link)].never:
        return None
    for name in (link, *_sliding_with(st, link)):
        found = _two_points(st, name)
        if found is not None:
            return found
    number, name = st.mech.number(link), st.unknown.name
    raise NoMethodError(
        Words(
            f"构件 {number} 上有力偶，但只有一个标字母的点，而速度杠杆法需要其上两点；"
            f"请给构件 {number} 再加一个点，或改求不需要它的 {name}_power（虚功率法）",
            f"link {number} carries a couple but has one lettered point, and the lever needs two; give link {number} "
            f"another point, or ask for {name}_power (virtual power), which needs none",
        ),
        code="no-method",
        numbers={"link": number},
    )


def _two_points(st: Statics, link: str) -> Pair | None:
    desk = st.desk
    letters = [letter for letter in desk.mech.link(link).points if letter in desk.at]
    for p, q in combinations(letters, 2):
        if abs(nominal(desk.at[q] - desk.at[p])) > APART * desk.mm(st.mech.scale):
            return Pair(link=link, p=p, q=q)
    return None


def _sliding_with(st: Statics, link: str) -> list[str]:
    """Links that form a sliding pair with this one."""
    ends = [(j.guide, j.block) for j in st.mech.joints if isinstance(j, Prismatic)]
    return [b if a == link else a for a, b in ends if link in (a, b) and FRAME not in (a, b)]
