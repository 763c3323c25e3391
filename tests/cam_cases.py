"""Cams, trains and gears whose answers were worked out elsewhere, and how such a case is written as a device."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from vecpoly.board.construction import Construction
from vecpoly.board.hand import hand
from vecpoly.devices.base import Device, kind_of
from vecpoly.drawing.sheets.paper import DrawingPaper
from vecpoly.methods.devices.plan import construct_device
from vecpoly.oracle.devices.registry import device_answers
from vecpoly.problem.asked.asks import AskNamed
from vecpoly.problem.problem import Problem
from vecpoly.words import Words

CASES: dict[str, Any] = json.loads(
    (Path(__file__).resolve().parent / "data" / "cams-and-gears.json").read_text(encoding="utf-8")
)


def device(kind: str, **data: Any) -> Device:
    return kind_of(kind).model_validate(data)


def cam_of(case: str) -> Device:
    """A cam of the cases as `data:` would have it."""
    given = CASES[case]["inputs"]
    by = f"{given['swing_deg']} deg" if "swing_deg" in given else f"{given['h']} mm"
    motion = [_entry(one, by) for one in given["segments"]]
    follower: dict[str, Any] = {}
    if "OA" in given:
        follower["arm"] = {key: f"{given[key]} mm" for key in ("OA", "AB")}
    if given.get("offset"):
        follower["offset"] = f"{given['offset']} mm"
    end = {"roller": f"{given['roller']} mm"} if given.get("roller") else {"knife": "yes"}
    follower |= {"flat": "yes"} if case.startswith("flat") else end
    if "r0" in given:
        return device("cam", follower=follower, motion=motion, r0=f"{given['r0']} mm")
    allowed = {"rise": f"{given['alpha_allowed_rise']} deg", "return": f"{given['alpha_allowed_return']} deg"}
    return device("cam", follower=follower, motion=motion, alpha=allowed)


def _entry(one: Mapping[str, Any], by: str) -> str:
    if one["kind"].startswith("dwell"):
        return f"dwell {one['angle']} deg"
    return f"{f'rise {by}' if one['kind'] == 'rise' else 'return'} in {one['angle']} deg {one['law']}"


def drawn(subject: Device, by: str = "exact") -> Construction:
    asks = tuple(AskNamed(rel=named) for named in subject.quantities())
    problem = Problem(id="x", title=Words.same("x"), subject=subject, asks=asks)
    return construct_device(problem, hand(by), DrawingPaper())[0]


def agree(subject: Device, within: float = 1e-9) -> Mapping[str, float]:
    """Everything that may be asked, by the exact hand and by the oracle; gives what was drawn."""
    readings, exact = drawn(subject).readings, device_answers(subject)
    size = max(1.0, *(abs(value) for value in exact.values()))
    off = {key: (reading.scalar, exact[key]) for key, reading in readings.items()}
    assert set(off) == {named.key for named in subject.quantities()}
    wrong = {key: pair for key, pair in off.items() if not abs(pair[0] - pair[1]) <= within * max(size, 1.0)}
    assert not wrong, wrong
    return {key: reading.scalar for key, reading in readings.items()}


def mirrored(found: Mapping[str, float]) -> dict[str, float]:
    """The answers of a cam as its mirror image has them: θ goes round the other way."""
    return {key: 360.0 - value if key.startswith("theta_") else value for key, value in found.items()}
