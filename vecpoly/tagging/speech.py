"""Formulas as they are read out: "v sub C B equals omega sub 2 times l sub B C", 「v 下标 C B 等于 …」."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import assert_never

from ..algebra.formula import Frac, Node, Over, Power, Root, Row, Sym, Txt, Vec, row, split_words
from ..words import Lang, Words
from .units_said import unit_said

_GREEK = {
    "α": ("阿尔法", "alpha"), "β": ("贝塔", "beta"), "γ": ("伽马", "gamma"), "δ": ("德尔塔", "delta"),
    "Δ": ("德尔塔", "delta"), "ε": ("艾普西隆", "epsilon"), "η": ("伊塔", "eta"), "θ": ("西塔", "theta"),
    "λ": ("兰姆达", "lambda"), "μ": ("缪", "mu"), "π": ("派", "pi"), "ρ": ("柔", "rho"), "σ": ("西格马", "sigma"),
    "φ": ("斐", "phi"), "ψ": ("普西", "psi"), "χ": ("希", "chi"), "ω": ("欧米伽", "omega"),
}  # fmt: skip
_SIGNS = {
    "=": ("等于", "equals"), "≈": ("约等于", "is about"), "≙": ("相当于", "stands for"), "≠": ("不等于", "is not"),
    "<": ("小于", "is less than"), ">": ("大于", "is greater than"), "≤": ("不大于", "is at most"),
    "≥": ("不小于", "is at least"), "+": ("加", "plus"), "−": ("减", "minus"), "-": ("减", "minus"),
    "±": ("正负", "plus or minus"), "×": ("乘", "times"), "·": ("乘", "times"), "⋅": ("乘", "times"),
    "/": ("除以", "over"), "⊥": ("垂直于", "perpendicular to"), "⟂": ("垂直于", "perpendicular to"),
    "∥": ("平行于", "parallel to"), "∠": ("角", "angle"), "→": ("指向", "to"), "°": ("度", "degrees"),
    "↻": ("顺时针", "clockwise"), "↺": ("逆时针", "counter-clockwise"), "?": ("未知", "unknown"),
    "？": ("未知", "unknown"), "√": ("已知", "known"), "%": ("百分之一", "per cent"), "–": ("至", "to"),
    "″": ("两撇", "double prime"), "∞": ("无穷", "infinity"),
    "∑": ("求和", "the sum of"), "Σ": ("求和", "the sum of"), "′": ("撇", "prime"), "'": ("撇", "prime"),
    "✓": ("已知", "known"), "✔": ("已知", "known"), "—": ("无", "none"),
    "²": ("的平方", "squared"), "³": ("的立方", "cubed"),
}  # fmt: skip
_ASKING = re.compile(r"[^\W\d_]([?？])")
_TOLD = frozenset("⊥⟂∥→✓✔√?？—")
_UNARY = {"−": ("负", "minus"), "-": ("负", "minus"), "+": ("正", "plus")}
_POWERS = {"2": ("的平方", "squared"), "3": ("的立方", "cubed")}
_TOKEN = re.compile(r"\d+(?:\.\d+)?|[A-Za-z]+|[\u4e00-\u9fff]+|\s+|.")
_NUMBER = r"(?<![\w.}])(\d+(?:\.\d+)?(?:\s*×\s*10\^\{?[-−]?\d+\}?)?)"
_QUANTITY = re.compile(_NUMBER + r"\s+(\(?[A-Za-zμ°%][A-Za-zμ°%·/()^²³⁻0-9]*)")
_RAISED = re.compile(r"\^\{?([-−]?\w+)\}?")
_DIRECTION, _MAGNITUDE = Words("方向", "Direction"), Words("大小", "Magnitude")


@lru_cache(maxsize=4096)
def spoken(text: str, lang: Lang) -> str:
    """A formula of running text, as it is read out: its quantities with their units, and what is between them."""
    out: list[str] = []
    end = 0
    for match in _QUANTITY.finditer(text):
        unit = unit_said(match[2], lang)
        if unit is not None:
            out += [said(row(text[end : match.start()]), lang), *_signs(match[1], lang), unit]
            end = match.end()
    return " ".join(part for part in (*out, said(row(text[end:]), lang)) if part)


def said(node: Node, lang: Lang) -> str:
    """A formula as it is read out."""
    return re.sub(r"\s+", " ", " ".join(_said(node, lang))).strip()


def equation_said(symbols: Sequence[str], signs: Sequence[str], rows: Sequence[Sequence[str]], lang: Lang) -> str:
    """A vector equation and its rows of directions and magnitudes (words of each term)."""
    terms = (part for sign, one in zip(signs, symbols, strict=True) for part in (sign, one))
    equation = spoken(" ".join(part for part in terms if part), lang)
    below = ("; ".join(_row_said(symbols, cells, lang)) for cells in rows)
    names = (_DIRECTION.of(lang), _MAGNITUDE.of(lang))
    return ". ".join((equation, *(f"{name}: {told}" for name, told in zip(names, below, strict=False))))


def _row_said(symbols: Sequence[str], cells: Sequence[str], lang: Lang) -> Iterator[str]:
    """What is known of each term; nothing of a bare 0."""
    for symbol, cell in zip(symbols, cells, strict=True):
        if cell:
            yield f"{spoken(symbol, lang)}: {words_said(cell, lang)}"


def words_said(text: str, lang: Lang) -> str:
    """A sentence with formulas between dollar signs, as it is read out."""
    pieces = (spoken(piece, lang) if formula else _signed(piece, lang) for formula, piece in split_words(text))
    return re.sub(r"\s+", " ", " ".join(pieces)).strip()


def _signed(text: str, lang: Lang) -> str:
    """Words with their signs told: ∥guide; a question mark behind a word asks, and names no unknown."""
    asking = {found.start(1) for found in _ASKING.finditer(text)}
    return "".join(
        f" {_named(char, lang)} " if char in _TOLD and at not in asking else char for at, char in enumerate(text)
    )


def _said(node: Node, lang: Lang) -> list[str]:
    zh = lang == "zh"
    match node:
        case Sym(base, sub, sup):
            raised = [_power(sup, lang)] if sup else []
            lowered = [f"{'下标' if zh else 'sub'} {_letters(sub, lang)}"] if sub else []
            scripts = (lowered, raised) if sup in _POWERS else (raised, lowered)  # v sub B squared, a super n sub B
            return [_letters(base, lang), *scripts[0], *scripts[1]]
        case Txt(text):
            return _text(text, lang)
        case Row(items):
            return _row(items, lang)
        case Frac(num, den):
            over = "分数线，分母为" if zh else "over"
            return ["分子为" if zh else "the fraction", *_said(num, lang), over, *_said(den, lang), "" if zh else "end"]
        case Power(body, exponent):
            return [*_said(body, lang), _power(exponent, lang)]
        case Root(body):
            return ["根号" if zh else "the square root of", *_said(body, lang), "根号止" if zh else "end of root"]
        case Over(body, summed):
            sum_ = ["各" if zh else "the sum of"] * summed
            return [*sum_, "线段" if zh else "the length", *_said(body, lang), *(["之和"] * (summed and zh))]
        case Vec(body):
            return ["矢量" if zh else "vector", *_said(body, lang)]
    assert_never(node)


def _row(items: Sequence[Node], lang: Lang) -> list[str]:
    out: list[str] = []
    for item in items:
        out += _said(item, lang)
    return out


def _letters(text: str, lang: Lang) -> str:
    """Letters one by one; digits and primes stay with their letter, max, min and Roman numbers are words."""
    parts = re.findall(r"max|min|I{2,3}|\d+|.", text)
    return " ".join(_named(part, lang) for part in parts if part.strip(", "))


def _named(char: str, lang: Lang) -> str:
    pair = _GREEK.get(char) or _SIGNS.get(char)
    return char if pair is None else pair[lang == "en"]


def _power(exponent: str, lang: Lang) -> str:
    if exponent in _POWERS:
        return _POWERS[exponent][lang == "en"]
    if not exponent.strip("′'"):
        return _letters(exponent, lang)
    return f"{'上标' if lang == 'zh' else 'super'} {_letters(exponent, lang)}"


def _text(text: str, lang: Lang) -> list[str]:
    """Numbers with their units, signs in words; what comes before a sign tells a minus from a negative number."""
    out: list[str] = []
    end = 0
    for match in _QUANTITY.finditer(text):
        unit = unit_said(match[2], lang)
        if unit is not None:
            out += [*_signs(text[end : match.start()], lang), *_signs(match[1], lang), unit]
            end = match.end()
    return [*out, *_signs(text[end:], lang)]


def _raised(exponent: str, lang: Lang) -> str:
    """What is said for ^2, ^{-6}: words that stand as they are."""
    if exponent in _POWERS:
        return _POWERS[exponent][lang == "en"]
    number = exponent.lstrip("-−")
    if lang == "zh":
        return f"的{'负' if number != exponent else ''} {number} 次方"
    return f"to the power of {'minus ' if number != exponent else ''}{number}"


def _signs(text: str, lang: Lang) -> list[str]:
    out: list[str] = []
    before = ""
    text = _RAISED.sub(lambda raised: f" {_raised(raised[1], lang)} ", text)
    for token in _TOKEN.findall(text):
        if not token.strip():
            continue
        pair = _UNARY.get(token) if before in ("=", "(", ",", "×", "·") else None
        pair = pair or _GREEK.get(token) or _SIGNS.get(token)
        out.append(token if pair is None else pair[lang == "en"])
        before = token
    return out
