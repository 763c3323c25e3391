"""A guide's resultant that leaves what is drawn of the guide supposes a longer one, and that is said."""

from __future__ import annotations

import re

import numpy as np

from tests.drawn_library import Drawn, drawn
from tests.each import each
from tests.found import FORCES
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import Block, FixedGuide
from vecpoly.mechanism.model import Prismatic
from vecpoly.plane import nominal

SAID = ("outside of the block as drawn", "outside of the guide as drawn")


END = 0.1  # mm: nearer to the end of a guide a resultant tells nothing
RUBBED = ("4-3a", "4-3b", "4-3c", "4-3d", "cam-face-load", "cam-knife-load", "cam-roller-load", *FORCES)


@each(RUBBED)
def test_where_a_resultant_leaves_the_guide_as_drawn_that_is_said(name: str) -> None:
    here = drawn(name)
    said = " ".join(re.findall(r"The lines? of [^.]* cross(?:es)? the guide's line outside of", _words(here)))
    for symbol, past in _crossings(here):
        if abs(past) < END:
            continue
        assert (f"${symbol}$" in said) == (past > 0.0), (symbol, past)


def test_it_is_said_of_a_face_a_point_and_a_block_and_not_of_a_force_through_the_pin() -> None:
    for name, words in (("cam-face-load", SAID[1]), ("cam-knife-load", SAID[1]), ("4-3b", SAID[0])):
        assert words in _words(drawn(name))
    assert not any(words in _words(drawn("4-6")) for words in SAID)


def _words(here: Drawn) -> str:
    return " ".join(step.words.en for step in here.construction.steps)


def _crossings(here: Drawn) -> list[tuple[str, float]]:
    """Of every slide between a fixed guide and what slides, with friction: the symbol of its reaction, and how far (mm)
    it crosses the guide past the end of the block, or of the guide of a rod."""
    found: list[tuple[str, float]] = []
    marks = [mark for figure in here.figures(View.MECHANISM) for mark in figure.marks]
    assert here.desk is not None and here.problem.loads is not None
    for joint in here.problem.mechanism.joints:
        if not isinstance(joint, Prismatic) or not {joint.guide, joint.block} & {"0"}:
            continue
        number = here.problem.mechanism.number
        symbol = f"R_{{{number(joint.guide)}{number(joint.block)}}}"
        reading = next((r for r in here.construction.forces.values() if plain(r.symbol) == plain(symbol)), None)
        sliding = here.desk.guide_line(joint)
        at, along = complex(nominal(sliding.at)), complex(nominal(sliding.along))
        if reading is None or reading.vector is None or reading.acts is None or abs(reading.vector) < 1e-6:
            continue
        if abs((np.conj(along) * reading.vector).real) < 1e-6 * abs(reading.vector):
            continue  # no friction there
        force, place = reading.vector / abs(reading.vector), reading.acts.point * here.desk.mm(1.0)
        travel = (np.conj(along) * (place - at)).real
        off = (np.conj(along) * (place - at)).imag
        lean = np.conj(along) * force
        travel -= off * lean.real / lean.imag
        ends = [
            (np.conj(along) * (end - at)).real
            for mark in marks
            if isinstance(mark, Block | FixedGuide)
            for end in _ends(mark)
            if abs((np.conj(along) * (end - at)).imag) < 2.0
        ]
        if ends:
            found.append((symbol, float(max(travel - max(ends), min(ends) - travel))))
    return found


def plain(symbol: str) -> str:
    return symbol.replace("{", "").replace("}", "")


def _ends(mark: Block | FixedGuide) -> tuple[complex, complex]:
    if isinstance(mark, Block):
        return mark.at - mark.along * mark.length / 2, mark.at + mark.along * mark.length / 2
    return mark.a, mark.b
