"""vecpoly cycle: the whole cycle of a mechanism: facts and extremes in the terminal, tables as CSV or XLSX, curves."""

from __future__ import annotations

from contextlib import suppress
from math import ceil, floor
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from ...errors import NotAskedError, VecpolyError
from ...limits import POSITIONS
from ...words import Words
from ..completion import ids
from ..errors import Tally, about
from ..files import STDOUT, put, spared
from ..jobs import each, problems
from ..onward import ThenOption, onward
from ..options import Lang, LangOption, OutsideOption, place
from ..terminal import warn

if TYPE_CHECKING:
    from ...curves import Plot
    from ...cycle import Cycle
    from ...problem.problem import Problem

from ..whole_turn import print_turn

TABLES, PLOTS = (".csv", ".xlsx"), (".svg", ".pdf", ".png")

Id = Annotated[
    str,
    typer.Argument(
        metavar="ID_OR_PATH",
        help="A problem or an assignment: an id such as A-27, or a file.",
        show_default=False,
        autocompletion=ids,
    ),
]
Count = Annotated[int, typer.Option("-n", min=2, max=POSITIONS, help="Number of positions, both ends included.")]
Step = Annotated[
    float | None,
    typer.Option(
        "--step",
        min=1e-6,
        max=1e6,
        help="Instead of -n: positions at the whole multiples of this step of the drive, in degrees (mm of a sliding "
        "input).",
        show_default=False,
    ),
]
Out = Annotated[
    Path | None,
    typer.Option(
        "-o",
        "--output",
        metavar="FILE",
        parser=place,
        help="Write a table: .csv or .xlsx, or - for CSV to standard output; missing folders are made.",
        show_default=False,
    ),
]
PlotOption = Annotated[
    Path | None,
    typer.Option("--plot", metavar="FILE", parser=place, help="Draw curves: .svg, .pdf or .png.", show_default=False),
]
Of = Annotated[
    str,
    typer.Option(
        "--of",
        metavar="KEYS",
        help="Quantities, such as omega_5,alpha_5,a_F,M_1; phi_5, s_45, gamma_23, v_F.x too.",
        show_default=False,
    ),
]
Path_ = Annotated[
    str,
    typer.Option(
        "--path", metavar="LETTERS", help="With --plot: the paths of these points, F or E,F.", show_default=False
    ),
]
Hodograph = Annotated[
    str,
    typer.Option("--hodograph", metavar="KEY", help="With --plot: the hodograph of a vector, a_F.", show_default=False),
]


def cycle(
    name: Id,
    n: Count = 361,
    step: Step = None,
    output: Out = None,
    plot: PlotOption = None,
    of: Of = "",
    path: Path_ = "",
    hodograph: Hodograph = "",
    lang: LangOption = "en",
    allow_outside: OutsideOption = False,
    then: ThenOption = None,
) -> None:
    """Take a mechanism through its whole cycle: print what is to be said of it, write tables, draw curves."""
    _one_drawing(path, hodograph, plot)
    tally = Tally()
    found = onward(problems([name], tally, allow_outside), then, tally, lang)
    spared(output, TABLES, found)
    spared(plot, PLOTS, found)
    from ...cycle import cycle as whole

    keys = tuple(part.strip() for part in of.split(",") if part.strip())
    for problem in found:
        with tally.job(), about(problem):
            warn(problem.id, problem.warnings, lang)
            turn = whole(problem, n) if step is None else whole(problem, over=_multiples(whole(problem, 2), step))
            for key in keys:
                turn.info(key)
            if output is not None:
                _write(turn, keys, each(output, problem.id, len(found)) if output != STDOUT else output, lang)
            if plot is not None:
                _plot(_drawn(turn, problem, keys, path, hodograph, lang), each(plot, problem.id, len(found)))
            if output is None and plot is None:
                print_turn(turn, problem, keys, lang)
            _weigh(problem, lang, tally)
    tally.settle()


def _one_drawing(path: str, hodograph: str, plot: Path | None) -> None:
    """NotAskedError where two drawings are asked for, or one without a place for it."""
    if path and hodograph:
        raise NotAskedError(
            Words(
                "--path 与 --hodograph 是两种图；请只取其一",
                "--path and --hodograph are two drawings: ask for one of them",
            )
        )
    if (path or hodograph) and plot is None:
        raise NotAskedError(
            Words(
                "--path 与 --hodograph 用于绘图；请用 --plot 文件 指明输出",
                "--path and --hodograph are drawings: say where to with --plot FILE",
            )
        )


def _plot(drawn: Plot, path: Path) -> None:
    kinds = {".pdf": drawn.pdf, ".png": drawn.png}
    put(path, kinds.get(path.suffix.lower(), lambda: drawn.svg().encode())())


def _weigh(problem: Problem, lang: Lang, tally: Tally) -> None:
    """Raise the alarm where the drawing of the problem's own position
    contradicts the analysis that the cycle goes by."""
    from ...solution import solve

    with suppress(VecpolyError):  # no method draws it: there is nothing to compare with
        tally.weigh(problem.id, solve(problem, by="exact", repeats=0).construction.warning, lang)


def _multiples(turn: Cycle, step: float) -> list[float]:
    """The drive's positions (rad or m) at the whole multiples of a step within its range: 0°, 7°, 14° ... 357°."""
    factor = turn.drive.factor
    low, high = turn.drive.told(turn.low), turn.drive.told(turn.high)
    first, last = ceil(low / step - 1e-9), floor(high / step + 1e-9)
    count = last - first + 1
    if count > POSITIONS:
        raise NotAskedError(
            Words(
                f"步长 {step:g} 产生 {count} 个位置；至多 {POSITIONS} 个",
                f"a step of {step:g} makes {count} positions; at most {POSITIONS} are possible",
            )
        )
    if count < 2:
        raise NotAskedError(
            Words(
                f"步长 {step:g} 在 {low:.6g} … {high:.6g} {turn.drive.shown_unit} 内不足 2 个位置；请减小步长",
                f"a step of {step:g} makes fewer than 2 positions within {low:.6g} … {high:.6g} "
                f"{turn.drive.shown_unit}; take a finer step",
            )
        )
    return [turn.drive.zero + k * step / factor for k in range(first, last + 1)]


def _write(turn: Cycle, keys: tuple[str, ...], output: Path, lang: Lang) -> None:
    put(output, _encoded(turn, keys, output, lang))


def _encoded(turn: Cycle, keys: tuple[str, ...], output: Path, lang: Lang) -> bytes:
    from ...cycle import csv_bytes, xlsx_bytes
    from ...cycle import table as tabled

    made = tabled(turn, keys)
    return csv_bytes(made) if output.suffix.lower() != ".xlsx" else xlsx_bytes(made, turn.name, lang)


def _drawn(turn: Cycle, problem: Problem, keys: tuple[str, ...], path: str, hodograph: str, lang: Lang) -> Plot:
    from ...curves import curves, trace
    from ...curves import hodograph as end_curve

    if path:
        return trace(turn, tuple(letter.strip() for letter in path.split(",")), lang)
    if hodograph:
        return end_curve(turn, hodograph, lang)
    return curves(turn, keys or _asked(turn, problem), lang)


def _asked(turn: Cycle, problem: Problem) -> tuple[str, ...]:
    """What the problem asks and a cycle has: angular velocities and accelerations first."""
    known = {column.key for column in turn.columns}
    asked = [ask.rel.key for ask in problem.asks if ask.rel.key in known]
    turning = [key for key in asked if key.startswith(("omega", "alpha", "M_"))]
    return tuple(turning or asked or [f"omega_{name}" for name in turn.mech.numbered if name != turn.mech.drive.link])
