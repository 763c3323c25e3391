"""How far what was asked is from exact, in a sentence: the largest deviations of the table of readings."""

from __future__ import annotations

from collections.abc import Sequence

from ....algebra.rounding import read_back
from ....solution import Answer
from ....words import Words
from ...answers.placed import gaps
from ...answers.tables import deviation_told, parted


def agreement(answers: Sequence[Answer]) -> Words:
    """By how much these deviate at most: in per cent, angles in degrees, places in mm; nothing of what is computed."""
    places, others = parted(answers)
    told = [text for text in map(deviation_told, others) if text[-1:].isdigit() or text.endswith("°")]
    found = [
        (names, f"{most}{unit}")
        for names, unit, texts in (
            (Words("以上各值", "these values"), " %", [text for text in told if not text.endswith("°")]),
            (Words("角度", "the angles"), "°", [text.removesuffix("°") for text in told if text.endswith("°")]),
            (
                Words("点的位置", "the positions of points"),
                " mm",
                [text for text in gaps(places) if text[-1:].isdigit()],
            ),
        )
        if (most := _largest(texts))
    ]
    if not found:
        return Words("", "")
    found = [(names, most) for names, most in found if read_back(most.rstrip("°% m"))[0]]
    if not found:
        return Words("图解与解析在所列位数内一致。", " Drawing and computation agree in all digits told.")
    zh = "，".join(f"{names.zh}最多相差 {most}" for names, most in found)
    en = " and ".join(f"{most} in {names.en}" for names, most in found)
    return Words(f"图解与解析相比，{zh}。", f" Drawing and computation differ by at most {en}.")


def _largest(texts: Sequence[str]) -> str:
    """As it is printed, without its sign."""
    return max(texts, key=lambda text: abs(read_back(text)[0]), default="").lstrip("+−")
