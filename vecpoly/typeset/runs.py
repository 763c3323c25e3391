"""Runs of letters: each character in the first face that has it, symbols italic, exponents raised."""

from __future__ import annotations

from functools import lru_cache

from ..algebra.formula import LOWERED, RAISED
from ..foundation.indices import DIGITS, ON_LINE
from ..foundation.patterns import pattern
from .box import MM, Box, Glyphs, Item, beside, place
from .fonts import Face, glyph

SCRIPT = 0.7  # size of sub- and superscripts, em
SUP, SUB, SUB_BOTH = 0.38, 0.17, 0.25  # shifts of the script baselines, em
SHOWN = str.maketrans({"-": "−", "'": "′", "µ": "μ", "⋅": "·"})
_UPRIGHT = frozenset("π∞Σ")
_APART = 0.14  # em between a figure and a Roman number behind it, which else might be one: 1I and 11


def run(text: str, face: Face, em: float) -> Box:
    """A text in one face (each character in the first face that has it), without kerning."""
    items: list[Item] = []
    x = start = top = bottom = 0.0
    font, chars = "", ""
    for char in text:
        g = glyph(char, face)
        if g.font != font and chars:
            items.append(Glyphs(font, em * MM, start, 0.0, chars))
            start, chars = x, ""
        font = g.font
        chars += g.text
        x += g.width * em
        top, bottom = max(top, g.top), min(bottom, g.bottom)
    if chars:
        items.append(Glyphs(font, em * MM, start, 0.0, chars))
    return Box(x, top * em, -bottom * em, tuple(items))


_RAISED = pattern(rf"\^\{{?([-−]?\d+)\}}?|([{RAISED}]+)")
_HIGH = str.maketrans({low: high for high, low in zip(RAISED, "0123456789−+", strict=True)} | {"-": "⁻"})


def lowered(text: str) -> str:
    """The digits of an exponent that was written with raised characters."""
    return text.translate(LOWERED)


def raised(text: str) -> str:
    """A word with its exponents as characters of their own: ``m/s^2`` as m/s²."""
    return _RAISED.sub(lambda found: found[2] or found[1].translate(_HIGH), text)


_APOSTROPHE = pattern(r"(?<=[a-z0-9])'(?=[a-z])|^'(?=s\b)|(?<=[a-z]s)'(?= |$)")


def latin(text: str, em: float, bold: bool) -> Box:
    """A word of running text; the exponent of a unit (``m/s^2``) is raised, an apostrophe is curved."""
    face, text = roman_or_italic(False, bold), _APOSTROPHE.sub("’", text)
    parts: list[Box] = []
    end = 0
    for found in _RAISED.finditer(text):
        parts.append(run(text[end : found.start()], face, em))
        box = run((found[1] or lowered(found[2])).translate(SHOWN), face, em * SCRIPT)
        parts.append(place([(0.0, SUP * em, box)], box.width))
        end = found.end()
    return beside((*parts, run(text[end:], face, em))) if parts else run(text, face, em)


def letters(text: str, em: float, bold: bool) -> Box:
    """Symbols' letters: Latin and Greek italic; digits, primes and everything else upright."""
    parts: list[tuple[float, float, Box]] = []
    x = 0.0
    if NUMBERED.match(text):
        return run(text, roman_or_italic(False, bold), em)
    for italic, piece in _by_slope(text.translate(SHOWN).replace("′′′", "‴").replace("′′", "″")):
        below = piece[0] in DIGITS  # O₁ in an index: the figure hangs under its letter
        box = run(piece.translate(ON_LINE), roman_or_italic(italic, bold), em * SCRIPT if below else em)
        parts.append((x, -SUB * em if below else 0.0, box))
        x += box.width
    return place(parts, x) if len(parts) != 1 else parts[0][2]


WORD = pattern(
    r"(?<![a-z])(?:max|min|mean|lim|opt|rim|local|redundant|low|all|in|out|red)(?![a-z])"
    r"|II+|I?V(?=I)I+|IV|(?:^|(?<=[a-z])|(?<=I,))I(?![A-Z0-9])"
    r"|(?:(?<=^[0-9])|(?<=^[0-9][0-9])|(?<=^M))I$"  # W_1I beside W_1II, θ_MI beside θ_MII: planes, orders
)
NUMBERED = pattern(r"^(?:II+|IV|VI+)$")  # a plane, a shaft, a group


def index(text: str, em: float, bold: bool) -> Box:
    """The letters of an index: words (max, min, rim) and Roman numbers are upright, what stands for a quantity or a
    point is italic; so is the I of inertia before a number, which else might be another: M_I2 and M_12."""
    parts, end = list[Box](), 0
    for found in WORD.finditer(text):
        parts += [letters(text[end : found.start()], em, bold)] if found.start() > end else []
        parts += [Box(_APART * em, 0.0, 0.0, ())] if found.start() and text[found.start() - 1] in "1234567890" else []
        parts.append(run(found[0], roman_or_italic(False, bold), em))
        end = found.end()
    rest = [letters(text[end:], em, bold)] if end < len(text) or not parts else []
    return beside((*parts, *rest)) if len(parts) + len(rest) > 1 else (*parts, *rest)[0]


def roman_or_italic(italic: bool, bold: bool) -> Face:
    if italic:
        return Face.BOLD_ITALIC if bold else Face.ITALIC
    return Face.BOLD if bold else Face.STIX


@lru_cache(maxsize=4096)
def _by_slope(text: str) -> tuple[tuple[bool, str], ...]:
    pieces: list[tuple[bool, str]] = []
    for char in text:
        italic = char.isalpha() and ord(char) < 0x400 and char not in _UPRIGHT
        if pieces and pieces[-1][0] is italic and (char in DIGITS) is (pieces[-1][1][-1] in DIGITS):
            pieces[-1] = (italic, pieces[-1][1] + char)
        else:
            pieces.append((italic, char))
    return tuple(pieces)
