"""A feedback sheet for everybody: marks, reasons in sentences, the own polygon over the exact one."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

from ...batch.codes import SCHEME
from ...batch.register import Part, Register, Sheet
from ...batch.run.tasks import file_name
from ...batch.sheet.marks import TINY, write
from ...board.hand import hand
from ...board.otherwise.amended import AS_DRAWN
from ...drawing.backends.pdf import draw_pdf
from ...drawing.scene import Scene
from ...errors import VecpolyError
from ...foundation.data import data_dir
from ...foundation.files import write_whole
from ...foundation.short import short
from ...foundation.slotted import replace
from ...grading.compare.outcome import Basis, Finding
from ...grading.marking.marked import Marked
from ...grading.rules import USUAL_RULES, Rules
from ...grading.told.brief import brief, notes
from ...grading.told.message import Message
from ...grading.told.scheme import rules_told
from ...grading.told.veiled import veiled
from ...names import written_unit
from ...problem.problem import Scales
from ...report.content import Objects
from ...report.document import FIELDS
from ...report.flow.blocks import Drawing
from ...report.flow.doc import Metadata, ReportDoc, Stamp
from ...report.flow.table import DataTable
from ...report.flow.xml import to_flowables
from ...report.templates import filled
from ...solution import constructed
from ...typeset.box import MM
from ...words import Lang, Words, label
from ..drawn import Work
from ..work import Result
from .overlay import overlays

Told = Callable[[Words, int, int], None]
_HEAD = {
    "zh": ("量", "所写", "结论", "得分", "满分", "说明"),
    "en": ("Quantity", "Written", "Verdict", "Points", "of", "Why"),
}
_LINES = {
    "zh": ("矢量", "图", "结论", "得分", "满分", "说明"),
    "en": ("Vector", "Figure", "Verdict", "Points", "of", "Why"),
}
_ROWS = {
    "zh": ("方程", "所写", "结论", "得分", "满分", "说明"),
    "en": ("Equation", "Written", "Verdict", "Points", "of", "Why"),
}
_WIDTHS = (28.0, 27.0, 24.0, 12.0, 12.0, 67.0)
_HANDED = Words("所交的图与准确的多边形", "The drawing handed in, over the exact polygons")
_OWN = Words("由前正确", "right by own values")
_TITLE = Words("批改反馈", "feedback")
_WIDE, _HIGH = 168.0, 150.0  # mm that a figure may take
_BETWEEN = 12.0  # mm between two of a row


def feedback_files(
    register: Register, results: Sequence[Result], out: Path, lang: Lang, told: Told, rules: Rules = USUAL_RULES
) -> list[Path]:
    """Write one PDF for each student who returned something, feedback/NUMBER_NAME.pdf."""
    written = [one for one in results if one.returned]
    files: list[Path] = []
    for done, result in enumerate(written, 1):
        sheet = feedback_bytes(register, result, lang, rules)
        files.append(write_whole(out / "feedback" / f"{file_name(result.student)}.pdf", sheet))
        told(Words("写反馈", "writing feedback"), done, len(written))
    return files


def feedback_bytes(register: Register, result: Result, lang: Lang, rules: Rules = USUAL_RULES) -> bytes:
    """The PDF of one student; while answers can be handed in again nothing that gives the right values away."""
    objects, open_ = Objects(), rules.open
    title = Words(f"{register.title.zh}　{_TITLE.zh}", f"{register.title.en}: {_TITLE.en}").of(lang)
    sheet = register.sheet(result.student.number)
    parts = {part.problem: part for part in sheet.parts} if sheet else {}
    problems = [
        _problem(register, parts[name], marked, result.drawings.get(name), lang, objects, open_)
        for name, marked in result.marks.items()
    ]
    said = ("；" if lang == "zh" else "; ").join(one.of(lang) for one in rules_told(rules))
    context = {"title": title, "fields": _fields(result, lang), "problems": problems, "rules": said}
    xml = filled(f"feedback.{lang}.xml.j2", (data_dir("templates"),), context)
    meta = Metadata(title=title, subject=title, keywords=tuple(result.marks), lang=lang)
    stamp = None if sheet is None else _stamp(register, sheet)
    return ReportDoc(to_flowables(xml, objects.named, lang), meta, stamp).made()[0]


def _stamp(register: Register, sheet: Sheet) -> Stamp:
    """Whose it is and of which sheet, at the foot of every page."""
    code = f"{SCHEME}-{short(register.assignment, 4)}-{sheet.sheet}-F"

    def stamp(canvas: Any, _: bool) -> None:
        write(canvas, f"{sheet.student.name} {sheet.student.number}  {code}", (20.0, 4.5), TINY)

    return stamp


def _fields(result: Result, lang: Lang) -> list[tuple[str, str]]:
    known = (result.student.team, result.student.name, result.student.number, f"{result.total:g} / {result.worth:g}")
    return list(zip(FIELDS[lang], (*known, "", ""), strict=True))


def _problem(
    register: Register, part: Part, marked: Marked, work: Work | None, lang: Lang, objects: Objects, open_: bool
) -> dict[str, Any]:
    problem = register.variant(part)
    rows = [_row(one, marked, lang, open_) for one in marked.findings]
    table = DataTable(_HEAD[lang], rows, _WIDTHS, "lllddl", lang=lang)
    drawn: Sequence[Scene] = () if work is None else work.scenes
    below = notes([said for one in marked.findings for said in _shown(one.messages, open_)])
    said = [*(one.words.of(lang) for one in marked.messages), *(fault.of(lang) for fault in marked.faults)]
    said += [] if work is None else [one.of(lang) for one in work.mark.told]
    figures, cut = ([], "") if open_ or drawn else _figures(register, part, marked, lang, objects)
    return {
        "label": label(problem.id).of(lang), "title": problem.title.of(lang), "total": f"{marked.total:g}",
        "worth": f"{marked.worth:g}", "messages": said, "table": objects.add("tab", table),
        "scattered": " ".join(one.of(lang) for one in below),
        "named": _named(marked, lang),
        "stated": f"{sum(marked.stated.values()):g}" if marked.stated else "",
        "lost": f"{marked.lost:g}" if marked.lost else "",
        "equations": objects.add("tab", _equations(marked, lang, open_)) if marked.equations else "",
        "lines": objects.add("tab", _lines(marked, lang, open_)) if marked.lines else "",
        "drawn": [] if open_ else [objects.add("pic", _block(one, _HANDED.of(lang))) for one in drawn if _fits(one)],
        "figures": figures, "cut": cut,
    }  # fmt: skip


def _named(marked: Marked, lang: Lang) -> list[str]:
    """The equations whose rows are marked, by their numbers."""
    rows = {one.row.key.partition("_")[0]: one.row.printed for one in marked.equations}
    head = Words("方程 {n}：", "equation {n}: ").of(lang)
    return [f"{head.format(n=key.removeprefix('eq'))}${printed}$" for key, printed in rows.items()]


def _shown(said: tuple[Message, ...], open_: bool) -> tuple[Message, ...]:
    return veiled(said) if open_ else said


def _row(one: Finding, marked: Marked, lang: Lang, open_: bool) -> tuple[str, ...]:
    graded = marked.key[one.key]
    verdict = _OWN if one.basis is not Basis.EXACT and one.is_right else one.outcome.words
    messages = _shown(one.messages, open_)
    unit = written_unit(graded.written_in)
    unit = f" /({unit})" if set(unit) & set("/·") else f" /{unit}" if unit else ""
    points = (f"{one.earned.total:.2g}", f"{graded.points.total:.2g}") if graded.points.total else ("", "")
    return (f"${graded.symbol}${unit}", one.written.raw or "—", verdict.of(lang), *points, _why(messages, lang))


def _why(said: Sequence[Message], lang: Lang) -> str:
    return ("；" if lang == "zh" else ". ").join(words.of(lang) for words in brief(said))


def _equations(marked: Marked, lang: Lang, open_: bool) -> DataTable:
    """The rows of the vector equations."""
    rows = []
    for one in marked.equations:
        why = _why(_shown(one.messages, open_), lang)
        points = (f"{one.earned:.2g}", f"{one.worth:.2g}") if one.worth else ("", "")
        rows.append((one.title.of(lang), one.raw.strip() or "—", one.outcome.words.of(lang), *points, why))
    return _table(_ROWS[lang], rows, lang)


def _lines(marked: Marked, lang: Lang, open_: bool) -> DataTable:
    """The vectors of the drawing that was handed in; while it can be handed in again, without what should be drawn."""
    rows = [
        (
            f"${one.symbol}$", one.figure.of(lang), one.verdict.words.of(lang), f"{one.earned:.2g}",
            f"{one.worth:.2g}", "" if open_ else one.reason.of(lang),
        )
        for one in marked.lines
    ]  # fmt: skip
    return _table(_LINES[lang], rows, lang)


def _table(heads: Sequence[str], rows: Sequence[Sequence[str]], lang: Lang) -> DataTable:
    """Without the last column where nothing stands in it: all is right."""
    last = None if any(row[-1] for row in rows) else -1
    return DataTable(heads[:last], [row[:last] for row in rows], _WIDTHS[:last], "lllddl"[:last], lang=lang)


def _figures(register: Register, part: Part, marked: Marked, lang: Lang, objects: Objects) -> tuple[list[str], str]:
    """The polygons at the student's own scales; the vectors that go off the page."""
    problem = replace(register.variant(part), scales=Scales(dict(marked.key.scales)))
    try:
        construction = constructed(problem, hand("exact"), AS_DRAWN).construction
    except VecpolyError:
        return [], ""  # at a scale of the student's own that no paper holds
    found = [one for one in overlays(construction, marked, lang) if _fits(one.scene)]
    drawn = [(one.figure.title.of(lang), one.scene) for one in found]
    cut = ("、" if lang == "zh" else ", ").join(f"${symbol}$" for one in found for symbol in one.cut)
    return [objects.add("pic", _block(scene, said)) for said, scene in side_by_side(drawn)], cut


def side_by_side(drawn: Sequence[tuple[str, Scene]]) -> Iterator[tuple[str, Scene]]:
    """Figures in rows: the next beside the last where the page is wide enough, at one height of their titles."""
    row: tuple[str, Scene] | None = None
    for said, scene in drawn:
        if row is not None:
            before = row[1].extents
            beside = scene.moved(complex(before.x1 + _BETWEEN - scene.extents.x0, before.y0 - scene.extents.y0))
            if _fits(both := row[1] + beside):
                row = f"{row[0]}; {said}", both
                continue
            yield row
        row = said, scene
    if row is not None:
        yield row


def _fits(scene: Scene) -> bool:
    return scene.extents.width <= _WIDE and scene.extents.height <= _HIGH


def _block(scene: Scene, said: str) -> Drawing:
    e = scene.extents
    return Drawing(e.width, e.height, lambda canvas, x, y: draw_pdf(scene, canvas, x - e.x0 * MM, y - e.y0 * MM), said)
