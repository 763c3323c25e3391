"""Aronhold: where links slide, points of the inflection circle are seen at once."""

from __future__ import annotations

from ....errors import NoMethodError
from ....words import Words
from ...registry import Stage, method
from ..state import CurvatureFigure
from ..strokes.at_sight import inflection_at_sight
from ..strokes.circle import letter_tangent, through_two
from ..strokes.triangles import centre_by_triangles, inflection_by_triangles

_SOURCE = "Aronhold 1872; 机械原理, 拐点圆与回归圆"


@method(
    stage=Stage.CURVATURE,
    group="aronhold",
    source=_SOURCE,
    example="curv-4",
    title=Words("阿龙霍尔德定理作图", "Aronhold's theorem"),
)
def aronhold(fig: CurvatureFigure, points: tuple[str, ...]) -> None:
    """A point whose path is straight lies on the inflection circle; a point that a line envelops, on the return
    circle."""
    if all(ray.whole for ray in fig.rays):
        raise NoMethodError(
            Words(
                "阿龙霍尔德作图须有作直线运动的点，或穿过固定点的杆；此构件只有铰链，请用 construction: bobillier",
                "Aronhold's construction needs a point on a straight path, or a rod through a fixed point; this link "
                "has hinges only: use construction: bobillier",
            )
        )
    order = sorted(fig.rays, key=lambda ray: ray.whole)
    seen = [inflection_by_triangles(fig, ray) if ray.whole else inflection_at_sight(fig, ray) for ray in order]
    through_two(fig, (order[0], *seen[0]), (order[1], *seen[1]))
    letter_tangent(fig)
    for letter in points:
        centre_by_triangles(fig, letter)
