"""Reports, sheets, DXF, GeoGebra, the player, the page of a notebook: of any problem, in either language."""

from __future__ import annotations

import re
from io import BytesIO
from zipfile import ZipFile

import numpy as np
from ezdxf import recover
from pypdfium2 import PdfDocument

from vecpoly.drawing.backends.svg import to_svg
from vecpoly.drawing.sheets.sheet import sheets
from vecpoly.export.dxf.document import figure_dxf, sheet_dxf
from vecpoly.export.geogebra.document import to_ggb
from vecpoly.export.recording import record
from vecpoly.mechanism.model import Mechanism
from vecpoly.notebook.pages import construction_html, problem_html, solution_html
from vecpoly.player.page import player
from vecpoly.report.document import report_bytes
from vecpoly.solution import Solution
from vecpoly.words import Lang

from ..family import family
from .anything import anything, used

NEVER = re.compile(r"(?<![A-Za-z])(None|nan|NaN|inf)(?![A-Za-z])|\{\{|Words\(")


def _lang(rng: np.random.Generator) -> Lang:
    return "zh" if rng.random() < 0.5 else "en"


def _faulty(pdf: bytes) -> str:
    """A page on which nothing is written, or what no reader should see."""
    with PdfDocument(pdf) as book:
        for number, page in enumerate(book, 1):
            text = page.get_textpage().get_text_range()
            if not text.strip():
                return f"page {number} is empty"
            if said := NEVER.search(text):
                return f"page {number} says {text[max(0, said.start() - 40) : said.end() + 20]!r}"
    return ""


@used
def reported(solution: Solution, rng: np.random.Generator) -> str:
    """The solution, or the questions, as a PDF."""
    style = "question" if rng.random() < 0.25 else "solution"
    return _faulty(report_bytes([solution], lang=_lang(rng), style=style, plain=bool(rng.random() < 0.3)))


@used
def studied(solution: Solution, rng: np.random.Generator) -> str:
    """The course report of a mechanism."""
    if not isinstance(solution.problem.subject, Mechanism):
        return ""
    return _faulty(report_bytes([solution], lang=_lang(rng), style="course"))


@used
def drawn(solution: Solution, rng: np.random.Generator) -> str:
    """Sheets as SVG and DXF, figures as DXF after some step: files that others open, with something in them."""
    construction, lang = solution.construction, _lang(rng)
    step = int(rng.integers(1, len(construction.steps) + 1)) if construction.steps else None
    made = sheets(construction, lang=lang, title=solution.problem.title, on=solution.problem.paper)
    for page in made:
        if '"nan' in to_svg(page.scene) or "NaN" in to_svg(page.scene):
            return "a place on the sheet is no number"
        if wrong := _unsound(sheet_dxf(page)):
            return wrong
    for figure in construction.figures:
        figure_dxf(figure, lang, step)
        if wrong := _unsound(figure_dxf(figure, lang)):
            return f"{figure.view}: {wrong}"
    return "" if made else "there is no sheet"


def _unsound(dxf: bytes) -> str:
    document, audit = recover.read(BytesIO(dxf))
    if audit.has_errors:
        return f"the DXF is faulty: {audit.errors[0].message}"
    return "" if len(document.modelspace()) else "the DXF is empty"


@used
def moving(solution: Solution, rng: np.random.Generator) -> str:
    """The GeoGebra file."""
    with ZipFile(BytesIO(to_ggb(record(solution.problem), _lang(rng)))) as whole:
        return "" if "geogebra.xml" in whole.namelist() else "there is no construction in the file"


@used
def played(solution: Solution, rng: np.random.Generator) -> str:
    """The step player, and the page in a notebook."""
    page = player(solution, lang=_lang(rng), places=int(rng.choice([0, 5])), check=bool(rng.random() < 0.3))
    told = [problem_html(solution.problem, "en"), solution_html(solution, "zh")]
    told.append(construction_html(solution.construction, "en"))
    return "" if page.html.rstrip().endswith("</html>") and all(told) else "a page is empty"


family("used-report", also=reported, often=1, first=6)(anything("report"))
family("used-course", also=studied, often=1, first=33)(
    anything(
        "course",
        "linkage",
        "class-iii",
        "gears",
        "cylinder",
        "roller",
        "change",
        "forces",
        "offset",
        "pin-in",
        "machine",
    )
)
family("used-drawn", also=drawn, often=1, first=11)(anything("drawn"))
family("used-geogebra", also=moving, often=1, first=8)(
    anything("geogebra", "linkage", "class-iii", "gears", "offset", "pin-in", "four")
)
family("used-player", also=played, often=1, first=7)(anything("player"))
