"""A student's drawing of a problem, graded vector by vector."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from ...foundation.slotted import replace
from ...problem.problem import Problem
from ...words import Words
from ..allowance import CAD, Allowance
from .declared import stated
from .expected import Shape
from .judging.figures import Figures, figures_of
from .judging.mark import DrawingMark
from .matching.askew import laid_askew, taken_so
from .matching.find import Found, find
from .matching.fit import Fit
from .matching.held import UPRIGHT
from .matching.letters import by_letters
from .matching.naming import named
from .matching.tidy import Strokes, strokes
from .model import DrawingKey, drawing_key
from .readers.door import read_drawing
from .segment import Drawing


def grade_drawing(
    problem: Problem | DrawingKey,
    file: Path | str | Drawing,
    *,
    scales: Mapping[str, float] | None = None,
    allowance: Allowance = CAD,
) -> DrawingMark:
    """The verdict on a student's drawing (DXF, SVG, vector PDF, .ggb, or segments in mm from anywhere).

    Each vector is matched by its name, or else by optimal assignment; its length is right within T and wrong beyond
    `allowance.wrong` T, its direction and sense are judged by themselves; what is not right against the exact drawing
    is held against what follows from the student's own diagram and polygons. The pole may be anywhere, terms be added
    in any order, and μ be one's own.

    problem: or its `drawing_key`, where many have the same. scales: that the sheet prints or the student declared
    elsewhere, ``mu_v`` → SI per mm; what is stated on the drawing itself goes before them.
    Raises ProblemFileError for a file that cannot be read, and what `solve` raises.
    """
    key = problem if isinstance(problem, DrawingKey) else drawing_key(problem, allowance)
    drawing = file if isinstance(file, Drawing) else read_drawing(file)
    drawing, own = _known(drawing, key.exact.shapes), dict(scales or {}) | stated(drawing.labels)
    lines = strokes(drawing)
    found = _Grading(key, drawing, lines, own)
    if not found.figures.costs:
        return found.mark()
    told = replace(lines, lines=by_letters(lines.lines, drawing.labels, key.exact.shapes))
    other = found if told == lines else _Grading(key, drawing, told, own)
    return min(other, found, key=lambda way: way.figures.costs).mark()  # letters help where geometry alone misleads


def _known(drawing: Drawing, shapes: Sequence[Shape]) -> Drawing:
    """The drawing with names that stand for a vector, as figure:quantity, and no others."""
    found = []
    for one in drawing.segments:
        meant = named(one.name, one.layer, shapes) or named(one.layer, "", shapes)
        found.append(replace(one, name=":".join(meant) if meant else ""))
    return replace(drawing, segments=tuple(found))


class _Grading:
    """One drawing, on its way to its mark."""

    def __init__(self, key: DrawingKey, drawing: Drawing, lines: Strokes, scales: Mapping[str, float]) -> None:
        self.key, self.drawing, self.scales = key, drawing, scales
        self.strokes = lines
        self.heads = any(one.headed for one in self.strokes.lines)
        self.found = find(self.key, self.strokes, self.scales)
        self.figures = self._figures()

    def mark(self) -> DrawingMark:
        """The mark of the whole."""
        figures, held = self.figures, self.found.held
        return DrawingMark(
            problem=self.key.problem.id,
            file=self.drawing.file,
            figures=figures.marks,
            slips=figures.slips,
            mirrored=held.mirror,
            turned=0.0 if held.mirror else held.degrees,
            twice=self.strokes.twice,
            remarks=tuple(self._said()),
        )

    def _figures(self) -> Figures:
        """The figures as they lie; some of them held by themselves, where that leaves fewer mistakes, or as many and
        none that is known."""
        upright, found = self._judged(self.found), self.found
        if not upright.unexplained or not self.strokes.lines:
            return upright
        figures = [one for one in self.key.variants if not one[0].diagram]
        laid = laid_askew(figures, self.strokes, found.fits, found.declared, found.held, upright.unexplained)
        some = [(one,) for one in laid] + ([laid] if len(laid) > 1 else [])
        ways = [(self._judged(replace(found, fits=taken_so(found.fits, each))), each) for each in some]
        best = min(ways, key=lambda way: _mistakes(*way), default=None)
        return best[0] if best is not None and _mistakes(*best) <= upright.costs else upright

    def _judged(self, found: Found) -> Figures:
        return figures_of(self.key, found, self.drawing.labels, self.scales, heads=self.heads)

    def _said(self) -> list[Words]:
        said = list(self.drawing.remarks)
        if self.found.held.mirror:
            said.append(
                Words("整幅图左右镜像了；以下按还原后衡量", "the drawing is mirrored; it was held as unmirrored")
            )
        elif self.found.held != UPRIGHT:
            by = abs(self.found.held.degrees)
            said.append(
                Words(
                    f"整幅图转过了 {by:.3g}°；以下按转正后衡量",
                    f"the drawing is turned by {by:.3g}°; it was held upright",
                )
            )
        if self.found.printed != 1.0:
            said.append(
                Words(
                    f"整幅图按 {self.found.printed:.3f} 倍输出；以下按原尺寸衡量",
                    f"the whole drawing was put out at {self.found.printed:.3f} times its size; it was held at its own",
                )
            )
        if not self.heads:
            said.append(
                Words(
                    "图上没有箭头；指向按线段的起点和终点判断",
                    "no arrow heads; senses are by the order of the lines' ends",
                )
            )
        return said


def _mistakes(figures: Figures, laid: Sequence[Fit]) -> int:
    """How many there are; another scale than is stated is one as well."""
    return figures.costs + sum(fit.told is not None for fit in laid)
