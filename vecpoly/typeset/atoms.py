"""Rows of formulas cut into atoms, and the space that belongs between two of them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from enum import Enum, auto

from ..algebra.formula import RAISED, Node, Row, Sym, Txt, plain
from ..foundation.patterns import pattern
from ..foundation.slotted import dataclass
from .runs import lowered


class Kind(Enum):
    """What an atom is to its neighbours."""

    SYMBOL = auto()
    NUMBER = auto()
    WORD = auto()
    HAN = auto()
    RELATION = auto()
    BINARY = auto()
    DOT = auto()
    SIGN = auto()  # a plus or minus that belongs to what follows
    PREFIX = auto()  # ⊥ and ∥ before a line's letters
    TIGHT = auto()  # / and → between two letters
    OPEN = auto()
    CLOSE = auto()
    COMMA = auto()


@dataclass(frozen=True, slots=True)
class Atom:
    """A node or a text (with its exponent) set without inner spaces; spaced: a blank stood before it; factor: a thin
    one, as products have it between their factors."""

    kind: Kind
    body: Node | str
    exponent: str = ""
    spaced: bool = False
    factor: bool = False


_PRODUCT = "\u2009"
_TOKEN = pattern(
    r"(?P<blank>\s+)"
    r"|(?P<number>\d+(?:\.\d+)?(?:[eE][-+]?\d+)?)"
    r"|(?P<word>[A-Za-zµμΩ°℃′″%√]+(?:-[A-Za-z]+)*)"
    r"|(?P<relation>[=≈≠<>≤≥≡∽∼]|:=)"
    r"|(?P<binary>[-+−±×])"
    r"|(?P<dot>[·⋅])"
    r"|(?P<prefix>[⊥∥⟂∠△])"
    r"|(?P<tight>[/→])"
    r"|(?P<open>[(\[{（])"
    r"|(?P<close>[)\]}）])"
    r"|(?P<comma>[,;，、；:])"
    r"|(?P<han>.)"
)
_EXPONENT = pattern(rf"\^\{{?([-−+]?\w+)\}}?|([{RAISED}]+)")
_KINDS = {
    "number": Kind.NUMBER,
    "word": Kind.WORD,
    "relation": Kind.RELATION,
    "binary": Kind.BINARY,
    "dot": Kind.DOT,
    "prefix": Kind.PREFIX,
    "tight": Kind.TIGHT,
    "open": Kind.OPEN,
    "close": Kind.CLOSE,
    "comma": Kind.COMMA,
    "han": Kind.HAN,
}
_FULL = frozenset("，、；：。（）")  # full-width marks bring their own white
_AFTER_WHAT_IS_NO_TERM = {None, Kind.RELATION, Kind.BINARY, Kind.SIGN, Kind.OPEN, Kind.COMMA}
_AFTER_WHAT_IS_NO_TERM |= {Kind.TIGHT, Kind.DOT, Kind.PREFIX}
_LETTER_LIKE = {Kind.SYMBOL, Kind.NUMBER, Kind.WORD, Kind.CLOSE}
_UNITS = frozenset(("m", "mm", "cm", "km", "rad", "s", "ms", "min", "h", "r", "N", "kN", "kg", "g", "t"))
_UNITS |= {"Hz", "W", "kW", "J", "kJ", "Pa", "kPa", "MPa", "μm"}
_PARTS = pattern(r"[·⋅/()^{}²³\d−-]+")
THIN, MEDIUM, THICK, UNIT, WORD_SPACE = 3 / 18, 4 / 18, 5 / 18, 0.2, 0.25


def is_unit(text: str) -> bool:
    """Whether a word is the unit of the number before it: mm, N·m, (m/s)/mm, %, °."""
    if text in ("%", "°", "deg", "mm^2", "‰"):
        return True
    words = [part for part in _PARTS.split(text) if part]
    return bool(words) and set(words) <= _UNITS


def _text(text: str, spaced: bool) -> Iterator[Atom]:
    end = 0
    while end < len(text):
        match = _TOKEN.match(text, end)
        assert match is not None and match.lastgroup is not None
        end = match.end()
        if match.lastgroup == "blank":
            spaced = True
            continue
        exponent = _EXPONENT.match(text, end)
        sup = ""
        if exponent is not None:
            end = exponent.end()
            sup = exponent[1] or lowered(exponent[2])
        yield Atom(_KINDS[match.lastgroup], match[0], sup, spaced)
        spaced = False
    if spaced:
        yield Atom(Kind.WORD, "", "", True, text == _PRODUCT)


def _raw(nodes: tuple[Node, ...]) -> Iterator[Atom]:
    for node in nodes:
        match node:
            case Row(items):
                yield from _raw(items)
            case Txt(text):
                yield from _text(text, False)
            case _:
                yield Atom(Kind.SYMBOL, node)


def atoms(nodes: tuple[Node, ...]) -> list[Atom]:
    """The atoms of a row, blanks turned into `spaced`, signs told from plus and minus."""
    out: list[Atom] = []
    blank = factor = False
    for atom in _raw(nodes):
        if atom.body == "":
            blank, factor = True, atom.factor
            continue
        last = out[-1].kind if out else None
        kind = atom.kind
        if kind is Kind.BINARY and last in _AFTER_WHAT_IS_NO_TERM and atom.body != "×":
            kind = Kind.SIGN
        if kind is Kind.PREFIX and last in _LETTER_LIKE and atom.body in ("⊥", "∥", "⟂"):
            kind = Kind.RELATION
        out.append(Atom(kind, atom.body, atom.exponent, atom.spaced or blank, factor))
        blank = factor = False
    return _with_units(out)


def _with_units(row: list[Atom]) -> list[Atom]:
    """Letters after a number and a blank are upright if they spell a unit: ``0.006 (m/s)/mm``; a factor is none."""
    out: list[Atom] = []
    i = 0
    while i < len(row):
        out.append(row[i])
        i += 1
        if row[i - 1].kind is Kind.NUMBER and i < len(row) and row[i].spaced and not row[i].factor:
            unit = _unit(row, i)
            letters = sum(len(atom.body) for atom in unit if isinstance(atom.body, str))
            out.extend(unit)
            i += letters
    return out


def _unit(row: list[Atom], start: int) -> list[Atom]:
    out: list[Atom] = []
    for i in range(start, len(row)):
        atom = row[i]
        if atom.spaced and i > start:
            break
        if isinstance(atom.body, Sym) and not atom.body.sub and len(atom.body.base) == 1:
            letter = Atom(Kind.WORD, atom.body.base, atom.body.sup, atom.spaced)
            if out and out[-1].kind is Kind.WORD and not out[-1].exponent:
                letter = Atom(Kind.WORD, f"{out[-1].body}{letter.body}", letter.exponent, out[-1].spaced)
                out.pop()
            out.append(letter)
        elif atom.kind in (Kind.DOT, Kind.OPEN, Kind.CLOSE) or atom.body == "/":
            out.append(atom)
        else:
            break
    words = {atom.body for atom in out if atom.kind is Kind.WORD}
    return out if words and words <= _UNITS else []


def written(row: Iterable[Atom]) -> str:
    """The atoms as plain text."""
    out = ""
    for atom in row:
        body = atom.body if isinstance(atom.body, str) else plain(atom.body)
        out += (" " if atom.spaced and out else "") + body + (f"^{atom.exponent}" if atom.exponent else "")
    return out


def space(left: Atom, right: Atom) -> float:
    """The space between two neighbours, in em."""
    a, b = left.kind, right.kind
    if Kind.RELATION in (a, b):
        return THICK
    if left.body in _FULL or right.body in _FULL:
        return 0.0
    if Kind.BINARY in (a, b):
        return MEDIUM
    if Kind.DOT in (a, b):
        units = a is Kind.WORD or b is Kind.WORD
        return 0.04 if units and not right.spaced else THIN
    if a in (Kind.SIGN, Kind.OPEN) or b is Kind.CLOSE:
        return 0.0
    if a is Kind.PREFIX:
        return 0.08
    if a is Kind.COMMA:
        return WORD_SPACE if right.spaced else THIN
    return _blank(a, b) if right.spaced else _joined(a, b)


def _joined(a: Kind, b: Kind) -> float:
    if Kind.TIGHT in (a, b):
        return 0.05
    if Kind.HAN in (a, b) and a is not b:
        return THIN
    return THIN if b is Kind.PREFIX and a in _LETTER_LIKE else 0.0


def _blank(a: Kind, b: Kind) -> float:
    if Kind.TIGHT in (a, b):
        return THIN / 2
    if b is Kind.PREFIX:
        return THICK
    if a is Kind.NUMBER and b in (Kind.WORD, Kind.OPEN):
        return UNIT
    if a is Kind.SYMBOL and b in (Kind.SYMBOL, Kind.OPEN, Kind.NUMBER):
        return THIN
    if a in (Kind.NUMBER, Kind.CLOSE) and b is Kind.SYMBOL:
        return THIN
    return WORD_SPACE
