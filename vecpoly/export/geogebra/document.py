"""A recording as a GeoGebra file: figures side by side, the input a slider, readings and answers as numbers."""

from __future__ import annotations

import io
from collections.abc import Iterator, Sequence
from dataclasses import fields
from math import degrees, isfinite
from typing import Any
from xml.etree import ElementTree as ET
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

import numpy as np

from ...algebra.quantity import number
from ...board import acts as done
from ...board.paper.tones import tones
from ...board.place import View, view_of
from ...names import written_unit
from ...plane.derived import moves
from ...words import Lang, bare
from ..parts import Numbers
from ..recording import Recording
from ..terms import Term, values
from .bodies import Bodies
from .figure import Figure
from .labels import INDEX, length, named
from .page import Page
from .spelling import Spelling

GAP, TITLE = 28.0, 14.0  # mm between figures; from the lowest ink to the title
PIXELS = (1180.0, 640.0)  # of the window into which the figures are fitted
FORMAT = "4.0"
_DAY = (1980, 1, 1, 0, 0, 0)  # equal drawings are equal files


def to_ggb(recording: Recording, lang: Lang = "zh") -> bytes:
    """The file: a ZIP with one XML document."""
    into = io.BytesIO()
    with ZipFile(into, "w", ZIP_DEFLATED) as folder:
        folder.writestr(ZipInfo("geogebra.xml", _DAY), document(recording, lang), ZIP_DEFLATED)
    return into.getvalue()


def document(recording: Recording, lang: Lang = "zh") -> bytes:
    """The construction as XML."""
    extents = {view: box for view in INDEX if (box := _extent(recording, view)) is not None}
    root = ET.Element("geogebra", format=FORMAT, version=FORMAT)
    _window(root, extents)
    root.append(_Writer(recording, lang, _anchors(extents), extents).written())
    ET.indent(root)
    text: bytes = ET.tostring(root, encoding="utf-8", xml_declaration=True)
    return text


class _Writer:
    """The acts of a recording, one after the other."""

    def __init__(
        self,
        recording: Recording,
        lang: Lang,
        anchors: dict[View, complex],
        extents: dict[View, tuple[complex, complex]],
    ) -> None:
        self.recording, self.lang, self.terms = recording, lang, recording.terms
        self.page = Page(bare(recording.problem.title.of(lang)))
        self.spelling = Spelling(_roots(recording.desk.board.acts, self.terms), self.page.hidden)
        self.written_down: set[str] = set()
        self.anchors = anchors
        self._slider()
        board = recording.desk.board
        written = [step.equation.symbols for step in board.steps if step.equation is not None]
        self.tones = tones([figure.marks for figure in board.figures()], written)
        self.figures = {view: self._figure(view, at, extents[view][0]) for view, at in anchors.items()}
        self.bodies = Bodies(self.figures[View.MECHANISM], recording.desk, recording.drive)

    def written(self) -> ET.Element:
        """All acts, then the answers."""
        for act in self.recording.desk.board.acts:
            view = None if act.head.place is None or act.number in self.recording.stale else view_of(act.head.place)
            match act:
                case done.Measure(key=key, mm=mm) if key and moves(mm):
                    self._number("m", key, mm)
                case done.Compute(key=key, value=value) if key and moves(value):
                    self._quantity(key, value)
                case done.Depict() if view is View.MECHANISM:
                    self.bodies.draw(act)
                case done.Angle() if view is View.MECHANISM:
                    self.bodies.angle(act)
                case _ if view in self.figures:
                    self.figures[view].draw(act)
        for answer in self.recording.follow:
            self._answer(answer)
        for view, figure in self.figures.items():
            self._stand(figure, self.anchors[view])
        return self.page.root

    def _stand(self, figure: Figure, anchor: complex) -> None:
        """Points and vectors as the file is written: GeoGebra finds them anew, other programs need not."""
        ones = [*figure.placed, *figure.vectors]
        terms = [part for _, pair in ones for part in pair]
        found = values(terms, {self.recording.variable: self.recording.drive.position})
        for (one, _), x, y in zip(ones, found[::2], found[1::2], strict=True):
            if isfinite(x) and isfinite(y):
                self.page.stands(one, complex(x, y) + (0j if one.get("type") == "vector" else anchor))

    def _slider(self) -> None:
        """The input: an angle in degrees, or a travel in mm."""
        r, slide = self.recording, self.recording.drive.slide
        factor = 1e3 if slide else degrees(1.0)
        stem, link = r.variable.split("_")
        label = self.page.labels.quantity(r.variable)
        zero, whole = r.drive.lead, not slide and r.low == 0.0
        value = r.drive.position - zero
        low, high = (r.low, r.high) if whole else (r.low - zero, r.high - zero)
        self.page.slider(
            label,
            (value % (2 * np.pi) if whole else value) * factor,
            low * factor,
            high * factor,
            0.5 if slide else 1.0,
            (40.0, 40.0),
            f"${'s' if stem == 's' else 'φ'}_{{{link}}}$",
        )
        ahead = f" + {zero!r}" if zero else ""
        own = self.page.hidden(f"{label} / 1000" if slide else f"{label} * {np.pi!r} / 180{ahead}")
        self.spelling.know(self.terms.variable(r.variable), own)

    def _figure(self, view: View, at: complex, low: complex) -> Figure:
        pole = view is not View.MECHANISM
        anchor = self.page.labels.new("p" if pole else "O", INDEX[view] or "m")
        self.page.free_point(
            anchor, at, caption="$p'$" if view is View.ACCELERATION else "$p$" if pole else "", seen=pole
        )
        scale = self.recording.desk.board.scale_of(view)
        words = (
            f"{view.title.of(self.lang)}  {scale.symbol} = {number(scale.told.value)} {written_unit(scale.told.per_mm)}"
        )
        self.page.text(words, f"{anchor} + ({low.real!r}, {low.imag - TITLE!r})")
        return Figure(self.page, self.terms, self.spelling, view, anchor, self.tones)

    def _number(self, base: str, index: str, value: Any) -> None:
        term = self.terms.parts(value)[0]
        label = self.page.labels.new(base, "".join(filter(str.isalnum, index)))
        self.page.number(label, self.spelling.text(term), caption=length(index))
        self.spelling.know(term, label)

    def _quantity(self, key: str, value: Any, end: str = "", part: int = 0) -> None:
        term = self.terms.parts(value)[part]
        label = self.page.labels.quantity(key, end)
        self.page.number(label, self.spelling.text(term), caption=named(key) + (f".{end}" if end else ""))
        self.written_down.add(key)
        self.spelling.know(term, label)

    def _answer(self, act: done.Answer) -> None:
        """A quantity that is asked: a number with its sign, or both components of a vector (SI)."""
        if act.unit in ("rad/s", "rad/s^2", "deg") or (not moves(act.value) and not isinstance(act.value, complex)):
            if act.key not in self.written_down:
                self._quantity(act.key, act.value)
        else:
            for part, end in enumerate("xy"):
                self._quantity(act.key, act.value, end, part)


def _roots(acts: Sequence[done.Act], terms: Numbers) -> Iterator[Term]:
    """Every term that an object will be made of."""
    for act in acts:
        for one in fields(act):
            found = getattr(act, one.name)
            for value in found if isinstance(found, tuple) else (found,):
                if moves(value):
                    yield from terms.parts(value)


def _extent(recording: Recording, view: View) -> tuple[complex, complex] | None:
    """Lower left and upper right corner of the figure over the range of its input,
    a little larger at most than as given."""
    spots = [
        recording.terms.parts(act.at)
        for act in recording.desk.board.acts
        if isinstance(act, done.Locate | done.Plot) and act.head.place is not None and view_of(act.head.place) is view
    ]
    if not spots:
        return None
    rows = [
        values([part for pair in spots for part in pair], {recording.variable: at})
        for at in (recording.drive.position, *np.linspace(recording.low, recording.high, 25).tolist())
    ]
    boxes = [(min(row[::2]), min(row[1::2]), max(row[::2]), max(row[1::2])) for row in rows if all(map(isfinite, row))]
    x0, y0, x1, y1 = boxes[0]
    room = 0.75 * max(x1 - x0, y1 - y0, 20.0)
    low = complex(max(min(b[0] for b in boxes), x0 - room), max(min(b[1] for b in boxes), y0 - room))
    return low - (8 + 8j), complex(
        min(max(b[2] for b in boxes), x1 + room), min(max(b[3] for b in boxes), y1 + room)
    ) + (8 + 8j)


def _anchors(extents: dict[View, tuple[complex, complex]]) -> dict[View, complex]:
    """Where each figure has its origin: side by side, their middles on one line; the mechanism's is the page's."""
    found: dict[View, complex] = {}
    right, middle = 0.0, 0.0
    for view, (low, high) in extents.items():
        centre = (low.imag + high.imag) / 2
        if not found:
            found[view], middle = 0j, centre
        else:
            found[view] = complex(round(right + GAP - low.real), round(middle - centre))
        right = found[view].real + high.real
    return found


def _window(root: ET.Element, extents: dict[View, tuple[complex, complex]]) -> None:
    """The part of the plane that is seen: all figures."""
    anchors = _anchors(extents)
    x0 = min(anchors[v].real + low.real for v, (low, _) in extents.items()) - 10
    x1 = max(anchors[v].real + high.real for v, (_, high) in extents.items()) + 10
    y0 = min(anchors[v].imag + low.imag for v, (low, _) in extents.items()) - 2 * TITLE
    y1 = max(anchors[v].imag + high.imag for v, (_, high) in extents.items()) + 2 * TITLE
    scale = min(PIXELS[0] / (x1 - x0), PIXELS[1] / (y1 - y0))
    view = ET.SubElement(root, "euclidianView")
    ET.SubElement(view, "size", width=str(int(PIXELS[0])), height=str(int(PIXELS[1])))
    ET.SubElement(
        view, "coordSystem", xZero=repr(-x0 * scale), yZero=repr(y1 * scale), scale=repr(scale), yscale=repr(scale)
    )
    ET.SubElement(
        view,
        "evSettings",
        axes="false",
        grid="false",
        gridIsBold="false",
        pointCapturing="0",
        rightAngleStyle="1",
        checkboxSize="13",
        gridType="0",
    )
    ET.SubElement(view, "bgColor", r="255", g="255", b="255")
    for axis in ("0", "1"):
        ET.SubElement(view, "axis", id=axis, show="false", label="", unitLabel="", tickStyle="1", showNumbers="false")
    kernel = ET.SubElement(root, "kernel")
    ET.SubElement(kernel, "decimals", val="4")
    ET.SubElement(kernel, "angleUnit", val="degree")
