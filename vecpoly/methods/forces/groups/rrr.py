"""Reactions of an RRR group loaded on both links:
ΣM_C of either link gives R^t at its outer pin, one polygon of the group the rest."""

from __future__ import annotations

from ....mechanism.groups.assur import Dyad
from ....mechanism.model import Revolute
from ....plane import nominal
from ....words import Words
from ...registry import Stage, method
from ..lines.arms import moments_about
from ..state import Statics
from .body import group_pane
from .corners import Reaction, part_named, tangential
from .polygon import draw_group, reactions
from .reactions import draw_body, settle_pin

_SOURCE = "机械原理, kinetostatic analysis of Assur groups"


@method(
    stage=Stage.FORCE,
    group="RRR",
    source=_SOURCE,
    example="C-inertia",
    title=Words("RRR 杆组的动态静力分析", "Forces in an RRR group"),
)
def forces_rrr(st: Statics, d: Dyad) -> None:
    """R^t_pj + ΣF_j + ΣF_k + R^t_qk + R^n_qk + R^n_pj = 0, normals along the links; then R_kj closes link j alone."""
    assert isinstance(d.outer_j, Revolute) and isinstance(d.inner, Revolute) and isinstance(d.outer_k, Revolute)
    p, c, q = d.outer_j.point, d.inner.point, d.outer_k.point
    first = split(st, d.links, d.parent_j, d.link_j, (p, c))
    last = split(st, d.links, d.parent_k, d.link_k, (q, c))
    r_pj, r_kj, r_qk = reactions(st, d, draw_group(st, d, first, last))
    settle_pin(st, d.parent_j, d.link_j, p, r_pj)
    settle_pin(st, d.parent_k, d.link_k, q, r_qk)
    settle_pin(st, d.link_k, d.link_j, c, r_kj)
    draw_body(st, d, first, last)


def split(
    st: Statics, group: tuple[str, ...], by: str, on: str, arm: tuple[str, str], links: tuple[str, ...] = ()
) -> Reaction:
    """The reaction at an outer pin P, split along and across the line to C: R^t from ΣM_C = 0 of its link (or of
    `links` together)."""
    p, c = arm
    whole, j, body = st.named(by, on), st.mech.number(on), links or (on,)
    both, along, square = (f"${part_named(whole, part).symbol}$" for part in ("", "n", "t"))
    of, of_en = ("杆组", "the group") if len(body) > 1 else (f"构件 {j} ", f"link {j}")
    pane = group_pane(st, *group)
    st.board.step(
        Words(
            f"将 {both} 分解为沿 ${p}{c}$ 的 {along} 与垂直于 ${p}{c}$ 的 {square}；"
            f"量取各力对 ${c}$ 点的力臂，由{of}的 $ΣM_{c}$ = 0 求 {square}：",
            f"Split {both} into {along} along ${p}{c}$ and {square} "
            f"perpendicular to it; measure the arms of the forces about ${c}$; $ΣM_{c}$ = 0 of "
            f"{of_en} gives {square}:",
        ),
        pane,
    )
    across = tangential(st, by, on, arm, moments_about(st, pane, body, c))
    return Reaction(
        by=by,
        on=on,
        line=st.desk.towards(c, p),
        direction=Words.same(f"∥$ {p}{c}$"),
        part="n" if abs(nominal(across)) > 1e-9 else "",
        across=across,
        pin=p,
        across_direction=Words.same(f"⊥$ {p}{c}$"),
    )
