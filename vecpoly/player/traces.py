"""What is followed over the places of the drive: the way of each lettered point, and each asked quantity as a curve."""

from __future__ import annotations

import re
from collections.abc import Sequence
from math import isfinite

from ..algebra.formula import row
from ..board.acts import Plot
from ..board.construction import Figure, View
from ..board.paper.marks import Point
from ..drawing.style import LETTER
from ..mechanism.model import Mechanism
from ..names import written_unit
from ..printed.units import printed_unit
from ..solution import YES_NO
from ..tagging.speech import spoken
from ..tagging.units_said import unit_said
from ..typeset import layout
from .figures import LANGS, key_of
from .inverted import Turned
from .setting.ink import UNIT, Ink

Data = dict[str, object]
Where = dict[str, complex]  # letter → its point (mm)
TRACED = (View.MECHANISM, View.VELOCITY, View.ACCELERATION)
NAMED = re.compile(r"[A-QS-Z]'?(_\{?\d\}?)?|P_\{?\d.*")  # a point of a mechanism, or a centre; no force, no arm
STILL = 0.05  # mm: what moves less stands still


def traces(turns: Sequence[Turned], key: str, start: int, size: float, ink: Ink) -> list[Data]:
    """The points of a figure that move: the letter, how it is read out, its type, where the point lies at each place
    (at the scale of the given one; None where it is not drawn), and whether it is one of the driven link."""
    found = [_points(turn, key) for turn in turns]
    scales = [_scale(turn, key) for turn in turns]
    driven = _driven(turns[start])
    letters = list(dict.fromkeys(letter for there in found for letter in there))
    ways = {
        letter: [
            None if letter not in there or not scale or not scales[start] else there[letter] * scale / scales[start]
            for there, scale in zip(found, scales, strict=True)
        ]
        for letter in letters
    }
    return [
        {
            "letter": letter,
            "say": [spoken(letter, lang) for lang in LANGS],
            "type": ink.type(layout(row(letter), size * LETTER)),
            "at": [_units(z) for z in way],
            "drives": letter in driven,
        }
        for letter, way in ways.items()
        if _moves([z for z in way if z is not None])
    ]


def _driven(turn: Turned) -> tuple[str, ...]:
    """The letters of the link that is driven."""
    mech = turn.solution.problem.subject
    if not isinstance(mech, Mechanism):
        return ()
    return next((tuple(link.points) for link in mech.links if link.name == mech.drive.link), ())


def curves(turns: Sequence[Turned]) -> list[Data]:
    """Of each asked quantity its unit (also as it is read out), its values as drawn and exact over the places, and the
    figures on which it stands; none of what is a place, or yes or no."""
    out: list[Data] = []
    for key, answer in turns[0].solution.answers.items():
        factor, unit = printed_unit(answer.reading.unit)
        found = [turn.solution.answers[key] for turn in turns]
        plain = not answer.is_place and answer.reading.unit != YES_NO
        out.append(
            {
                "unit": written_unit(unit),
                "aloud": [unit_said(unit, lang) or "" for lang in LANGS],
                "drawn": [_short(factor * one.drawn) for one in found] if plain else [],
                "exact": [_short(factor * one.exact) for one in found] if plain else [],
                "on": _on(turns, key),
            }
        )
    return out


def _on(turns: Sequence[Turned], key: str) -> list[str]:
    """The figures on which the quantity is drawn."""
    figures = turns[0].solution.construction.figures
    return [key_of(figure) for figure in figures if any(mark.key == key for mark in figure.marks)]


def _points(turn: Turned, key: str) -> Where:
    """The lettered points of a figure at a place; lines with letters at their ends are none."""
    figure, acts = _figure(turn, key), turn.solution.construction.acts
    if figure is None or figure.view not in TRACED or not acts:
        return {}
    points = [m for m in figure.marks if isinstance(m, Point) and m.label and isinstance(acts[m.act], Plot)]
    if figure.view is View.MECHANISM:
        points = [mark for mark in points if NAMED.fullmatch(mark.label)]
    return {mark.label: mark.at for mark in points if [one.label for one in points].count(mark.label) == 1}


def _scale(turn: Turned, key: str) -> float:
    figure = _figure(turn, key)
    return 0.0 if figure is None else figure.scale.value


def _figure(turn: Turned, key: str) -> Figure | None:
    return next((one for one in turn.solution.construction.figures if key_of(one) == key), None)


def _moves(way: Sequence[complex]) -> bool:
    return len(way) > 1 and max(abs(z - way[0]) for z in way) > STILL


def _units(z: complex | None) -> tuple[int, int] | None:
    return None if z is None else (round(UNIT * z.real), round(-UNIT * z.imag))


def _short(size: float) -> float | None:
    """Five digits; zero where only rounding noise is left; nothing where there is no value."""
    return None if not isfinite(size) else float(f"{size:.5g}") if abs(size) > 1e-9 else 0.0
