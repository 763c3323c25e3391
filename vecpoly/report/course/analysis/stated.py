"""What was asked at the given position: drawn and exact values of the output, in a sentence."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from math import degrees

import numpy as np

from ....findings.output_links import ends
from ....findings.shown import shown
from ....findings.study.study import Study
from ....mechanism.model import Prismatic
from ....printed.digits import drawn_number
from ....solution import Answer
from ....words import Words

_AXES = {
    0: Words("向右", "to the right"),
    90: Words("向上", "upwards"),
    180: Words("向左", "to the left"),
    270: Words("向下", "downwards"),
}
_NEAR = 0.05  # degrees


def stated(study: Study) -> Iterator[Words]:
    """The velocities and accelerations asked for of the output links and points, at the given position."""
    keys = _keys(study)
    if not keys or study.sense_only:
        return
    told = [_told(study, key) for key in keys]
    at, drawn = study.where(study.mech.drive.position), any(key in study.given.answers for key in keys)
    how = Words("（图解值/解析值）", " (drawn / exact)") if drawn else Words("（解析值）", " (exact)")
    yield Words(
        f"题设位置（{at}）所求各量{how.zh}：{'；'.join(w.zh for w in told)}。",
        f"Required quantities in the given position, {at}{how.en}: {'; '.join(w.en for w in told)}.",
    )


def output_pins(study: Study) -> dict[str, str]:
    """The letters pinned to output blocks on the frame's guides, each with its block."""
    outputs = ends(study)
    return {
        j.pin: j.block
        for j in study.mech.joints
        if isinstance(j, Prismatic) and j.guide not in study.mech.bodies and j.block in outputs and j.pin
    }


def _keys(study: Study) -> list[str]:
    """Of what is asked for: the output links' ω and α, and v and a of an output block, else of the points shown."""
    sliding = output_pins(study)
    names = {*ends(study), *(sliding or study.points)}
    return [key for key in study.outputs if key.partition("_")[2] in names]


def _told(study: Study, key: str) -> Words:
    """$v_F$ = 0.319/0.3189 m/s, to the left."""
    info, answer = study.whole.info(key), study.given.answers.get(key)
    exact = complex(np.ravel(study.here.value(key))[0])
    size = abs(exact) if info.is_vector else exact.real
    if _vanishes(study, key, size, answer):
        return Words(f"${info.symbol}$ ≈ 0", f"${info.symbol}$ ≈ 0")
    text = shown(study, key, size)
    if answer is not None:
        number, _, unit = text.partition(" ")
        sign = "−" if shown(study, key, answer.drawn).startswith("−") else ""
        text = f"{sign}{drawn_number(answer).lstrip('−')}/{number} {unit}"
    block = output_pins(study).get(key.partition("_")[2])
    name = Words(
        f"（构件 {study.name(block)}）" if block else " ", f" (of link {study.name(block)}) " if block else " "
    )
    towards = (
        _direction(exact)
        if info.is_vector
        else Words("逆时针", "counter-clockwise")
        if size > 0
        else Words("顺时针", "clockwise")
    )
    return Words(f"${info.symbol}${name.zh}= {text}，{towards.zh}", f"${info.symbol}${name.en}= {text}, {towards.en}")


def _vanishes(study: Study, key: str, size: float, answer: Answer | None) -> bool:
    """Whether a value is nothing beside its largest in the cycle."""
    found = study.extremes(key)
    top = max((abs(s.value) for s in (found.highest, found.lowest) if s is not None), default=0.0)
    return abs(size) < 1e-9 * top and (answer is None or abs(answer.drawn) < 1e-2 * top)


def _direction(vector: complex) -> Words:
    """Along an axis in words, else the angle from +x."""
    angle = degrees(cmath.phase(vector)) % 360
    axis = next((a for a in _AXES if abs((angle - a + 180) % 360 - 180) < _NEAR), None)
    return _AXES[axis] if axis is not None else Words(f"方向角 {angle:.1f}°", f"at {angle:.1f}° from $x$")
