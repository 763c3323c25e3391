"""vecpoly search: a linkage for a path, for a dwell, for the best transmission, among many candidates."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from ...names import written_unit
from ...words import Words, bare
from ..errors import Tally
from ..files import STDOUT, put, spared
from ..jobs import refuse_other
from ..options import JobsOption, Lang, LangOption, OutOption
from ..terminal import add, progress, show, table
from ..wording import beside, number

if TYPE_CHECKING:
    from ...problem.problem import Problem
    from ...search.run import Found

ENDINGS = (".yaml", ".pdf")
_COLUMNS = {"zh": ("求得", "值"), "en": ("found", "value")}

SearchFile = Annotated[
    str,
    typer.Argument(metavar="ID_OR_PATH", help="A search: search-dwell of the library, or a file.", show_default=False),
]
RandomOption = Annotated[int, typer.Option("--seed", min=0, help="Seed of the candidates: another has others.")]
CountOption = Annotated[
    int | None,
    typer.Option(
        "--candidates", min=1000, max=100_000_000, help="How many are tried, instead of the file's.", show_default=False
    ),
]


def search(
    name: SearchFile,
    output: OutOption = None,
    count: CountOption = None,
    seed: RandomOption = 0,
    processes: JobsOption = 0,
    lang: LangOption = "en",
) -> None:
    """Search a linkage where no construction gives one: for a path, for a dwell, for the best transmission angle.

    -o FOUND.yaml writes it as a problem, to be drawn and analysed; -o FOUND.pdf its report.
    """
    from ...problem.load import locate

    tally = Tally()
    with tally.job():
        spared(output, ENDINGS, more=[Path(name)])
        refuse_other(locate(name), "search")
        found = _found(name, count, seed, processes)
        if output is not None:
            put(output, _written(found, output, lang))
        if output != STDOUT:
            _tell(found, lang)
    tally.settle()


def _found(name: str, count: int | None, seed: int, processes: int) -> Found:
    from ...search.run import run
    from ...search.spec import load_search

    def watch(blocks: Sequence[Any]) -> Iterable[Any]:
        return progress(blocks, Words("搜索", "searching"))

    sought, spec, path = load_search(name)
    tried = count or spec.candidates
    jobs = processes or os.cpu_count() or 1
    return run(sought, path.stem, spec.title, count=tried, seed=seed, jobs=jobs, watch=watch)


def _written(found: Found, output: Path, lang: Lang) -> bytes:
    """The problem file, or its report."""
    if output.suffix.lower() != ".pdf":
        return found.problem.text.encode()
    from ...report.document import report_bytes
    from ...solution import solve

    return report_bytes([solve(found.problem)], lang=lang)


def _tell(found: Found, lang: Lang) -> None:
    """What was found, as the general solver measures it."""
    made = table(
        bare(found.problem.title.of(lang)),
        [(head, "left" if not i else "right") for i, head in enumerate(_COLUMNS[lang])],
    )
    for one in found.measures:
        add(made, (one.name.of(lang), beside(number(one.value), written_unit(one.unit))))
    add(made, (Words("候选数", "candidates").of(lang), str(found.tried)))
    for row in _linkage(found.problem):
        add(made, row)
    show(made)
    for length in found.problem.given.lengths:
        if length.words is not None:  # a point beside its link
            told = bare(length.words.of(lang))
            typer.echo(f"{told[0].upper()}{told[1:]}{Words('。', '.').of(lang)}")


def _linkage(problem: Problem) -> Iterable[tuple[str, str]]:
    """Where its fixed pivots lie, and its lengths."""
    for letter, at in problem.mechanism.frame.items():
        yield letter, f"({number(1e3 * at.real)}, {number(1e3 * at.imag)}) mm"
    for length in problem.given.lengths:
        if length.words is None:
            yield bare(length.symbol), length.text
