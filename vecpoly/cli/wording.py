"""Answers in the letters a terminal has."""

from __future__ import annotations

from math import isnan
from typing import TYPE_CHECKING

from ..foundation.greek import GREEK
from ..names import written_unit
from ..words import Lang

if TYPE_CHECKING:
    from ..solution import Answer

_SENSE = {"ccw": {"zh": "逆时针", "en": "↺ ccw"}, "cw": {"zh": "顺时针", "en": "↻ cw"}}
_STEMS = GREEK | {"psi0": "ψ0"}
_YES_NO = {True: {"zh": "是", "en": "yes"}, False: {"zh": "否", "en": "no"}}
_UNDEFINED = {"zh": "无意义", "en": "undefined"}
MM = 1e3  # in a metre: places are told in mm, as a text gives them
YES_NO = "yes/no"  # unit of an answer that is 1 or 0
_HUGE = 1e9  # a value below this is written without a power of ten


def symbol(key: str) -> str:
    """omega_3 → ω_3, eta → η, an_CB → a^n_CB, the rest as it is."""
    stem, joint, rest = key.partition("_")
    if stem in _STEMS:
        return f"{_STEMS[stem]}{joint}{rest}"
    return f"a^{stem[1]}_{rest}" if stem in ("an", "at", "ak", "ar") else key


def number(value: float, digits: int = 5, zero: float = 0.0) -> str:
    """A number for reading, with a zero that is a zero (what is no larger than `zero`) and a real minus."""
    text = "0" if abs(value) <= zero else f"{value:.{digits}g}"
    return (f"{float(text):.0f}" if "e+" in text and abs(value) < _HUGE else text).replace("-", "−")


def drawn(answer: Answer, lang: Lang) -> str:
    """The value read off the drawing; of what turns its size, beside which the sense stands."""
    return _value(answer, answer.drawn, answer.drawn_vector, lang)


def exact(answer: Answer, lang: Lang) -> str:
    """The exact value."""
    return _value(answer, answer.exact, answer.exact_vector, lang)


def _value(answer: Answer, size: float, vector: complex | None, lang: Lang) -> str:
    zero = answer.nothing
    if answer.is_place and vector is not None:
        return place(vector, zero=zero)
    if answer.is_place:
        return f"∞, {number(size, zero=zero)}"
    return scalar(answer.counted * size, answer.reading.unit, lang, zero=zero)


def place(at: complex, digits: int = 5, zero: float = 0.0) -> str:
    """The coordinates of a point (m), in mm."""
    return f"({', '.join(number(MM * part, digits, MM * zero) for part in (at.real, at.imag))})"


def unit(answer: Answer) -> str:
    """The unit of what `drawn` and `exact` say."""
    return "mm" if answer.is_place and answer.drawn_vector is not None else written_unit(answer.reading.unit)


def beside(text: str, name: str) -> str:
    """A number with its unit: 12 N, 5.71°."""
    return text + name if name == "°" else f"{text} {name}".rstrip()


def scalar(size: float, unit_text: str, lang: Lang, digits: int = 5, zero: float = 0.0) -> str:
    """A number, or yes and no; 0/0 is undefined."""
    if isnan(size):
        return _UNDEFINED[lang]
    return _YES_NO[bool(size)][lang] if unit_text == YES_NO else number(size, digits, zero)


def gap(answer: Answer) -> str:
    """How far the drawn value is off, in per cent of the exact one; nothing to say of what a formula gave."""
    if answer.computed:
        return "—"
    if answer.is_place and answer.drawn_vector is not None and answer.exact_vector is not None:
        return number(MM * abs(answer.drawn_vector - answer.exact_vector), 2, MM * answer.nothing)
    if abs(answer.exact) <= answer.nothing or answer.is_place:  # of a direction to infinity, in degrees
        return number(answer.deviation, 2, answer.nothing)
    return percent(answer.relative_deviation)


def percent(part: float) -> str:
    """+0.13 %."""
    text = f"{100 * part:+.2f} %".replace("-", "−")
    return "0.00 %" if text[1:] == "0.00 %" else text


def degrees(off: float) -> str:
    """+0.13°."""
    text = f"{off:+.2f}°".replace("-", "−")
    return "0.00°" if text[1:] == "0.00°" else text


def reach(answer: Answer) -> str:
    """±3σ of repeated hands."""
    in_mm = answer.is_place and answer.drawn_vector is not None
    return "—" if answer.computed else f"±{number(answer.expected_error * (MM if in_mm else 1.0), 2)}"


def way(answer: Answer, lang: Lang) -> str:
    """Direction in degrees, or the sense of turning."""
    if answer.is_place:
        return "—"
    if answer.drawn_vector is not None:
        from ..printed.angles import bearing_told

        turn = answer.direction
        return "—" if turn is None or abs(answer.drawn_vector) <= answer.nothing else bearing_told(turn)
    if answer.along is not None:
        return answer.along.of(lang)
    return sense(answer.drawn, lang) if answer.sense and abs(answer.drawn) > answer.nothing else "—"


def sense(turn: float, lang: Lang) -> str:
    """The sense of turning by the sign."""
    return _SENSE["ccw" if turn > 0 else "cw"][lang]
