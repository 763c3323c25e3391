"""How the line is called along which a point lies: by two letters, or by what runs along it."""

from __future__ import annotations

from ...words import Words
from ..problem import Shape
from .draft import Draft

_OWN = {Shape.SLOT: Words("导槽中线", "the slot's line"), Shape.ROD: Words("杆的中线", "the rod's line")}


def line_words(draft: Draft, along: str, start: str) -> Words:
    """BC, or the link's own guide line, or the guide in which it slides, from the point that is on it."""
    if len(along) == 2:
        return Words(f" ${along}$ ", f"${along}$")
    line = _OWN.get(draft.shape) if draft.line is not None else None
    if line is not None:
        return Words(f"{line.zh}（自 ${start}$ 起）", f"{line.en} from ${start}$")
    return Words(
        f"构件 {draft.name} 所沿导路的方向（自 ${start}$ 起）",
        f"the direction of the guide of link {draft.name} from ${start}$",
    )
