"""What a beat points at: the vector that is drawn, the lengths that are measured, the vectors that a formula takes, and
the relative velocity that is turned by 90° for a Coriolis term. As data for the script."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping, Sequence
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from ..board.acts import Act, Arrow, Compute, Measure
from ..board.construction import Construction, Figure
from ..board.paper.marks import Point, Segment, Vector
from ..errors import UnknownNameError
from ..foundation.slotted import replace
from ..names import Kind, ascii_key, parse_rel
from ..tagging.speech import spoken
from ..words import Words
from .beats import Beat
from .figures import LANGS, key_of
from .setting.ink import UNIT

Data = dict[str, object]
Points = NDArray[np.complex128]
SAME = 0.01  # mm: nearer, two ends are one
_DRAW = Words("作 {}", "draw {}")
NOTHING = 1e-6  # mm: a shorter vector has no direction


def pointed(construction: Construction, cut: Sequence[Beat]) -> list[Data]:
    """Of each beat its step, and what of this applies to it:

    at: figure and place of the one point that is sought; marks: figure and ends of each measured length; glow: the
    earlier beats that drew what a formula takes; turn: figure, tail, direction, length and sweep of the relative
    velocity that turns into a Coriolis term, and the beat that drew it; say: what is drawn as it is read out, in both
    languages.
    """
    arrows = {act.key: (act, beat) for beat in cut for act in beat.acts if isinstance(act, Arrow) and act.shown}
    ends = {key_of(figure): _ends(figure) for figure in construction.figures}
    symbols = {ascii_key(one): one for step in construction.steps if step.equation for one in step.equation.symbols}
    return [_data(beat, construction.acts, arrows, ends, symbols) for beat in cut]


def _symbol(key: str, written: Mapping[str, str]) -> str:
    """The symbol of a vector: as its equation has it, else that of its key."""
    head, _, below = key.partition("_")
    try:
        return written.get(key) or parse_rel(key).symbol
    except UnknownNameError:
        return f"{head}_{{{below.replace('_', ',')}}}" if below else head


def _data(
    beat: Beat,
    acts: Sequence[Act],
    arrows: Mapping[str, tuple[Arrow, Beat]],
    ends: Mapping[str, Points],
    symbols: Mapping[str, str],
) -> Data:
    arrow, read = beat.arrow, _measured(beat, acts)
    found: Data = {"step": beat.step}
    if sought := beat.sought:
        found["at"] = [key_of(sought[0]), *_units(sought[1])]
    if marks := [[key, *_units(one.a), *_units(one.b)] for one in read for key in _where(one, ends)]:
        found["marks"] = marks
    if arrow is not None:
        if symbol := _symbol(arrow.key, symbols):
            found["say"] = [_DRAW.of(lang).format(spoken(symbol, lang)) for lang in LANGS]
        if turn := _turned(arrow, beat, arrows):
            found["turn"] = turn
    elif not read and (glow := _taken(beat, acts, arrows)):
        found["glow"] = glow
    return found


def _ends(figure: Figure) -> Points:
    """Where lines end and points lie on a figure (mm)."""
    kinds = (Segment, Vector)
    found = [z for mark in figure.marks if isinstance(mark, kinds) for z in (mark.a, mark.b)]
    return np.array(found + [mark.at for mark in figure.marks if isinstance(mark, Point)], dtype=complex)


def _where(read: Measure, ends: Mapping[str, Points]) -> list[str]:
    """The figure that has an end of the length: where the step is drawn, or, if it is measured elsewhere, another."""
    own = [] if read.head.place is None else [key_of(read.head.place)]
    there = (key for key in (*own, *ends) if _has(ends.get(key), (read.a, read.b)))
    return list(islice(there, 1))


def _has(ends: Points | None, sought: tuple[complex, complex]) -> bool:
    return ends is not None and any(np.any(np.abs(ends - z) < SAME) for z in sought)


def _measured(beat: Beat, acts: Sequence[Act]) -> list[Measure]:
    """The lengths that a formula of now takes; of one that takes none, what is read with it."""
    if not beat.formulas:
        return []
    taken = {n for act in beat.acts if isinstance(act, Compute) for n in act.inputs}
    found = [act for act in acts if act.number in taken and isinstance(act, Measure)]
    return found or [act for act in beat.acts if isinstance(act, Measure)]


def _taken(beat: Beat, acts: Sequence[Act], arrows: Mapping[str, tuple[Arrow, Beat]]) -> list[int]:
    """The beats that drew the vectors that a formula of now takes."""
    keys = {acts[n].key for act in beat.acts if isinstance(act, Compute) for n in act.inputs}
    return sorted({drawn.number for key, (_, drawn) in arrows.items() if key in keys and drawn.number < beat.number})


def _turned(arrow: Arrow, beat: Beat, arrows: Mapping[str, tuple[Arrow, Beat]]) -> list[object]:
    """The way of v_r into the Coriolis term; nothing where there is no such vector."""
    try:
        rel = parse_rel(arrow.key)
    except UnknownNameError:
        return []
    if rel.kind is not Kind.AK or arrow.head.place is None:
        return []
    velocity = arrows.get(replace(rel, kind=Kind.V).key)
    if velocity is None or abs(velocity[0].b - velocity[0].a) < NOTHING or abs(arrow.b - arrow.a) < NOTHING:
        return []
    along, to = velocity[0].b - velocity[0].a, arrow.b - arrow.a
    degrees = [round(math.degrees(one), 1) for one in (-cmath.phase(along), -cmath.phase(to / along))]
    key, size = key_of(arrow.head.place), round(UNIT * abs(to))
    return [key, *_units(arrow.a), degrees[0], size, degrees[1], velocity[1].number]


def _units(at: complex) -> tuple[int, int]:
    return round(UNIT * at.real), round(-UNIT * at.imag)
