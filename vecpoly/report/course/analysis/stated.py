"""What was asked at the given position: all of it in the order asked, drawn and exact, in a sentence."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence
from math import degrees

import numpy as np

from ....findings.output_links import ends
from ....findings.shown import shown
from ....findings.study.study import Study
from ....foundation.patterns import pattern
from ....mechanism.model import Prismatic
from ....names import Kind, Rel
from ....printed.angles import bearing_told
from ....printed.digits import coordinates, drawn_number
from ....printed.places import place_parts
from ....printed.units import printed_unit
from ....solution import YES_NO, Answer
from ....words import Words, joined
from ...answers.placed import angle
from ...answers.verdict import is_ill
from ...values import called, direction_of_load, unit_after, value, way_of
from .agreement import agreement
from .several_ways import alike, by_ways

_AXES = {
    0: Words("向右", "to the right"),
    90: Words("向上", "upwards"),
    180: Words("向左", "to the left"),
    270: Words("向下", "downwards"),
}
_NEAR = 0.05  # degrees
_BARE = pattern(r"\$[^$]+\$ ")
_MANY = 10  # quantities asked: of more, those of the output are told, and where the others stand
_LISTED = 3  # instant centres asked: of more, a table tells the places
_COMMA, _DRAWN, _EXACT = (
    Words("，", ", "),
    Words("作图求得", "the drawing gives "),
    Words("计算求得", "the computation gives "),
)
RATES = (Kind.V, Kind.A, Kind.OMEGA, Kind.ALPHA)


def stated(study: Study) -> Iterator[Words]:
    """All that is asked, in the order asked: size and sense in the given position; and how far it is from exact."""
    keys = [ask.rel.key for ask in study.given.problem.asks]
    centres = [key for key in keys if key.startswith("P_")]
    gathered = centres if len(centres) > _LISTED and study.drawn else []
    main = _main(study, keys) if len(keys) - len(gathered) > _MANY and study.drawn else []
    told = [_centres(study, gathered)] if gathered else []
    alone = [key for key in main or keys if key not in gathered]
    told += [said for some in alike(alone, study.solution.answers) if (said := _all_ways(study, some)) is not None]
    if not told:
        return
    at, how = study.where(study.mech.drive.position), _DRAWN if study.solution.answers else _EXACT
    rate = f"$|ω_{{{study.mech.drive.link}}}|$ = 1 rad/s"
    taken = Words(f"（按 {rate}）", f" (at {rate})") if study.sense_only and _has_rates(study) else Words("", "")
    rest = Words("；其余各量见 6.2", "; for the others see 6.2") if 0 < len(main) < len(keys) else Words("", "")
    near = _near(study, [one for key in main or keys if (one := study.solution.answers.get(key)) is not None])
    yield Words(
        f"题设位置 {at}{taken.zh}，{how.zh}{'；'.join(w.zh for w in _once(told))}{rest.zh}。{near.zh}",
        f"In the given position, {at}{taken.en}, {how.en}{'; '.join(w.en for w in _once(told))}{rest.en}.{near.en}",
    )


def _near(study: Study, answers: Sequence[Answer]) -> Words:
    """How far drawing and computation differ, of what can be drawn; what hardly can is named, however near it came."""
    ill = [one for one in answers if is_ill(one, study.solution)]
    near = agreement([one for one in answers if one not in ill])
    if not ill:
        return near
    named, many = joined([Words.same(f"${one.rel.symbol}$") for one in ill]), len(ill) > 1
    return near + Words(
        f"{named.zh} 由作图不易准确求得，不在此列，以精确值为准（见 6.2）。",
        f" {named.en} {'are' if many else 'is'} ill-conditioned in the drawing and left out here: take the exact "
        f"value{'s' if many else ''} (see 6.2).",
    )


def _once(told: list[Words]) -> Iterator[Words]:
    """What has the same value and direction is told of all at once: $R_{12}$ = $R_{23}$ = 321 N."""
    same: dict[tuple[str, str], list[Words]] = {}
    for n, one in enumerate(told):
        symbol, _, value_told = one.en.partition("= ")
        alone = not _BARE.fullmatch(symbol)
        same.setdefault((value_told, str(n) * alone), []).append(one)
    for some in same.values():
        heads = "= ".join(one.en.partition("= ")[0] for one in some)
        ends = Words(*(text.partition("= ")[2] for text in (some[0].zh, some[0].en)))
        yield some[0] if len(some) == 1 else Words.same(f"{heads}= ") + ends


def _all_ways(study: Study, keys: list[str]) -> Words | None:
    """A quantity; one that is found by several ways with all of them."""
    answers = [study.solution.answers[key] for key in keys if key in study.solution.answers]
    if len(keys) == 1 or any(one.undefined or _nothing(study, one) for one in answers):
        return _asked(study, keys[0])
    return by_ways(answers, [_numbers(one) for one in answers], _sense(study, answers[0]))


def _main(study: Study, keys: list[str]) -> list[str]:
    """Of many: what is told of the output, and of the one other link of which ω and α are asked."""
    full = [key[6:] for key in keys if key.startswith("alpha_") and f"omega_{key[6:]}" in keys]
    own = {f"{stem}_{link}" for stem in ("omega", "alpha") for link in full} if len(full) == 1 else set()
    return [key for key in keys if key in own or _is_output(study, key)]


def _centres(study: Study, keys: list[str]) -> Words:
    """Many instant centres by their number, and which of them lie at infinity: the places fill a table."""
    answers = [study.solution.answers[key] for key in keys if key in study.solution.answers]
    far = [f"${one.reading.symbol}$" for one in answers if one.exact_vector is None]
    count = len(answers)
    return Words(
        f"全部 {count} 个瞬心，位置列于 6.2" + (f"，其中 {'、'.join(far)} 在无穷远处" if far else ""),
        f"all {count} instant centres, with their positions in 6.2"
        + (f", {' and '.join(far)} at infinity" if far else ""),
    )


def _is_output(study: Study, key: str) -> bool:
    """Whether it is told of what the mechanism is for: an output link, a point on one, a load, the efficiency."""
    stem, _, of = key.partition("_")
    if stem in ("v", "a", "omega", "alpha"):
        return of in (*output_pins(study), *ends(study), *study.points)
    return stem not in ("an", "at", "ak", "ar", "R")


def _has_rates(study: Study) -> bool:
    return any(isinstance(ask.rel, Rel) and ask.rel.kind in RATES for ask in study.given.problem.asks)


def output_pins(study: Study) -> dict[str, str]:
    """The letters pinned to output blocks on the frame's guides, each with its block."""
    outputs = ends(study)
    return {
        j.pin: j.block
        for j in study.mech.joints
        if isinstance(j, Prismatic) and j.guide not in study.mech.bodies and j.block in outputs and j.pin
    }


def _asked(study: Study, key: str) -> Words | None:
    """$v_F$ = 0.319 m/s, to the left; None of what is neither drawn nor a column of the cycle."""
    answer = study.solution.answers.get(key)
    if answer is None:
        return _computed(study, key) if any(column.key == key for column in study.whole.columns) else None
    symbol, way = f"${answer.reading.symbol}$", _way(key)
    if answer.reading.unit == YES_NO or answer.undefined:
        name = Words(called(answer.reading.symbol, key, "zh"), called(answer.reading.symbol, key, "en"))
        return name + Words("：", ": ") + Words(value(answer.exact, YES_NO, "zh"), value(answer.exact, YES_NO, "en"))
    if answer.is_place:
        return _place(answer)
    if _nothing(study, answer):
        return Words.same(f"{symbol} {'=' if is_zero(answer) else '≈'} 0")
    block = output_pins(study).get(key.partition("_")[2]) if key[0] in "va" else None
    number = study.name(block) if block else ""
    name = Words(f"（构件 {number}）" if block else " ", f" (of link {number}) " if block else " ")
    return Words.same(symbol) + way + name + Words.same(f"= {_numbers(answer)}") + _sense(study, answer)


def _way(key: str) -> Words:
    """By which way it is found, where one is found by several: （虚功率法）."""
    way = None if key.startswith("R_") else way_of(key)
    return Words("", "") if way is None else Words(f"（{way.zh}）", f" ({way.en})")


def _place(answer: Answer) -> Words:
    """$F$ (−130.0, 164.4) mm; one at infinity by its direction."""
    symbol, drawn, exact = f"${answer.reading.symbol}$", answer.drawn_vector, answer.exact_vector
    if drawn is None or exact is None:
        turn = angle(answer.exact)
        return Words(f"{symbol} 在无穷远处，方向角 {turn}", f"{symbol} at infinity, at {turn} from $x$")
    return Words.same(f"{symbol} ({', '.join(place_parts(drawn, coordinates(answer)))}) mm")


def _numbers(answer: Answer) -> str:
    """The size as drawn, with the unit: what the sense tells has no sign."""
    drawn = drawn_number(answer)
    unit = unit_after(printed_unit(answer.reading.unit)[1]).replace("^2", "²")
    return (drawn.lstrip("−") if answer.turns else drawn) + unit


def _sense(study: Study, answer: Answer) -> Words:
    """Which way: the direction of a vector, the sense of what turns, the line along which a force is counted; of what
    reads as zero none."""
    if is_zero(answer):
        return Words("", "")
    fixed = direction_of_load(study.problem, answer.key)
    if answer.exact_vector is not None:
        return _COMMA + direction(answer.exact_vector)
    if fixed is not None:
        return _COMMA + direction(cmath.rect(1.0, fixed))
    return _COMMA + _turning(answer.exact) if answer.turns else Words("", "")


def _turning(size: float) -> Words:
    return Words("逆时针", "counter-clockwise") if size > 0 else Words("顺时针", "clockwise")


def _nothing(study: Study, answer: Answer) -> bool:
    """Whether it is nothing: beside its largest in the cycle, where it has one."""
    if any(column.key == answer.key for column in study.whole.columns) and _vanishes(
        study, answer.key, answer.exact, answer
    ):
        return True
    return abs(answer.exact) < 1e-9 * max(1.0, answer.expected_error) and is_zero(answer)


def is_zero(answer: Answer) -> bool:
    """Whether it reads as nothing but noughts: 0, 0.0."""
    return not drawn_number(answer).strip("−0.")


def _computed(study: Study, key: str) -> Words:
    """The same of what is not drawn, off the cycle."""
    info = study.whole.info(key)
    exact = complex(np.ravel(study.here.value(key))[0])
    size = abs(exact) if info.is_vector else exact.real
    if _vanishes(study, key, size, None):
        return Words.same(f"${info.symbol}$ ≈ 0")
    turns = key.partition("_")[0] in ("omega", "alpha")
    sense = (
        _COMMA + (direction(exact) if info.is_vector else _turning(size)) if info.is_vector or turns else Words("", "")
    )
    return Words.same(f"${info.symbol}$ = {shown(study, key, abs(size) if turns else size)}") + sense


def _vanishes(study: Study, key: str, size: float, answer: Answer | None) -> bool:
    """Whether a value is nothing beside its largest in the cycle."""
    found = study.extremes(key)
    top = max((abs(s.value) for s in (found.highest, found.lowest) if s is not None), default=0.0)
    return abs(size) < 1e-9 * top and (answer is None or abs(answer.drawn) < 1e-2 * top)


def direction(vector: complex) -> Words:
    """Along an axis in words, else the angle from +x."""
    turn = degrees(cmath.phase(vector))
    axis = next((a for a in _AXES if abs((turn - a + 180) % 360 - 180) < _NEAR), None)
    return (
        _AXES[axis] if axis is not None else Words(f"方向角 {bearing_told(turn)}", f"at {bearing_told(turn)} from $x$")
    )
