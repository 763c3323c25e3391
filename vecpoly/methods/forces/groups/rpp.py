"""Reactions of an RPP group (sine mechanism):
link k is held by two slides of known directions, link j's pin closes its own polygon."""

from __future__ import annotations

from ....mechanism.groups.assur import Dyad
from ....mechanism.model import Prismatic, Revolute
from ....vector.equation import UNKNOWN
from ....words import Words
from ...registry import Stage, method
from ..lines.arms import moments_about
from ..state import Statics
from .body import group_pane
from .corners import Reaction
from .polygon import draw_link_k, reactions
from .reactions import draw_body, lean, settle_pin, settle_slide

_SOURCE = "机械原理, kinetostatic analysis of Assur groups"


@method(
    stage=Stage.FORCE,
    group="RPP",
    source=_SOURCE,
    example="",
    title=Words("RPP 杆组的动态静力分析", "Forces in an RPP group"),
)
def forces_rpp(st: Statics, d: Dyad) -> None:
    """ΣF_k + R_qk + R_jk = 0, both normal to their guides (or at φ to that); then R_pj = −ΣF_j − R_kj."""
    assert isinstance(d.outer_j, Revolute) and isinstance(d.inner, Prismatic) and isinstance(d.outer_k, Prismatic)
    p, pane = d.outer_j.point, group_pane(st, *d.links)
    inner, last = (lean(st, d.links, d.inner, d.link_j, d.link_k), lean(st, d.links, d.outer_k, d.parent_k, d.link_k))
    about = (p, moments_about(st, pane, (d.link_j,), p))
    r_pj, r_kj, r_qk = reactions(st, d, draw_link_k(st, d, inner, last))
    settle_pin(st, d.parent_j, d.link_j, p, r_pj)
    settle_slide(st, d.links, d.link_k, d.link_j, r_kj, about)
    pin = d.outer_k.pin
    settle_slide(st, d.links, d.parent_k, d.link_k, r_qk, (pin, moments_about(st, pane, (d.link_k,), pin)))
    draw_body(st, d, Reaction(by=d.parent_j, on=d.link_j, line=inner.line, direction=UNKNOWN), last)
