"""The text in the signs of a Chinese keyboard, its senses, units and branches in Chinese."""

from __future__ import annotations

import re

import numpy as np

from ..family import family
from .original import original
from .units import unchanged

_WIDE = {
    ":": "：",
    ",": "，",
    "{": "｛",
    "}": "｝",
    "[": "［",
    "]": "］",
    "-": "－",
    ".": "．",
    "=": "＝",
    "/": "／",
    "^": "＾",
    "*": "＊",
    "_": "＿",
}
_SQUARE = {"[": "【", "]": "】"}
_WORDS = {"ccw": "逆时针", "cw": "顺时针", "mm": "毫米", "deg": "度", "r/min": "转/分", "m/s": "米/秒", "kg": "千克"}
_SIDES = {"left of": "左侧", "right of": "右方", "above": "上方", "below": "下面"}


@family("retold-signs", also=unchanged)
def in_chinese_signs(rng: np.random.Generator) -> str:
    """Any member of the other families, as a Chinese keyboard writes it."""
    mark, text = original(rng)
    return widened(rng, text, mark)


def widened(rng: np.random.Generator, text: str, mark: str) -> str:
    """Some kinds of signs wide, some words Chinese; the title the mark."""
    share = {sign: rng.choice([0.0, 0.5, 1.0]) for sign in _WIDE}
    letters = rng.choice([0.0, 0.0, 0.3])
    square, curly = rng.random() < 0.5, rng.random() < 0.5
    if rng.random() < 0.7:
        text = _chinese(rng, text)
    lines = [
        line if line.startswith("title") else _line(rng, line, share, letters, (square, curly))
        for line in text.splitlines()
    ]
    return "\n".join(f"title: {mark}" if line.startswith("title") else line for line in lines) + "\n"


def _line(
    rng: np.random.Generator, line: str, share: dict[str, float], letters: float, brackets: tuple[bool, bool]
) -> str:
    """Quoted texts and the dashes of a list stay."""
    dash = re.match(r"\s*(- )?", line)
    assert dash is not None
    out, quoted = dash[0], False
    for sign in line[dash.end() :]:
        quoted ^= sign == '"'
        if sign == '"' and brackets[1]:
            out += "“" if quoted else "”"
        elif quoted or rng.random() >= share.get(sign, letters if sign.isalnum() and sign.isascii() else 0.0):
            out += sign
        else:
            out += _SQUARE[sign] if brackets[0] and sign in _SQUARE else chr(ord(sign) + 0xFEE0)
    return out


def _chinese(rng: np.random.Generator, text: str) -> str:
    for word, zh in _WORDS.items():
        if rng.random() < 0.5:
            text = re.sub(rf"(?<=[\d ]) ?(?<![\w/]){re.escape(word)}(?![\w/^*])", f" {zh}", text)
    if rng.random() < 0.5:
        text = re.sub(
            r"\b([A-Z][a-m]?) (left of|right of|above|below) ((?:[A-Z][a-m]?){1,2})\b(?=[,\]])",
            lambda m: f"{m[1]} 在 {m[3]} {_SIDES[m[2]]}",
            text,
        )
    return text
