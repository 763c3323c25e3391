"""vecpoly design: a design project, from the data of the task to the demands on the machine, as one report."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from ...words import Words, bare
from ..completion import ids
from ..errors import DISAGREES, Tally
from ..files import STDOUT, put, spared
from ..jobs import refuse_other
from ..options import Hand, HandOption, Lang, LangOption, OutOption, OutsideOption, SeedOption
from ..terminal import add, say, show, table, warn
from ..tongue import told_in
from .report import labelled

if TYPE_CHECKING:
    from ...project.project import Project

PDF = (".pdf",)
_COLUMNS = {"zh": ("要求", "允许值", "图解值", "精确值", "结论"), "en": ("demand", "allowed", "drawn", "exact", "")}
_VERDICT = {True: Words("满足", "met"), False: Words("不满足", "NOT MET")}

ProjectFile = Annotated[
    str,
    typer.Argument(
        metavar="ID_OR_PATH",
        help="A project: design-shaper of the library, or a file.",
        show_default=False,
        autocompletion=ids,
    ),
]


def design(
    name: ProjectFile,
    output: OutOption = None,
    lang: LangOption = "zh",
    hand: HandOption = "drafting",
    seed: SeedOption = 0,
    allow_outside: OutsideOption = False,
) -> None:
    """Write the report of a design project: linkage, motion, forces, cam, gears, and whether the demands are met."""
    from ...problem.load import locate

    tally = Tally()
    unmet = False
    with tally.job():
        refuse_other(locate(name), "design")
        found = _solved(name, hand, seed, allow_outside)
        path = _place(output, found.id, lang)
        spared(path, PDF, more=[found.path])
        from ...report.project.document import project_bytes

        put(path, project_bytes(found, lang=lang, fields=labelled(found.block, lang)))
        _tell(found, lang, tally, quiet=path == STDOUT)
        unmet = not all(one.holds for one in found.demands)
    tally.settle()
    if unmet:
        raise typer.Exit(DISAGREES)


def _solved(name: str, hand: Hand, seed: int, outside: bool) -> Project:
    """The project, each part told as its drawing begins."""
    from ...project.project import load_project

    return load_project(
        name, by=hand, seed=seed, allow_outside=outside,
        tell=lambda title: say(f"  {bare(told_in(title))} ..."),
    )  # fmt: skip


def _place(output: Path | None, name: str, lang: Lang) -> Path:
    """The file; a name of our own in a folder, or here."""
    own = f"{name}.{lang}.pdf"
    if output is None:
        return Path(own)
    return output if output == STDOUT or output.suffix.lower() in PDF else output / own


def _tell(found: Project, lang: Lang, tally: Tally, *, quiet: bool) -> None:
    """The demands as a table; what is to be noted of the parts."""
    from ...report.project.binder import allowed, amount

    for part in found.parts:
        warn(part.problem.id, part.solution.warnings, lang)
        drawn = part.solution.construction
        tally.weigh(part.problem.id, drawn.warning, lang, drawn.conclusion)
    if quiet or not found.demands:
        return
    made = table("", [(head, "left" if i in (0, 4) else "right") for i, head in enumerate(_COLUMNS[lang])])
    for one in found.demands:
        cells = (allowed(one), amount(one.drawn), amount(one.exact), _VERDICT[one.holds].of(lang))
        add(made, (bare(one.say.of(lang)), *cells), alarmed=not one.holds)
    show(made)
