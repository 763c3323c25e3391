"""Sentences, formulas and tables as HTML; every formula is a small SVG of outlines, in the colour of the text."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape

from ..algebra.formula import Node, plain, row, split_words
from ..board.construction import EquationTable
from ..typeset import layout
from ..typeset.outlines import outlined_group
from ..words import Lang, Words

EM = 4.0  # mm: size in which a formula is laid out; on the page it follows the size of the text
PAD = 0.06 * EM  # slanted letters lean out of their widths
_SIDES = {"l": "left", "c": "center", "r": "right", "d": "right", "u": "right"}
_ROWS = (Words("方向", "direction"), Words("大小", "magnitude"))


def formula(node: Node) -> str:
    """A formula on the line of the text."""
    box = layout(node, EM)
    width, height = box.width + 2 * PAD, box.height + 2 * PAD
    size = (
        f"height:{height / EM:.3f}em;width:{width / EM:.3f}em;"
        f"vertical-align:{-(box.descent + PAD) / EM:.3f}em;max-width:none"
    )
    name = f'role="img" aria-label="{escape(plain(node))}"'
    return (
        f'<svg {name} viewBox="0 0 {width:.3f} {height:.3f}" '
        f'style="{size}">{outlined_group(box, PAD, box.ascent + PAD, "currentColor")}</svg>'
    )


def sentence(text: str) -> str:
    """A sentence with its symbols between dollar signs."""
    return "".join(formula(row(piece)) if is_formula else _running(piece) for is_formula, piece in split_words(text))


def _running(text: str) -> str:
    return escape(text).replace("^2", "<sup>2</sup>")


def paragraph(text: str) -> str:
    """A sentence of its own; nothing where there is none."""
    return f"<p>{sentence(text)}</p>" if text else ""


def table(header: Sequence[str], rows: Iterable[Sequence[str]], align: str) -> str:
    """A table; align: l, c, r, d (numbers) for each column."""
    head = "".join(_cell("th", text, side) for text, side in zip(header, align, strict=True))
    body = "".join(
        f"<tr>{''.join(_cell('td', text, side) for text, side in zip(line, align, strict=True))}</tr>" for line in rows
    )
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def equation(written: EquationTable, lang: Lang) -> str:
    """A vector equation with its rows of directions and magnitudes under it."""
    terms = [f"{sign} ${symbol}$".strip() for sign, symbol in zip(written.signs, written.symbols, strict=True)]
    rows = (
        ("", *terms),
        (_ROWS[0].of(lang), *(one.of(lang) for one in written.directions)),
        (_ROWS[1].of(lang), *written.magnitudes),
    )
    lines = "".join(f"<tr>{''.join(_cell('td', text, 'c') for text in line)}</tr>" for line in rows)
    return f"<table><tbody>{lines}</tbody></table>"


def _cell(tag: str, text: str, side: str) -> str:
    return f'<{tag} style="text-align:{_SIDES[side]};padding:2px 8px">{sentence(text)}</{tag}>'
