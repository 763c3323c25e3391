"""v = ω l about a fixed pivot: another way to a velocity than that of the drawing, which anybody may take."""

from __future__ import annotations

from ...errors import UnknownNameError
from ...mechanism.model import Mechanism
from ...names import Kind, omega, parse_rel
from ...problem.problem import Problem
from ..key import Graded


def rates_about_pivots(problem: Problem, one: Graded) -> dict[str, float]:
    """Key of ω → the radius l (m) by which a point's velocity follows from it, of every link that carries the point
    and turns about a fixed pivot; none of anything else."""
    try:
        rel = parse_rel(one.key)
    except UnknownNameError:
        return {}
    mech = problem.subject
    if not isinstance(mech, Mechanism) or rel.kind is not Kind.V or rel.key != f"v_{rel.to.point}":
        return {}
    links = (link for link in mech.links if rel.to.point in link.points)
    return {
        omega(link.name).key: abs(link.points[rel.to.point] - link.points[pivot])
        for link in links
        for pivot in link.points
        if pivot in mech.frame and pivot != rel.to.point
    }
