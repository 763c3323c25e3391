"""DXF, R12 to 2018: lines and polylines of the model space, blocks taken apart, in the unit of the drawing."""

from __future__ import annotations

import io
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from ....errors import FaultError
from ....limits import DRAWING_NESTED, DRAWN
from ....words import Words
from ..segment import Drawing, Label, Segment
from .found import Found
from .refuse import reading

if TYPE_CHECKING:
    from ezdxf.entities.dxfentity import DXFEntity

MM = 4  # $INSUNITS
UNITS = {
    "centimeters": "厘米",
    "decimeters": "分米",
    "meters": "米",
    "microns": "微米",
    "inches": "英寸",
    "feet": "英尺",
}
FLAT = 1e-9


def read_dxf(file: str, data: bytes) -> Drawing:
    """The drawing in a DXF file; without a unit it is taken for mm, aloud. Raises FaultError."""
    found = Found(file)
    with reading("DXF"):
        document = _document(data)
        unit = _Unit(document, found)
        for entity in _apart(document.modelspace(), found):
            _take(entity, unit, found)
        return found.drawing()


def _document(data: bytes) -> Any:
    from ezdxf import recover

    document, _ = recover.read(io.BytesIO(data))
    return document


class _Unit:
    """mm of a unit of the drawing."""

    def __init__(self, document: Any, found: Found) -> None:
        from ezdxf.enums import InsertUnits
        from ezdxf.units import conversion_factor

        code = int(document.header.get("$INSUNITS", 0))
        self.mm = float(conversion_factor(InsertUnits(code), InsertUnits(MM))) if code else 1.0
        if not code:
            found.remark(Words("DXF 未注明单位，按 mm 读取", "the DXF states no unit; it was read as mm"))
        elif code != MM:
            name = InsertUnits(code).name.casefold()
            zh = UNITS.get(name, f" {name}")
            found.remark(Words(f"DXF 的单位是{zh}，已换算为 mm", f"the DXF is in {name}; converted to mm"))

    def at(self, point: Any) -> complex:
        """A place of the drawing in mm."""
        return complex(point[0], point[1]) * self.mm


def _apart(entities: Any, found: Found, depth: int = 0) -> Iterator[DXFEntity]:
    """Every entity, those of blocks and their blocks at their places."""
    for number, entity in enumerate(entities):
        if number > DRAWN:
            found.counted()
            raise _too_many(entity)
        if entity.dxftype() != "INSERT":
            yield entity
            continue
        if depth >= DRAWING_NESTED or entity.mcount > DRAWN:
            raise _too_many(entity)
        for one in entity.multi_insert() if entity.mcount > 1 else (entity,):
            yield from one.attribs
            yield from _named(one, _apart(one.virtual_entities(), found, depth + 1))
            found.counted()


def _named(insert: Any, entities: Iterator[DXFEntity]) -> Iterator[DXFEntity]:
    """The entities of a block; what lies on layer 0 there is on the layer of the block."""
    for one in entities:
        if one.dxf.layer == "0":
            one.dxf.layer = insert.dxf.layer
        yield one


def _too_many(entity: DXFEntity) -> FaultError:
    handle = entity.dxf.handle
    return FaultError(
        Words(
            f"块 #{handle} 展开后多于 {DRAWN} 个对象，或嵌套超过 {DRAWING_NESTED} 层；请先分解",
            f"block #{handle} unfolds into more than {DRAWN} objects, or {DRAWING_NESTED} levels; explode it first",
        ),
        code="too-many",
        numbers={"most": DRAWN, "levels": DRAWING_NESTED},
    )


def _take(entity: Any, unit: _Unit, found: Found) -> None:
    """What an entity adds: lines, heads, lettering."""
    kind, like = entity.dxftype(), _like(entity)
    match kind:
        case "LINE":
            found.line((unit.at(entity.dxf.start), unit.at(entity.dxf.end)), like)
        case "LWPOLYLINE":
            _polyline(list(entity.get_points("xyseb")), bool(entity.closed), unit, found, like)
        case "POLYLINE" if entity.is_2d_polyline or entity.is_3d_polyline:
            _polyline([_vertex(one) for one in entity.vertices], bool(entity.is_closed), unit, found, like)
        case "SOLID" | "TRACE":
            found.area([unit.at(entity.dxf.get(name)) for name in ("vtx0", "vtx1", "vtx3", "vtx2")])
        case "HATCH":
            for path in entity.paths.paths:
                if hasattr(path, "vertices"):
                    found.area([unit.at(point) for point in path.vertices])
        case "LEADER":
            points = [unit.at(point) for point in entity.vertices]
            found.line(points[::-1], _like(entity, headed=bool(entity.dxf.get("has_arrowhead", 1))))
        case "TEXT" | "ATTRIB":
            found.letter(_label(entity, entity.dxf.text, entity.dxf.height, unit))
        case "MTEXT":
            found.letter(_label(entity, entity.plain_text(), entity.dxf.char_height, unit))
        case _:
            return


def _like(entity: Any, headed: bool = False) -> Segment:
    """Name, layer, place and width of what an entity draws."""
    layer, weight = str(entity.dxf.layer), float(entity.dxf.get("lineweight", -1))
    if weight < 0 and entity.doc is not None and layer in entity.doc.layers:
        weight = float(entity.doc.layers.get(layer).dxf.get("lineweight", -1))
    where = f"{entity.dxftype()} #{entity.dxf.handle or '?'}"
    return Segment(start=0j, end=0j, layer=layer, where=where, headed=headed, width=max(weight, 0.0) / 100)


def _vertex(one: Any) -> tuple[float, ...]:
    x, y, _ = one.dxf.location
    return x, y, one.dxf.get("start_width", 0.0), one.dxf.get("end_width", 0.0), one.dxf.get("bulge", 0.0)


def _polyline(rows: list[Any], closed: bool, unit: _Unit, found: Found, like: Segment) -> None:
    """Its straight pieces; one that tapers to a point is an arrow head."""
    from dataclasses import replace

    ends = rows[1:] + rows[:1] if closed else rows[1:]
    for (x, y, wide, narrow, bulge), (u, v, *_) in zip(rows, ends, strict=False):
        if abs(bulge) <= FLAT:
            headed = wide > 0 and narrow <= FLAT
            found.line((unit.at((x, y)), unit.at((u, v))), replace(like, headed=headed))


def _label(entity: Any, text: str, height: float, unit: _Unit) -> Label:
    return Label(text=text, at=unit.at(entity.dxf.insert), height=height * unit.mm, layer=str(entity.dxf.layer))
