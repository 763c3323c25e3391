"""Reactions of an RPR group:
ΣM of the whole group about one outer pin gives R^t at the other, then link j closes alone."""

from __future__ import annotations

from ....mechanism.groups.assur import Dyad
from ....mechanism.model import Prismatic, Revolute
from ....vector.equation import UNKNOWN
from ....words import Words
from ...registry import Stage, method
from ..lines.arms import Turning, all_pass, moments_at
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
    """R^t_pj + ΣF_j + R_kj + R^n_pj = 0, R_kj normal to the guide (or at φ to that); R_qk closes the group.

    R_kj lies where moments of link j about P put it; where all other forces on link k pass through Q, so does it."""
    assert isinstance(d.outer_j, Revolute) and isinstance(d.inner, Prismatic) and isinstance(d.outer_k, Revolute)
    p, q = d.outer_j.point, d.outer_k.point
    first = split(st, d.links, d.parent_j, d.link_j, (p, q), (d.link_j, d.link_k))
    inner = lean(st, d.links, d.inner, d.link_k, d.link_j)
    common = all_pass(st, d.link_k, q)
    about = (q, Turning(terms=(), signs=(), value=0.0)) if common else (p, _about(st, d, p))
    r_pj, r_kj, r_qk = reactions(st, d, draw_link_j(st, d, first, inner))
    settle_pin(st, d.parent_j, d.link_j, p, r_pj)
    settle_pin(st, d.parent_k, d.link_k, q, r_qk)
    settle_slide(st, d.links, d.link_k, d.link_j, r_kj, about, d.link_k if common else d.link_j)
    draw_body(st, d, first, Reaction(by=d.parent_k, on=d.link_k, line=st.desk.towards(p, q), direction=UNKNOWN))


def _about(st: Statics, d: Dyad, p: str) -> Turning:
    """The moments of link j about its outer pin P; the arms have the point in their letters, for those about Q stand
    beside them."""
    return moments_at(st, group_pane(st, *d.links), (d.link_j,), st.desk.at[p], p)
