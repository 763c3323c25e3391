"""What a found linkage does: built with the lengths read on paper and moved over its cycle by the exact solver."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import degrees, nan
from typing import Any

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
from ..grashof import grashof

LOOSE = 0.02  # of a length: an expected drawing error above which the construction is called ill-conditioned

RARE = 0.02  # of the repeated hands: so many may miss a grazing meeting without a word
NOTHING = 1e-6  # of the size of a linkage: a bar that is shorter is none


@dataclass(frozen=True, slots=True, kw_only=True)
class Verified:
    """One solution as it moves. driver: the letters of its input link. kind, margin (mm): of a four-bar.

    stroke: of the last link, in `unit` (° or mm). gamma, gamma_at: least transmission angle and the crank's angle there
    (deg). loose: key of each length of which the drawing tells less than 2 %, with what it may be off by. lost: the
    share of repeated hands that do not find it, where they are more than a few. assumed: what was not given, and is
    taken for it to be moved. broken: why it does not move. spoilt: what it is exactly, where it is of another type with
    the lengths read.
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
        stroke = {"swing_deg" if self.unit == "°" else "stroke_mm": self.stroke}
        ill = {"ill_conditioned": dict(self.loose)} if self.loose else {}
        moved = {"broken": self.broken.en} if self.broken else {"turns_fully": self.full, **kind, **told, **stroke}
        lost = {"not_found_share": self.lost} if self.lost else {}
        spoilt = {"spoilt": bare(self.spoilt.en)} if self.spoilt else {}
        return {"solution": self.number, **moved, **ill, **lost, **spoilt}


def linkage(design: Design, values: Mapping[str, float], name: str, title: Words | None = None) -> Problem | None:
    """The problem of a linkage with these lengths (mm), its crank as the input; None of a task that builds none."""
    data, called = design.built(values), title or Words.same(name)
    return None if data is None else made({"id": name, "title": {"zh": called.zh, "en": called.en}, **data})


def verified(
    design: Design, number: int, values: Mapping[str, float], spread: Mapping[str, float], lost: float = 0.0
) -> Verified | None:
    """What the linkage with the values that were read does; spread: what the hand may be off by in each of them; lost:
    the share of repeated hands that do not find it."""
    loose = {
        key: spread[key] / abs(values[key])
        for key in spread
        if design.is_length(key) and spread[key] > LOOSE * abs(values[key]) > 0
    }
    lost = lost if lost > RARE else 0.0
    if none := [key for key in values if design.is_length(key) and key.isupper() and not values[key] > 0]:
        return Verified(number=number, loose=loose, lost=lost, broken=_nothing(none))
    try:
        found = linkage(design, values, f"solution-{number}")
        if found is not None and (short := _vanishing(found.mechanism)):
            return Verified(number=number, loose=loose, lost=lost, broken=short)
        moved = None if found is None else _moved(number, values, loose, cycle(found.mechanism, 181))
        if moved is None:
            return None
        return replace(moved, lost=lost, assumed=design.assumed(values), spoilt=_spoilt(design, moved))
    except VecpolyError as error:
        return Verified(number=number, loose=loose, lost=lost, broken=error.words)


def _spoilt(design: Design, read: Verified) -> Words | None:
    """What the solution is by the closed form, where reading off the paper made a linkage of another type of it, or one
    whose driver does not turn."""
    known = exact(design)
    if not 0 < read.number <= len(known):
        return None
    values = known[read.number - 1]
    kind, margin = _type_of(values)
    same = kind is None or read.kind is None or kind.en == read.kind.en
    if same and read.full:
        return None
    found = linkage(design, values, "exactly")
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


def _type_of(values: Mapping[str, float]) -> tuple[Words | None, float]:
    """Of a four-bar with these lengths the type, and the margin of Grashof's condition (mm)."""
    lengths = [values[key] for key in ("AB", "BC", "CD", "AD") if key in values]
    return grashof(*lengths) if len(lengths) == 4 else (None, nan)


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


def _moved(number: int, values: Mapping[str, float], loose: Mapping[str, float], turn: Cycle) -> Verified:
    seen = facts(turn)
    kind, margin = _type_of(values)
    stroke, least = (seen.strokes or (None,))[-1], min((t.least for t in seen.transmissions), key=_value, default=None)
    angle = stroke is not None and stroke.key.startswith("phi")
    return Verified(
        number=number,
        driver="".join(turn.mech.link(turn.mech.drive.link).axis),
        full=turn.whole,
        kind=kind,
        margin=margin,
        ratio=stroke.ratio if stroke else nan,
        theta=degrees(stroke.theta) if stroke else nan,
        stroke=nan if stroke is None else degrees(stroke.swing) if angle else 1e3 * stroke.swing,
        unit="°" if angle else "mm",
        gamma=degrees(least.value) if least else nan,
        gamma_at=degrees(least.phi) % 360 if least else nan,
        loose=loose,
    )


def _value(spot: Any) -> float:
    return float(spot.value)
