"""Design projects of the library, each solved and printed once for all files that make claims about them."""

from __future__ import annotations

from functools import cache

import pypdfium2

from vecpoly.project.project import Project, load_project
from vecpoly.report.project.document import project_bytes
from vecpoly.words import Lang

NAMES = ("design-shaper", "design-press", "design-feeder")


@cache
def project(name: str) -> Project:
    """The project, solved by the drafting hand."""
    return load_project(name)


@cache
def printed(name: str, lang: Lang) -> bytes:
    """Its report."""
    return project_bytes(project(name), lang=lang)


@cache
def pages(name: str, lang: Lang) -> tuple[str, ...]:
    """The text of each page."""
    with pypdfium2.PdfDocument(printed(name, lang)) as document:
        return tuple(page.get_textpage().get_text_range() for page in document)
