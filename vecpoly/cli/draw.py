"""vecpoly draw: one figure, or the sheet, as SVG, PNG or PDF at its true size."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from ..errors import UnknownNameError
from .errors import about
from .files import write_bytes
from .jobs import problems
from .options import HandOption, Lang, LangOption, OutOption, SeedOption
from .terminal import say

if TYPE_CHECKING:
    from ..drawing.scene import Scene
    from ..solution import Solution

FigureName = Literal["mechanism", "velocity", "acceleration", "sheet"]
FORMATS = (".svg", ".png", ".pdf")
Id = Annotated[str, typer.Argument(metavar="ID_OR_PATH", help="The problem: an id such as 3-9, or a file.", show_default=False)]
FigureOption = Annotated[FigureName, typer.Option("--figure", help="Which figure; sheet is the whole A4 page.")]
Dpi = Annotated[float, typer.Option("--dpi", min=10, max=1200, help="Resolution of a PNG.")]


def draw(
    name: Id,
    figure: FigureOption = "sheet",
    output: OutOption = None,
    lang: LangOption = "zh",
    hand: HandOption = "drafting",
    seed: SeedOption = 0,
    dpi: Dpi = 150.0,
) -> None:
    """Draw a figure or the sheet as SVG, PNG or PDF.

    1 mm drawn is 1 mm on paper. A second page of a sheet goes to x-2.svg (a PDF has them all).
    """
    path = output or Path(f"{Path(name).stem}-{figure}.svg")
    if path.suffix.lower() not in FORMATS:
        raise UnknownNameError(f"{path}: draws {', '.join(FORMATS)}; end the file's name with one of these")
    (problem,) = problems([name])
    from ..solution import solve

    with about(problem.id):
        pages = scenes(solve(problem, by=hand, seed=seed, repeats=0), figure, lang)
    for target, data in encoded(pages, path, dpi):
        say(f"wrote {write_bytes(target, data)}")


def scenes(solution: Solution, figure: FigureName, lang: Lang) -> tuple[Scene, ...]:
    """The pages of a sheet, or the one scene of a figure."""
    if figure == "sheet":
        from ..drawing.sheet import sheets

        return tuple(page.scene for page in sheets(solution.construction, lang=lang, title=solution.problem.title))
    from ..board.construction import View
    from ..drawing.figure import draw_figure
    from ..drawing.scene import Scene

    drawn = solution.construction.figure(View(figure))
    if drawn is None:
        there = ", ".join(one.view.value for one in solution.construction.figures)
        raise UnknownNameError(f"{solution.problem.id} has no figure '{figure}', for nothing it asks needs one; drawn: {there}, sheet")
    scene = draw_figure(drawn, lang=lang)
    return (Scene(scene.items, scene.extents.grown(3.0)),)


def encoded(pages: tuple[Scene, ...], path: Path, dpi: float) -> list[tuple[Path, bytes]]:
    """The files: one PDF of all pages, or one picture a page (x.svg, x-2.svg ...)."""
    if path.suffix.lower() == ".pdf":
        from ..drawing.pdf import to_pdf

        return [(path, to_pdf(*pages))]
    names = [path, *(path.with_name(f"{path.stem}-{n}{path.suffix}") for n in range(2, len(pages) + 1))]
    return [(target, _picture(page, path.suffix.lower(), dpi)) for target, page in zip(names, pages, strict=True)]


def _picture(page: Scene, ending: str, dpi: float) -> bytes:
    if ending == ".svg":
        from ..drawing.svg import to_svg

        return to_svg(page).encode()
    from ..drawing.png import to_png

    return to_png(page, dpi)
