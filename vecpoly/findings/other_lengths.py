"""Other lengths tried on the mechanism itself:
whether it still runs, with which transmission angles, and what becomes of its output."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import degrees

import numpy as np

from ..cycle import Cycle, Extremes, cycle, extremes, facts
from ..cycle.facts.found import Facts
from ..cycle.sample import sample
from ..errors import AssemblyError, VecpolyError
from ..foundation.slotted import replace
from ..mechanism.dimensions.set_out import stretched
from ..mechanism.model import Link, Mechanism, Prismatic
from ..words import Words
from .output_links import ends, motions
from .shown import shown
from .study.study import Study

_STATIONS = 720  # positions at which a mechanism is tried that does not run
_UNCHANGED = 1e-6  # of a value
_TENTH = 1e-3  # rad: a change of an angle worth a word


Ends = tuple[float, float]  # lowest and highest value


@dataclass(frozen=True, slots=True)
class Side:
    """A link's side to be made so long (m); the letter that moves, the other letters staying where they are beside
    `fast`."""

    link: str
    fast: str
    moved: str
    length: float


@dataclass(frozen=True, slots=True)
class Tried:
    """A mechanism with other lengths: its cycle and facts where it runs all round,
    else the share of the turn in which it cannot be assembled."""

    turn: Cycle | None
    facts: Facts | None
    lost: float = 0.0

    @property
    def least(self) -> dict[str, float]:
        """The least γ (rad) of every group, by its column."""
        return {t.key: t.least.value for t in self.facts.transmissions} if self.facts is not None else {}


def tried(study: Study, sides: tuple[Side, ...]) -> Tried | None:
    """The mechanism with these sides over the whole turn;
    None where it has what is not measured from its letters alone, or where its own position is none with these lengths
    or does not tell how it is assembled."""
    mech = study.mech
    changed = {side.link for side in sides}
    if (
        mech.contacts
        or mech.guesses
        or any(isinstance(j, Prismatic) and changed & {j.guide} for j in mech.joints)
        or mech.drive.link in changed
    ):
        return None
    links = tuple(_stretched(link, [side for side in sides if side.link == link.name]) for link in mech.links)
    other = replace(mech, links=links)
    try:
        turn = cycle(replace(study.problem, subject=other, loads=None, tables=()), n=len(study.entire.phi))
        if turn.whole:
            return Tried(turn, facts(turn))
    except VecpolyError:
        pass
    try:
        return Tried(None, None, _lost(other))
    except AssemblyError:
        return None


def _stretched(link: Link, sides: list[Side]) -> Link:
    """The link with each of these sides as long as asked."""
    for side in sides:
        link = stretched(link, side.fast, side.moved, side.length)
    return link


def _lost(mech: Mechanism) -> float:
    """The share of the turn in which it cannot be assembled. Raises AssemblyError where this cannot be told."""
    here = sample(mech, None, mech.drive.position + 2 * np.pi * np.arange(_STATIONS) / _STATIONS)
    sound = np.logical_and.reduce([np.isfinite(here.value(f"phi_{link.name}")) for link in mech.links])
    return float(1 - np.mean(sound))


def output_changes(study: Study, other: Tried) -> Iterator[Words]:
    """What becomes of the output links: swing or stroke, and the greatest rates, before and after."""
    assert other.turn is not None and other.facts is not None
    for link in ends(study):
        strokes = [f"s_{key.partition('_')[2]}" for key in motions(study, link) if key.startswith("v_")]
        told = {swing.key for swing in study.facts.swings}
        swings = [key for key in (f"phi_{link}", *strokes) if key in told]
        for key in (*swings, *motions(study, link)):
            before, after = _ends(study.extremes(key)), _ends(extremes(other.turn, key))
            if before and after and not _alike(before, after):
                yield (_swing if key in swings else _greatest)(study, key, before, after)
            elif after and not before:
                symbol = f"${study.whole.info(key).symbol}$"
                yield Words(f"{symbol} 不再恒定", f"{symbol} is no longer constant")


def _alike(before: Ends, after: Ends) -> bool:
    return all(abs(a - b) < _UNCHANGED * abs(b) for a, b in zip(after, before, strict=True))


def _ends(found: Extremes) -> Ends | None:
    return None if found.highest is None or found.lowest is None else (found.lowest.value, found.highest.value)


def _swing(study: Study, key: str, before: Ends, after: Ends) -> Words:
    symbol, angle = study.whole.info(key).symbol, key.startswith("phi")
    what = Words("总摆角" if angle else "行程", "swing" if angle else "stroke")
    old, new = (shown(study, key, high - low) for low, high in (before, after))
    return Words(
        f"${symbol}$ 的{what.zh}由 {old} 变为 {new}", f"the {what.en} of ${symbol}$ becomes {new} instead of {old}"
    )


def _greatest(study: Study, key: str, before: Ends, after: Ends) -> Words:
    symbol = study.whole.info(key).symbol
    old, new = (shown(study, key, max(abs(high), abs(low))) for low, high in (before, after))
    return Words(f"$|{symbol}|$ 最大值由 {old} 变为 {new}", f"the maximum $|{symbol}|$ {new} instead of {old}")


def trial(study: Study, ways: tuple[tuple[Side, ...], ...], own: str, change: Words, promised: float) -> Words:
    """What comes of a change that raises a group's own γ (its column) to so much (degrees), in every way in which the
    links' other letters may stay; nothing where it cannot be tried."""
    found = [tried(study, way) for way in ways]
    known = [one for one in found if one is not None]
    if len(known) < len(found):
        return Words.same("")
    told = Words(
        f"{change.zh}，这一杆组的最小传动角可提高到 {promised:.1f}°",
        f"{change.en[0].upper()}{change.en[1:]} would raise the minimum angle of this group to {promised:.1f}°",
    )
    return told + (_lost_told(known) or _worse_told(study, known[0], own) or _well_told(study, known[0], own))


def _lost_told(known: list[Tried]) -> Words | None:
    """In how many positions it cannot be assembled; None where it can in all of them."""
    lost = sorted({f"{100 * one.lost:.0f} %" for one in known if one.lost}, key=lambda text: float(text.split()[0]))
    if not lost:
        return None
    surely = all(one.lost for one in known)
    cannot = Words("有", "cannot") if surely else Words("可能有", "may fail to")
    span = Words.same(lost[0]) if len(lost) == 1 else Words(f"{lost[0]}～{lost[-1]}", f"{lost[0]} to {lost[-1]}")
    which = Words("（视杆上其余各点怎样取定而异）", " (as the other points of the links are laid down)")
    if len(lost) == 1 and surely:
        which = Words.same("")
    return Words(
        f"；但试算表明，其余尺寸不变时{cannot.zh} {span.zh} 的位置不能装配{which.zh}，须同时改变后续杆组的尺寸。",
        f"; but on trial, all else unchanged, the mechanism {cannot.en} be assembled in {span.en} of all "
        f"positions{which.en}: the groups that follow must be changed too.",
    )


def _worse_told(study: Study, one: Tried, own: str) -> Words | None:
    """The other groups whose γ falls; None where none does."""
    worse = [
        (study.whole.info(t.key).symbol, degrees(t.least.value), degrees(least))
        for t in study.facts.transmissions
        if t.key != own and (least := one.least.get(t.key, 0.0)) < min(np.radians(40.0), t.least.value) - _TENTH
    ]
    if not worse:
        return None
    zh = "、".join(f"${s}$ 的最小值由 {a:.1f}° 降为 {b:.1f}°" for s, a, b in worse)
    en = ", ".join(f"the least ${s}$ falls from {a:.1f}° to {b:.1f}°" for s, a, b in worse)
    return Words(
        f"；但试算表明，其余尺寸不变时 {zh}，须同时改变后续杆组的尺寸。",
        f"; but on trial, all else unchanged, {en}: the groups that follow must be changed too.",
    )


def _well_told(study: Study, one: Tried, own: str) -> Words:
    """The γ of the other groups, and what becomes of the output."""
    others = [
        (study.whole.info(key).symbol, degrees(value))
        for key, value in one.least.items()
        if key != own and value < np.pi / 2 - 1e-6
    ]
    rest = Words(
        "".join(f"，${s}$ 最小 {size:.1f}°" for s, size in others),
        "".join(f", ${s}$ is at least {size:.1f}°" for s, size in others),
    )
    results = list(output_changes(study, one)) or [
        Words("输出构件的运动不变", "the motion of the output links is unchanged")
    ]
    return Words(
        f"。试算（其余尺寸不变）：机构在全部位置均可装配{rest.zh}；" + "，".join(w.zh for w in results) + "。",
        ". On trial, all else unchanged, the mechanism can be assembled in all "
        f"positions{rest.en}; " + ", ".join(w.en for w in results) + ".",
    )
