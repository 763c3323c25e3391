"""A report from solutions: Jinja2 fills a template of our small XML,
which is set with drawn figures, tables and formulas."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from jinja2 import TemplateNotFound

from ..board.construction import Construction, Figure
from ..check.printed.answers import check_problem
from ..designs.base import Design
from ..drawing.sheets.sheet import hung
from ..errors import ArgumentError, NotAskedError, UnknownNameError
from ..foundation.arguments import known_language, of_kind
from ..foundation.data import data_dir
from ..foundation.files import write_whole
from ..foundation.stock import one_format
from ..solution import REPEATS, Solution
from ..typeset.box import MM
from ..words import Lang, Words, label
from .answers.box import answer_box, explained_by
from .answers.moved import moved_told
from .content import Objects, beside_tables, by_rank, cautions, conclusions
from .flow.blocks import Callout, Drawing
from .flow.doc import Metadata, ReportDoc, Stamp
from .flow.paging.tight import saved
from .flow.results.halved import even
from .flow.table import DataTable
from .flow.xml import to_flowables
from .identity import identity
from .lines import lines_table
from .picture import diagram, magnified, to_scale
from .plates.bound import bound, pages, with_plates
from .plates.sketch import LETTERED, sketch_of
from .printed_tables import printed_tables
from .question.content import question
from .question.framed.frames import frames
from .question.sketch import sketched
from .steps.sections import sections
from .tables import given_tables, printed_table
from .templates import filled
from .titles import subject
from .verdicts import concluded, judged_by, verdicts
from .verification.table import as_moved, beside_exact, heads_told

FIELDS: dict[Lang, tuple[str, ...]] = {
    "zh": ("班级", "姓名", "学号", "成绩", "任课教师", "批改日期"),
    "en": ("Class", "Name", "Student no.", "Mark", "Lecturer", "Marked on"),
}
_SOLVED = Words("解答（solve 的结果）", "a solution, as solve gives it,")
STYLES = ("solution", "question", "course")
WIDEST = 160.0  # mm: of a sketch that is drawn larger, to fill its page
PICTURE = (125.0 / LETTERED, 62.0 / LETTERED)  # mm: room for the mechanism beside the statement
ALONE = (140.0 / LETTERED, 85.0 / LETTERED)  # mm: where no sheet follows, on which it would be larger


def write_report(
    solutions: Sequence[Solution],
    path: str | Path,
    *,
    lang: Lang = "zh",
    style: str = "solution",
    fields: Mapping[str, str] | None = None,
    title: Words | None = None,
    templates: Path | None = None,
    plain: bool = False,
) -> Path:
    """Write one PDF of these solutions; the file appears whole or not at all.

    fields: values of the title block by their label; templates: a folder whose templates come before the built-in ones;
    plain: in black alone, as a question always is.
    Raises UnknownNameError for a style without a template.
    """
    of_kind(path, (str, Path), Words("文件名", "the name of a file"))
    return write_whole(
        Path(path),
        report_bytes(solutions, lang=lang, style=style, fields=fields, title=title, templates=templates, plain=plain),
    )


def report_bytes(
    solutions: Sequence[Solution],
    *,
    lang: Lang = "zh",
    style: str = "solution",
    fields: Mapping[str, str] | None = None,
    title: Words | None = None,
    templates: Path | None = None,
    stamp: Stamp | None = None,
    plain: bool = False,
) -> bytes:
    """The PDF that `write_report` writes; stamp: draws on every page."""
    known_language(lang)
    solutions = [
        of_kind(one, Solution, _SOLVED)
        for one in of_kind(solutions, Sequence, Words("若干解答的列表", "a list of solutions"))
    ]
    if not solutions:
        raise ArgumentError(
            Words("没有可写的解答：列表是空的", "there is nothing to report: the list of solutions is empty"),
            code="empty",
        )
    if plain or style == "question":
        solutions = [one.toned({}) for one in solutions]
    document, objects = markup(solutions, lang, style, fields or {}, title, templates)
    head = (title or _title(solutions)).of(lang)
    story = [*alarms(solutions, lang), *to_flowables(document, objects.named, lang)]
    meta = Metadata(
        title=head,
        author=(fields or {}).get(FIELDS[lang][1], ""),
        subject=subject(solutions).of(lang),
        keywords=tuple(s.problem.id for s in solutions),
        lang=lang,
        identity="" if stamp else identity([s.problem for s in solutions]),
        format=one_format(s.problem.paper for s in solutions),
    )
    return saved(story, meta) if stamp is None else ReportDoc(story, meta, stamp).made()[0]


def alarms(solutions: Sequence[Solution], lang: Lang) -> list[Callout]:
    """The red boxes that open a report in which an answer is suspect, whatever its template says."""
    said = [(one.problem.id, one.construction.warning) for one in solutions]
    return [
        Callout(Words(f"题 {name}：{text.zh}", f"Problem {name}: {text.en}").of(lang), "fail", lang)
        for name, text in said
        if text is not None
    ]


def markup(
    solutions: Sequence[Solution],
    lang: Lang,
    style: str,
    fields: Mapping[str, str],
    title: Words | None,
    templates: Path | None,
) -> tuple[str, Objects]:
    """The filled template, and the things it names."""
    if style == "course" and len(solutions) != 1:
        raise NotAskedError(
            Words(
                f"一份课程报告只写一道题，这里给了 {len(solutions)} 道；请只给一道，或输出到文件夹",
                f"a course report is about one problem, and {len(solutions)} are given; name one, or write to a folder",
            )
        )
    objects = Objects()
    context = {
        "title": (title or subject(solutions)).of(lang),
        "fields": [(label, fields.get(label, "")) for label in FIELDS[lang]],
        "problems": [_problem(s, lang, style, objects) for s in solutions],
    }
    try:
        folders = (*((Path(templates),) if templates else ()), data_dir("templates"))
        return filled(f"{style}.{lang}.xml.j2", folders, context), objects
    except TemplateNotFound:
        raise UnknownNameError(
            Words(
                f"没有报告样式“{style}”；已有：{', '.join(STYLES)}",
                f"no report style '{style}': there are {', '.join(STYLES)}",
            )
        ) from None


def _title(solutions: Sequence[Solution]) -> Words:
    if len(solutions) != 1:
        return subject(solutions)
    problem = solutions[0].problem
    name = label(problem.id)
    return Words(f"{name.zh}　{problem.title.zh}", f"{name.en}: {problem.title.en}") if name.zh else problem.title


def _sketch(figure: Figure, solution: Solution, lang: Lang) -> Drawing:
    """The picture beside the statement, which may be drawn larger on a page that ends early."""
    drawn = sketch_of(figure, solution, lang, sketch=True)
    widest = WIDEST * MM / drawn.size[0]
    drawn.ampler = lambda times: _sketch(magnified(figure, min(times, widest)), solution, lang)
    return drawn


def _problem(solution: Solution, lang: Lang, style: str, objects: Objects) -> dict[str, Any]:
    """All that a template may say of one problem."""
    if style == "course":
        from .course.document import course

        return course(solution, lang, objects)
    room = ALONE if _repeats(solution.construction) else PICTURE
    drawn = sketched(solution.problem, solution.construction, *room)
    common = {
        **beside_tables(solution, lang),
        "repeats": REPEATS,
        "data": [objects.add("tab", even(one)) for one in given_tables(solution.problem, lang)],
        "picture": objects.add("pic", _sketch(drawn, solution, lang)) if drawn else "",
    }
    if style == "question":
        blank, places = frames(solution.construction, solution.problem)
        made = hung(blank, places, of=solution.problem.paper.format, lang=lang, title=solution.problem.title)
        return common | question(solution, blank, lang, objects) | {"frames": bound(made, blank, lang, objects)}
    return common | _solved(solution, lang, objects)


def _solved(solution: Solution, lang: Lang, objects: Objects) -> dict[str, Any]:
    """What a template may say of a problem's solution."""
    checked, lines = check_problem(solution.problem), lines_table(solution, lang)
    blocks = diagram(solution.construction)
    answer = answer_box(solution, lang, conclusions(solution, lang), explained=explained_by(objects.named.values()))
    printed, (verified, moved) = printed_table(checked.answers, lang), as_moved(solution, lang)
    names, homes = ([], []) if blocks or _repeats(solution.construction) else pages(solution, lang, objects)
    return {
        "moved": moved,
        "verified": objects.add("tab", even(verified)) if verified else "",
        "beside": "beside" if beside_exact(solution) else "",
        "heads": heads_told(verified, lang),
        "lines": objects.add("tab", even(lines)) if lines else "",
        "tables": printed_tables(
            solution.problem,
            lang,
            lambda _, header, rows, align: objects.add("tab", even(DataTable(header, rows, None, align, lang=lang))),
        ),
        "sections": with_plates(sections(solution, lang, objects), names, homes, objects),
        "counts": by_rank(solution, lang),
        "compared": answer.compared,
        "design": isinstance(solution.problem.subject, Design),
        "printed": objects.add("tab", even(printed)) if printed is not None else "",
        "verdicts": verdicts(solution, checked, lang),
        "concluded": concluded(checked, lang),
        "missed": moved_told(solution, lang),
        "answer": objects.add("ans", answer),
        "cautions": cautions(solution, lang),
        "diagram": objects.add("pic", sketch_of(blocks, solution, lang)) if blocks else "",
        "sheets": names,
        "plates": names[: len(homes)],
    } | judged_by(checked.answers)


def _repeats(construction: Construction) -> bool:
    """Whether a sheet would only show the sketch beside the statement once more."""
    figures = construction.figures
    return len(figures) == 1 and not to_scale(figures[0])
