"""Three forces on the disc of an eccentric clamp: through one point, that of the pin tangent to its friction circle."""

from __future__ import annotations

from ....board.construction import Pane
from ....errors import DeadPointError, EquilibriumError, LockedError
from ....names import Named
from ....plane import Line, Points, Reals, nominal
from ....vector.close import Closed
from ....words import Words
from ..bench import Bench
from ..equilibrium import balance, given, points_along, sought
from ..sketches.eccentric_clamp import Clamp


def balance_three(
    bench: Bench,
    plan: Pane,
    clamp: Clamp,
    size: float,
    up: Points,
    rho: Reals,
    moment: float,
    names: tuple[Named, Named, Named],
) -> tuple[Points, Points, Closed]:
    """The point where three forces meet, the direction of the pin's reaction through it, and the polygon."""
    press_on, push, hold = names
    meet = _meeting(bench, clamp, up)
    along = bench.board.tangent_from(meet, 0j, rho, moment, -(clamp.pull + up), key=hold.key)
    touches = Words("切于摩擦圆", "touches the circle") if float(nominal(rho)) else Words("过 $A$", "through $A$")
    pressed, force = given(bench, plan, press_on, size, up), sought(push, clamp.pull, Words("✓", "✓"))
    closed = balance(bench, plan, 0j, pressed, force, sought(hold, along, touches))
    if not points_along(closed, force):
        raise LockedError(
            Words(
                "力多边形只有在 F 反向时才闭合：在此摩擦下手柄上的力不能使夹具继续夹紧；请加长手柄，或减小 f 或 rho",
                "the polygon closes only with F reversed: with this friction no force on the handle keeps the "
                "clamp closing; lengthen the handle, or lower f or rho",
            )
        )
    return meet, along, closed


def _meeting(bench: Bench, clamp: Clamp, up: Points) -> Points:
    """Where the lines of F and R_21 cross; raises EquilibriumError where they are parallel."""
    try:
        return bench.board.meet(Line(clamp.k, up), Line(clamp.h, clamp.pull), Words("F 与 R_21", "F and R_21"))
    except DeadPointError:
        raise EquilibriumError(
            Words(
                "F 与 R_21 的作用线平行，三力在图上不能汇交；请略微改变 F 的方向",
                "F and R_21 act along parallel lines, so the three forces meet at no point of any sheet; turn "
                "the direction of F a little",
            )
        ) from None
