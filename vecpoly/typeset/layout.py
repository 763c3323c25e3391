"""Formula trees laid out in the STIX faces: 0.2 ms a formula, as text that can be selected and searched."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import accumulate, pairwise
from typing import assert_never

from ..algebra.formula import Frac, Node, Over, Power, Root, Row, Sym, Txt, Vec
from .atoms import Atom, Kind, atoms, space, written
from .box import EMPTY, MM, Box, Glyphs, Rule, place, scaled
from .fonts import Face, glyph
from .runs import SCRIPT, SHOWN, SUB, SUB_BOTH, SUP, index, letters, roman_or_italic, run

AXIS = 0.26  # height of the bar of a fraction and of the minus sign, em
BAR = 0.05  # thickness of bars, em
Cuts = frozenset[Kind]
RELATIONS: Cuts = frozenset({Kind.RELATION})  # where a formula is cut into lines
SIGNS: Cuts = frozenset({Kind.RELATION, Kind.BINARY})
SIMILAR, GROWN = "∽∼", 1.2  # signs that the face has too small between triangles, and how much larger they are set
TRIANGLE, SHRUNK = "△", 0.8  # a sign that the face has larger than the letters behind it


@lru_cache(maxsize=8192)
def layout(node: Node, em_mm: float, bold: bool = False) -> Box:
    """The formula set at the given size (1 em = the size of its type, mm); what was set last is kept."""
    match node:
        case Sym():
            return _sym(node, em_mm, bold)
        case Txt():
            return _row((node,), em_mm, bold)
        case Row(items):
            return _row(items, em_mm, bold)
        case Frac(num, den):
            return _frac(layout(num, em_mm, bold), layout(den, em_mm, bold), em_mm)
        case Power(body, exponent):
            return _power(body, exponent, em_mm, bold)
        case Root(body):
            return _root(layout(body, em_mm, bold), em_mm)
        case Over(body, summed):
            if summed:
                return _row((Txt("Σ"), Over(body)), em_mm, bold)
            return _over(layout(body, em_mm, bold), em_mm)
        case Vec(body):
            return _sym(body, em_mm, bold, arrow=True)
    assert_never(node)


@lru_cache(maxsize=8192)
def _sym(node: Sym, em: float, bold: bool, arrow: bool = False) -> Box:
    bare = node.base.rstrip("′'")
    if bare != node.base and node.sub and not node.sup and not arrow:  # R′_21: index under the prime
        return _sym(Sym(bare, node.sub, node.base[len(bare) :]), em, bold)
    alone = node.base == "I" and not node.sub and not node.sup  # a plane, a shaft; a point I has a number or a prime
    base = run("I", roman_or_italic(False, bold), em) if alone else letters(node.base, em, bold)
    slope = _overhang(node.base, em, bold)
    if arrow:
        base = _arrow(base, node.base, em, bold)
    sub = index(node.sub, em * SCRIPT, bold) if node.sub else EMPTY
    if node.sup and not node.sup.strip("′'"):
        return _primed(base, letters(node.sup, em, bold), sub, em, slope)
    sup = letters(node.sup, em * SCRIPT, bold) if node.sup else EMPTY
    return _scripts(base, sup, sub, em, slope)


def _primed(base: Box, prime: Box, sub: Box, em: float, slope: float) -> Box:
    """b′₂: the prime at its own height, the subscript under it."""
    left = base.width + 0.03 * em
    parts = [(0.0, 0.0, base), (left + slope, 0.0, prime), (left, -SUB * em, sub)]
    return place(
        [part for part in parts if part[2] is not EMPTY], left + max(prime.width + slope, sub.width) + 0.03 * em
    )


def _overhang(text: str, em: float, bold: bool) -> float:
    """How far the ink of the last letter leans out of its width."""
    last = glyph(text[-1].translate(SHOWN), roman_or_italic(text[-1].isalpha(), bold))
    return max(0.0, last.right - last.width) * em


def _scripts(base: Box, sup: Box, sub: Box, em: float, slope: float = 0.0) -> Box:
    if sup is EMPTY and sub is EMPTY:
        return base
    both = sup is not EMPTY and sub is not EMPTY
    low = -(SUB_BOTH if both else SUB) * em
    high = max(SUP * em, base.ascent - 0.32 * em)
    if both:
        high = max(high, low + sub.ascent + 0.1 * em + sup.descent)
    left = base.width + 0.03 * em
    parts = [(0.0, 0.0, base), (left + slope, high, sup), (left, low, sub)]
    width = left + max(sup.width + slope, sub.width) + 0.03 * em
    return place([part for part in parts if part[2] is not EMPTY], width)


def _row(nodes: tuple[Node, ...], em: float, bold: bool) -> Box:
    return _set(atoms(nodes), em, bold)


def _set(row: Sequence[Atom], em: float, bold: bool) -> Box:
    parts: list[tuple[float, float, Box]] = []
    x = 0.0
    last: Atom | None = None
    boxes = [_atom(atom, em, bold) for atom in row]
    if any(box.ascent > em for box in boxes):
        _grow_brackets(row, boxes, em)
    for atom, box in zip(row, boxes, strict=True):
        if last is not None:
            x += space(last, atom) * em
        parts.append((x, 0.0, box))
        x += box.width
        last = atom
    return place(parts, x)


def _grow_brackets(row: Sequence[Atom], boxes: list[Box], em: float) -> None:
    """Make brackets as high as what they enclose, centred on the axis."""
    opened: list[int] = []
    for i, atom in enumerate(row):
        if atom.kind is Kind.OPEN:
            opened.append(i)
        elif atom.kind is Kind.CLOSE and opened:
            start = opened.pop()
            inner = boxes[start + 1 : i]
            above = max((box.ascent for box in inner), default=0.0) - AXIS * em
            below = max((box.descent for box in inner), default=0.0) + AXIS * em
            if above > 0.7 * em:
                boxes[start], boxes[i] = (_tall(boxes[j], 2 * max(above, below), em) for j in (start, i))


def _tall(bracket: Box, height: float, em: float) -> Box:
    grown = scaled(bracket, height / bracket.height)
    shift = AXIS * em - (grown.ascent - grown.descent) / 2
    return place([(0.0, shift, grown)], grown.width)


@lru_cache(maxsize=4096)
def segments(node: Node, em: float, bold: bool = False, *, before: bool, at: Cuts = RELATIONS) -> tuple[Box, ...]:
    """The formula cut before (or after) its relations: lines of a display, pieces of running text. at: and before its
    plus and minus signs outside brackets, or elsewhere."""
    return tuple(_set(part, em, bold) for part in _cut(node, before, at))


def pieces(node: Node) -> tuple[str, ...]:
    """What the pieces of running text, cut after the relations, say: plain text in the order of reading."""
    return tuple(written(part) for part in _cut(node, False, RELATIONS))


def halves(node: Node, piece: str, em: float, bold: bool = False) -> list[tuple[tuple[Box, str], tuple[Box, str]]]:
    """A piece of running text (or a whole formula) cut in two after each of its signs, with what the halves say."""
    whole = atoms((node,))
    row = next((part for part in _cut(node, False, RELATIONS) if written(part) == piece), whole)
    cuts = [i + 1 for i, atom in enumerate(row[:-1]) if _ends_a_line(atom)]
    parts = ((row[:cut], row[cut:]) for cut in cuts)
    return [((_set(a, em, bold), written(a)), (_set(b, em, bold), written(b))) for a, b in parts]


def _ends_a_line(atom: Atom) -> bool:
    """A relation, a plus or minus, a stroke with blanks about it: not that of m/s."""
    return atom.kind in (Kind.RELATION, Kind.BINARY) or (atom.kind is Kind.TIGHT and atom.body == "/" and atom.spaced)


def _cut(node: Node, before: bool, at: Cuts) -> list[list[Atom]]:
    row = atoms((node,))
    steps = ((atom.kind is Kind.OPEN) - (atom.kind is Kind.CLOSE) for atom in row)
    depths = list(accumulate(steps))
    cuts = [
        i if before else i + 1
        for i, atom in enumerate(row)
        if atom.kind in at and not (atom.kind is Kind.BINARY and depths[i] > 0)
    ]
    edges = [0, *(cut for cut in cuts if 0 < cut < len(row)), len(row)]
    return [row[a:b] for a, b in pairwise(edges) if b > a]


def _atom(atom: Atom, em: float, bold: bool) -> Box:
    if not isinstance(atom.body, str):
        return layout(atom.body, em, bold)
    return _piece(atom.body, atom.exponent, atom.kind is Kind.HAN, em, bold)


@lru_cache(maxsize=8192)
def _piece(text: str, exponent: str, han: bool, em: float, bold: bool) -> Box:
    face = roman_or_italic(False, bold)
    if han and ord(text[0]) >= 0x2E80:
        face = Face.HEI_BOLD if bold else Face.SONG
    base = run(text if text[0].isalpha() and "-" in text else text.translate(SHOWN), face, em)  # a hyphen stays one
    if text in SIMILAR:
        base = scaled(base, GROWN)
        return place([(0.0, AXIS * (1.0 - GROWN) * em, base)], base.width)
    if text == TRIANGLE:
        return scaled(base, SHRUNK)
    if not exponent:
        return base
    return _scripts(base, run(exponent.translate(SHOWN), face, em * SCRIPT), EMPTY, em)


def _power(body: Node, exponent: str, em: float, bold: bool) -> Box:
    if isinstance(body, Sym) and body.sub and not body.sup:
        return _sym(Sym(body.base, body.sub, exponent), em, bold)
    return _scripts(layout(body, em, bold), letters(exponent, em * SCRIPT, bold), EMPTY, em)


def _frac(num: Box, den: Box, em: float) -> Box:
    width = max(num.width, den.width) + 0.16 * em
    high = (AXIS + 0.22) * em + num.descent
    low = (AXIS - 0.23) * em - den.ascent
    bar = Box(width, 0.0, 0.0, (Rule(0.0, (AXIS - BAR / 2) * em, width, BAR * em),))
    side = 0.06 * em
    over, under = (width - num.width) / 2 + side, (width - den.width) / 2 + side
    return place([(over, high, num), (side, 0.0, bar), (under, low, den)], width + 2 * side)


def _over(body: Box, em: float) -> Box:
    y = body.ascent + 0.1 * em
    bar = Rule(0.03 * em, y, body.width, BAR * em)
    return Box(body.width + 0.04 * em, y + BAR * em, body.descent, (*body.items, bar))


def _arrow(base: Box, text: str, em: float, bold: bool) -> Box:
    """U+20D7 over the middle of the base's ink."""
    first = glyph(text[0], roman_or_italic(text[0].isalpha(), bold))
    mark = glyph("\u20d7", Face.STIX)
    lean = 0.08 if first.top > 0.5 else 0.04
    x = ((first.left + first.right) / 2 + lean - (mark.left + mark.right) / 2) * em
    y = (max(first.top, 0.44) + 0.08 - mark.bottom) * em
    arrow = Glyphs(mark.font, em * MM, x, y, mark.text)
    return Box(base.width, y + mark.top * em, base.descent, (*base.items, arrow))


def _root(body: Box, em: float) -> Box:
    sign = glyph("√", Face.STIX)
    gap = 0.1 * em
    height = body.height + gap + BAR * em
    size = max(em, height / (sign.top - sign.bottom))
    top = body.ascent + gap + BAR * em
    y = top - sign.top * size
    left = sign.right * size
    hook = Glyphs(sign.font, size * MM, 0.0, y, "√")
    bar = Rule(left - 0.02 * em, top - BAR * em, body.width + 0.1 * em, BAR * em)
    width = left + body.width + 0.1 * em
    descent = max(body.descent, -(y + sign.bottom * size))
    return Box(width, top, descent, (hook, bar, *body.moved(left + 0.04 * em, 0.0)))
