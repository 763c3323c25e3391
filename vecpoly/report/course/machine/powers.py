"""The section on the flow of power: what the loads give, and at what rate every link gains energy."""

from __future__ import annotations

from typing import Any

import numpy as np

from ....findings.machine.running import Flow, Running
from ....findings.study.study import Study
from ....words import Words
from ..numbering import SMALL, Press
from ..results.tabled import decimal


def powers(study: Study, press: Press, run: Running) -> dict[str, Any]:
    """A row every 30° (60° of two turns) of a period: powers of the loads, dT/dt of the links, their difference."""
    assert run.trial is not None
    flows = run.trial.flows[:: 2 if run.of.period > 2 * np.pi * 1.5 else 1]
    wheel = run.found is not None and run.found.flywheel > 0
    return {
        "title": Words("功率的流动", "The flow of power").of(press.lang),
        "words": [_told(run, wheel=wheel).of(press.lang)],
        "tables": [_table(study, press, run, flows)],
        "figures": [],
    }


def _told(run: Running, *, wheel: bool) -> Words:
    link = run.mech.number(run.mech.drive.link)
    with_zh, with_en = (f"（构件 {link} 连同飞轮）", f" (link {link} with its flywheel)") if wheel else ("", "")
    return Words(
        f"真实运动中，任一瞬时各载荷的功率之和等于各构件动能的变化率之和：Σ$P$ = Σd$T_i$/d$t${with_zh}。正的 "
        "d$T$/d$t$ 表示构件"
        "储存能量，负的表示放出能量。",
        "At every instant of the true motion the powers of the loads add up to the rates at which the links gain "
        "energy, Σ$P$ = "
        f"Σd$T_i$/d$t${with_en}: where d$T$/d$t$ is positive a link stores energy, where negative it gives it away.",
    )


def _table(study: Study, press: Press, run: Running, flows: tuple[tuple[float, Flow], ...]) -> str:
    loads, links = (tuple(part) for part in (flows[0][1].powers, flows[0][1].gains))
    values = [[*flow.powers.values(), *flow.gains.values()] for _, flow in flows]
    size = max(abs(value) for row in values for value in row) or 1.0
    places = int(np.clip(4 - np.floor(np.log10(size)), 0, 3))
    head = [f"${study.turn.drive.symbol}$ /°", *(f"$P_{{{name.replace('_', '')}}}$ /W" for name in loads), "Σ$P$ /W"]
    head += [*(f"d$T_{{{run.mech.number(link)}}}$/d$t$ /W" for link in links), "Σd$T$/d$t$ /W"]
    rows = []
    for at, flow in flows:
        gives, gains = sum(flow.powers.values()), sum(flow.gains.values())
        told = [*flow.powers.values(), gives, *flow.gains.values(), gains]
        rows.append((f"{np.degrees(at):.0f}", *(decimal(value, places) for value in told)))
    title = Words("各载荷的功率和各构件动能的变化率", "Powers of the loads, and rates at which the links gain energy")
    return press.table(title, head, rows, "r" * len(head), style=SMALL)
