"""Reactions of an RRP group loaded on both links:
R^t at the outer pin from ΣM_C, the slide's reaction along its known direction."""

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
from .rrr import split

_SOURCE = "机械原理, kinetostatic analysis of Assur groups"


@method(
    stage=Stage.FORCE,
    group="RRP",
    source=_SOURCE,
    example="slider-crank-dynamic",
    title=Words("RRP 杆组的动态静力分析", "Forces in an RRP group"),
)
def forces_rrp(st: Statics, d: Dyad) -> None:
    """R^t_pj + ΣF_j + ΣF_k + R_qk + R^n_pj = 0, R_qk normal to its guide (or at φ to that);
    ΣM_C of the slide gives its line."""
    assert isinstance(d.outer_j, Revolute) and isinstance(d.inner, Revolute) and isinstance(d.outer_k, Prismatic)
    p, c = d.outer_j.point, d.inner.point
    first = split(st, d.links, d.parent_j, d.link_j, (p, c))
    last = lean(st, d.links, d.outer_k, d.parent_k, d.link_k)
    about = (c, moments_about(st, group_pane(st, *d.links), (d.link_k,), c))
    r_pj, r_kj, r_qk = reactions(st, d, draw_group(st, d, first, last))
    settle_pin(st, d.parent_j, d.link_j, p, r_pj)
    settle_pin(st, d.link_k, d.link_j, c, r_kj)
    settle_slide(st, d.links, d.parent_k, d.link_k, r_qk, about)
    draw_body(st, d, first, last)
