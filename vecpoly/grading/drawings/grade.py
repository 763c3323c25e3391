"""A student's drawing of a problem, graded vector by vector."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from ...problem.problem import Problem
from ...words import Words
from ..allowance import CAD, Allowance
from .declared import stated
from .expected import NOTHING, Edge, Shape
from .judging.diagnose import exchanged, misplaced, slips_that_fit, turned_over
from .judging.judge import WORST, judged, missing
from .judging.mark import Basis, DrawingMark, FigureMark, VectorMark, Verdict
from .judging.meeting import met
from .judging.own import Own
from .judging.reason import FAIR, reason
from .judging.slipped import by_one_mistake
from .matching.assign import Match, assigned
from .matching.find import find
from .matching.fit import Fit
from .matching.held import UPRIGHT
from .matching.naming import named
from .matching.place import beside, drawn_places, gap
from .matching.tidy import Strokes, strokes
from .model import DrawingKey, drawing_key
from .readers.door import read_drawing
from .segment import Drawing

BETTER = 0.75  # of a cost: a mistake that explains the lines fits them clearly better than what is right
GAP = 1.0  # mm on the sheet: a polygon closes within


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
    return _Grading(key, _known(drawing, key.exact.shapes), dict(scales or {}) | stated(drawing.labels)).mark()


def _known(drawing: Drawing, shapes: Sequence[Shape]) -> Drawing:
    """The drawing with names that stand for a vector, as figure:quantity, and no others."""
    found = []
    for one in drawing.segments:
        meant = named(one.name, one.layer, shapes) or named(one.layer, "", shapes)
        found.append(replace(one, name=":".join(meant) if meant else ""))
    return replace(drawing, segments=tuple(found))


class _Grading:
    """One drawing, on its way to its mark."""

    def __init__(self, key: DrawingKey, drawing: Drawing, scales: Mapping[str, float]) -> None:
        self.key, self.drawing, self.scales = key, drawing, scales
        self.strokes: Strokes = strokes(drawing)
        self.heads = any(one.headed for one in self.strokes.lines)
        self.own = Own(problem=key.problem, exact=key.exact, sketch=key.sketch)
        self.held, self.printed = UPRIGHT, 1.0

    def mark(self) -> DrawingMark:
        """The mark of the whole."""
        found = find(self.key, self.strokes, self.scales)
        fits, self.held, self.printed = found.fits, found.held, found.printed
        by_name = {fit.shape.name: fit for fit in fits}
        matches = {fit.shape.name: self._match(fit) for fit in fits if not fit.shape.diagram}
        for fit in fits:
            if fit.shape.diagram:
                self.own.diagram(fit)
        figures = tuple(
            self._figure(by_name[shape.name], matches[shape.name]) if shape.name in by_name else self._undrawn(shape)
            for shape in self.key.exact.shapes
            if not shape.diagram
        )
        wrong = any(v.verdict not in FAIR for one in figures if one.drawn for v in one.vectors)
        slips = slips_that_fit(self.key, matches) if wrong and matches else ()
        if slips:
            figures = by_one_mistake(figures, slips[0], dict(self.key.worlds)[slips[0]])
        return DrawingMark(
            problem=self.key.problem.id,
            file=self.drawing.file,
            figures=figures,
            slips=slips,
            mirrored=self.held.mirror,
            turned=0.0 if self.held.mirror else self.held.degrees,
            twice=self.strokes.twice,
            remarks=tuple(self._said()),
        )

    def _match(self, fit: Fit) -> Match:
        """The lines as they fit best: what is right, or what a mistake makes of it."""
        best = assigned(fit, fit.shape)
        if all(self._right(fit, edge, best) for edge in fit.shape.edges):
            return best
        at = [shape.name for shape in self.key.exact.shapes].index(fit.shape.name)
        for shape in self.key.variants[at][1:]:
            other = assigned(fit, shape)
            if other.cost < BETTER * best.cost:
                best = other
        return best

    def _right(self, fit: Fit, edge: Edge, match: Match) -> bool:
        line = match.lines.get(edge.key)
        return line is not None and self._judged(fit, edge, match, edge.along, Basis.EXACT).verdict is Verdict.RIGHT

    # -- verdicts ---------------------------------------------------------------------------------------------

    def _figure(self, fit: Fit, match: Match) -> FigureMark:
        shape = fit.shape
        places = self.own.polygon(shape, match)
        first = {edge.key: self._vector(fit, edge, match) for edge in shape.edges}
        marks = tuple(self._to_the_meeting(fit, edge, match, first) for edge in shape.edges)
        wrong = [one for one in marks if one.verdict not in FAIR]
        widest = gap(shape, match, fit.scale)
        remarks = [*turned_over(shape, places, wrong), *exchanged(marks, match)]
        if fit.origin is not None and self.held == UPRIGHT:
            remarks += misplaced(fit, drawn_places(shape, match), self.drawing.labels, fit.origin)
        if widest > GAP:
            remarks.append(
                Words(f"多边形不封闭，缺口 {widest:.1f} mm", f"the polygon does not close, gap {widest:.1f} mm")
            )
        declared = shape.view.mu.key in self.scales or fit.scale == 1.0
        if not declared:
            remarks.append(_undeclared(shape.mu / fit.scale, shape.view.mu.symbol))
        return FigureMark(
            figure=shape.name,
            title=shape.view.title,
            mu=self.printed * shape.mu / fit.scale,
            unit=shape.view.mu.unit,
            declared=declared and self.printed == 1.0,
            vectors=marks,
            extra=tuple(one for one in match.extra if one.headed or not beside(one, match)),
            gap=widest,
            remarks=tuple(remarks),
        )

    def _vector(self, fit: Fit, edge: Edge, match: Match) -> VectorMark:
        if edge.key not in match.lines:
            return missing(edge, fit.shape.name, self.key.allowed[fit.shape.name, edge.key])
        best = self._judged(fit, edge, match, edge.along, Basis.EXACT)
        if best.verdict is not Verdict.RIGHT:
            follows = self.own.should(fit.shape, edge.key)
            if follows is not None and abs(follows) > NOTHING:
                other = self._judged(fit, edge, match, follows, Basis.OWN)
                best = min(best, other, key=lambda one: WORST.index(one.verdict))
        return replace(best, reason=reason(best, edge, fit.scale))

    def _to_the_meeting(self, fit: Fit, edge: Edge, match: Match, marks: Mapping[str, VectorMark]) -> VectorMark:
        """The mark, by the own direction of the vector that this one meets where that alone is wrong."""
        should = met(fit.shape, self.key.exact.construction, match, edge, marks)
        if should is None:
            return marks[edge.key]
        other = self._judged(fit, edge, match, should, Basis.OWN)
        if other.verdict not in FAIR:
            return marks[edge.key]
        return replace(other, reason=reason(other, edge, fit.scale))

    def _judged(self, fit: Fit, edge: Edge, match: Match, should: complex, basis: Basis) -> VectorMark:
        allowed = self.key.allowed[fit.shape.name, edge.key]
        line = match.lines[edge.key]
        return judged(edge, fit.shape.name, line, should, allowed, self.key.allowance, heads=self.heads, basis=basis)

    def _undrawn(self, shape: Shape) -> FigureMark:
        marks = tuple(missing(edge, shape.name, self.key.allowed[shape.name, edge.key]) for edge in shape.edges)
        said = Words("图上没有找到这个多边形", "this polygon was not found on the drawing")
        return FigureMark(
            figure=shape.name,
            title=shape.view.title,
            mu=shape.mu,
            unit=shape.view.mu.unit,
            declared=True,
            vectors=marks,
            remarks=(said,),
            drawn=False,
        )

    def _said(self) -> list[Words]:
        said = list(self.drawing.remarks)
        if self.held.mirror:
            said.append(
                Words("整幅图左右镜像了；以下按还原后衡量", "the drawing is mirrored; it was held as unmirrored")
            )
        elif self.held != UPRIGHT:
            by = abs(self.held.degrees)
            said.append(
                Words(
                    f"整幅图转过了 {by:g}°；以下按转正后衡量", f"the drawing is turned by {by:g}°; it was held upright"
                )
            )
        if self.printed != 1.0:
            said.append(
                Words(
                    f"整幅图按 {self.printed:.3f} 倍输出；以下按原尺寸衡量",
                    f"the whole drawing was put out at {self.printed:.3f} times its size; it was held at its own",
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


def _undeclared(mu: float, symbol: str) -> Words:
    return Words(
        f"没有写比例尺 ${symbol}$；由已知矢量推得 {mu:.4g}：或是另取了比例尺，或是已知矢量画错",
        f"${symbol}$ is not stated; by the known vector it is {mu:.4g}: another scale, or the known vector is wrong",
    )
