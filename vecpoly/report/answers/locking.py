"""Whether a wedge locks by itself, said in words beside the limits that were asked for."""

from __future__ import annotations

from collections.abc import Mapping
from math import atan, degrees

from ...algebra.quantity import number
from ...devices.ring_spring import RingSpring
from ...devices.wedge_clamp import WedgeClamp
from ...devices.wedges import Wedges
from ...solution import Answer
from ...words import Words, begun

_EDGE = 1 + 1e-12  # at the limit itself it locks
_FIGURES = 3


def locking_of(subject: object, answers: Mapping[str, Answer]) -> Words | None:
    """The sentence that ends such a problem; nothing of other subjects."""
    match subject:
        case WedgeClamp():
            return _clamp(degrees(subject.alpha.si), degrees(atan(subject.f.si)))
        case RingSpring():
            return _spring(degrees(subject.alpha.si), degrees(atan(subject.f.si)))
        case Wedges() if {"phi", "lock_direct", "lock_reverse"} <= set(answers):
            return _pair(*(answers[key].drawn for key in ("phi", "lock_direct", "lock_reverse")))
        case _:
            return None


def _clamp(alpha: float, phi: float) -> Words:
    """α ≤ 2φ."""
    locks = alpha <= 2 * phi * _EDGE
    because = f"$α$ = {number(alpha, 4)}° {'≤' if locks else '>'} $2φ$ = {number(2 * phi, _FIGURES)}°"
    return Words(f"{'自锁' if locks else '不自锁'}，因 {because}。", f"{_locked(locks).capitalize()}, since {because}.")


def _spring(alpha: float, phi: float) -> Words:
    """α < 90° − φ; what cannot be pushed in is refused."""
    locks = alpha >= 90 - phi - 1e-9
    because = f"$α$ = {number(alpha, 4)}° {'≥' if locks else '<'} $90° − φ$ = {number(90 - phi, _FIGURES)}°"
    if locks:
        return Words(f"回弹行程自锁，因 {because}。", f"The release is self-locking, since {because}.")
    return Words(
        f"两个行程都不自锁，因 $φ$ = {number(phi, _FIGURES)}° < {because}。",
        f"Neither stroke is self-locking, since $φ$ = {number(phi, _FIGURES)}° < {because}.",
    )


def _pair(phi: float, direct: float, back: float) -> Words:
    """φ below the limits of lifting and of the return stroke, or not below."""
    said = [
        Words(
            f"{zh}{'自锁' if phi >= limit else '不自锁'}（$φ$ {'≥' if phi >= limit else '<'} ${symbol}$）",
            f"{en} is {_locked(phi >= limit)} ($φ$ {'≥' if phi >= limit else '<'} ${symbol}$)",
        )
        for zh, en, symbol, limit in (
            ("正行程", "lifting", "φ_{lim}", direct),
            ("反行程", "the return stroke", "φ'_{lim}", back),
        )
    ]
    return begun(Words("，".join(one.zh for one in said) + "。", ", ".join(one.en for one in said) + "."))


def _locked(locks: bool) -> str:
    return "self-locking" if locks else "not self-locking"
