"""How many decimals an answer has: as many as its reading allows, wherever it is printed."""

from __future__ import annotations

from decimal import Decimal
from math import floor, isfinite, log10

from ..algebra.columns import places_of
from ..algebra.formula import Row
from ..algebra.quantity import number
from ..algebra.rounding import places_of as decimals_of
from ..algebra.rounding import to_figures, to_places
from ..answer import YES_NO, Answer
from .lengths import is_length
from .units import printed_unit

TENTH = 0.1  # mm: what a rule is read to
_HALF = TENTH / 2
SHARE, SHARE_OF_READ = 0.3, 0.1  # of the expected error: what is smaller says nothing; of a length that was read well
MOST = 4  # significant digits of an answer; an exact value has one more
READ = 3  # significant digits of what is read on paper, at least; one more after a leading 1
LEAST = 1e-4  # smaller numbers are told by powers of ten
_GRID = 1e-6  # of a tenth: a reading that lies on one
_SAME = 1e-9  # share by which a number read to a tenth may differ from itself
_FINEST, _OF_SCALE = 2, 3  # decimals of a place, figures of a scale, at most
COARSE = 0.1  # an expected error of this share of an answer is told beside it
_BEARINGS = ("theta_b", "theta_h")  # where balancing masses and holes are
HOPELESS = 0.5  # share of a value: with a reading error above it, nothing was read but its first figure


def drawn_number(answer: Answer) -> str:
    """The answer as it is printed, in printed units: with the zeros that were read; turning is told by its sense."""
    return rounded(_towards(answer) * answer.drawn, decimals(answer), MOST)


def exact_number(answer: Answer, exact: float) -> str:
    """The exact value (SI) beside it: one decimal more; of what is computed, which is exact, the same."""
    places, more = decimals(answer), not answer.computed
    return rounded(_towards(answer) * exact, None if places is None else places + more, MOST + more)


def _towards(answer: Answer) -> float:
    """To the printed unit; what turns clockwise is counted that way, for its sense stands beside it."""
    return printed_unit(answer.reading.unit)[0] * answer.counted


def rounded(value: float, places: int | None, most: int) -> str:
    """A number with so many decimals, and no more than so many significant digits."""
    if not value or not isfinite(value) or places is None:
        return number(value, most)
    if abs(value) < LEAST:
        return number(value, max(1, min(most, floor(log10(abs(value))) + 1 + places)))
    fit = most - 1 - floor(log10(abs(value)))
    kept = max(0, min(places, fit))
    text = f"{to_places(value, kept):.{kept}f}".replace("-", "−")
    return "0" if not text.strip("−0.") else text


def decimals(answer: Answer) -> int | None:
    """So many that the last one is worth what was read; of what is computed, the figures of a result at least; None of
    pure numbers that are computed or counted.

    What was worked out has the zeros that its expected error leaves it; an angle has the tenth of the protractor. What
    is read off as a length has the figures of its reading. None ends with a digit that is worth less than its expected
    error while three figures are left, four after a leading 1: of fewer the rounding would look like a deviation;
    what is hardly read has one. What lies midway between two numbers of so many has one more (`finer`).
    """
    places = _decimals(answer)
    return None if places is None else places + answer.finer


def _decimals(answer: Answer) -> int | None:
    places, error = _places(answer), printed_unit(answer.reading.unit)[0] * _error(answer)
    if answer.computed and printed_unit(answer.reading.unit)[1] and answer.reading.unit != YES_NO:
        return _whole_figures(places, printed_unit(answer.reading.unit)[0] * answer.drawn, answer.reading.unit == "deg")
    if places is None or not error or not answer.drawn or answer.reading.unit == "deg":
        return places
    drawn = printed_unit(answer.reading.unit)[0] * answer.drawn
    if is_hopeless(answer):
        return min(places, places_for(drawn, 1))
    return min(places, max(places_of(error), places_for(drawn, READ + leads_with_1(drawn)), _beside(answer, drawn)))


def _beside(answer: Answer, drawn: float) -> int:
    """The decimals of others beside it, as far as its reading has so many figures."""
    return min(answer.least, places_for(drawn, figures_read(drawn, answer.reading.mm or 0.0)))


def _whole_figures(places: int | None, value: float, angle: bool) -> int | None:
    """The decimals of a computed value, 0.5 m/s, beside those that are read: 0.500; of an angle a tenth at least."""
    if not isfinite(value) or abs(value) < LEAST:
        return places
    own = decimals_of(number(value, MOST)) if places is None else places
    return max(own, 1 if angle else places_for(value, READ))


def _places(answer: Answer) -> int | None:
    """As many as its reading has figures, however far that may be off."""
    factor = printed_unit(answer.reading.unit)[0]
    read, error = factor * _read_to(answer), factor * _error(answer)
    line = answer.reading.formula
    if read and isinstance(line, Row) and is_length(line) and not answer.computed:
        return places_as_read(factor * answer.drawn, answer.reading.mm or 0.0)
    well = answer.reading.mm is not None and coarse(answer) is None
    step = max(read, error * (SHARE_OF_READ if well else SHARE))
    if answer.reading.unit == YES_NO or not step or not isfinite(answer.drawn):
        return None
    places, drawn = (_places_read if step == read else places_of)(step), factor * answer.drawn
    most = MOST if answer.computed or answer.reading.unit == "deg" else figures_read(drawn, answer.reading.mm or 0.0)
    places = min(places, places_for(drawn, most))
    if answer.reading.mm is None or answer.computed:
        least = 1 if answer.reading.unit == "deg" else max(min(places, places_of(error)), answer.least)
        finest = max(places, least)
        return next((n for n in range(0 if answer.computed else least, finest) if _is_on(drawn, n)), finest)
    return places


def places_as_read(value: float, mm: float) -> int:
    """Decimals of a value that is so many millimetres on paper, times a scale: it has their figures; one more where it
    lies midway, 16.7 × 0.015 = 0.2505, for that is no matter of rounding."""
    finest, fit = _places_read(TENTH * abs(value / mm)), places_for(value, figures_read(value, mm))
    places = min(finest, fit)
    midway = places < finest and _is_on(2 * value * 10.0**places, 0) and not _is_on(value, places)
    return places + midway


def figures_read(value: float, mm: float) -> int:
    """As many as the reading has to a tenth, three at least; one more where the value begins with 1."""
    return min(MOST, max(READ, floor(log10(abs(mm))) + 2 if mm else READ) + leads_with_1(value))


def leads_with_1(value: float) -> bool:
    """Whether the number begins with 1: its first three figures tell it no better than two of a 9 do."""
    return f"{abs(value):e}"[0] == "1"


def places_for(value: float, figures: int) -> int:
    """The decimals with which a number has so many figures."""
    return max(0, figures - 1 - floor(log10(abs(value)))) if value else _FINEST


def _places_read(tenth: float) -> int:
    """Decimals of what is read to so much: one more where its multiples need it, 16.7 × 0.015 = 0.2505."""
    tenth, places = to_figures(tenth, _OF_SCALE), places_of(tenth)
    return places if _is_on(tenth, places) or not _is_on(tenth, places + 1) else places + 1


def _is_on(value: float, places: int) -> bool:
    return abs(value - round(value, places)) < _SAME * abs(value)


def _read_to(answer: Answer) -> float:
    """What a tenth of a millimetre is worth, of half the sum of two lengths too; nothing where the hand reads finer."""
    mm = answer.reading.mm
    if not mm or not isfinite(mm) or not isfinite(answer.drawn) or abs(mm / _HALF - round(mm / _HALF)) > 1e-6:
        return 0.0
    return TENTH * abs(answer.drawn) / mm


def _error(answer: Answer) -> float:
    return answer.expected_error if not answer.computed and isfinite(answer.expected_error) else 0.0


def in_percent(text: str) -> str:
    """A share as it is printed, 0.44, with the same figures in per cent: 44 %."""
    return f"{Decimal(text).scaleb(2):f} %"


def on_paper(answer: Answer) -> str:
    """The length read on paper (mm), to a tenth as by a rule; half the sum of two such lengths to half of that."""
    mm = answer.reading.mm or 0.0
    fine = abs(2e1 * mm - round(2e1 * mm)) < _GRID < abs(1e1 * mm - round(1e1 * mm))
    return f"{mm:.2f}" if fine else f"{mm:.1f}"


def coordinates(answer: Answer) -> int:
    """The decimals of a place in mm: as many as were read, up to those that the expected error leaves certain."""
    at, error = answer.drawn_vector or 0j, 1e3 * _error(answer)
    finest = max(1, min(_FINEST, places_of(error))) if error else _FINEST
    return next((n for n in range(1, finest) if all(_falls_on(1e3 * part, n) for part in (at.real, at.imag))), finest)


def _falls_on(mm: float, places: int) -> bool:
    return abs(mm - round(mm, places)) < 1e-6


def coarse(answer: Answer) -> float | None:
    """The share that the expected error is of the answer, where it is so large that it must be told; inf of zero."""
    if answer.computed or answer.is_place or answer.reading.unit == YES_NO:
        return None
    if answer.reading.unit == "deg" and answer.key.startswith(_BEARINGS):  # no share of a direction
        return None
    error = answer.expected_error
    if not isfinite(error) or not error or abs(answer.drawn) < 1e-9 * error:
        return None
    whole = abs(answer.exact)  # as in the check beside it
    share = error / (whole if whole and isfinite(whole) else abs(answer.drawn))
    return share if share >= COARSE else None


def is_hopeless(answer: Answer) -> bool:
    """Whether its reading may be off by so much that nothing was read."""
    share = coarse(answer)
    return share is not None and not share < HOPELESS
