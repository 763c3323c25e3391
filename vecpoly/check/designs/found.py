"""What a found linkage does: built with the lengths read on paper and moved over its cycle by the exact solver."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import degrees, isfinite, nan
from typing import Any, Protocol

from ...cycle.cycle import Cycle
from ...cycle.facts.found import facts
from ...cycle.whole_cycle import cycle
from ...designs.base import Design
from ...errors import VecpolyError
from ...foundation.slotted import replace
from ...mechanism.model import Mechanism
from ...problem.problem import Problem
from ...problem.values.made import problem as made
from ...words import Words, bare
from ..candidates import exact
from .four_bars import type_of
from .working import least_between

LOOSE = 0.02  # of a length: an expected drawing error above which the construction is called ill-conditioned

RARE = 0.02  # of the repeated hands: so many may miss a grazing meeting without a word
NOTHING = 1e-6  # of the size of a linkage: a bar that is shorter is none


@dataclass(frozen=True, slots=True, kw_only=True)
class Verified:
    """One solution as it moves. driver: the letters of its input link. kind, margin (mm): of a four-bar.

    stroke: of the last link, in `unit` (° or mm). gamma, gamma_at: least transmission angle and the crank's angle there
    (deg). between: of one that does not turn right round the least transmission angle from the first of the given
    positions to the last. loose: key of each length of which the drawing tells less than 2 %, with what it may be off
    by. lost: the share of repeated hands that do not find it, where they are more than a few. assumed: what was not
    given, and is taken for it to be moved. broken: why it does not move. spoilt: what it is exactly, where it is of
    another type with the lengths read.
    """

    number: int
    driver: str = ""
    full: bool = False
    kind: Words | None = None
    margin: float = nan
    ratio: float = nan
    theta: float = nan
    stroke: float = nan
    unit: str = ""
    gamma: float = nan
    gamma_at: float = nan
    between: float = nan
    loose: Mapping[str, float]
    lost: float = 0.0
    assumed: Words | None = None
    broken: Words | None = None
    spoilt: Words | None = None

    def as_json(self) -> dict[str, Any]:
        """Plain data; lengths in mm, angles in degrees."""
        kind = {} if self.kind is None else {"type": self.kind.plain.en, "grashof_margin_mm": self.margin}
        told = {
            "K": self.ratio,
            "theta_deg": self.theta,
            "gamma_min_deg": self.gamma,
            "gamma_min_at_deg": round(self.gamma_at, 9) % 360,  # 3e-13 is the rounding of a whole turn
        }
        told |= {"gamma_min_between_positions_deg": self.between} if isfinite(self.between) else {}
        stroke = {"swing_deg" if self.unit == "°" else "stroke_mm": self.stroke}
        ill = {"ill_conditioned": dict(self.loose)} if self.loose else {}
        moved = {"broken": self.broken.en} if self.broken else {"turns_fully": self.full, **kind, **told, **stroke}
        lost = {"not_found_share": self.lost} if self.lost else {}
        spoilt = {"spoilt": bare(self.spoilt.en)} if self.spoilt else {}
        return {"solution": self.number, **moved, **ill, **lost, **spoilt}


class AsRead(Protocol):
    """A solution as it is read off the paper: its number, its pins in all positions, values and what the hand may be
    off by in each; last: whether its last link drives it; lost: the share of repeated hands that do not find it."""

    @property
    def number(self) -> int: ...
    @property
    def pins(self) -> Mapping[str, complex]: ...
    @property
    def values(self) -> Mapping[str, float]: ...
    @property
    def spread(self) -> Mapping[str, float]: ...
    @property
    def last(self) -> bool: ...
    @property
    def lost(self) -> float: ...


def linkage(
    design: Design, values: Mapping[str, float], name: str, title: Words | None = None, *, last: bool = False
) -> Problem | None:
    """The problem of a linkage with these lengths (mm), its crank as the input, or where only its last link drives it
    that; None of a task that builds none."""
    data, called = design.driven_last(values) if last else design.built(values), title or Words.same(name)
    return None if data is None else made({"id": name, "title": {"zh": called.zh, "en": called.en}, **data})


def verified(design: Design, one: AsRead) -> Verified | None:
    """What the linkage of a candidate does, built with the values that were read."""
    number, values, spread = one.number, one.values, one.spread
    loose = {
        key: spread[key] / abs(values[key])
        for key in spread
        if design.is_length(key) and spread[key] > LOOSE * abs(values[key]) > 0
    }
    lost = one.lost if one.lost > RARE else 0.0
    if none := [key for key in values if design.is_length(key) and key.isupper() and not values[key] > 0]:
        return Verified(number=number, loose=loose, lost=lost, broken=_nothing(none))
    try:
        found = linkage(design, values, f"solution-{number}", last=one.last)
        if found is not None and (short := _vanishing(found.mechanism)):
            return Verified(number=number, loose=loose, lost=lost, broken=short)
        if found is None:
            return None
        turn = cycle(found.mechanism, 181)
        moved = replace(_moved(design, one, loose, turn), lost=lost, assumed=design.assumed(values))
        return replace(moved, spoilt=_spoilt(design, moved, last=one.last))
    except VecpolyError as error:
        return Verified(number=number, loose=loose, lost=lost, broken=error.words)


def _spoilt(design: Design, read: Verified, *, last: bool) -> Words | None:
    """What the solution is by the closed form, where reading off the paper made a linkage of another type of it, or one
    whose driver does not turn."""
    known = exact(design)
    if not 0 < read.number <= len(known):
        return None
    values = known[read.number - 1]
    kind, margin = type_of(design, values)
    same = kind is None or read.kind is None or kind.en == read.kind.en
    if same and read.full:
        return None
    found = linkage(design, values, "exactly", last=last)
    turns = found is not None and cycle(found.mechanism, 181).whole
    if same and turns == read.full:
        return None
    told = [f"$l_{{{key}}}$ = {values[key]:.5g} mm" for key in ("AB", "BC", "CD", "AD") if key in values]
    what = Words("", "") if kind is None else kind + Words(f"（裕量 {margin:.3g} mm）", f" (by {margin:.3g} mm)")
    turn = Words("原动件可整周转动", "its driver turns right round") if turns else Words("", "")
    parts = [part for part in (what, turn) if part.en]
    return Words(
        f"准确作图时为{'，'.join(part.zh for part in parts)}，按量得的长度则不是，该解不能按量得值采用："
        f"应取计算值 {'、'.join(told)}",
        f"with the exact lengths it is: {', '.join(part.en for part in parts)}; with those read it is not: they are "
        f"of no use. Computed are {', '.join(told)}",
    )


def _nothing(keys: Sequence[str]) -> Words:
    """That no length is left of what is read on paper."""
    zh, en = "、".join(f"$l_{{{key}}}$" for key in keys), ", ".join(f"$l_{{{key}}}$" for key in keys)
    return Words(f"{zh} 量得为零", f"nothing is left of {en} as read")


def _vanishing(mech: Mechanism) -> Words | None:
    """That a bar is nothing beside the others: no linkage of such lengths moves as a linkage."""
    bars = [tuple(link.points.items())[:2] for link in mech.links if len(link.points) > 1]
    bars += [tuple(mech.frame.items())[:2]] if len(mech.frame) > 1 else []
    for (one, start), (other, end) in bars:
        if abs(end - start) < NOTHING * mech.scale:
            return Words(f"{one}{other} 与其余构件相比过短", f"{one}{other} is nothing beside the other links")
    return None


def _moved(design: Design, one: AsRead, loose: Mapping[str, float], turn: Cycle) -> Verified:
    seen = facts(turn)
    kind, margin = type_of(design, one.values)
    driver = "".join(turn.mech.link(turn.mech.drive.link).axis)
    stroke, least = (seen.strokes or (None,))[-1], min((t.least for t in seen.transmissions), key=_value, default=None)
    angle = stroke is not None and stroke.key.startswith("phi")
    return Verified(
        number=one.number,
        driver=driver,
        full=turn.whole,
        kind=kind,
        margin=margin,
        ratio=stroke.ratio if stroke else nan,
        theta=degrees(stroke.theta) if stroke else nan,
        stroke=nan if stroke is None else degrees(stroke.swing) if angle else 1e3 * stroke.swing,
        unit="°" if angle else "mm",
        gamma=degrees(least.value) if least else nan,
        gamma_at=degrees(least.phi) % 360 if least else nan,
        between=nan if turn.whole else degrees(least_between(turn, one.pins, driver)),
        loose=loose,
    )


def _value(spot: Any) -> float:
    return float(spot.value)
