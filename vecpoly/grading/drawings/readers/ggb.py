"""GeoGebra: segments and vectors between points, as the file last showed them, with labels."""

from __future__ import annotations

import io
import re
from typing import TYPE_CHECKING
from zipfile import BadZipFile, ZipFile

from ....errors import FaultError
from ....limits import DRAWING_UNPACKED
from ....words import Words
from ..segment import Drawing, Label, Segment
from .found import Found
from .refuse import reading, too_large_unpacked, xml

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

INSIDE = "geogebra.xml"
UNIT = {"mm": 1.0, "cm": 10.0, "dm": 100.0, "m": 1000.0, "in": 25.4}
_PAIR = re.compile(r"^\(\s*([-+0-9.eE]+)\s*,\s*([-+0-9.eE]+)\s*\)$")


def read_ggb(file: str, data: bytes) -> Drawing:
    """The drawing in a GeoGebra file; a unit without a name on the axes is taken for 1 mm. Raises FaultError."""
    with reading("GeoGebra"):
        root = xml(_document(data), INSIDE)
        page = root.find("construction")
        if page is None:
            raise FaultError(Words(f"{INSIDE} 中没有 construction", f"{INSIDE} has no construction"), code="no-ggb")
        found = Found(file)
        _Reader(page, _unit(root, found), found).read()
        return found.drawing()


def _document(data: bytes) -> bytes:
    try:
        with ZipFile(io.BytesIO(data)) as folder:
            if folder.getinfo(INSIDE).file_size > DRAWING_UNPACKED:
                raise too_large_unpacked(INSIDE)
            with folder.open(INSIDE) as inside:
                text = inside.read(DRAWING_UNPACKED + 1)
    except (BadZipFile, KeyError):
        raise FaultError(
            Words(f"不是 GeoGebra 文件：其中没有 {INSIDE}", f"no GeoGebra file: there is no {INSIDE} in it"),
            code="no-ggb",
        ) from None
    if len(text) > DRAWING_UNPACKED:
        raise too_large_unpacked(INSIDE)
    return text


def _unit(root: Element, found: Found) -> float:
    """mm of a unit of the axes."""
    for axis in root.iterfind("euclidianView/axis"):
        name = axis.get("unitLabel", "").strip()
        if name in UNIT:
            return UNIT[name]
    found.remark(Words("坐标轴没有长度单位，按 1 格 = 1 mm 读取", "the axes state no unit of length; 1 was 1 mm"))
    return 1.0


class _Reader:
    """Goes through the construction in its order."""

    def __init__(self, page: Element, mm: float, found: Found) -> None:
        self.page, self.mm, self.found = page, mm, found
        self.elements = {one.get("label", ""): one for one in page.iterfind("element")}
        self.lost: list[str] = []
        self.points = {name: at for name, one in self.elements.items() if (at := self._point(one)) is not None}

    def read(self) -> None:
        """All lines with the names that are shown, and the letters of points."""
        made = set[str]()
        for command in self.page.iterfind("command"):
            made |= set(_values(command.find("output")))
            self._command(command)
        for name, one in self.elements.items():
            if one.get("type") == "vector" and name not in made and _seen(one):
                self._free_vector(name, one)
        if self.lost:
            names, number = ", ".join(self.lost[:3]), len(self.lost)
            self.found.remark(
                Words(
                    f"{names} 等 {number} 条线的端点不是点，也不是坐标，未读取",
                    f"{number} lines ({names} ...) end neither at points nor at coordinates; they were left out",
                )
            )
        for name, at in self.points.items():
            one = self.elements[name]
            if _seen(one) and _lettered(one):
                self.found.letter(Label(text=_called(one), at=at, height=0.0, layer=_layer(one)))

    def _command(self, command: Element) -> None:
        inputs, outputs = _values(command.find("input")), _values(command.find("output"))
        match command.get("name"):
            case "Segment" | "Vector" as kind if outputs:
                ends = [self._at(text) for text in inputs]
                if len(ends) == 1 and kind == "Vector":
                    ends = [0j, *ends]
                if len(ends) == 2 and (shaped := self._two(ends, outputs)) is not None:
                    self._line(outputs[0], shaped, headed=kind == "Vector")
            case "PolyLine" | "Polygon" as kind:
                ends = [self._at(text) for text in inputs]
                known = [at for at in ends if at is not None]
                if len(known) == len(ends) and outputs and kind == "PolyLine":
                    self._line(outputs[0], known, headed=False)
                for side, a, b in zip(outputs[1:], known, known[1:] + known[:1], strict=False):
                    self._line(side, [a, b], headed=False)
            case _:
                return

    def _two(self, ends: list[complex | None], outputs: list[str]) -> list[complex] | None:
        """Both ends; of a segment of a given length the second is a point that the command made."""
        a, b = ends
        if b is None and len(outputs) > 1:
            b = self.points.get(outputs[1])
        step = self._step(outputs[0])
        if step is not None and (a is None) != (b is None):
            a, b = (a, a + step) if a is not None else ((b or 0j) - step, b)
        if a is None or b is None:
            self.lost.append(outputs[0])
            return None
        return [a, b]

    def _step(self, name: str) -> complex | None:
        """The components of a vector."""
        one = self.elements.get(name)
        at = one.find("coords") if one is not None and one.get("type") == "vector" else None
        return None if at is None else complex(float(at.get("x", "nan")), float(at.get("y", "nan"))) * self.mm

    def _line(self, name: str, points: list[complex], headed: bool) -> None:
        one = self.elements.get(name)
        if one is not None and _seen(one):
            like = Segment(start=0j, end=0j, name=_called(one), layer=_layer(one), where=name, headed=headed)
            self.found.line(points, like)

    def _free_vector(self, name: str, one: Element) -> None:
        """A vector given by its components, at its starting point."""
        step, start = self._step(name), one.find("startPoint")
        begin = 0j if start is None else self._at(start.get("exp", "")) or 0j
        if step is not None:
            self._line(name, [begin, begin + step], headed=True)

    def _at(self, text: str) -> complex | None:
        if (pair := _PAIR.match(text.strip())) is not None:
            return complex(float(pair[1]), float(pair[2])) * self.mm
        return self.points.get(text.strip())

    def _point(self, one: Element) -> complex | None:
        at = one.find("coords")
        if one.get("type") != "point" or at is None:
            return None
        x, y, z = (float(at.get(name, "nan")) for name in "xyz")
        return complex(x, y) / z * self.mm if z else None


def _values(one: Element | None) -> list[str]:
    """The attributes a0, a1 ... in their order."""
    given = {} if one is None else one.attrib
    return [given[key] for key in sorted(given, key=lambda name: int(name[1:] or 0)) if given[key]]


def _seen(one: Element) -> bool:
    show = one.find("show")
    return show is None or show.get("object") != "false"


def _lettered(one: Element) -> bool:
    show = one.find("show")
    return show is None or show.get("label") != "false"


def _called(one: Element) -> str:
    """Its caption where it has one, else its label."""
    caption = one.find("caption")
    return (caption.get("val", "") if caption is not None else "") or one.get("label", "")


def _layer(one: Element) -> str:
    layer = one.find("layer")
    return "" if layer is None else layer.get("val", "")
