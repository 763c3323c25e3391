"""Chapter 1, the task: the statement, what is given and asked, the mechanism in its given position."""

from __future__ import annotations

from typing import Any

from ...algebra.quantity import number
from ...drawing.figure import draw_figure
from ...findings.study.study import Study
from ...foundation.slotted import replace
from ...mechanism.groups.mobility import mobility
from ...names import Rel
from ...words import Words
from ..content import pivots, statement
from ..flow.table import DataTable
from ..picture import picture, to_scale
from ..statement.given_data import given_data
from ..statement.in_table import in_table, scalar
from ..statement.shortened import shortened
from ..tables import given_tables
from .modelling.dimensions import dimensions, listed, rounded
from .numbering import Press

_PICTURE = (130.0, 80.0)  # mm
_MANY, _FEW = 7, 3  # data that make a table, and at least in a column of it
_DATA = Words("已知数据", "The data")
_TABLE = Words("给定的数据", "What is given by a table")
_HEADS = {"zh": ("已知量", "数值", "单位"), "en": ("Quantity", "Value", "Unit")}


def task(study: Study, press: Press) -> dict[str, Any]:
    """The words of the statement, and the sketch."""
    press.chapter = "1"
    figure = picture(study.problem, study.solution.construction, *_PICTURE)
    figure = rounded(figure) if figure else None
    scene = draw_figure(figure, lang=press.lang, caption=False) if figure else None
    where = study.where(study.mech.drive.position)
    if figure is not None and to_scale(figure):
        where += f", ${figure.scale.symbol}$ = {number(figure.scale.value)} {figure.scale.per_mm}"
    title = Words(f"机构运动简图（{where.replace(', ', '，')}）", f"Kinematic diagram ({where})")
    told = statement(study.given, press.lang) if study.drawn else _undrawn(study, press)
    return {
        **told,
        **known(study, press, listed(study, figure)),
        "tables": [press.table(_TABLE, one.header, one.rows, one.align) for one in _series(study, press)],
        "picture": press.figure(scene, title) if scene else "",
        "dimensions": dimensions(study, press, figure),
        "freedom": mobility(study.mech).freedom,
        "more": ("、" if press.lang == "zh" else ", ").join(_more(study)),
        "assumed": " ".join(filter(None, (one.of(press.lang) for one in (assumed(study), counted(study))))),
    }


def _series(study: Study, press: Press) -> list[DataTable]:
    """What is given by a table of its own, as p over φ; the single numbers have theirs."""
    single = in_table(study.problem, press.lang)[1] is not None
    return given_tables(study.problem, press.lang)[single:]


def known(study: Study, press: Press, listed: frozenset[str] = frozenset()) -> dict[str, Any]:
    """What is given in words, and the table of the numbers where they are many; listed: lengths that the table of the
    dimensions tells, whose symbols stand in no other place."""
    lengths = [datum for datum in given_data(study.problem) if _bare(datum.symbol) in listed]
    data = [datum for datum in given_data(study.problem) if datum not in lengths]
    rows = [row for datum in data if (row := scalar(datum, press.lang)) is not None]
    parted = len(rows) >= _MANY
    told = [
        pivots(study.mech).of(press.lang),
        *(shortened(d.of(press.lang)) for d in data if not parted or scalar(d, press.lang) is None),
    ]
    given = ("，" if press.lang == "zh" else ", ").join(told)
    return {"given": given, "lengths": bool(lengths), "data": _data(rows, press) if parted else ""}


def _bare(symbol: str) -> str:
    return symbol.replace("{", "").replace("}", "")


def _data(rows: list[tuple[str, str, str]], press: Press) -> str:
    """The table of many numbers, in as many blocks as it fills."""
    blocks = next(n for n in (3, 2, 1) if n == 1 or len(rows) >= n * _FEW)
    high = -(-len(rows) // blocks)
    columns = [rows[i : i + high] for i in range(0, len(rows), high)]
    lines = [[one[n] if n < len(one) else ("",) * 3 for one in columns] for n in range(high)]
    table = [tuple(cell for row in line for cell in (*row, ""))[:-1] for line in lines]
    heads = [*([*_HEADS[press.lang], ""] * len(columns))][:-1]
    return press.table(_DATA, heads, table, ("lrll" * len(columns))[:-1])


def _undrawn(study: Study, press: Press) -> dict[str, str]:
    """The same for a mechanism that is not drawn: what is asked is named by its symbols."""
    bare = statement(replace(study.given, problem=replace(study.problem, asks=())), press.lang)
    symbols = [f"${study.whole.info(ask.rel.key).symbol}$" for ask in study.problem.asks if isinstance(ask.rel, Rel)]
    return {**bare, "asked": ("、" if press.lang == "zh" else ", ").join(symbols)}


def _more(study: Study) -> list[str]:
    """What is drawn beyond what is asked for."""
    return [
        f"${answer.reading.symbol}$" for key, answer in study.solution.answers.items() if key not in study.given.answers
    ]


def assumed(study: Study) -> Words:
    """Where only the sense of the input link's ω is given: what is taken, and how everything scales with it."""
    if not study.sense_only:
        return Words.same("")
    symbol = f"$ω_{{{study.mech.drive.link}}}$"
    loads = study.problem.loads
    forces = (
        Words.same("")
        if loads is None
        else Words(
            "；惯性力与 ω² 成正比" if loads.dynamic else "；反力和平衡载荷与其大小无关",
            "; inertia forces with its square"
            if loads.dynamic
            else "; reactions and the balancing load do not depend on it",
        )
    )
    return Words(
        f"题目只给出 {symbol} 的转向，未给大小，本报告取 |{symbol}| = 1 rad/s 计算和作图。各角速度、"
        f"速度与 {symbol} 成正比，各角加速度、加速度与 {symbol} 的平方成正比，位置与其大小无关{forces.zh}；"
        "转速为其他值时按此换算。",
        f"Only the sense of {symbol} is given, not its size: this report takes |{symbol}| = 1 "
        f"rad/s. All velocities are proportional to {symbol}, all accelerations to its square, and "
        f"positions do not depend on it{forces.en}; for another speed the results scale "
        "accordingly.",
    )


def counted(study: Study) -> Words:
    """From where the angles of this report count, where the position is given in another way."""
    drive = study.mech.drive
    if study.problem.mechanism.drive.ray is None:
        return Words.same("")
    given = next(datum for datum in study.problem.given.motion if datum.symbol == f"φ_{drive.link}")
    here = study.where(drive.position).split(" = ")[1]
    return Words(
        f"本报告中各角由 $x$ 轴量起至构件的 $x$ 轴：题目所给的 {given.of('zh')} 在此为 {here}。",
        f"In this report angles count from the $x$ axis to the $x$ axis of each link: the given {given.of('en')} is "
        f"{here} here.",
    )
