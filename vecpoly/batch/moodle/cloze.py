"""The cloze text of a question: ``{2:NUMERICAL:%100%0.583:0.029~%50%0.583:0.058#...}``, as Moodle's own patterns read
it."""

from __future__ import annotations

from ...grading.key import Graded, Kind
from ...words import Lang, Words
from .answers import Worth

UNITS = {
    "m/s": ("mm/s", "rad/s"),
    "m/s^2": ("mm/s²", "rad/s²"),
    "rad/s": ("r/min", "m/s"),
    "rad/s^2": ("rad/s", "m/s²"),
    "N": ("N·m", "kg"),
    "N·m": ("N", "N·mm"),
    "m": ("mm", "m/s"),
}
_SENSE = (Words("逆时针 ↺", "counter-clockwise ↺"), Words("顺时针 ↻", "clockwise ↻"))
_CHECK = Words("检查矢量的指向", "look at where the vector points")


def escaped(text: str) -> str:
    """A text inside a blank: } # ~ " \\ have a meaning there."""
    return "".join(f"\\{char}" if char in '}#~"\\/' else char for char in text)


def plain_number(value: float) -> str:
    """Without a leading plus, without an exponent that a pattern might miss."""
    text = f"{value:.10f}".rstrip("0").rstrip(".")
    return text if text not in ("", "-0") else "0"


def blank(weight: int, worths: tuple[Worth, ...], lang: Lang) -> str:
    """One numerical blank; the weight is whole."""
    answers = "~".join(
        f"%{one.percent}%{plain_number(one.value)}:{plain_number(one.allowed)}"
        + (f"#{escaped(one.said.of(lang))}" if one.said.of(lang) else "")
        for one in worths
    )
    return f"{{{weight}:NUMERICAL:{answers}}}"


def row(one: Graded, worths: tuple[Worth, ...], lang: Lang) -> str:
    """Symbol = value, unit, and for ω and α the sense; there the value is a size."""
    sized = tuple(worth for worth in worths if worth.value >= 0) if one.kind is not Kind.SIGNED else _sizes(worths)
    text = f"{blank(2, sized, lang)} {unit_of(one.unit)}"
    return text + (f" {sense(one, lang)}" if one.kind is Kind.SIGNED and one.exact else "")


def _sizes(worths: tuple[Worth, ...]) -> tuple[Worth, ...]:
    """Sizes alone: the sense is asked beside."""
    kept: list[Worth] = []
    for one in worths:
        size = abs(one.value)
        if all(
            abs(size - abs(other.value)) > other.allowed
            or one.percent == other.percent == 100
            or (one.percent == 50 and other.percent == 100)
            for other in kept
        ):
            kept.append(Worth(value=size, allowed=one.allowed, percent=one.percent, said=one.said))
    return tuple(kept)


def unit_of(unit: str) -> str:
    """A choice of units, the right one among two others."""
    shown = unit.replace("^2", "²")
    wrong = "".join(f"~{escaped(other)}" for other in UNITS.get(unit, ()))
    return f"{{1:MULTICHOICE_S:={escaped(shown)}{wrong}}}" if wrong else shown


def sense(one: Graded, lang: Lang) -> str:
    """↺ or ↻."""
    right, wrong = _SENSE if one.exact > 0 else _SENSE[::-1]
    return f"{{1:MULTICHOICE:={escaped(right.of(lang))}~{escaped(wrong.of(lang))}#{escaped(_CHECK.of(lang))}}}"
