"""Points of the driving crank: each runs round its circle, at an even pace where the crank turns evenly."""

from __future__ import annotations

from ....findings.shown import shown
from ....findings.study.study import Study
from ....mechanism.joints import Revolute
from ....mechanism.model import FRAME
from ....names import subscripted
from ....words import Words


def circling(study: Study) -> tuple[str, ...]:
    """The points of a crank on a pivot of the frame."""
    mech = study.problem.mechanism
    turns = any(isinstance(one, Revolute) and {mech.drive.link, FRAME} == {one.a, one.b} for one in mech.joints)
    return tuple(mech.link(mech.drive.link).points) if turns else ()


def is_trivial(study: Study, letter: str) -> bool:
    """Whether the data tell all of a point's motion: even motion on a circle needs no table and no curves."""
    return letter in circling(study) and not study.mech.drive.accel and not study.varies(f"v_{letter}")


def told(study: Study, letter: str) -> Words:
    """How fast, in a sentence that stands for the table."""
    at, link = subscripted(letter), study.mech.number(study.mech.drive.link)
    v, a = (shown(study, f"{stem}_{letter}", abs(study.turn.real(f"{stem}_{letter}")[0])) for stem in "va")
    return Words(
        f"${at}$ 是匀速转动的原动件 {link} 上的点，速度、加速度的大小不变，$|v_{{{at}}}|$ = {v}，$|a_{{{at}}}|$ = {a}"
        f"（指向圆心）；坐标和各分量都是转角的正弦、余弦函数，不列表，也不列入极值。",
        f" ${at}$ is a point of the driving link {link}, which rotates uniformly: its velocity and acceleration have "
        f"the constant sizes $|v_{{{at}}}|$ = {v} and $|a_{{{at}}}|$ = {a} (towards the centre), and all components "
        "are sines and cosines of the angle, which need no table and no extremes.",
    )
