"""What is given of a mechanism, with what is told of a datum beside its number: that the drive is uniform, in which
sense it speeds up, from which ray an angle of a link is measured."""

from __future__ import annotations

import re
from collections.abc import Sequence

from ...foundation.slotted import replace
from ...mechanism.model import Mechanism
from ...names import Kind, Rel
from ...problem.problem import Problem
from ...problem.values.given import Datum
from ...units.patterns import SENSE
from ...words import Lang, Words

_SENSED = re.compile(rf"\s*{SENSE}$")
_ACCELERATIONS = (Kind.A, Kind.ALPHA)
_SIZED = re.compile(r"(\d+(?:\.\d+)?) ?(?=°|mm|g\b|kg|N\b)")
_RATES, _ANGULAR = ("ω_", "v_"), "α_"
_UNIFORM, _CCW = Words("匀速", "constant"), Words("逆时针", "counter-clockwise")
_CCW_POSITIVE = Words("以逆时针为正", "positive counter-clockwise")
_FRICTION = (  # before the first of its kind
    ("ρ_", Words("摩擦圆半径 ", "radius of the friction circle ")),
    ("φ_", Words("摩擦角 ", "friction angle ")),
)


def given_data(problem: Problem) -> tuple[Datum, ...]:
    """All that is given, in the order in which it is printed; of a device as it is."""
    data = problem.given.data
    if not isinstance(problem.subject, Mechanism):
        return tuple(one for one in data if not _is_said(one, problem.statement))
    uniform = _is_uniform(problem, problem.subject)
    return tuple(_told(one, problem, uniform) for one in data if not _needless(one, problem))


def _is_said(one: Datum, statement: Words | None) -> bool:
    """Whether the statement says what is given in words: it has all sizes in them."""
    if one.words is None or statement is None:
        return False
    both = ((one.words.zh, statement.zh), (one.words.en, statement.en))
    return all(_sizes(words) and _sizes(words) <= _sizes(text) for words, text in both)


def _sizes(text: str) -> frozenset[float]:
    return frozenset(float(found) for found in _SIZED.findall(text))


def _needless(one: Datum, problem: Problem) -> bool:
    """How fast a slider drives, where only curvatures are asked: they are the same at any speed."""
    return problem.curvature is not None and one.symbol.startswith("v_") and one in problem.given.motion


def _told(one: Datum, problem: Problem, uniform: bool) -> Datum:
    if one.words is not None or one.table is not None:
        return one
    if one in problem.given.motion:
        if uniform and one.symbol.startswith(_RATES):
            return _beside(one, _UNIFORM)
        if one.symbol.startswith(_ANGULAR) and one.si and not _SENSED.search(one.text):
            return _beside(one, _CCW if one.si > 0 else _CCW_POSITIVE)
    if one.symbol.startswith("∠") and len(one.symbol) == len("∠ABC"):
        ray, side = (f"${one.symbol[2]}{one.symbol[at]}$" for at in (1, 3))
        return _beside(one, Words(f"自 {ray} 逆时针量至 {side}", f"counter-clockwise from {ray} to {side}"))
    return one


def _beside(one: Datum, remark: Words) -> Datum:
    """The datum with a remark in brackets, behind the sense of turning where it has one."""
    zh, en = one.of("zh"), one.of("en")
    return replace(one, words=Words(_bracketed(zh, remark.zh, "，", "（）"), _bracketed(en, remark.en, ", ", "()")))


def _bracketed(text: str, remark: str, comma: str, brackets: str) -> str:
    opening, closing = brackets[0], brackets[1]
    if text.endswith(closing):
        return f"{text[:-1]}{comma}{remark}{closing}"
    return f"{text}{'' if opening == '（' else ' '}{opening}{remark}{closing}"


def _is_uniform(problem: Problem, mech: Mechanism) -> bool:
    """Whether accelerations are asked, or inertia acts, and the drive has none; a machine runs as it is moved."""
    if problem.machine is not None or any(drive.accel for drive in mech.drives):
        return False
    if any(one.symbol.startswith(("α", "a_", "a^")) for one in problem.given.motion):
        return False  # it is given as 0
    loads = problem.loads
    inertia = loads is not None and any(mass.inertia for mass in loads.masses)
    return inertia or any(isinstance(ask.rel, Rel) and ask.rel.kind in _ACCELERATIONS for ask in problem.asks)


def friction_heads(problem: Problem, data: Sequence[Datum], lang: Lang) -> dict[str, str]:
    """By its symbol, what the first radius of a friction circle, and the first angle of friction, is called."""
    if not isinstance(problem.subject, Mechanism):
        return {}
    acting = [one.symbol for one in data if one in problem.given.loads and one.words is None]
    firsts = ((next((s for s in acting if s.startswith(letter)), None), words) for letter, words in _FRICTION)
    return {symbol: words.of(lang) for symbol, words in firsts if symbol is not None}
