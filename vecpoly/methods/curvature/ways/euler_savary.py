"""Euler and Savary: the inflection circle from two normals by similar triangles, and every centre by the same."""

from __future__ import annotations

from ....plane import Points
from ....words import Words
from ...registry import Stage, method
from ..state import CurvatureFigure, Ray
from ..strokes.at_sight import inflection_at_sight
from ..strokes.circle import letter_tangent, on_the_normal, through_two
from ..strokes.triangles import centre_by_triangles, inflection_by_triangles

_SOURCE = "Euler 1765, Savary 1831; 机械原理, 连杆曲线的曲率"


@method(
    stage=Stage.CURVATURE,
    group="euler-savary",
    source=_SOURCE,
    example="curv-2",
    title=Words("欧拉—萨瓦里作图法", "Construction of Euler and Savary"),
)
def euler_savary(fig: CurvatureFigure, points: tuple[str, ...]) -> None:
    """EP² = EJ · EO on every normal, 1/r − 1/r_0 = 1/j."""
    found = [_point(fig, ray) for ray in fig.rays]
    if len(found) == 1:
        on_the_normal(fig, *found[0][1:])
    else:
        through_two(fig, found[0], found[1])
    letter_tangent(fig)
    for letter in points:
        centre_by_triangles(fig, letter)


def _point(fig: CurvatureFigure, ray: Ray) -> tuple[Ray, Points, str]:
    """The point of the inflection circle on this normal."""
    return (ray, *(inflection_by_triangles(fig, ray) if ray.whole else inflection_at_sight(fig, ray)))
