"""Running text cut into cells that no line break enters: Chinese characters, words, pieces of formulas."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from enum import Enum, auto
from functools import lru_cache

from ...algebra.formula import row, split_words
from ...foundation.slotted import dataclass, replace
from ...tagging.pieces import Source
from ...tagging.references import called
from ...typeset.atoms import THICK
from ...typeset.box import Box, beside
from ...typeset.fonts import Face, glyph
from ...typeset.layout import halves, layout, pieces, segments
from ...typeset.runs import latin, raised, run
from ...typeset.words import ROMAN, is_han
from .text.held import held, in_brackets

NO_START = frozenset("，。、；：？！）〕］｝》〉」』】”’…—·～℃％")
NO_END = frozenset("（〔［｛《〈「『【“‘￥№")
_LATIN_NO_START = frozenset(",.;:!?)]}%")
_LATIN_NO_END = frozenset("([{")
_AMBIGUOUS = frozenset("“”‘’—…·") | ROMAN  # full width in Chinese text, narrow in English
_BOLD = re.compile(r"\*\*(.+?)\*\*", re.DOTALL)
AUTO = 0.2  # space between Chinese and Latin, em
_ADDRESS = 30  # letters
SHORT = 12.0  # em: a formula in running text that is no longer is not broken
BLANK = 0.25  # a blank between words, em


class Kind(Enum):
    """What a cell is to its neighbours."""

    HAN = auto()
    OPEN = auto()
    CLOSE = auto()
    WORD = auto()
    FORMULA = auto()


@dataclass(frozen=True, slots=True)
class Cell:
    """One cell, in mm; spaced: a blank stood before it; lead, trail: blank at its ends that may go."""

    kind: Kind
    box: Box
    text: str = ""
    spaced: bool = False
    joined: bool = False  # continues the formula before it
    lead: float = 0.0
    trail: float = 0.0
    source: Source | None = None
    goal: str = ""  # the place that it calls, a part of a reference
    bold: bool = False  # of a formula
    kept: bool = False  # on the line of the cell before it


@dataclass(frozen=True, slots=True)
class Gap:
    """The space between two cells: width (mm), share of what justification adds, whether a line may end."""

    width: float
    stretch: float
    breakable: bool


@lru_cache(maxsize=4096)
def cells(text: str, em: float, chinese: bool, bold: bool = False) -> tuple[Cell, ...]:
    """The cells of a paragraph with ``$formulas$`` and ``**bold**``."""
    out: list[Cell] = []
    spaced = False
    for strong, piece in _emphasis(text):
        for formula, part in split_words(piece):
            heavy = bold or strong
            if formula:
                found = _formula(part, em, heavy, spaced)
                spaced = False
                out.extend(found)
                continue
            for goal, bit in called(part):
                found, spaced = _words(bit, em, chinese, heavy, spaced)
                out.extend(replace(cell, goal=goal) for cell in found) if goal else out.extend(found)
    for n in in_brackets([cell.text for cell in out]):
        out[n] = replace(out[n], kept=True)
    return tuple(out)


def _emphasis(text: str) -> Iterator[tuple[bool, str]]:
    for i, piece in enumerate(_BOLD.split(text)):
        if piece:
            yield i % 2 == 1, piece


def _formula(text: str, em: float, bold: bool, spaced: bool) -> list[Cell]:
    boxes = _segments(text, em, bold)
    sources = _sources(text, len(boxes))
    return [
        Cell(Kind.FORMULA, box, "$", spaced and i == 0, i > 0, source=source, bold=bold)
        for i, (box, source) in enumerate(zip(boxes, sources, strict=True))
    ]


@lru_cache(maxsize=4096)
def _sources(text: str, count: int) -> tuple[Source, ...]:
    """What each of so many pieces says; a short formula is one piece."""
    said = pieces(row(text))
    return tuple(Source(text, piece) for piece in (said if len(said) == count else (" ".join(said),)))


def parted(cell: Cell, em: float) -> list[tuple[Cell, Cell]]:
    """A piece of a long formula cut in two after each of its signs, for a line that would be stretched too far else."""
    if cell.kind is not Kind.FORMULA or cell.source is None or not cell.source.text or cell.box.width <= SHORT * em:
        return []
    text = cell.source.text
    return [
        (
            replace(cell, box=head, source=Source(text, first)),
            replace(cell, box=tail, source=Source(text, rest), spaced=False, joined=True),
        )
        for (head, first), (tail, rest) in halves(row(text), cell.source.piece, em, cell.bold)
    ]


@lru_cache(maxsize=4096)
def _segments(text: str, em: float, bold: bool) -> tuple[Box, ...]:
    whole = layout(row(text), em, bold)
    return (whole,) if whole.width <= SHORT * em else segments(row(text), em, bold, before=False)


def _words(text: str, em: float, chinese: bool, bold: bool, spaced: bool) -> tuple[list[Cell], bool]:
    out: list[Cell] = []
    word = ""
    for i, char in enumerate(text):
        full = is_han(char) or (chinese and char in _AMBIGUOUS and not _within_unit(text, i))
        if not full and not char.isspace():
            word += char
            continue
        if word:
            out.append(_word(word, em, bold, spaced))
            word, spaced = "", False
        if full:
            out.append(_han(char, em, bold, spaced))
        spaced = not full
    if word:
        out.append(_word(word, em, bold, spaced))
        spaced = False
    return out, spaced


def _within_unit(text: str, at: int) -> bool:
    """Whether a dot stands between two letters, as in N·m: it is as narrow in Chinese text."""
    around = text[at - 1 : at] + text[at + 1 : at + 2]
    return text[at] == "·" and len(around) == 2 and around.isascii() and around.isalpha()


@lru_cache(maxsize=16384)
def _han(char: str, em: float, bold: bool, spaced: bool) -> Cell:
    face = Face.HEI_BOLD if bold else Face.SONG
    shape = glyph(char, face)
    box = run(char, face, em)
    if char in NO_END:
        return Cell(Kind.OPEN, box, char, spaced, lead=max(0.0, min(shape.left, 0.5)) * em)
    if char in NO_START:
        trail = 0.0 if char in "—…·" else max(0.0, min(shape.width - shape.right, 0.5)) * em
        return Cell(Kind.CLOSE, box, char, spaced, trail=trail)
    return Cell(Kind.HAN, box, char, spaced)


@lru_cache(maxsize=16384)
def _word(text: str, em: float, bold: bool, spaced: bool) -> Cell:
    source = Source("", raised(text)) if "^" in text else None
    return Cell(Kind.WORD, latin(text, em, bold), text, spaced, source=source)


def chopped(cell: Cell, width: float, em: float, bold: bool) -> list[Cell]:
    """A word wider than the line, cut where it must be; a long address, after its strokes."""
    if cell.kind is not Kind.WORD or (cell.box.width <= width and len(cell.text) < _ADDRESS):
        return [cell]
    count = max(1, int(len(cell.text) * width / cell.box.width * 0.9))
    pieces = re.findall(r"[^/]*/|[^/]+", cell.text)
    parts = [piece[i : i + count] for piece in pieces for i in range(0, len(piece), count)]
    first, *rest = (_word(part, em, bold, False) for part in parts)
    return [replace(first, spaced=cell.spaced), *(replace(part, joined=True) for part in rest)]


def gap(a: Cell, b: Cell, em: float) -> Gap:
    """The space between two neighbouring cells."""
    found = _gap(a, b, em)
    return replace(found, breakable=False) if found.breakable and (b.kept or held(a.text, b.text)) else found


def _gap(a: Cell, b: Cell, em: float) -> Gap:
    latin_a, latin_b = a.kind in (Kind.WORD, Kind.FORMULA), b.kind in (Kind.WORD, Kind.FORMULA)
    if latin_a and latin_b:
        if b.joined:
            return Gap(THICK * em, 1.0, True) if b.kind is Kind.FORMULA else Gap(0.0, 0.0, True)
        return Gap(BLANK * em, 3.0, True) if b.spaced else Gap(0.0, 0.0, False)
    allowed = not (_no_end(a) or _no_start(b))
    if latin_a or latin_b:
        tight = _tight(a, b) or not (allowed and Kind.HAN in (a.kind, b.kind))
        return Gap(0.0, 1.0, allowed) if tight else Gap(AUTO * em, 2.0, allowed)
    return Gap(-_overlap(a, b), 0.0 if a.text == b.text and a.text in "—…" else 1.0, allowed)


def _tight(a: Cell, b: Cell) -> bool:
    return (a.kind is Kind.WORD and a.text[-1] in _LATIN_NO_END) or (
        b.kind is Kind.WORD and b.text[0] in _LATIN_NO_START
    )


def _no_start(cell: Cell) -> bool:
    return cell.kind is Kind.CLOSE or (cell.kind is Kind.WORD and cell.text[0] in _LATIN_NO_START)


def _no_end(cell: Cell) -> bool:
    return cell.kind is Kind.OPEN or (cell.kind is Kind.WORD and cell.text[-1] in _LATIN_NO_END)


def _overlap(a: Cell, b: Cell) -> float:
    """Two full-width punctuation marks together lose half an em."""
    if a.kind is Kind.CLOSE and b.kind in (Kind.CLOSE, Kind.OPEN):
        return a.trail or b.lead
    return b.lead if a.kind is Kind.OPEN and b.kind is Kind.OPEN else 0.0


def joined(parts: Sequence[Cell], em: float) -> Box:
    """All cells on one line, unjustified."""
    boxes: list[Box] = []
    for i, cell in enumerate(parts):
        if i:
            boxes.append(Box(gap(parts[i - 1], cell, em).width, 0.0, 0.0))
        boxes.append(cell.box)
    return beside(boxes)
