"""Points of the inflection circle that are seen at once: a slider's pin; the mirror image of a block's pivot."""

from __future__ import annotations

from ....plane import Points
from ....words import Words
from ..state import CurvatureFigure, Ray


def inflection_at_sight(fig: CurvatureFigure, ray: Ray) -> tuple[Points, str]:
    """The pin itself, whose path is straight; or the pivot mirrored in the pole, since it lies on the return circle."""
    if ray.x is not None:
        name = fig.shown(ray.moving)
        fig.board.step(
            Words(
                f"${name}$ 作直线运动，曲率中心在无穷远处，故 ${name}$ 在拐点圆上。",
                f"Point ${name}$ runs on a straight line; its centre of curvature is at infinity, so ${name}$ itself "
                "lies on the inflection circle.",
            ),
            fig.pane,
        )
        return ray.x, name
    assert ray.o is not None
    pivot, name = fig.shown(ray.fixed), fig.free("J", ray.fixed)
    fig.board.step(
        Words(
            f"构件的导路线包络于 ${pivot}$，故 ${pivot}$ 在回归圆上；回归圆与拐点圆对 ${fig.p}$ 对称，${pivot}$ 关于 "
            f"${fig.p}$ 的对称点 ${name}$ 在拐点圆上。",
            f"The line of the link envelops ${pivot}$, which therefore lies on the return circle; this is the mirror "
            f"image of the inflection circle in ${fig.p}$, so the image ${name}$ of ${pivot}$ in ${fig.p}$ lies on the "
            "inflection circle.",
        ),
        fig.pane,
    )
    mirrored = fig.letter(name, fig.board.follow(fig.pane, fig.pole, fig.pole - ray.o, f"P{ray.fixed}"))
    fig.thin(ray.line, fig.pole, mirrored)
    return mirrored, name
