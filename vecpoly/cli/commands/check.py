"""vecpoly check: printed answers against exact ones, with a verdict on each and on the whole."""

from __future__ import annotations

from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from ...foundation.patterns import pattern
from ...names import written_unit
from ...words import Words, bare
from ..classes.claims import check_claims, claims_among, with_equals
from ..completion import ids
from ..errors import DISAGREES, Tally, about
from ..files import STDOUT, spared, write_json
from ..jobs import problems
from ..options import JSON, ColumnsOption, JsonOption, Lang, LangOption, OutsideOption, TableOption
from ..terminal import add, progress, show, table
from ..wording import beside, degrees, number, percent, sense, symbol
from .check_drawing import check_drawings, drawings_among
from .check_table import check_table_of, columns_said

if TYPE_CHECKING:
    from ...check.printed.answers import PrintedCheck
    from ...check.printed.verdict import Checked
    from ...problem.problem import Printed, Problem

_COLUMNS = {
    "zh": ("量", "原书", "精确值", "偏差", "结论", "缘由"),
    "en": ("quantity", "printed", "exact", "deviation", "verdict", "by which slip"),
}
_SENSED = pattern(r"\bc?cw\b")
_NOTHING = {"zh": "没有可核对的印刷答案", "en": "no printed answers to check"}


Claimed = Annotated[
    list[str],
    typer.Argument(
        metavar="ID_OR_FILE... [SYMBOL=VALUE...]",
        help="The problems, and answers such as v_D=0.49.",
        show_default=False,
        autocompletion=ids,
    ),
]


def check(
    names: Claimed,
    table_file: TableOption = None,
    columns: ColumnsOption = None,
    json: JsonOption = None,
    lang: LangOption = "en",
    allow_outside: OutsideOption = False,
) -> None:
    """Check printed answers, or a printed table, against exact values.

    Each gets a verdict and, if wrong, the slip that explains it; where several are wrong, all crank angles and
    assemblies are tried, to see whether the numbers are possible at all. With --table, the columns of a table over
    the cycle are compared. Answers of one's own may stand behind the problem: check 3-12 v_D=0.49 ω5=4.72
    "α3=12 rad/s² cw". Each is right, close, or wrong with the reason, where one slip alone explains it.

    Exit code: 0 all agrees, 1 something printed is wrong, 2 it cannot be checked.
    """
    if files := drawings_among(names):
        check_drawings(names, files, json, lang, allow_outside)
        return
    said, names = columns_said(columns), with_equals(names)
    tally = Tally()
    if claims := claims_among(names):
        check_claims(names, claims, tally, json, lang, allow_outside)
        return
    found = problems(names, tally, allow_outside)
    spared(json, JSON, found, [table_file] if table_file else [])
    if table_file is not None:
        tally.settle()
        check_table_of(found, table_file, said, json, lang)
        return
    _check_printed(found, tally, json, lang)


def _check_printed(found: list[Problem], tally: Tally, json: Path | None, lang: Lang) -> None:
    """The printed answers of each problem; leaves with an exit code of its own where one is wrong."""
    from ...check.printed.answers import check_problem
    from ...check.printed.verdict import Verdict

    checked: list[tuple[Problem, PrintedCheck]] = []
    for problem in progress(found, Words("核对", "checking")):
        with tally.job(), about(problem):
            checked.append((problem, check_problem(problem)))
    if json != STDOUT:
        for problem, result in checked:
            _print(problem, result, lang)
    if json is not None and checked:
        data = [_as_json(problem, result) for problem, result in checked]
        write_json(data if len(data) + len(tally.failed) > 1 else data[0], json)
    tally.settle()
    if any(line.verdict is Verdict.WRONG for _, result in checked for line in result.answers) or any(
        result.whole is not None for _, result in checked
    ):
        raise typer.Exit(DISAGREES)


def _print(problem: Problem, result: PrintedCheck, lang: Lang) -> None:
    title = f"{problem.id}  {bare(problem.title.of(lang))}"
    if not problem.printed:
        typer.echo(f"{title}: {_NOTHING[lang]}\n")
        return
    right = {2, 3}
    made = table(title, [(name, "right" if i in right else "left") for i, name in enumerate(_COLUMNS[lang])])
    for line in result.answers:
        add(made, _row(line, lang))
    for printed in result.unchecked:
        add(made, (symbol(printed.symbol), _as_printed(printed, lang), "—", "—", "—", ""))
    show(made)
    if result.whole is not None:
        typer.echo(f"{bare(result.whole.of(lang))}\n")


def _row(line: Checked, lang: Lang) -> tuple[str, ...]:
    printed, name = line.printed, _unit(line.printed)
    text = _as_printed(printed, lang)
    if printed.paper_mm is not None:
        text += f" = {beside(number(printed.value), name)}"
    return (
        symbol(printed.symbol), text, _exact(line, lang), _off(line), line.verdict.words.of(lang),
        bare(line.slip.of(lang)) if line.slip else "",
    )  # fmt: skip


def _as_printed(printed: Printed, lang: Lang) -> str:
    from ...problem.problem import as_printed

    return written_unit(as_printed(printed.text, lang)).replace("*", "·").replace("-", "−")


def _exact(line: Checked, lang: Lang) -> str:
    """The exact value with its unit, and with its sense where the printed one has one."""
    if not line.exact or not _SENSED.search(line.printed.text):
        return beside(number(line.exact), _unit(line.printed))
    return f"{beside(number(abs(line.exact)), _unit(line.printed))} {sense(line.exact, lang)}"


def _off(line: Checked) -> str:
    """By how many per cent a printed value is off, an angle by how many degrees; of an exact zero nothing."""
    from ...check.printed.verdict import is_angle

    if not isfinite(line.deviation):
        return "—"
    return degrees(line.deviation * line.exact) if is_angle(line.printed) else percent(line.deviation)


def _unit(printed: Printed) -> str:
    return written_unit(printed.rel.unit if printed.rel is not None else "m")


def _as_json(problem: Problem, result: PrintedCheck) -> dict[str, Any]:
    data: dict[str, Any] = {"id": problem.id, "answers": [_line(line) for line in result.answers]}
    data["unchecked"] = [printed.symbol for printed in result.unchecked]
    data["possible"] = result.whole is None
    data["misfit"] = None if result.fit is None else result.fit.misfit
    return data


def _line(line: Checked) -> dict[str, Any]:
    return {
        "symbol": line.printed.symbol, "printed": line.printed.text, "value": line.printed.value, "exact": line.exact,
        "deviation": line.deviation if isfinite(line.deviation) else None, "verdict": line.verdict.value,
        "slip": line.slip.en if line.slip else None,
    }  # fmt: skip
