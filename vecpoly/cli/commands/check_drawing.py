"""vecpoly check 3-12 drawing.dxf: a drawing to scale, vector by vector.

Exit code 0: every vector is right or nearly so; 1: one is wrong; 2: the drawing cannot be read.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from ...errors import UnknownNameError
from ...words import Words, bare
from ..errors import DISAGREES, Tally
from ..files import STDOUT, write_json
from ..jobs import problems
from ..options import Lang
from ..terminal import add, show, table

if TYPE_CHECKING:
    from ...grading.drawings.judging.mark import DrawingMark, FigureMark

ENDINGS = (".dxf", ".svg", ".pdf", ".ggb")
_COLUMNS = {"zh": ("图", "矢量", "结论", "缘由"), "en": ("figure", "vector", "verdict", "reason")}


def drawings_among(names: Sequence[str]) -> list[str]:
    """The files that are drawings."""
    return [name for name in names if Path(name).suffix.lower() in ENDINGS]


def check_drawings(names: Sequence[str], files: Sequence[str], json: Path | None, lang: Lang, outside: bool) -> None:
    """Grade each file as a drawing of the one problem; one that cannot be read does not stop the others."""
    from ...grading.drawings.grade import grade_drawing
    from ...grading.drawings.model import drawing_key

    tally = Tally()
    found = problems([name for name in names if name not in files], tally, outside)
    if len(found) != 1:
        raise UnknownNameError(
            Words(
                f"{'、'.join(files)} 是哪道题的图？请只写一道题，这里有 {len(found)} 道",
                f"of which problem is {', '.join(files)} the drawing? name one problem; here are {len(found)}",
            )
        )
    key = drawing_key(found[0])
    marks: list[DrawingMark] = []
    for file in files:
        with tally.job():
            marks.append(grade_drawing(key, file))
    if json is not None and marks:
        data = [_as_json(mark) for mark in marks]
        write_json(data if len(files) > 1 else data[0], json)
    if json != STDOUT:
        for mark in marks:
            _print(mark, lang)
    tally.settle()
    if not all(mark.right for mark in marks):
        raise typer.Exit(DISAGREES)


def _print(mark: DrawingMark, lang: Lang) -> None:
    made = table(f"{mark.problem}  {mark.file}", [(name, "left") for name in _COLUMNS[lang]])
    for figure in mark.figures:
        for one in figure.vectors if figure.drawn else ():
            add(made, (figure.title.of(lang), one.key, one.verdict.words.of(lang), bare(one.reason.of(lang))))
    show(made)
    for words in mark.told:
        typer.echo(bare(words.of(lang)))
    if mark.slip is not None:
        slip = Words("差错：", "slip: ") + Words.same(f"{mark.slip.key} ") + mark.slip.mistake.words
        typer.echo(slip.of(lang))
    typer.echo("")


def _as_json(mark: DrawingMark) -> dict[str, Any]:
    return {
        "id": mark.problem, "file": mark.file, "right": mark.right, "mirrored": mark.mirrored, "turned": mark.turned,
        "slip": str(mark.slip) if mark.slip else None, "figures": [_figure(one) for one in mark.figures],
        "vectors": [
            {
                "figure": one.figure, "key": one.key, "verdict": one.verdict.value, "basis": one.basis.value,
                "sense": one.sense, "off_mm": one.off, "turned_deg": one.turned, "allowed_mm": one.allowed,
                "zh": one.reason.zh, "en": one.reason.en,
            }
            for one in mark.vectors
        ],
    }  # fmt: skip


def _figure(one: FigureMark) -> dict[str, Any]:
    return {
        "figure": one.figure, "drawn": one.drawn, "mu": one.mu, "declared": one.declared, "gap_mm": one.gap,
        "turned": one.turned, "mirrored": one.mirrored,
        "zh": [said.zh for said in one.remarks], "en": [said.en for said in one.remarks],
    }  # fmt: skip
