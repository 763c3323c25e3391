"""The figures of a drawing, each vector with its verdict, once it is known where they stand."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ....board.otherwise.slip import Slip
from ....foundation.slotted import replace
from ....words import Words
from ..expected import NOTHING, Edge, Shape
from ..matching.assign import Match, assigned
from ..matching.find import Found
from ..matching.fit import Fit
from ..matching.held import UPRIGHT
from ..matching.place import beside, drawn_places, gap
from ..model import DrawingKey
from ..segment import Label
from .askew import as_laid
from .diagnose import exchanged, misplaced, slips_that_fit, turned_over
from .judge import WORST, judged, missing
from .mark import Basis, FigureMark, VectorMark, Verdict
from .meeting import met
from .own import Own
from .reason import FAIR, reason
from .scales import OTHER_SCALE, OTHER_SIZE, other_scale, undeclared
from .slipped import by_one_mistake

BETTER = 0.75  # of a cost: a mistake that explains the lines fits them clearly better than what is right
GAP = 1.0  # mm on the sheet: a polygon closes within


@dataclass(frozen=True, slots=True, kw_only=True)
class Figures:
    """The figures with their verdicts, and the mistakes that explain them all."""

    marks: tuple[FigureMark, ...]
    slips: tuple[Slip, ...]

    @property
    def costs(self) -> int:
        """How many mistakes there are; a polygon that is not drawn is as many as it has vectors."""
        return sum(one.costs for figure in self.marks for one in figure.vectors)

    @property
    def unexplained(self) -> frozenset[str]:
        """The figures with a mistake, but those that are drawn with one that is known."""
        wrong = (one for one in self.marks if any(vector.costs for vector in one.vectors))
        return frozenset(one.figure for one in wrong if not (self.slips and one.drawn))


def figures_of(
    key: DrawingKey, found: Found, labels: Sequence[Label], scales: Mapping[str, float], *, heads: bool
) -> Figures:
    """The verdict on every vector of every figure. scales: as declared; heads: the drawing has arrow heads."""
    return _Judging(key, found, labels, scales, heads).figures()


class _Judging:
    """The figures of one drawing, on their way to their marks."""

    def __init__(
        self, key: DrawingKey, found: Found, labels: Sequence[Label], scales: Mapping[str, float], heads: bool
    ) -> None:
        self.key, self.found, self.labels, self.scales, self.heads = key, found, labels, scales, heads
        self.own = Own(problem=key.problem, exact=key.exact, sketch=key.sketch)

    def figures(self) -> Figures:
        """All figures that should be drawn."""
        fits = self.found.fits
        by_name = {fit.shape.name: fit for fit in fits}
        matches = {fit.shape.name: self._match(fit) for fit in fits if not fit.shape.diagram}
        for fit in fits:
            if fit.shape.diagram:
                self.own.diagram(fit)
        marks = tuple(
            self._figure(by_name[shape.name], matches[shape.name]) if shape.name in by_name else self._undrawn(shape)
            for shape in self.key.exact.shapes
            if not shape.diagram
        )
        wrong = any(v.verdict not in FAIR for one in marks if one.drawn for v in one.vectors)
        slips = slips_that_fit(self.key, matches) if wrong and matches else ()
        if slips:
            marks = by_one_mistake(marks, slips[0], dict(self.key.worlds)[slips[0]])
        return Figures(marks=as_laid(marks, fits), slips=slips)

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

    def _figure(self, fit: Fit, match: Match) -> FigureMark:
        shape = fit.shape
        places = self.own.polygon(shape, match)
        first = {edge.key: self._vector(fit, edge, match) for edge in shape.edges}
        marks = tuple(self._to_the_meeting(fit, edge, match, first) for edge in shape.edges)
        wrong = [one for one in marks if one.verdict not in FAIR]
        widest = gap(shape, match, fit.scale)
        remarks = [*turned_over(shape, places, wrong), *exchanged(marks, match)]
        if fit.origin is not None and self.found.held == UPRIGHT == fit.held:
            remarks += misplaced(fit, drawn_places(shape, match), self.labels, fit.origin)
        if widest > GAP:
            remarks.append(
                Words(f"多边形不封闭，缺口 {widest:.1f} mm", f"the polygon does not close, gap {widest:.1f} mm")
            )
        declared = fit.told is None and (shape.view.mu.key in self.scales or fit.scale == 1.0)
        if not declared:
            found = shape.mu / fit.scale, shape.view.mu.symbol
            remarks.append(undeclared(*found) if fit.told is None else other_scale(*found))
        return FigureMark(
            figure=shape.name,
            title=shape.view.title,
            mu=self.found.printed * shape.mu / fit.scale,
            unit=shape.view.mu.unit,
            declared=declared and self.found.printed == 1.0,
            vectors=marks,
            extra=tuple(one for one in match.extra if one.headed or not beside(one, match)),
            gap=widest,
            remarks=tuple(remarks),
            doubt=OTHER_SCALE if fit.told is not None else OTHER_SIZE if self.found.printed != 1.0 else None,
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
