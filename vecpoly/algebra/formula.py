"""Formulas as a small tree: laid out by the report, spoken by the terminal, never parsed from TeX.

A symbol is written in one short notation everywhere (words, tables, code): ``v_CB``, ``a^n_CB``, ``ω_2``, ``μ_v``,
``v_{B3B2}``; `sym` reads it. Texts may hold such symbols, and rows of them, between dollar signs: ``作 $pb ⊥ AB$``.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import field
from functools import lru_cache

from ..foundation.indices import DIGITS, ON_LINE
from ..foundation.slotted import dataclass


@dataclass(frozen=True, slots=True)
class Sym:
    """One symbol: italic base, optional subscript and superscript (letters italic, digits upright)."""

    base: str
    sub: str = ""
    sup: str = ""


@dataclass(frozen=True, slots=True)
class Txt:
    """Upright text: numbers, units, operators, Chinese."""

    text: str


@dataclass(frozen=True, slots=True)
class Row:
    """Nodes side by side; worked: the expression whose numbers a line shows, for as long as their digits are open."""

    items: tuple[Node, ...]
    worked: object = field(default=None, compare=False, repr=False, metadata={"kept": False})

    def __getstate__(self) -> list[object]:
        return [self.items, None]


@dataclass(frozen=True, slots=True)
class Frac:
    """A fraction with a bar."""

    num: Node
    den: Node


@dataclass(frozen=True, slots=True)
class Power:
    """A node raised to an exponent."""

    body: Node
    exponent: str


@dataclass(frozen=True, slots=True)
class Root:
    """A square root."""

    body: Node


@dataclass(frozen=True, slots=True)
class Over:
    """A length on paper, overlined: \\overline{pb}; of many that are added up with the sign of a sum before it."""

    body: Node
    summed: bool = False


@dataclass(frozen=True, slots=True)
class Vec:
    """A vector: an arrow over the symbol's base (sub- and superscripts stay outside)."""

    body: Sym


Node = Sym | Txt | Row | Frac | Power | Root | Over | Vec

PARSED = 4096  # texts whose symbols are remembered: the same ones stand in every problem
_LETTERS = "A-Za-zμωαφρθβγδψχΔληπεσ"
_SYMBOL = re.compile(
    rf"(?P<base>[{_LETTERS}]['′]*)(?P<index>[{DIGITS}]?)"
    r"(?:\^(?P<sup>\{[^}]*\}|[A-Za-z0-9′']))?"
    rf"(?:_(?P<sub>\{{[^}}]*\}}|[{_LETTERS}0-9′'{DIGITS}]+))?"
    r"(?:\^(?P<sup2>\{[^}]*\}|[A-Za-z0-9′']))?"
)


_POINTS = re.compile(r"(?<=[∠△])[A-Z0-9_'′]+")  # ∠C_1OA: letters of points, whose subscripts are digits alone
_NEXT = re.compile(r"_([0-9]+)(?=[A-Z]['′]*_)")  # C_1C_2: the second C has a subscript of its own
_PIECE = re.compile(rf"(?<![A-Za-z])(?P<function>arctan|sin|cos|tan|cot)(?![A-Za-z])|{_SYMBOL.pattern}")


RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺"  # exponents written as characters of their own, which not every face has: ω², 10⁻¹⁴
LOWERED = str.maketrans(RAISED, "0123456789−+")
_EXPONENT = re.compile(f"[{RAISED}]+")


def _bare(group: str | None) -> str:
    return (group or "").strip("{}")


@lru_cache(maxsize=PARSED)
def sym(text: str) -> Sym:
    """Read one symbol in the short notation; raises ValueError when the text is none."""
    m = _SYMBOL.fullmatch(text)
    if m is None:
        raise ValueError(f"'{text}' is no symbol")
    return _symbol(m)


def _symbol(m: re.Match[str]) -> Sym:
    """O₁ is O with the subscript 1; thought on link 2 it has both, O_{1,2}."""
    indices = (m["index"].translate(ON_LINE), _bare(m["sub"]))
    return Sym(m["base"], ",".join(filter(None, indices)), _bare(m["sup"] or m["sup2"]))


def is_symbol(text: str) -> bool:
    """Whether a text is one symbol in the short notation."""
    return _SYMBOL.fullmatch(text) is not None


def row(text: str) -> Row:
    """Read a run of symbols, operators, functions and numbers: ``ω_3 = μ_v pb / l_BC``;
    whatever is no symbol stays upright."""
    return Row(_items(text))


@lru_cache(maxsize=PARSED)
def _items(text: str) -> tuple[Node, ...]:
    items: list[Node] = []
    end = 0
    text = _EXPONENT.sub(lambda found: f"^{{{found[0].translate(LOWERED)}}}", _apart(text))
    for m in _PIECE.finditer(text):
        if m.start() > end:
            items.append(Txt(text[end : m.start()]))
        items.append(Txt(m["function"]) if m["function"] else _symbol(m))
        end = m.end()
    if end < len(text):
        items.append(Txt(text[end:]))
    return tuple(items)


def _apart(text: str) -> str:
    """Letters of points side by side, each with its own index: C_1C_2, ∠C_1OA; but W_1I, P_24C, i_1H are one symbol."""
    points = _POINTS.sub(lambda found: re.sub(r"_([0-9]+)", r"_{\1}", found[0]), text)
    return _NEXT.sub(r"_{\1}", points)


def letters_node(letters: str) -> Node:
    """Letters of a paper length side by side: ``p c_2`` → p c₂."""
    return Row(tuple(item for word in letters.split() for item in row(word).items))


def adjoined(*letters: str) -> str:
    """Letters of a figure side by side, each with its own index: b_{2}c′."""
    return "".join(re.sub(r"_([^{}^′']+)", r"_{\1}", letter) for letter in letters)


def named(text: str) -> Node:
    """The name of a quantity: one symbol, or a run of them such as ``M_1/Q`` or ``α ≤ φ``."""
    return sym(text) if _SYMBOL.fullmatch(text) else row(text)


def split_words(text: str) -> tuple[tuple[bool, str], ...]:
    """Cut a text at its dollar signs: (is_formula, piece) pairs."""
    return tuple((i % 2 == 1, piece) for i, piece in enumerate(text.split("$")) if piece)


def signed(nodes: Iterable[Node], signs: Iterable[int]) -> Row:
    """A sum: each node behind its sign, +1 or −1; a leading plus is not written, nor + before a negative number."""
    items: list[Node] = []
    for i, (node, sign) in enumerate(zip(nodes, signs, strict=True)):
        if i and sign > 0 and isinstance(node, Txt) and node.text.startswith("(−"):
            items.append(Txt(f" − {node.text[2:-1]}"))
            continue
        items += [Txt(" + " if sign > 0 else " − ")] if i else [Txt("−")] if sign < 0 else []
        items.append(node if items else alone(node))
    return Row(tuple(items))


def alone(node: Node) -> Node:
    """A negative number without its brackets, where nothing stands before it."""
    match node:
        case Row((Txt() as only,)):
            return alone(only)
        case Txt(text) if text.startswith("(") and text.endswith(")"):
            return Txt(text[1:-1])
    return node


def plain(node: Node) -> str:
    """The node as one line of plain text, for terminals and alternative texts."""
    match node:
        case Sym(base, sub, sup):
            return base + (f"^{sup}" if sup else "") + (f"_{sub}" if sub else "")
        case Txt(text):
            return text
        case Row(items):
            return "".join(plain(item) for item in items)
        case Frac(num, den):
            return f"({plain(num)})/({plain(den)})"
        case Power(body, exponent):
            return f"{plain(body)}^{exponent}"
        case Root(body):
            return f"√({plain(body)})"
        case Over(body, summed):
            return "Σ" * summed + plain(body)
        case Vec(body):
            return plain(body)
