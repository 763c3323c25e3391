"""Set type as SVG text: every run at its own place, in the best face the viewer has."""

from __future__ import annotations

from .box import MM, Box, Item, Rule
from .fonts import MISSING, Face, missing_text

_STYLES = {
    Face.ITALIC: ' font-style="italic"',
    Face.BOLD: ' font-weight="bold"',
    Face.BOLD_ITALIC: ' font-style="italic" font-weight="bold"',
    Face.HEI_BOLD: ' font-weight="bold"',
}
_SONG = "'Noto Serif CJK SC','Source Han Serif SC',SimSun,serif"
_HEI = "'Noto Sans CJK SC','Source Han Sans SC',SimHei,sans-serif"
_ROMAN = "STIXGeneral,'STIX Two Text','Times New Roman','Noto Serif CJK SC',serif"


def svg_group(box: Box, x_mm: float, y_mm: float, fill: str = "black") -> str:
    """The box as an SVG group in millimetre units, its origin at (x, y), y downwards."""
    pieces = [_element(item, x_mm, y_mm) for item in box.items]
    return f'<g fill="{fill}">{"".join(pieces)}</g>'


def _element(item: Item, x: float, y: float) -> str:
    from xml.sax.saxutils import escape  # it loads what reads the net: only where a picture is written

    if isinstance(item, Rule):
        top = y - item.y - item.height
        corner = f'x="{x + item.x:.3f}" y="{top:.3f}"'
        return f'<rect {corner} width="{item.width:.3f}" height="{item.height:.3f}"/>'
    size, text, face = item.size / MM, item.text, Face.STIX
    if item.font == MISSING:
        size, text = size / 2, "".join(map(missing_text, text))
    else:
        face = Face(item.font)
    at = f'x="{x + item.x:.3f}" y="{y - item.y:.3f}" font-size="{size:.3f}"'
    style = f'font-family="{_family(face)}"{_STYLES.get(face, "")}'
    return f'<text {at} {style} xml:space="preserve">{escape(text)}</text>'


def _family(face: Face) -> str:
    match face:
        case Face.SONG | Face.SONG_EXT:
            return _SONG
        case Face.HEI | Face.HEI_BOLD:
            return _HEI
        case Face.DEJAVU:
            return "'DejaVu Sans',sans-serif"
        case _:
            return _ROMAN
