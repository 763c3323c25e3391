"""What is said of a found linkage when it has been moved: one sentence, and a caution where it was drawn in vain."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import isfinite

from ...words import Words
from ..grashof import CRANK_ROCKER, DOUBLE_CRANK
from .found import LOOSE, Verified

CANNOT = Words("不能整周转动", "cannot turn right round")


def told(one: Verified, alone: bool, *, given: bool = False) -> Words:
    """The line of verification of one solution; alone: there is no other. given: its lengths are, and none is read."""
    zh, en = ("", "") if alone else (f"解 {one.number}，", f" of solution {one.number}")
    if one.broken is not None:
        return Words(f"校核（{zh}按量得的长度）：", f"Check{en} with the lengths read: ") + Words(
            f"该解不能使用：{one.broken.zh}。", f"it cannot be used: {one.broken.en}."
        )
    lengths = Words("给定的杆长", "the given lengths") if given else Words("量得的长度", "the lengths read")
    own = Words("", "") if one.assumed is None else Words("和", " and ") + one.assumed
    head = Words(
        f"校核（{zh}按{lengths.zh}{own.zh}用解析法计算）：", f"Check{en}, computed with {lengths.en}{own.en}: "
    )
    parts = list(_parts(one))
    said = head + Words("，".join(part.zh for part in parts) + "。", ", ".join(part.en for part in parts) + ".")
    if one.spoilt is None:
        return said
    return said + Words(f"{one.spoilt.zh}。", f" But {one.spoilt.en}.")


def _parts(one: Verified) -> list[Words]:
    parts = []
    if one.kind is not None:
        parts.append(one.kind + _margin(one.margin))
    crank = one.kind in (CRANK_ROCKER, DOUBLE_CRANK)  # of the four-bar, to which what is added need not follow it
    added = Words("连同所加的杆组，", "with what is added ") if crank and not one.full else Words("", "")
    driver = added + Words(f"原动件 ${one.driver}$ ", f"the driver ${one.driver}$ ")
    parts.append(driver + (Words("可整周转动", "turns right round") if one.full else CANNOT))
    if isfinite(one.ratio):
        name = Words("摆角", "swing") if one.unit == "°" else Words("行程", "stroke")
        unit = one.unit if one.unit == "°" else " mm"
        parts.append(Words.same(f"$K$ = {one.ratio:.4f}"))
        parts.append(Words.same(f"$θ$ = {one.theta:.2f}°"))
        parts.append(name + Words(f" {one.stroke:.2f}{unit}", f" {one.stroke:.2f}{unit}"))
    if isfinite(one.gamma) and one.full:  # a rocker comes to its dead points at the ends of its range
        parts.append(
            Words(
                f"最小传动角 {one.gamma:.2f}°（曲柄转角 {one.gamma_at:.1f}° 处）",
                f"minimum transmission angle {one.gamma:.2f}° (crank at {one.gamma_at:.1f}°)",
            )
        )
    if isfinite(one.between):
        parts.append(
            Words(
                f"在给定各位置之间的最小传动角 {one.between:.2f}°",
                f"minimum transmission angle between the given positions {one.between:.2f}°",
            )
        )
    return parts


def _margin(by: float) -> Words:
    """How the sum of the shortest and the longest link compares with that of the others."""
    if not by:
        return Words(
            "（最短杆与最长杆之和等于其余两杆之和，机构有变点）",
            " (shortest and longest link together as long as the two others: it folds at its change points)",
        )
    margin = f"{abs(by):.4g} mm"
    return Words(
        f"（最短杆与最长杆之和比其余两杆之和{'大' if by < 0 else '小'} {margin}）",
        f" (shortest and longest link together {margin} {'more' if by < 0 else 'less'} than the two others)",
    )


def ill_conditioned(one: Verified, alone: bool) -> Words | None:
    """That some lengths hardly follow from the drawing; None where all do. alone: there is no other solution."""
    loose, lost = _loose(one, alone), _lost(one, alone)
    return loose + lost if loose and lost else loose or lost


def all_lost(every: Sequence[Verified]) -> list[Words]:
    """That some hands miss solutions; which lengths hardly follow from the drawing is marked where these are told."""
    some = [one for one in every if one.lost]
    if some and len(every) == 1:
        share = f"{100 * some[0].lost:.0f} %"
        return [
            Words(
                f"所给数据的微小误差即令解不存在：重复作图中有 {share} 得不到该解。",
                f"A small error in what is given loses the solution: {share} of the repeated drawings lack it.",
            )
        ]
    return [words for words in (_all_lost(some),) if words is not None]


def _symbol(key: str) -> str:
    """Of a length between two pins, or of an offset."""
    return f"l_{{{key}}}" if key.isupper() and len(key) > 1 else key


def _all_lost(some: Sequence[Verified]) -> Words | None:
    which = _alike((f"{100 * one.lost:.0f} %", one.number) for one in some if one.lost)
    if not which:
        return None
    zh, en = (
        "，".join(f"有 {s} 得不到{who.zh}" for s, who in which),
        ", ".join(f"{s} lack {who.en}" for s, who in which),
    )
    return Words(
        f"所给数据的微小误差即令解不存在：重复作图中{zh}。",
        f"A small error in what is given loses a solution: of the repeated drawings {en}.",
    )


def _alike(told: Iterable[tuple[str, int]]) -> list[tuple[str, Words]]:
    """What is said of solutions, and of which: 解 1、2, solutions 1 and 2."""
    found: dict[str, list[str]] = {}
    for said, number in told:
        found.setdefault(said, []).append(str(number))
    return [(said, Words(f"解 {'、'.join(of)}", _listed(of))) for said, of in found.items()]


def _listed(of: Sequence[str]) -> str:
    return f"solution {of[0]}" if len(of) == 1 else f"solutions {', '.join(of[:-1])} and {of[-1]}"


def _lost(one: Verified, alone: bool) -> Words | None:
    """That some hands do not find the solution at all."""
    if not one.lost:
        return None
    zh, en = ("该解", "The solution") if alone else (f"解 {one.number} ", f"Solution {one.number}")
    return Words(
        f"（{zh}在 {100 * one.lost:.0f} % 的重复作图中消失：所给数据的微小误差即令其不存在。）",
        f" ({en} vanishes in {100 * one.lost:.0f} % of the repeated drawings: a small error in what is given is "
        "enough.)",
    )


def _loose(one: Verified, alone: bool) -> Words | None:
    """That lengths hardly follow from the drawing."""
    if not one.loose:
        return None
    parts = ", ".join(f"${_symbol(key)}$" for key in one.loose)
    zh, en = ("", "") if alone else (f"（解 {one.number}）", f" (solution {one.number})")
    return Words(
        f"作图条件差{zh}：{parts.replace(', ', '、')} 的预期作图误差超过 {100 * LOOSE:g} %，宜用解析法求得。",
        f"Ill-conditioned construction{en}: the expected drawing error of {parts} is above {100 * LOOSE:g} %; find "
        f"{'it' if len(one.loose) == 1 else 'them'} by calculation.",
    )
