"""vecpoly class: sheets, solutions, register, key and forms for everybody on a roster."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from ...errors import VecpolyError
from ...words import Words
from ..errors import REFUSED, tell
from ..options import JobsOption, LangOption, OutsideOption, place
from ..terminal import say, wrote
from ..tongue import told_in

if TYPE_CHECKING:
    from ...batch.classwork import Made
    from ...batch.forms.profile import Profile
    from ...batch.roster import Roster
    from ...problem.problem import Problem

Told = Callable[[Words, int, int], None]
Sheet = Annotated[
    Path,
    typer.Argument(metavar="ASSIGNMENT", help="The assignment: a YAML file that lists problems.", show_default=False),
]
RosterOption = Annotated[
    Path, typer.Option("--roster", metavar="FILE", help="Numbers, names and classes: XLSX or CSV.", show_default=False)
]
OutOption = Annotated[
    Path,
    typer.Option("-o", "--output", metavar="FOLDER", parser=place, help="The folder to write to.", show_default=False),
]
ShardOption = Annotated[
    str,
    typer.Option(
        "--shard",
        metavar="I/N",
        help="Write only every Nth sheet, from the Ith (0/4 ... 3/4), and a manifest; --gather completes the class.",
        show_default=False,
    ),
]
GatherOption = Annotated[
    list[Path] | None,
    typer.Option(
        "--gather",
        metavar="FOLDER",
        help="Complete the class from this folder of shards, or from several: all there, none twice, bytes equal.",
        show_default=False,
    ),
]
DaskOption = Annotated[
    str | None,
    typer.Option(
        "--dask",
        metavar="ADDRESS",
        help="Let a Dask cluster do the work: the address of its scheduler.",
        show_default=False,
    ),
]
ProfileOption = Annotated[
    Path | None,
    typer.Option(
        "--profile",
        metavar="FILE",
        help="Also a table with the columns of another platform, as this YAML file says.",
        show_default=False,
    ),
]


def classes(
    assignment: Sheet,
    roster: RosterOption,
    output: OutOption,
    lang: LangOption = "zh",
    jobs: JobsOption = 0,
    shard: ShardOption = "",
    gather: GatherOption = None,
    dask: DaskOption = None,
    profile: ProfileOption = None,
    allow_outside: OutsideOption = False,
) -> None:
    """Give everybody on a roster own numbers: question and solution PDFs, register, key, answers form, Moodle
    questions.

    Killed at any moment, it goes on where it was when it is started again.
    """
    from ... import __version__
    from ...batch.classwork import Order, make_class
    from ...batch.gather import gather as gathered
    from ...batch.roster import read_roster
    from ...batch.run.runners import runner
    from ...problem.assignment import load_assignment

    part, people = _shard(shard, gather), read_roster(roster)
    order = Order(
        assignment=load_assignment(assignment, allow_outside=allow_outside),
        students=people.students,
        out=output,
        lang=lang,
        version=__version__,
    )
    columns = _columns(profile, order.assignment.problems)
    with progress_bar() as told, runner(jobs or os.cpu_count() or 1, dask) as run:
        made = gathered(order, gather, run, told) if gather else make_class(order, run, told, part)
        if part is None:
            _bundle(made, output, columns, told)
    _report(made, order.assignment.problems)
    _settle(people, made.refused)


def _columns(path: Path | None, problems: Sequence[Problem]) -> Profile | None:
    """The columns of another platform's table, each of which will hold something."""
    from ...batch.forms.profile import read_profile, refuse_unknown

    if path is None:
        return None
    refuse_unknown(profile := read_profile(path), problems)
    return profile


def _settle(people: Roster, refused: Mapping[str, VecpolyError]) -> None:
    """Tell which rows and which students came to nothing, and leave with an exit code of failure where there were
    any."""
    if people.nameless:
        said = Words(
            "名单中没有“姓名”一列：题单上只有学号", "the roster has no column of names: sheets have numbers alone"
        )
        say(told_in(said))
    errors: list[Exception] = [VecpolyError(one.words, code=one.code, faults=(one,)) for one in people.faults]
    errors += [error.led_by(Words(f"{number}：", f"{number}: ")) for number, error in sorted(refused.items())]
    for error in errors:
        tell(error)
    if errors:
        raise typer.Exit(REFUSED)


def _shard(text: str, gather: Sequence[Path] | None) -> tuple[int, int] | None:
    """0/4: the first of four."""
    if not text:
        return None
    if gather:
        raise VecpolyError(
            Words(
                "--shard 与 --gather 不能同时写；请先分片，再汇总",
                "--shard and --gather do not go together; write the shards, then gather them",
            ),
            code="shard",
        )
    found = re.fullmatch(r"(\d+)/(\d+)", text)
    if found is None or not int(found[1]) < int(found[2]):
        raise VecpolyError(
            Words(
                f"--shard {text}：应写 0/4、1/4、2/4、3/4 之类", f"--shard {text}: write 0/4, 1/4, 2/4, 3/4 or the like"
            ),
            code="shard",
        )
    return int(found[1]), int(found[2])


def _bundle(made: Made, output: Path, profile: Profile | None, told: Told) -> None:
    from ...batch.moodle.quiz import left_out
    from ...batch.outputs import BESIDE, FORM, left_over, outputs

    for path in outputs(made.register, output, profile, told):
        wrote(path)
        if path.name == BESIDE:
            say(
                told_in(
                    Words(
                        f"{output / FORM} 中已填有答案，未改动；新的空白表在 {path}",
                        f"{output / FORM} holds answers and stays as it is; the new blank form is {path}",
                    )
                )
            )
    if none := left_out(made.register):
        said = Words(
            f"{'、'.join(none)} 不在 Moodle 题库中：所求各量手工作图散布太大，不能由 Moodle 判分",
            f"{', '.join(none)}: not among the questions for Moodle, for drawings scatter too much there to be marked "
            "by it",
        )
        say(told_in(said))
    if old := left_over(made.register, output):
        names = [str(path.relative_to(output)) for path in old]
        said = Words(
            "以下文件不属于现在的名单（已退出，或改了姓名），可删去：", "of nobody on the roster now, may be deleted: "
        )
        say(told_in(said + Words("、".join(names), ", ".join(names))))


def _report(made: Made, problems: Sequence[Problem]) -> None:
    """Yield and what is demoted, problem by problem; texts that ask for something else."""
    from ...variants.told import asks_otherwise, demoted, said_already, told

    for line in (line for problem in problems for line in asks_otherwise(problem)):
        say(told_in(line))
    for name, found in made.pilots.items():
        if found.standard.work:
            for line in (*told(name, found), *demoted(found), *said_already(made.register.exercise(name).problem)):
                say(told_in(line))
    count = len(made.register.sheets)
    say(told_in(Words(f"{count} 份作业", f"{count} sheet{'' if count == 1 else 's'}")))


@contextmanager
def progress_bar() -> Iterator[Told]:
    """A bar on stderr where somebody watches."""
    if not sys.stderr.isatty():
        yield lambda doing, done, of: None
        return
    from rich.console import Console
    from rich.progress import Progress, TaskID

    with Progress(console=Console(stderr=True), transient=True) as progress:
        tasks: dict[str, TaskID] = {}

        def told(doing: Words, done: int, of: int) -> None:
            name = told_in(doing)
            if name not in tasks:
                tasks[name] = progress.add_task(name)
            progress.update(tasks[name], total=of, completed=done)

        yield told
