"""vecpoly draw: one figure, or the sheet, as SVG, PNG, PDF or DXF at its true size."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NamedTuple

import typer

from ...errors import UnknownNameError, VecpolyError
from ...words import Words
from ..completion import ids
from ..errors import Tally, about
from ..files import STDOUT, put, spared
from ..jobs import each, problems
from ..letters import warn_of_letters
from ..onward import ThenOption, onward
from ..options import HandOption, Lang, LangOption, OutOption, OutsideOption, PaperOption, PlainOption, SeedOption
from ..terminal import warn

if TYPE_CHECKING:
    from ...board.construction import Construction, Figure, Place
    from ...drawing.scene import Scene
    from ...drawing.sheets.sheet import Sheet
    from ...solution import Solution


class Said(NamedTuple):
    """What a drawing is called, and what it shows, in words."""

    title: str = ""
    shown: str = ""


SHEET, SILENT = "sheet", Said()
FORMATS = (".svg", ".png", ".pdf", ".dxf")
Id = Annotated[
    str,
    typer.Argument(
        metavar="ID_OR_PATH",
        help="A problem or an assignment: an id such as 3-9, or a file.",
        show_default=False,
        autocompletion=ids,
    ),
]
FigureOption = Annotated[
    str,
    typer.Option(
        "--figure",
        metavar="NAME",
        help="mechanism, velocity, acceleration, body, force; one of several by its name: force:3; sheet is the whole "
        "A4 page.",
    ),
]
StepOption = Annotated[
    int | None,
    typer.Option("--step", min=1, metavar="N", show_default=False, help="The paper as it stands after step N."),
]
Dpi = Annotated[float, typer.Option("--dpi", min=10, max=1200, help="Resolution of a PNG.")]


def draw(
    name: Id,
    figure: FigureOption = SHEET,
    output: OutOption = None,
    lang: LangOption = "zh",
    hand: HandOption = "drafting",
    seed: SeedOption = 0,
    dpi: Dpi = 150.0,
    step: StepOption = None,
    plain: PlainOption = False,
    paper: PaperOption = None,
    allow_outside: OutsideOption = False,
    then: ThenOption = None,
) -> None:
    """Draw a figure or the sheet as SVG, PNG, PDF or DXF.

    1 mm drawn is 1 mm on paper. A second page of a sheet goes to x-2.svg (a PDF has them all).
    A DXF has layers by what a line is for.
    """
    path = output or Path(f"{Path(name).stem}-{figure.replace(':', '-').replace(' ', '-')}.svg")
    tally = Tally()
    found = onward(problems([name], tally, allow_outside, paper), then, tally, lang, hand, seed)
    spared(path, FORMATS, found)
    from ...solution import solve

    for problem in found:
        with tally.job(), about(problem):
            solution = solve(problem, by=hand, seed=seed, repeats=0)
            solution = solution.toned({}) if plain else solution
            warn_of_letters([problem], lang)
            last = len(solution.construction.steps)
            upto = None if step in (None, last) else known_step(solution.construction, step)
            for target, data in _files(solution, figure, lang, each(path, problem.id, len(found)), dpi, upto):
                put(target, data)
            warn(problem.id, solution.warnings, lang)
            tally.weigh(problem.id, solution.construction.warning, lang, solution.construction.conclusion)
    tally.settle()


def _files(
    solution: Solution, figure: str, lang: Lang, path: Path, dpi: float, upto: int | None
) -> list[tuple[Path, bytes]]:
    if path.suffix.lower() != ".dxf":
        return encoded(scenes(solution, figure, lang, upto), path, dpi, said=_said(solution, figure, lang), lang=lang)
    from ...export.dxf.document import figure_dxf, sheet_dxf

    if figure != SHEET:
        return [(path, figure_dxf(_drawn(solution, figure), lang, upto))]
    files = [sheet_dxf(page, upto) for page in _sheets(solution, lang)]
    return list(zip(_names(path, len(files)), files, strict=True))


def _sheets(solution: Solution, lang: Lang) -> tuple[Sheet, ...]:
    from ...drawing.sheets.sheet import sheets
    from ...report.plates.results import concluded

    title, paper = solution.problem.title, solution.problem.paper
    return concluded(sheets(solution.construction, lang=lang, title=title, on=paper), solution, lang)


def scenes(solution: Solution, figure: str, lang: Lang, upto: int | None = None) -> tuple[Scene, ...]:
    """The pages of a sheet, or the one scene of a figure; upto: as they stand after that step."""
    if figure == SHEET:
        from ...drawing.sheets.unfinished import after

        return tuple((page if upto is None else after(page, upto)).scene for page in _sheets(solution, lang))
    from ...drawing.figure import draw_figure
    from ...drawing.scene import Scene

    scene = draw_figure(_drawn(solution, figure), lang=lang, upto_step=upto)
    return (Scene(scene.items, scene.extents.grown(3.0)),)


def _said(solution: Solution, figure: str, lang: Lang) -> Said:
    """What a PDF or an SVG says of the drawing to whoever cannot see it."""
    from ...report.plates.shown import shown

    return Said(solution.problem.title.of(lang), "" if figure == SHEET else shown(_drawn(solution, figure), lang))


def _drawn(solution: Solution, figure: str) -> Figure:
    """The figure of this name; raises UnknownNameError where none is drawn."""
    place = placed(figure)
    drawn = None if place is None else solution.construction.figure(place)
    if drawn is None:
        there = ", ".join([*named(solution.construction), SHEET])
        raise UnknownNameError(
            Words(
                f"没有图“{figure}”，所求各量用不到它；已绘的图：{there}",
                f"there is no figure '{figure}', for nothing it asks needs one; drawn: {there}",
            )
        )
    return drawn


def known_step(construction: Construction, step: int) -> int:
    """The number of a step; raises UnknownNameError where the solution has fewer."""
    if step > len(construction.steps):
        raise UnknownNameError(
            Words(
                f"没有第 {step} 步：题 {construction.problem} 的解答有 {len(construction.steps)} 步；"
                f"vecpoly solve {construction.problem} --acts 列出各步",
                f"there is no step {step}: the solution of {construction.problem} has "
                f"{len(construction.steps)}; 'vecpoly solve {construction.problem} --acts' lists them",
            ),
            code="no-step",
            numbers={"step": step, "steps": len(construction.steps)},
        )
    return step


def placed(figure: str) -> Place | None:
    """The figure of this name: a kind (`force`, the first of several) or one by its name (`force:3`)."""
    from ...board.place import Pane, view_named, views

    kind, _, name = figure.partition(":")
    if kind not in {view.name for view in views()}:
        return None
    return Pane(view_named(kind), name) if name else view_named(kind)


def named(construction: Construction) -> list[str]:
    """The names of all figures drawn."""
    return [f"{one.view.name}:{one.name}" if one.name else one.view.name for one in construction.figures]


def encoded(
    pages: tuple[Scene, ...], path: Path, dpi: float, *, said: Said = SILENT, lang: Lang = "en"
) -> list[tuple[Path, bytes]]:
    """The files: one PDF of all pages, or one picture a page (x.svg, x-2.svg ...)."""
    if path.suffix.lower() == ".pdf":
        from ...drawing.backends.pdf import to_pdf

        return [(path, to_pdf(*pages, title=": ".join(filter(None, said)) or path.stem, lang=lang))]
    if path == STDOUT and len(pages) > 1:
        raise VecpolyError(
            Words(
                f"共 {len(pages)} 页，标准输出只容一页；请用 -o 文件.pdf，或用 --figure 取一图",
                f"there are {len(pages)} pages, and standard output takes one; write -o "
                "FILE.pdf, or ask for one with --figure",
            ),
            code="pages",
        )
    return [
        (target, _picture(page, path.suffix.lower(), dpi, said))
        for target, page in zip(_names(path, len(pages)), pages, strict=True)
    ]


def _names(path: Path, count: int) -> list[Path]:
    """A file for every page."""
    return [path, *(path.with_name(f"{path.stem}-{n}{path.suffix}") for n in range(2, count + 1))]


def _picture(page: Scene, ending: str, dpi: float, said: Said) -> bytes:
    if ending not in (".png",):
        from ...drawing.backends.svg import to_svg

        return to_svg(page, said.title, desc=said.shown).encode()
    from ...drawing.backends.png import to_png

    return to_png(page, dpi)
