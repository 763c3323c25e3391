"""The ratio of two angular velocities: inverse to the distances of their common centre from their absolute centres."""

from __future__ import annotations

from ....algebra.formula import named as as_symbol
from ....algebra.quantity import Expr, Quotient, magnitude
from ....algebra.worked import worked
from ....board.construction import Reading
from ....errors import NoMethodError
from ....mechanism.asked.centres import Pair, ratio
from ....mechanism.model import FRAME
from ....names import Named
from ....plane import Reals, dot, nominal
from ....words import Words
from ...registry import Stage, method
from ..state import CentreFigure
from .motions import CLOSE, Motions
from .proportion import proportioned
from .spots import apart, measured, spot_of


@method(
    stage=Stage.CENTRES,
    group="ratio",
    source="机械原理, 瞬心法求传动比",
    example="3-3",
    title=Words("用瞬心求角速度比", "A velocity ratio by centres"),
)
def read_ratio(motions: Motions, pair: Pair) -> None:
    """ω_i/ω_j = P_jk P_ij / P_ik P_ij, k being the frame; positive where P_ij lies outside P_ik P_jk."""
    fig, name = motions.fig, ratio(motions.fig.mech, *pair)
    found = _alike if fig.known.of(*pair).endless else _measured
    value, expr = found(fig, pair, name)
    if isinstance(expr, Quotient):
        value = proportioned(fig.board, name.key, value, expr, "")
    node = as_symbol(name.symbol)
    fig.board.write_worked(node, expr, "")
    fig.board.keep(
        Reading(
            key=name.key, symbol=name.symbol, unit="", scalar=float(nominal(value)), formula=worked(node, expr, "")
        ),
        value,
    )


def _alike(fig: CentreFigure, pair: Pair, name: Named) -> tuple[Reals, Expr]:
    """P_ij at infinity: the ratio is 1."""
    letters = fig.letters(*pair)
    fig.board.step(
        Words(
            f"${letters}$ 在无穷远处，两构件角速度相等。",
            f"The centre ${letters}$ is at infinity: both links have the same angular velocity.",
        ),
        fig.pane,
    )
    return 1.0, magnitude(name.symbol, 1.0, "")


def _measured(fig: CentreFigure, pair: Pair, name: Named) -> tuple[Reals, Expr]:
    """The ratio with its sign, and its size from the figure.
    Raises NoMethodError where either link translates, or P_ij falls on P_ik."""
    i, j = pair
    if fig.known.of(i, FRAME).endless or fig.known.of(j, FRAME).endless:
        raise NoMethodError(
            Words(
                f"{name.key}：此时构件 {i} 与 {j} 之一作平动；请改求其速度",
                f"{name.key}: one of the links {i} and {j} only translates here; ask for its velocity instead",
            )
        )
    common, one, two = spot_of(fig, i, j), spot_of(fig, i, FRAME), spot_of(fig, j, FRAME)
    if apart(common, one) < CLOSE:
        raise NoMethodError(
            Words(
                f"{name.key}：{common.letter} 与 {one.letter} 重合，此时 ω_{j} = 0",
                f"{name.key}: {common.letter} falls on {one.letter}, so ω_{j} = 0 here",
            )
        )
    outside = float(nominal(dot(common.at - one.at, common.at - two.at))) > 0
    fig.board.step(
        _words(fig.mech.number(i), fig.mech.number(j), common.letter, one.letter, two.letter, outside), fig.pane
    )
    expr = measured(fig, two, common) / measured(fig, one, common)
    return expr.value if outside else -1.0 * expr.value, expr


def _words(i: str, j: str, common: str, one: str, two: str, outside: bool) -> Words:
    zh = (
        "在两绝对瞬心之外，两构件转向相同，比值为正"
        if outside
        else "在两绝对瞬心之间，两构件转向相反，比值为负（下式为其大小）"
    )
    en = (
        "outside the two absolute centres: they turn in the same sense"
        if outside
        else "between the two absolute centres: they turn in opposite senses, the ratio is negative (its size follows)"
    )
    return Words(
        f"${common}$ 处两构件速度相同，$ω_{i}$\u2009${one}{common}$ = $ω_{j}$\u2009${two}{common}$；${common}$ {zh}：",
        f"At ${common}$ both links have the same velocity, $ω_{i}$\u2009${one}{common}$ = "
        f"$ω_{j}$\u2009${two}{common}$; ${common}$ lies {en}:",
    )
