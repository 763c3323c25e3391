"""The faces of the product: Song and Hei shipped with it, STIX and DejaVu lying in matplotlib's files.

A face is opened when its first character is measured. Every character is looked up in a chain of faces; one
that no face has is set as its code point between brackets in the pseudo face `MISSING`: seen, and collected.
"""

from __future__ import annotations

from collections.abc import Iterable
from enum import StrEnum
from functools import cache, lru_cache
from importlib.resources import files
from importlib.util import find_spec
from io import BytesIO
from pathlib import Path
from struct import unpack_from
from typing import Any

from ..foundation.slotted import dataclass


class Face(StrEnum):
    """The faces by the name under which reportlab knows them."""

    SONG = "VPSong"
    SONG_EXT = "VPSongExt"
    HEI = "VPHei"
    HEI_BOLD = "VPHeiBold"
    STIX = "STIX"
    ITALIC = "STIX-Italic"
    BOLD = "STIX-Bold"
    BOLD_ITALIC = "STIX-BoldItalic"
    DEJAVU = "DejaVuSans"
    MONO = "DejaVuSansMono"


MISSING = "VP-missing"
SUBSETS = 16  # of a face that are kept, some 40 KB each: the documents of a class are of the same letters
_BLANKS = "\t\n\r\u00a0\u2009"

_OURS = {
    Face.SONG: "VecpolySong-GB2312.ttf",
    Face.SONG_EXT: "VecpolySong-GBK-extension.ttf",
    Face.HEI: "VecpolyHei-GB2312.ttf",
    Face.HEI_BOLD: "VecpolyHei-Bold-GB2312.ttf",
}
_MATPLOTLIBS = {
    Face.STIX: "STIXGeneral.ttf",
    Face.ITALIC: "STIXGeneralItalic.ttf",
    Face.BOLD: "STIXGeneralBol.ttf",
    Face.BOLD_ITALIC: "STIXGeneralBolIta.ttf",
    Face.DEJAVU: "DejaVuSans.ttf",
    Face.MONO: "DejaVuSansMono.ttf",
}
_SECOND = (Face.SONG, Face.SONG_EXT, Face.STIX, Face.DEJAVU)
_FIRST = {  # faces tried before _SECOND
    Face.HEI_BOLD: (Face.HEI_BOLD, Face.HEI),
    Face.ITALIC: (Face.ITALIC, Face.STIX),
    Face.BOLD: (Face.BOLD, Face.STIX),
    Face.BOLD_ITALIC: (Face.BOLD_ITALIC, Face.BOLD),
}


@dataclass(frozen=True, slots=True)
class Glyph:
    """One character as it will be set: face name, text, width and ink extents per em."""

    font: str
    text: str
    width: float
    left: float
    bottom: float
    right: float
    top: float


def path(face: Face) -> Path:
    """Where the face's file lies (for programs that take files; ours may lie inside an archive)."""
    if face in _OURS:
        return Path(str(files("vecpoly.fonts") / _OURS[face]))
    spec = find_spec("matplotlib")
    if spec is None or not spec.submodule_search_locations:
        raise ModuleNotFoundError("the STIX and DejaVu faces come with matplotlib, which is not installed")
    return Path(spec.submodule_search_locations[0], "mpl-data", "fonts", "ttf", _MATPLOTLIBS[face])


@cache
def load(face: Face) -> Any:
    """The face as a reportlab TTFont, opened and registered once."""
    from reportlab.pdfbase import pdfmetrics
    from reportlab.pdfbase.ttfonts import TTFont

    data = (files("vecpoly.fonts") / _OURS[face]).read_bytes() if face in _OURS else path(face).read_bytes()
    font = TTFont(face.value, BytesIO(data), shapable=False)
    subset = lru_cache(maxsize=SUBSETS)(font.face.makeSubset)
    font.face.makeSubset = lambda codes: subset(tuple(codes))
    pdfmetrics.registerFont(font)
    return font


def chain(face: Face) -> Iterable[Face]:
    """The faces in which a character is sought, best first."""
    first = _FIRST.get(face, (face,))
    return (*first, *(other for other in _SECOND if other not in first))


@cache
def glyph(char: str, face: Face) -> Glyph:
    """The character in the first face of the chain that has it."""
    code = ord(" " if char in _BLANKS else char)
    for candidate in chain(face):
        metrics = load(candidate).face
        if code in metrics.charToGlyph:
            width = metrics.charWidths.get(code, metrics.defaultWidth) / 1000
            return Glyph(candidate.value, chr(code), width, *_ink(metrics, metrics.charToGlyph[code]))
    return _missing(char)


def _missing(char: str) -> Glyph:
    text = f"[U+{ord(char):04X}]"
    width = sum(glyph(c, Face.STIX).width for c in text)
    return Glyph(MISSING, char, width / 2, 0.0, -0.1, width / 2, 0.4)


def missing_text(char: str) -> str:
    """What stands on paper for a character that no face has (set in STIX at half the size)."""
    return f"[U+{ord(char):04X}]"


def missing(text: str) -> tuple[str, ...]:
    """The characters of a text that no face has, each once, in order."""
    return tuple(c for c in dict.fromkeys(text) if c > " " and glyph(c, Face.STIX).font == MISSING)


def _ink(metrics: Any, index: int) -> tuple[float, float, float, float]:
    """xMin, yMin, xMax, yMax of a glyph, per em; zeros for a blank."""
    start, end = metrics.glyphPos[index], metrics.glyphPos[index + 1]
    if start == end:
        return (0.0, 0.0, 0.0, 0.0)
    box = unpack_from(">hhhh", metrics._ttf_data, metrics.get_table_pos("glyf")[0] + start + 2)
    em = float(metrics.unitsPerEm)
    left, bottom, right, top = (value / em for value in box)
    return (left, bottom, right, top)
