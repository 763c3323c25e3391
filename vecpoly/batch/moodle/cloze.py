"""The cloze text of a question: ``{2:NUMERICAL:%100%0.583:0.029~%50%0.583:0.058#...}``, as Moodle's own patterns read
it."""

from __future__ import annotations

from decimal import Decimal

from ...grading.key import Graded, Kind
from ...names import written_unit
from ...words import Lang, Words
from .answers import Worth, worded

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
_ESCAPES = str.maketrans({"}": "\\}", "#": "\\#", "~": "～", "\\": "＼"})
_CHECK = Words("检查矢量的指向", "look at where the vector points")


def escaped(text: str) -> str:
    """A text inside a blank. Moodle takes the backslash away before } and # alone (`qtype_multianswer`): it would stand
    before anything else, so that ~ and a backslash itself are written by letters that look like them."""
    return text.translate(_ESCAPES)


def plain_number(value: float) -> str:
    """All its digits, without a leading plus, without an exponent that a pattern might miss."""
    text = f"{Decimal(repr(value)):f}"
    whole = text.rstrip("0").rstrip(".") if "." in text else text
    return whole if whole not in ("", "-0") else "0"


def blank(weight: int, worths: tuple[Worth, ...], lang: Lang) -> str:
    """One numerical blank; the weight is whole."""
    answers = "~".join(
        f"%{one.percent}%{plain_number(one.value)}:{plain_number(one.allowed)}"
        + (f"#{escaped(one.said.of(lang))}" if one.said.of(lang) else "")
        for one in worths
    )
    return f"{{{weight}:NUMERICAL:{answers}}}"


def row(one: Graded, worths: tuple[Worth, ...], lang: Lang) -> str:
    """The value with its unit; of ω and α its size and its sense; a choice of what is told in words."""
    if said := worded(one, lang):
        return choice(2, said)
    signed = one.kind is Kind.SIGNED
    text = f"{blank(2, _sizes(worths) if signed else worths, lang)} {unit_of(one.unit)}".rstrip()
    return f"{text} {sense(one, lang)}" if signed and one.exact else text


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
    shown, wrong = written_unit(unit), UNITS.get(unit, ())
    return choice(1, (shown, *wrong)) if wrong else shown


def sense(one: Graded, lang: Lang) -> str:
    """↺ or ↻."""
    right, wrong = (said.of(lang) for said in (_SENSE if one.exact > 0 else _SENSE[::-1]))
    return choice(1, (right, wrong), _CHECK.of(lang))


def choice(weight: int, options: tuple[str, ...], said: str = "") -> str:
    """The first among others, shuffled, and what is said of those."""
    right, *wrong = map(escaped, options)
    told = f"#{escaped(said)}" if said else ""
    return f"{{{weight}:MULTICHOICE_S:={right}{''.join(f'~{other}{told}' for other in wrong)}}}"
