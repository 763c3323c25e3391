"""The steps in words: each sentence with its equation and formulas as HTML,
in both languages, and as it is read aloud."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html import escape
from itertools import groupby

from ..algebra.formula import Node, Vec, row, sym
from ..board.acts import Arrow
from ..board.construction import EquationTable, Listing, Step
from ..drawing.hues import hue_of
from ..figures.hue import Hue
from ..names import ascii_key
from ..tagging.speech import equation_said, words_said
from ..typeset import layout, layout_words
from ..words import Lang, Words
from .beats import Beat
from .setting.ink import inked
from .setting.type import Faces, formula_html, html, symbol_html, words_html

WIDEST, CELL, SIGN = 18.2, 0.35, 1.1  # em: a phone's column less white, white in a cell, a sign with its white
CAPTION = 0.85  # em: size of the rows' names
CAPTIONS = (Words("方向", "Direction"), Words("大小", "Magnitude"))


@dataclass(frozen=True, slots=True)
class Told:
    """One step on the page: sentence, equation and formulas as HTML; the sentence as it is read out.

    formulas: each with the beat in which it is written; first and last: the beats of the step.
    """

    number: int
    words: Words
    equation: Words | None
    formulas: tuple[tuple[int, str], ...]
    said: Words
    first: int
    last: int
    listing: Words | None = None


@dataclass(frozen=True, slots=True)
class Section:
    """Steps under their heading."""

    title: Words
    steps: tuple[Told, ...]


def sections(steps: tuple[Step, ...], cut: Sequence[Beat], faces: Faces, lang: Lang) -> tuple[Section, ...]:
    """All steps under their headings, each line with its beat; lang: in which the page is read out at first."""
    of = {number: list(inside) for number, inside in groupby(cut, key=lambda beat: beat.step)}
    return tuple(
        Section(html(title, faces), tuple(_told(step, of[step.number], faces, lang) for step in inside))
        for title, inside in groupby(steps, key=lambda s: s.section)
    )


def _told(step: Step, own: Sequence[Beat], faces: Faces, lang: Lang) -> Told:
    when = {n: beat.number for beat in own for n in beat.formulas}
    drawn = {act.key: beat.number for beat in own for act in beat.acts if isinstance(act, Arrow) and act.shown}
    table = None
    if step.equation is not None:
        table = Words(*(_table(step.equation, lang, faces, drawn) for lang in ("zh", "en")))
    lines = [(when.get(n, own[-1].number), formula_html(node, faces, lang)) for n, node in enumerate(step.formulas)]
    return Told(
        step.number,
        html(step.words, faces),
        table,
        tuple(sorted(lines, key=lambda line: line[0])),
        said(step),
        own[0].number,
        own[-1].number,
        None if step.listing is None else Words(*(_listed(step.listing, lang, faces) for lang in ("zh", "en"))),
    )


def _listed(listing: Listing, lang: Lang, faces: Faces) -> str:
    """What is read at many places, as a table."""
    head = "".join(f"<th>{words_html(one.of(lang), faces)}</th>" for one in listing.head)
    rows = "".join(f"<tr>{''.join(f'<td>{cell}</td>' for cell in row)}</tr>" for row in listing.rows)
    return f'<table class="listing"><tr>{head}</tr>{rows}</table>'


def said(step: Step) -> Words:
    """The sentence of a step as it is read out; its equation and formulas have words of their own."""
    return heard(step.words)


def heard(words: Words) -> Words:
    """Words with their symbols, as they are read out."""
    return Words(words_said(words.zh, "zh"), words_said(words.en, "en"))


def table_said(table: EquationTable, lang: Lang) -> str:
    """The equation and its rows, as they are read out."""
    rows = (tuple(direction.of(lang) for direction in table.directions), table.magnitudes)
    return equation_said(table.symbols, table.signs, rows, lang)


def vector(symbol: str) -> Node:
    """The symbol with an arrow; a row (``μ_a n'n``) stays as it is."""
    try:
        return Vec(sym(symbol))
    except ValueError:
        return row(symbol)


@dataclass(frozen=True, slots=True)
class Term:
    """One term of an equation: the sign before it, symbol, direction and magnitude as HTML,
    and how wide it will be (em)."""

    sign: str
    cells: tuple[str, str, str]
    width: float
    beat: int = 0  # in which it is drawn


def _table(table: EquationTable, lang: Lang, faces: Faces, drawn: Mapping[str, int]) -> str:
    """The equation over its rows of directions and magnitudes, cut where it would be wider than a phone."""
    rows = zip(table.symbols, table.signs, table.directions, table.magnitudes, table.tones, strict=True)
    terms = [
        _term((symbol, hue_of(tone)), sign, (direction.of(lang), magnitude), faces, lang, drawn)
        for symbol, sign, direction, magnitude, tone in rows
    ]
    groups: list[list[Term]] = [[]]
    room = WIDEST - layout_words(CAPTIONS[1].of(lang), CAPTION).width
    for term in terms:
        if groups[-1] and sum(t.width for t in groups[-1]) + term.width > room:
            groups.append([])
        groups[-1].append(term)
    name = f' aria-label="{escape(table_said(table, lang))}"'
    return f'<div class="scroll" role="group"{name}>{"".join(_group(group, lang) for group in groups)}</div>'


def _term(
    toned: tuple[str, Hue], sign: str, known: tuple[str, str], faces: Faces, lang: Lang, drawn: Mapping[str, int]
) -> Term:
    """known: direction and magnitude."""
    symbol, hue = toned
    boxes = (layout(vector(symbol), 1.0), *(layout_words(text, 1.0) for text in known))
    head = inked(symbol_html(vector(symbol), faces, lang), hue)
    direction, magnitude = (words_html(text, faces) for text in known)
    cells = (head, direction, magnitude)
    wide = max(box.width for box in boxes) + CELL + (SIGN if sign else 0.0)
    return Term(sign.replace("-", "−"), cells, wide, drawn.get(ascii_key(symbol), 0))


def _group(terms: list[Term], lang: Lang) -> str:
    """Three rows of some of the terms."""
    heads = ("<td></td>", *(f'<th scope="row">{caption.of(lang)}</th>' for caption in CAPTIONS))
    rows = (
        head
        + "".join(
            (f'<td class="sign">{"" if i else term.sign}</td>' if term.sign else "") + _cell(term, i) for term in terms
        )
        for i, head in enumerate(heads)
    )
    return f'<table class="equation">{"".join(f"<tr>{row}</tr>" for row in rows)}</table>'


def _cell(term: Term, row: int) -> str:
    """One cell of a term, which is pointed at in the beat that draws its vector."""
    return f'<td data-beat="{term.beat}">{term.cells[row]}</td>' if term.beat else f"<td>{term.cells[row]}</td>"
