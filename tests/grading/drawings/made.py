"""Honest drawings of library problems, and what students make of them: moved, scaled, turned about, with a slip."""

from __future__ import annotations

import io
import zipfile
from cmath import exp, pi
from collections.abc import Callable
from dataclasses import replace
from functools import cache

import ezdxf
from reportlab.pdfgen.canvas import Canvas

from vecpoly import load
from vecpoly.board.hand import hand
from vecpoly.board.otherwise.amended import AS_DRAWN
from vecpoly.grading.allowance import CAD, Allowance
from vecpoly.grading.drawings.expected import Edge, Expected, Shape, expected, shapes
from vecpoly.grading.drawings.grade import grade_drawing
from vecpoly.grading.drawings.judging.mark import DrawingMark, Verdict
from vecpoly.grading.drawings.model import DrawingKey, drawing_key
from vecpoly.grading.drawings.readers.door import parsed
from vecpoly.grading.drawings.segment import Drawing, Segment
from vecpoly.solution import constructed

APART = 300.0  # mm between figures
MM = 72 / 25.4
Verdicts = list[tuple[str, str, Verdict, bool | None]]


@cache
def key_of(problem: str, allowance: Allowance = CAD) -> DrawingKey:
    return drawing_key(load(problem), allowance)


def drawn(there: Expected, *, heads: bool = True, names: bool = False, diagram: bool = True) -> Drawing:
    """All figures of a solution side by side."""
    lines = [
        Segment(
            start=edge.a + n * APART,
            end=edge.b + n * APART,
            headed=heads and not shape.diagram,
            name=edge.key if names else "",
            where=f"{shape.name}:{edge.key}",
        )
        for n, shape in enumerate(there.shapes)
        for edge in shape.edges
        if diagram or not shape.diagram
    ]
    return Drawing(file="made", segments=tuple(lines))


def by_pencil(key: DrawingKey, seed: int) -> Drawing:
    return drawn(shapes(constructed(key.problem, hand("pencil", seed=seed), AS_DRAWN)))


def put(drawing: Drawing, to: Callable[[complex], complex]) -> Drawing:
    """Every point elsewhere."""
    lines = tuple(replace(one, start=to(one.start), end=to(one.end)) for one in drawing.segments)
    return replace(drawing, segments=lines)


To = Callable[[complex], complex]


def by(degrees: float) -> To:
    """Turned by so much."""
    return lambda z: z * exp(1j * pi * degrees / 180)


def lying(there: Expected, drawing: Drawing, **figures: To) -> Drawing:
    """Each of these polygons laid otherwise, about its pole; the others stay."""
    names = [shape.name for shape in there.shapes]

    def to(one: Segment) -> Segment:
        figure = one.where.partition(":")[0]
        if figure not in figures:
            return one
        pole = APART * names.index(figure)
        start, end = (figures[figure](at - pole) + pole for at in (one.start, one.end))
        return replace(one, start=start, end=end)

    return replace(drawing, segments=tuple(map(to, drawing.segments)))


def changed(drawing: Drawing, where: str, to: Callable[[Segment], Segment | None]) -> Drawing:
    """One line (``velocity:v_B``) otherwise, or not at all."""
    assert any(one.where == where for one in drawing.segments)
    lines = [to(one) if one.where == where else one for one in drawing.segments]
    return replace(drawing, segments=tuple(one for one in lines if one is not None))


def in_another_order(key: DrawingKey) -> Drawing:
    """Each two vectors of a chain between which nothing else begins, added the other way round."""
    there = tuple(shape if shape.diagram else replace(shape, edges=_reordered(shape)) for shape in key.exact.shapes)
    assert there != key.exact.shapes
    return drawn(replace(key.exact, shapes=there))


def _reordered(shape: Shape) -> tuple[Edge, ...]:
    edges = list(shape.edges)
    for i, one in enumerate(shape.edges):
        for j, other in enumerate(shape.edges):
            at_it = [e for e in edges if min(abs(e.a - one.b), abs(e.b - one.b)) < 1e-9]
            if i < j and abs(one.b - other.a) < 1e-9 and len(at_it) == 2 and edges[i] is one and edges[j] is other:
                middle = one.a + other.along
                edges[i], edges[j] = replace(one, a=middle, b=other.b), replace(other, a=one.a, b=middle)
    return tuple(edges)


def marked(key: DrawingKey, drawing: Drawing, *, declared: bool = False) -> DrawingMark:
    return grade_drawing(key, drawing, scales=key.problem.scales.given if declared else None)


def verdicts(mark: DrawingMark) -> Verdicts:
    return [(one.figure, one.key, one.verdict, one.sense) for one in mark.vectors]


def with_slip(key: DrawingKey, name: str) -> Expected:
    return next(world for slip, world in key.worlds if str(slip) == name)


def with_points(key: DrawingKey, **points: complex) -> Expected:
    from vecpoly.board.otherwise.amended import Amended
    from vecpoly.foundation.frozen import FrozenMap

    return expected(key.problem, Amended(points=FrozenMap({f"mechanism:{k}": at for k, at in points.items()})))


# -- the same drawing in four formats --------------------------------------------------------------------------


def as_dxf(drawing: Drawing, version: str = "R2010") -> bytes:
    doc = ezdxf.new(version, units=4)  # type: ignore[attr-defined]
    for one in drawing.segments:
        doc.modelspace().add_line((one.start.real, one.start.imag), (one.end.real, one.end.imag))
        if one.headed:
            doc.modelspace().add_solid([(z.real, z.imag) for z in _head(one)])
    into = io.StringIO()
    doc.write(into)
    return into.getvalue().encode(doc.output_encoding)


def as_svg(drawing: Drawing) -> bytes:
    lines = "".join(
        f'<line x1="{one.start.real}" y1="{-one.start.imag}" x2="{one.end.real}" y2="{-one.end.imag}" stroke="black"'
        f"{' marker-end=' + chr(34) + 'url(#head)' + chr(34) if one.headed else ''}/>"
        for one in drawing.segments
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="2000mm" height="1000mm" viewBox="0 0 2000 1000">{lines}</svg>'
    ).encode()


def as_pdf(drawing: Drawing) -> bytes:
    into = io.BytesIO()
    canvas = Canvas(into, pagesize=(2000 * MM, 1000 * MM))
    for one in drawing.segments:
        canvas.line(*(MM * part for z in (one.start, one.end) for part in (z.real + 200, z.imag + 500)))
        if one.headed:
            path = canvas.beginPath()
            for n, z in enumerate(_head(one)):
                (path.lineTo if n else path.moveTo)(MM * (z.real + 200), MM * (z.imag + 500))
            path.close()
            canvas.drawPath(path, stroke=0, fill=1)
    canvas.save()
    return into.getvalue()


def as_ggb(drawing: Drawing) -> bytes:
    parts = []
    for n, one in enumerate(drawing.segments):
        for name, at in (("A", one.start), ("B", one.end)):
            parts.append(
                f'<element type="point" label="{name}_{{{n}}}"><show object="true" label="false"/>'
                f'<coords x="{at.real!r}" y="{at.imag!r}" z="1"/></element>'
            )
        command = "Vector" if one.headed else "Segment"
        parts.append(
            f'<command name="{command}"><input a0="A_{{{n}}}" a1="B_{{{n}}}"/><output a0="d_{{{n}}}"/></command>'
            f'<element type="{command.lower()}" label="d_{{{n}}}"><show object="true" label="false"/></element>'
        )
    return zipped(f"<geogebra><construction>{''.join(parts)}</construction></geogebra>".encode())


def zipped(text: bytes, name: str = "geogebra.xml") -> bytes:
    into = io.BytesIO()
    with zipfile.ZipFile(into, "w", zipfile.ZIP_DEFLATED) as folder:
        folder.writestr(name, text)
    return into.getvalue()


def _head(one: Segment) -> tuple[complex, complex, complex]:
    way = one.along / abs(one.along)
    back = one.end - min(3.0, abs(one.along) / 2) * way
    return one.end, back + 0.4j * way, back - 0.4j * way


FORMATS: dict[str, Callable[[Drawing], bytes]] = {"dxf": as_dxf, "svg": as_svg, "pdf": as_pdf, "ggb": as_ggb}


def through(drawing: Drawing, kind: str) -> Drawing:
    """The drawing written to a file of this kind, and read back."""
    return parsed(f"made.{kind}", FORMATS[kind](drawing))
