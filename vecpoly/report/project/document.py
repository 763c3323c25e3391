"""The report of a project as a PDF: a template filled, and set with its drawings."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from ...foundation.data import data_dir
from ...foundation.files import write_whole
from ...foundation.stock import one_format
from ...project.part import Part
from ...project.project import Project
from ...words import Lang, Words
from ..content import Objects
from ..course.document import cover
from ..course.numbering import Press
from ..document import FIELDS, alarms
from ..flow.doc import Metadata
from ..flow.listing import Listing
from ..flow.paging.tight import saved
from ..flow.xml import to_flowables
from ..identity import told
from ..templates import filled
from . import device, forces, linkage, motion, summary, task
from .binder import Binder, binder, pages

KIND = Words("机械原理课程设计说明书", "Theory of machines: design report")


def write_project(
    project: Project, path: str | Path, *, lang: Lang = "zh", fields: Mapping[str, str] | None = None,
    templates: Path | None = None,
) -> Path:  # fmt: skip
    """Write the report of a project; the file appears whole or not at all."""
    return write_whole(Path(path), project_bytes(project, lang=lang, fields=fields, templates=templates))


def project_bytes(
    project: Project, *, lang: Lang = "zh", fields: Mapping[str, str] | None = None, templates: Path | None = None
) -> bytes:
    """The PDF that `write_project` writes; fields: the title block by its labels; templates: before the built-in."""
    objects = Objects()
    folders = (*((Path(templates),) if templates else ()), data_dir("templates"))
    context = _context(project, lang, fields or {}, objects)
    document = filled(f"project.{lang}.xml.j2", folders, context)
    solutions = [position.solution for part in project.parts for position in _solved(part)]
    meta = Metadata(
        title=project.title.of(lang),
        subject=KIND.of(lang),
        keywords=(project.id,),
        lang=lang,
        identity=told([project.id], [project.text]),
        format=one_format(one.problem.paper for one in solutions),
    )
    return saved([*alarms(solutions, lang), *to_flowables(document, objects.named, lang)], meta)


def _solved(part: Part) -> tuple[Any, ...]:
    return part.positions if part.moves else (part,)


def _context(project: Project, lang: Lang, fields: Mapping[str, str], objects: Objects) -> dict[str, Any]:
    """All that a template may say."""
    bound = binder(project, Press(lang, objects))
    first, second = task.task(bound), task.schemes(bound)
    chapters = list(_chapters(bound))
    bound.press.chapter = last = str(len(chapters) + 3)
    return {
        "title": project.title.of(lang),
        "kind": KIND.of(lang),
        "fields": [(name, fields.get(name, "")) for name in FIELDS[lang]],
        "cover": _cover(bound),
        "task": first,
        "schemes": second,
        "chapters": chapters,
        "summary": {"n": last, **summary.chapter(bound)},
        "file": objects.add("listing", Listing(project.text)),
        "sheets": pages(bound),
    }


def _chapters(bound: Binder) -> Iterator[dict[str, Any]]:
    """One for each part, two for a mechanism with loads."""
    n = 2
    for part in bound.project.parts:
        title = part.problem.title.of(bound.lang)
        for kind, made in _kinds(part):
            n += 1
            bound.press.chapter = str(n)
            yield {"n": n, "kind": kind, "title": title, **made(part, bound)}


def _kinds(part: Part) -> Iterator[tuple[str, Any]]:
    if part.finds:
        yield "linkage", linkage.chapter
    elif part.moves:
        yield "motion", motion.chapter
        if part.problem.loads is not None:
            yield "forces", forces.chapter
    else:
        yield "device", device.chapter


def _cover(bound: Binder) -> str:
    part = next((one for one in bound.project.parts if one.moves), None)
    return "" if part is None else cover(part.solution, bound.lang, bound.press.objects)
