"""One line of Chinese or English text with formulas between dollar signs."""

from __future__ import annotations

from ..algebra.formula import row, split_words
from .box import Box, beside
from .fonts import Face
from .layout import layout
from .runs import latin, run

ROMAN = frozenset("ⅠⅡⅢⅣⅤⅥⅦⅧⅨⅩ")  # numbers of classes and of planes: a Chinese character each
_QUOTES = frozenset("“”‘’—…·") | ROMAN


def is_han(char: str) -> bool:
    """Whether a character is set full width: Chinese characters and their punctuation."""
    return char >= "\u2e80"


def face_of(char: str, bold: bool, chinese: bool) -> Face:
    """The face a character of running text is set in: Song (Hei when bold) for Chinese, STIX for the rest."""
    if is_han(char) or (chinese and char in _QUOTES):
        return Face.HEI_BOLD if bold else Face.SONG
    return Face.BOLD if bold else Face.STIX


def layout_words(text: str, em_mm: float, bold: bool = False) -> Box:
    """One line of text with ``$...$`` formulas, set at the given size (mm)."""
    chinese = any(is_han(char) for char in text)
    boxes: list[Box] = []
    for formula, piece in split_words(text):
        if formula:
            boxes.append(layout(row(piece), em_mm, bold))
        else:
            for face, part in _by_face(piece, bold, chinese):
                roman = face in (Face.STIX, Face.BOLD)
                boxes.append(latin(part, em_mm, bold) if roman else run(part, face, em_mm))
    return beside(boxes)


def _by_face(text: str, bold: bool, chinese: bool) -> list[tuple[Face, str]]:
    parts: list[tuple[Face, str]] = []
    for char in text:
        face = face_of(char, bold, chinese)
        if parts and parts[-1][0] is face:
            parts[-1] = (face, parts[-1][1] + char)
        else:
            parts.append((face, char))
    return parts
