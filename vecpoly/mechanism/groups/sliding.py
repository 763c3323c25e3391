"""A loop of prismatic pairs alone, as of a wedge between two guides: it moves, though the count says that it cannot."""

from __future__ import annotations

from collections.abc import Iterable

from ...words import Words
from ..model import FRAME, Prismatic


def slides_alone(slides: Iterable[Prismatic]) -> Words | None:
    """That a loop has slides alone, and how it is written so that it counts; None where there is no such loop.

    No link of it can turn, so that three links have one freedom: one of the constraints is redundant (p′ = 1).
    """
    chain: dict[str, str] = {}  # each link and one that it slides on, over others too
    met: list[Prismatic] = []

    def last(link: str) -> str:
        return last(chain[link]) if link in chain else link

    for slide in (one for one in slides if not one.pin_in_slot):
        met.append(slide)
        one, other = last(slide.guide), last(slide.block)
        if one == other:
            return _told(slide.block, next((s for s in met if FRAME not in (s.guide, s.block)), slide))
        chain[one] = other
    return None


def _told(link: str, slide: Prismatic) -> Words:
    written = f"{slide.pin} runs in {slide.guide}"
    return Words(
        f"：构件 {link} 所在的封闭链全由移动副组成，其中各构件都不能转动，有一个虚约束（p′ = 1），故能运动而计数为 0；"
        f"请将其中一个移动副改写为槽中的销，如“{written}”",
        f": the loop of link {link} has prismatic pairs alone, in which no link can turn; one constraint is redundant "
        f"(p′ = 1), so that it moves though the count is 0. Write one of its slides as a pin in a slot: '{written}'",
    )
