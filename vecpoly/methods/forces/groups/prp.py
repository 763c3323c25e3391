"""Reactions of a PRP group: both slides' reactions have known directions, one polygon gives them;
moments about the pin their lines."""

from __future__ import annotations

from ....mechanism.groups.assur import Dyad
from ....mechanism.model import Prismatic, Revolute
from ....words import Words
from ...registry import Stage, method
from ..lines.arms import moments_about
from ..state import Statics
from .body import group_pane
from .polygon import draw_group, reactions
from .reactions import draw_body, lean, settle_pin, settle_slide

_SOURCE = "机械原理, kinetostatic analysis of Assur groups"


@method(
    stage=Stage.FORCE,
    group="PRP",
    source=_SOURCE,
    example="",
    title=Words("PRP 杆组的动态静力分析", "Forces in a PRP group"),
)
def forces_prp(st: Statics, d: Dyad) -> None:
    """ΣF_j + ΣF_k + R_qk + R_pj = 0, each reaction normal to its guide (or at φ to that)."""
    assert isinstance(d.outer_j, Prismatic) and isinstance(d.inner, Revolute) and isinstance(d.outer_k, Prismatic)
    c, pane = d.inner.point, group_pane(st, *d.links)
    first, last = (
        lean(st, d.links, d.outer_j, d.parent_j, d.link_j),
        lean(st, d.links, d.outer_k, d.parent_k, d.link_k),
    )
    on_j, on_k = ((c, moments_about(st, pane, (link,), c)) for link in (d.link_j, d.link_k))
    r_pj, r_kj, r_qk = reactions(st, d, draw_group(st, d, first, last))
    settle_pin(st, d.link_k, d.link_j, c, r_kj)
    settle_slide(st, d.links, d.parent_j, d.link_j, r_pj, on_j)
    settle_slide(st, d.links, d.parent_k, d.link_k, r_qk, on_k)
    draw_body(st, d, first, last)
