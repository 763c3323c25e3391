"""Characters that are written in several ways: full-width letters, raised digits, minus signs, dots."""

from __future__ import annotations

import re

from ...foundation.indices import ON_LINE

_WIDE = {code: chr(code - 0xFEE0) for code in range(0xFF01, 0xFF5F)}  # ！ to ～
_SIGNS = str.maketrans(
    {
        "　": " ",
        "\u00a0": " ",
        "\u2009": " ",
        "\u202f": " ",
        "－": "-",
        "−": "-",
        "–": "-",
        "﹣": "-",
        "＋": "+",
        "，": ",",
        "。": ".",
        "．": ".",
        "：": ":",
        "；": ";",
        "（": "(",
        "）": ")",
        "／": "/",
        "∕": "/",
        "∙": "·",
        "⋅": "·",
        "•": "·",
        "∗": "*",
        "✕": "×",
        "✖": "×",
        "˚": "°",
        "º": "°",
        "％": "%",
        "′": "'",
        "’": "'",
    }
)
_RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺"
_TO_LINE = str.maketrans(_RAISED, "0123456789-+")


def plain(text: str) -> str:
    """The text in ordinary characters: ３．２×１０² → 3.2×10^2."""
    narrow = text.translate(_WIDE).translate(_SIGNS).translate(ON_LINE)
    narrow = re.sub(r"^—\s*(?=[\d.])", "-", narrow.strip())  # the minus of a Chinese keyboard
    return re.sub(f"[{_RAISED}]+", lambda found: "^" + found[0].translate(_TO_LINE), narrow)
