"""SVG: lines, polylines and the straight pieces of paths, through all transforms, in mm by the view box."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ....errors import FaultError
from ....foundation.slotted import replace
from ....limits import DRAWING_NESTED, DRAWN
from ....words import Words
from ..segment import Drawing, Label, Segment
from .found import Found, is_straight
from .refuse import reading, xml

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

INKSCAPE, XLINK = "{http://www.inkscape.org/namespaces/inkscape}", "{http://www.w3.org/1999/xlink}"
UNIT = {"mm": 1.0, "cm": 10.0, "in": 25.4, "pt": 25.4 / 72, "pc": 25.4 / 6, "px": 25.4 / 96, "": 25.4 / 96}
HIDDEN = {"defs", "marker", "symbol", "clipPath", "mask", "pattern", "metadata", "style", "title", "desc"}
LETTER = 16.0  # user units: the size of letters of which none is stated
_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")


@dataclass(frozen=True, slots=True, kw_only=True)
class _Around:
    """What an element has from those around it."""

    matrix: Any
    style: dict[str, str]
    layer: str = ""
    depth: int = 0


def read_svg(file: str, data: bytes) -> Drawing:
    """The drawing in an SVG file. Raises FaultError."""
    with reading("SVG"):
        root = xml(data, "SVG")
        if _tag(root) != "svg":
            raise FaultError(
                Words(f"根元素是 {_tag(root)} 而不是 svg", f"its root is {_tag(root)}, and no svg"), code="no-svg"
            )
        found = Found(file)
        reader = _Reader(found, {one.get("id", ""): one for one in root.iter()})
        for child in root:
            reader.take(child, _Around(matrix=_page(root, found), style=_style(root)))
        return found.drawing()


def _page(root: Element, found: Found) -> Any:
    """The matrix from user units to mm, y down."""
    box = [float(n) for n in _NUMBER.findall(root.get("viewBox", ""))]
    width, height = _length(root.get("width")), _length(root.get("height"))
    if len(box) == 4 and box[2] > 0 and box[3] > 0 and (width or height):
        across = [size / span for size, span in ((width, box[2]), (height, box[3])) if size]
        scale = min(across)
    else:
        scale = UNIT["px"]
        found.remark(
            Words("SVG 没有以 mm 计的尺寸，按 1 px = 25.4/96 mm 读取", "the SVG has no size in mm; 1 px was 25.4/96 mm")
        )
    return np.diag([scale, scale, 1.0])


def _length(text: str | None) -> float:
    """A length in mm; 0 where there is none, or a share of something else."""
    number, unit = _NUMBER.match((text or "").strip()), re.search(r"[a-z%]*$", (text or "").strip())
    known = UNIT.get(unit.group() if unit else "", 0.0)
    return float(number.group()) * known if number else 0.0


class _Reader:
    """Goes through the elements, with what they inherit."""

    def __init__(self, found: Found, known: dict[str, Element]) -> None:
        self.found, self.known, self.seen = found, known, 0

    def take(self, one: Element, around: _Around) -> None:
        """An element and those in it."""
        tag, here = _tag(one), self._inside(one, around)
        if tag in HIDDEN or here.style.get("display") == "none" or here.style.get("visibility") == "hidden":
            return
        if tag in ("g", "svg", "a", "switch"):
            for child in one:
                self.take(child, here)
        elif tag == "use":
            self._used(one, here)
        elif tag == "text":
            self._letters(one, here, _first(one.get("x")), _first(one.get("y")))
        else:
            for points in _lines(one, tag):
                self._line(one, [_moved(z, here.matrix) for z in points], here)

    def _inside(self, one: Element, around: _Around) -> _Around:
        from svgpathtools.parser import parse_transform

        self.seen += 1
        if around.depth > 4 * DRAWING_NESTED or self.seen > 4 * DRAWN:
            raise FaultError(
                Words("SVG 嵌套过深或元素过多；请先取消编组", "groups too deep or elements too many; ungroup first"),
                code="too-many",
            )
        inherited = {key: value for key, value in around.style.items() if not key.startswith("marker")}
        style = inherited | _style(one)
        matrix = around.matrix @ parse_transform(one.get("transform"), strict=True)
        layer = around.layer if _tag(one) != "g" else _group(one) or around.layer
        return replace(around, matrix=matrix, style=style, layer=layer, depth=around.depth + 1)

    def _used(self, one: Element, here: _Around) -> None:
        target = self.known.get((one.get("href") or one.get(f"{XLINK}href") or "").removeprefix("#"))
        if target is not None and target is not one:
            shift = np.array([[1, 0, _first(one.get("x"))], [0, 1, _first(one.get("y"))], [0, 0, 1.0]])
            for part in target if _tag(target) == "symbol" else (target,):
                self.take(part, replace(here, matrix=here.matrix @ shift))

    def _letters(self, one: Element, here: _Around, x: float, y: float) -> None:
        """A text with its parts; a part without a place of its own goes on where it is."""
        label = Label(
            text="".join((one.text or "", *(_plain(part) for part in one if part.get("x") is None))),
            at=_moved(complex(x, y), here.matrix),
            height=0.7 * _size(here.style) * _scale(here.matrix),
            layer=here.layer,
        )
        self.found.letter(label)
        for part in one:
            if part.get("x") is not None:
                self._letters(part, self._inside(part, here), _first(part.get("x")), _first(part.get("y"), y))

    def _line(self, one: Element, points: list[complex], here: _Around) -> None:
        style, where = here.style, f"<{_tag(one)} id={one.get('id', '?')}>"
        if points[0] == points[-1] and style.get("fill", "") != "none" and len(set(points)) == 3:
            self.found.area(points)
        if style.get("stroke", "none" if style.get("fill", "none") != "none" else "") == "none":
            return  # only filled
        end, start = (style.get(f"marker-{at}", "none") != "none" for at in ("end", "start"))
        wide = _first(style.get("stroke-width")) * _scale(here.matrix)
        like = Segment(
            start=0j, end=0j, name=_name(one), layer=here.layer, where=where, headed=end or start, width=wide
        )
        self.found.line(points[::-1] if start and not end else points, like)


def _lines(one: Element, tag: str) -> Iterator[list[complex]]:
    """The straight lines of an element, in its own units."""
    match tag:
        case "line":
            yield [complex(_first(one.get(f"x{n}")), _first(one.get(f"y{n}"))) for n in "12"]
        case "polyline" | "polygon":
            numbers = [float(n) for n in _NUMBER.findall(one.get("points", ""))]
            points = [complex(x, y) for x, y in zip(numbers[::2], numbers[1::2], strict=False)]
            if points:
                yield points + points[:1] * (tag == "polygon")
        case "path":
            yield from _of_path(one.get("d", ""))


def _of_path(d: str) -> Iterator[list[complex]]:
    from svgpathtools import Arc, Line, parse_path

    run: list[complex] = []
    for piece in parse_path(d):
        straight = isinstance(piece, Line) or (
            not isinstance(piece, Arc) and is_straight(piece.start, *piece.bpoints()[1:-1], end=piece.end)
        )
        if run and (not straight or abs(piece.start - run[-1]) > 1e-9):
            yield run
            run = []
        if straight:
            run = [*(run or [piece.start]), piece.end]
    if run:
        yield run


def _scale(matrix: Any) -> float:
    return float(abs(np.linalg.det(matrix)) ** 0.5)


def _moved(at: complex, matrix: Any) -> complex:
    x, y, _ = matrix @ (at.real, at.imag, 1.0)
    return complex(x, -y)


def _style(one: Element) -> dict[str, str]:
    own = {key: one.get(key, "") for key in (*_ATTRIBUTES,) if one.get(key)}
    parts = (part.partition(":") for part in one.get("style", "").split(";"))
    return own | {key.strip(): value.strip() for key, _, value in parts if value}


_ATTRIBUTES = (
    "stroke", "fill", "display", "visibility", "marker-start", "marker-end", "stroke-width", "font-size"
)  # fmt: skip


def _name(one: Element) -> str:
    """What the drawer calls it."""
    title = next((child.text for child in one if _tag(child) == "title" and child.text), "")
    return one.get(f"{INKSCAPE}label") or title or one.get("data-name") or one.get("id") or ""


def _group(one: Element) -> str:
    return one.get(f"{INKSCAPE}label") or one.get("data-layer") or one.get("id") or ""


def _plain(one: Element) -> str:
    return "".join(one.itertext()) + (one.tail or "")


def _size(style: dict[str, str]) -> float:
    return _first(style.get("font-size"), LETTER)


def _first(text: str | None, default: float = 0.0) -> float:
    number = _NUMBER.search(text or "")
    return float(number.group()) if number else default


def _tag(one: Element) -> str:
    return one.tag.rpartition("}")[2] if isinstance(one.tag, str) else ""
