"""Set type and words for the page: glyph runs as SVG, sentences as HTML,
and the characters that each face must bring along."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from html import escape
from typing import assert_never

from ...algebra.formula import Node, Sym, Txt, row, split_words
from ...foundation.indices import DIGITS, ON_LINE
from ...report.flow.text.held import UNBROKEN, is_number, unbroken
from ...tagging.speech import said
from ...typeset import Box, Glyphs, Rule, layout
from ...typeset.box import MM
from ...typeset.fonts import MISSING, Face, glyph, missing_text
from ...typeset.layout import segments
from ...typeset.runs import SHOWN, WORD
from ...words import Lang, Words

EM = 10.0  # mm: size at which formulas for the page are set; 1 em = 1000 units
_UPRIGHT = "π∞Σ"
_BEFORE_RELATION = re.compile(rf"{UNBROKEN}(?=[=≈≙≤≥<>≠])")  # where a line of a formula may end
_RAISED = re.compile(r"\^\{?([-−]?\d+)\}?")


@dataclass(slots=True)
class Faces:
    """The characters used of each face."""

    used: dict[Face, set[str]] = field(default_factory=dict)

    def need(self, face: Face, text: str) -> None:
        """These characters must be there."""
        self.used.setdefault(face, set()).update(text)

    def take(self, text: str) -> None:
        """Characters of running text, each in the face that has it."""
        for char in set(text):
            if char > " " and (found := glyph(char, Face.STIX)).font != MISSING:
                self.need(Face(found.font), char)

    def letters(self, text: str) -> None:
        """Characters of symbols, in the italic as well."""
        for char in set(text):
            if char > " " and (found := glyph(char, Face.ITALIC)).font != MISSING:
                self.need(Face(found.font), char)


def short(face: Face) -> str:
    """The class of type in this face."""
    return f"k{list(Face).index(face)}"


def set_box(box: Box, faces: Faces, units: float) -> str:
    """The box as SVG, its origin at 0, 0; `units` in a millimetre."""
    return "".join(_element(item, faces, units) for item in box.items)


def _element(item: Glyphs | Rule, faces: Faces, units: float) -> str:
    match item:
        case Rule(x, y, width, height):
            return (
                f'<rect x="{round(units * x)}" y="{round(-units * (y + height))}" '
                f'width="{max(1, round(units * width))}" height="{max(1, round(units * height))}"/>'
            )
        case Glyphs(font, size, x, y, text):
            face, shown = (Face.STIX, "".join(map(missing_text, text))) if font == MISSING else (Face(font), text)
            faces.need(face, shown)
            left, down = round(units * x), round(-units * y)
            at = (f' x="{left}"' if left else "") + (f' y="{down}"' if down else "")
            return f'<text class="{short(face)}"{at} font-size="{round(units * size / MM)}">{escape(shown)}</text>'
    assert_never(item)


def formula_html(node: Node, faces: Faces, lang: Lang) -> str:
    """A formula of its own, cut before its relations so that a narrow screen can break it there; told in both
    languages, at first in this one."""
    pieces = "".join(_svg(box, faces) for box in segments(node, EM, before=True))
    return f'<span class="formula" role="img" {aloud(Words(said(node, "zh"), said(node, "en")), lang)}>{pieces}</span>'


def symbol_html(node: Node, faces: Faces, lang: Lang) -> str:
    """A symbol in a table of this language, with its arrow if it has one."""
    return (
        f'<span class="formula" role="img" aria-label="{escape(said(node, lang))}">'
        f"{_svg(layout(node, EM), faces)}</span>"
    )


def aloud(words: Words, lang: Lang) -> str:
    """The attributes by which something is read out: in both languages for the script, in this one as it stands."""
    return f'data-zh="{escape(words.zh)}" data-en="{escape(words.en)}" aria-label="{escape(words.of(lang))}"'


def _svg(box: Box, faces: Faces) -> str:
    units = 1000 / EM
    pad = 0.04 * EM  # slanted letters lean out of their widths
    view = (
        f"{round(-units * pad)} {round(-units * (box.ascent + pad))} {round(units * (box.width + 2 * pad))} "
        f"{round(units * (box.height + 2 * pad))}"
    )
    size = (
        f"height:{(box.height + 2 * pad) / EM:.3f}em;width:{(box.width + 2 * pad) / EM:.3f}em;"
        f"vertical-align:{-(box.descent + pad) / EM:.3f}em"
    )
    return f'<svg aria-hidden="true" viewBox="{view}" style="{size}">{set_box(box, faces, units)}</svg>'


def html(words: Words, faces: Faces) -> Words:
    """Words with their symbols as HTML."""
    return Words(words_html(words.zh, faces), words_html(words.en, faces))


def words_html(text: str, faces: Faces) -> str:
    """A sentence with its symbols between dollar signs, as HTML in which no line parts a number from its unit."""
    out, before = "", ""
    for formula, piece in split_words(text):
        if formula:
            out += f'<span class="m">{"".join(_inline(item, faces) for item in row(piece).items)}</span>'
        else:
            out += _running(unbroken(piece, before), faces)
        last = piece.rpartition(" ")[2]
        before = "$" if formula and not is_number(last) else last
    return out


def _running(text: str, faces: Faces) -> str:
    faces.take(text)
    pieces = [
        f"<sup>{piece.translate(SHOWN)}</sup>" if i % 2 else escape(piece)
        for i, piece in enumerate(_RAISED.split(text))
    ]
    return "".join(pieces)


def _inline(node: Node, faces: Faces) -> str:
    match node:
        case Sym(base, sub, sup):
            if sup and not sup.strip("′'"):
                letter, prime = _sloped(base, faces), f'<span class="prime">{_sloped(sup, faces)}</span>'
                return f'<span class="nb">{letter}{prime}{f"<sub>{_index(sub, faces)}</sub>" if sub else ""}</span>'
            below = f"<sub>{_index(sub, faces)}</sub>" if sub else ""
            above = f"<sup>{_index(sup, faces)}</sup>" if sup else ""
            scripts = f'<span class="ss">{above}{below}</span>' if above and below else above + below
            return f'<span class="nb">{_sloped(base, faces)}{scripts}</span>'
        case Txt(text):
            return _running(_BEFORE_RELATION.sub(" ", text.replace(" ", UNBROKEN)), faces)
    raise AssertionError(node)


def _index(text: str, faces: Faces) -> str:
    """The letters of an index as in type: words (max, min, rim) upright."""
    pieces = re.split(f"({WORD.pattern})", text)
    return "".join(_running(piece, faces) if i % 2 else _sloped(piece, faces) for i, piece in enumerate(pieces))


def _sloped(text: str, faces: Faces) -> str:
    """Latin and Greek letters italic, digits and primes upright."""
    shown = text.translate(SHOWN)
    faces.letters(shown.translate(ON_LINE))
    faces.take(shown.translate(ON_LINE))
    return "".join(map(_leaning, re.findall(rf"[^\W\d_{_UPRIGHT}{DIGITS}]+|.", shown)))


def _leaning(piece: str) -> str:
    if piece in DIGITS:  # O₁ in an index
        return f"<sub>{piece.translate(ON_LINE)}</sub>"
    return (
        f"<i>{piece}</i>"
        if piece[0].isalpha() and ord(piece[0]) < 0x400 and piece[0] not in _UPRIGHT
        else escape(piece)
    )
