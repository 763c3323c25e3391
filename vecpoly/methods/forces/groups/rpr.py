"""Reactions of an RPR group:
ΣM of the whole group about one outer pin gives R^t at the other, then link j closes alone."""

from __future__ import annotations

from ....mechanism.groups.assur import Dyad
from ....mechanism.model import Prismatic, Revolute
from ....vector.equation import UNKNOWN
from ....words import Words
from ...registry import Stage, method
from ..lines.arms import moments_at
from ..state import Statics
from .body import group_pane
from .corners import Reaction
from .polygon import draw_link_j, reactions
from .reactions import draw_body, lean, settle_pin, settle_slide
from .rrr import split

_SOURCE = "机械原理, kinetostatic analysis of Assur groups"


@method(
    stage=Stage.FORCE,
    group="RPR",
    source=_SOURCE,
    example="",
    title=Words("RPR 杆组的动态静力分析", "Forces in an RPR group"),
)
def forces_rpr(st: Statics, d: Dyad) -> None:
    """R^t_pj + ΣF_j + R_kj + R^n_pj = 0, R_kj normal to the guide (or at φ to that); R_qk closes the group."""
    assert isinstance(d.outer_j, Revolute) and isinstance(d.inner, Prismatic) and isinstance(d.outer_k, Revolute)
    p, q = d.outer_j.point, d.outer_k.point
    first = split(st, d.links, d.parent_j, d.link_j, (p, q), (d.link_j, d.link_k))
    inner = lean(st, d.links, d.inner, d.link_k, d.link_j)
    about = (p, moments_at(st, group_pane(st, *d.links), (d.link_j,), st.desk.at[p], p))  # those about Q stand beside
    r_pj, r_kj, r_qk = reactions(st, d, draw_link_j(st, d, first, inner))
    settle_pin(st, d.parent_j, d.link_j, p, r_pj)
    settle_pin(st, d.parent_k, d.link_k, q, r_qk)
    settle_slide(st, d.links, d.link_k, d.link_j, r_kj, about)
    draw_body(st, d, first, Reaction(by=d.parent_k, on=d.link_k, line=st.desk.towards(p, q), direction=UNKNOWN))
