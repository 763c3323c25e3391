"""What a question says of cams: which letter is the centre of curvature that intermediate results are told of."""

from __future__ import annotations

from ...mechanism.model import Mechanism
from ...problem.problem import Problem
from ...words import Words


def profile_centres(problem: Problem) -> Words:
    """Nothing where no profile moves a mechanism."""
    cams = problem.subject.cams if isinstance(problem.subject, Mechanism) else ()
    if not cams:
        return Words.same("")
    zh = "，".join(f"${one.centre}$ 为凸轮 {one.link} 的廓线在接触点 ${one.point}$ 处的曲率中心" for one in cams)
    en = ", ".join(
        f"${one.centre}$ is the centre of curvature of the profile of cam {one.link} at the contact ${one.point}$"
        for one in cams
    )
    return Words(f"高副低代时，{zh}。", f"Where the higher pair is replaced, {en}.")
