"""Chapters 8 and 9, the analysis in words and the conclusion: generated from the facts of the cycle."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import degrees
from typing import Any

import numpy as np

from ...cycle import Extremes, Spot, sentences
from ...cycle.facts import Peak
from ...mechanism.assur import decompose
from ...mechanism.mobility import mobility
from ...quantity import number
from ...words import Words
from .comparison import Compared
from .model.equations import GroupModel
from .numbering import Press
from .study import Study

_NEAR = np.radians(20.0)
_FEW = 4  # values told where nothing is remarkable
_SECOND = 0.5  # of the greatest value: a second peak worth a word
_SHORT = 0.35  # of its largest value: a determinant so small is worth a word


@dataclass(frozen=True, slots=True)
class Conditioning:
    """How a group's determinant varies over the cycle: least and largest absolute value, and where the least stands."""

    group: GroupModel
    least: float
    largest: float
    phi: float

    @property
    def ratio(self) -> float:
        return self.least / self.largest if self.largest else 0.0


def conditioning(study: Study) -> list[Conditioning]:
    """One entry a group whose determinant changes."""
    values = study.model.values(study.turn.phi)
    found = []
    for group in study.model.groups:
        if group.determinant is None:
            continue
        with np.errstate(invalid="ignore"):
            sizes = np.abs(np.broadcast_to(np.asarray(group.determinant.value(values), np.float64), study.turn.phi.shape))
        if np.isfinite(sizes).any() and np.nanmax(sizes) > 0:
            k = int(np.nanargmin(sizes))
            found.append(Conditioning(group, float(sizes[k]), float(np.nanmax(sizes)), float(study.turn.phi[k])))
    return found


def chapter(study: Study, press: Press, drawn: Compared) -> dict[str, Any]:
    """Lists of sentences: how it moves, extremes with their causes, conditioning of the groups; and the conclusion."""
    groups = conditioning(study)
    return {
        "motion": [w.of(press.lang) for w in sentences(study.entire, study.facts) if w.of(press.lang)],
        "extremes": [w.of(press.lang) for w in _extremes(study, groups)],
        "conditioning": [_conditioned(study, one).of(press.lang) for one in groups],
        "conclusion": [w.of(press.lang) for w in _conclusion(study, groups, drawn)],
    }


def _extremes(study: Study, groups: list[Conditioning]) -> Iterator[Words]:
    """Where the quantities asked for are greatest, those with the same cause in one sentence; then their second peaks."""
    found: dict[str, list[Words]] = {}
    for key in (*study.outputs, *study.forces[:1]):
        for rank, spot in enumerate(_tops(study, study.extremes(key))):
            cause = _cause(study, key, spot, groups)
            found.setdefault(cause.group.title.en if cause else "", []).append(_told(study, key, spot, rank))
    for group in groups:
        if told := found.get(group.group.title.en):
            name, where = group.group.title, study.where(group.phi)
            yield _listed(told) + Words(
                f"。这些峰值都在 {where} 附近，该处 {name.zh}的求解行列式最小，仅为其最大值的 {100 * group.ratio:.0f} %，同样的外副运动在此引起较大的从动速度和加速度。",
                f". All near {where}, where the determinant of the {name.en} is smallest, {100 * group.ratio:.0f} % of its largest value: the same motion of the outer joints causes large rates there.")
    told = found.get("", [])
    if told and len(found) > 1:
        yield Words("其余各量的极值（见极值表）不在任何杆组的奇异位置附近，属于机构的正常运动。",
                    "The other extreme values (see the table of extreme values) stand near no singular position of a group; they belong to the ordinary course of the motion.")
    elif told:
        yield _listed(told[-_FEW:]) + Words("。各极值均不在任何杆组的奇异位置附近，属于机构的正常运动。",
                                           ". No extreme value stands near a singular position of a group; they belong to the ordinary course of the motion.")


def _tops(study: Study, found: Extremes) -> list[Spot]:
    """The greatest absolute value, and a second peak of more than half of it farther away."""
    every = [s for s in (*found.maxima, *found.minima, found.highest, found.lowest) if s is not None]
    if found.is_constant or not every:
        return []
    top = max(every, key=lambda s: abs(s.value))
    if top.end:
        return []
    peaks = found.maxima if top.value > 0 else found.minima
    others = [s for s in peaks if abs(s.value) > _SECOND * abs(top.value) and s.value * top.value > 0 and _apart(study, s.phi, top.phi) > 2 * _NEAR]
    return [top, *sorted(others, key=lambda s: -abs(s.value))[:1]]


def _told(study: Study, key: str, spot: Spot, rank: int) -> Words:
    """|α_5| is greatest, 736.2 rad/s², at φ_1 = 101.4° (2.8 times its rms)."""
    info, rms = study.whole.info(key), float(np.sqrt(np.nanmean(study.turn.real(key) ** 2)))
    unit = info.shown_unit.replace("^2", "²")
    value, times = f"{number(info.factor * abs(spot.value), 4)} {unit}".strip(), f"{abs(spot.value) / rms:.1f}" if rms else "—"
    where = study.where(spot.phi)
    if rank:
        return Words(f"$|{info.symbol}|$ 在 {where} 处另有一峰值 {value}", f"$|{info.symbol}|$ has a second peak, {value}, at {where}")
    return Words(f"$|{info.symbol}|$ 在 {where} 处最大，为 {value}（均方根值的 {times} 倍）", f"$|{info.symbol}|$ is greatest at {where}, {value} ({times} times its rms)")


def _listed(told: list[Words]) -> Words:
    return Words("；".join(w.zh for w in told), "; ".join(w.en for w in told))


def _cause(study: Study, key: str, spot: Spot, groups: list[Conditioning]) -> Conditioning | None:
    """The group whose determinant is near its least value there, and small."""
    near = [g for g in groups if g.ratio < _SHORT and _apart(study, g.phi, spot.phi) < _NEAR and _depends(study, key, g)]
    return min(near, key=lambda g: g.ratio, default=None)


def _depends(study: Study, key: str, one: Conditioning) -> bool:
    """Whether the quantity belongs to the group or to one solved after it."""
    order = [group.links for group in study.model.groups]
    owner = key.partition("_")[2]
    index = next((i for i, links in enumerate(order) if owner in links or any(owner in study.mech.link(link).points for link in links)), len(order) - 1)
    return index >= order.index(one.group.links)


def _apart(study: Study, one: float, other: float) -> float:
    gap = abs(one - other)
    return min(gap, abs(2 * np.pi - gap)) if study.whole.whole else gap


def _conditioned(study: Study, one: Conditioning) -> Words:
    name, share = one.group.title, f"{100 * one.ratio:.1f} %"
    if one.ratio > 1 - 1e-9:
        return Words(f"{name.zh}：求解行列式为常数，全循环条件良好。", f"{name.en}: the determinant is constant; the group is well-conditioned throughout.")
    if one.ratio < 0.1:
        verdict = Words("接近奇异，此处杆组病态，尺寸和读数的微小误差都会被放大", "close to singular: the group is ill-conditioned there and small errors of lengths and readings are magnified")
    elif one.ratio < _SHORT:
        verdict = Words("此处条件较差", "the conditioning is poor there")
    else:
        verdict = Words("全循环条件良好", "the group is well-conditioned throughout")
    return Words(f"{name.zh}：求解行列式的绝对值在 {study.where(one.phi)} 处最小，为其最大值的 {share}，{verdict.zh}。",
                 f"{name.en}: the determinant is smallest at {study.where(one.phi)}, {share} of its largest value; {verdict.en}.")


def _conclusion(study: Study, groups: list[Conditioning], drawn: Compared) -> Iterator[Words]:
    """What a reader takes home, each item one sentence."""
    count, dyads = mobility(study.mech), decompose(study.mech)
    kinds = "、".join(g.kind for g in dyads)
    level = Words("Ⅱ 级机构", "a class II mechanism") if all(g.dyad for g in dyads) else Words("含高级杆组的机构", "a mechanism with groups of a higher class")
    yield Words(f"机构自由度 $F$ = {count.freedom}，由原动件和 {kinds} 杆组组成，属{level.zh}；主动件运动给定后各构件运动确定。",
                f"The mechanism has $F$ = {count.freedom} and consists of the driving link and the groups {kinds.replace('、', ', ')}: {level.en}, whose motion the drive determines.")
    for stroke in study.facts.strokes:
        info = study.whole.info(stroke.key)
        swing = f"{number(info.factor * stroke.swing, 4)}{'°' if info.shown_unit == '°' else ' ' + info.shown_unit}"
        quick = Words(f"行程速比系数 $K$ = {stroke.ratio:.3f}", f"quick-return ratio $K$ = {stroke.ratio:.3f}") if stroke.theta > 1e-9 else Words("无急回特性", "no quick return")
        yield Words(f"输出 ${info.symbol}$ 往复运动，行程 {swing}，{quick.zh}。", f"The output ${info.symbol}$ goes to and fro over {swing}, {quick.en}.")
    yield from _range(study)
    peaks = [peak for peak in study.facts.peaks if peak.key in study.outputs] or list(study.facts.peaks)
    if peaks:
        yield _peaked(study, max(peaks, key=lambda peak: abs(peak.spot.value) / peak.rms))
    poor = [t for t in study.facts.transmissions if t.is_poor]
    if poor:
        worst = min(poor, key=lambda t: t.least.value)
        symbol = study.whole.info(worst.key).symbol
        yield Words(f"最小传动角 ${symbol}$ = {degrees(worst.least.value):.1f}°（{study.where(worst.least.phi)}），小于通常要求的 40°，传力性能差。",
                    f"The least transmission angle, ${symbol}$ = {degrees(worst.least.value):.1f}° at {study.where(worst.least.phi)}, is below the usual 40°: force is transmitted poorly there.")
    if drawn.stations and drawn.keys:
        yield Words(f"在 {len(drawn.stations)} 个位置作图所得结果与解析结果的偏差不超过各量最大值的 {100 * drawn.worst(study):.2f} %，两种方法互相印证。",
                    f"Drawings at {len(drawn.stations)} positions agree with the analysis within {100 * drawn.worst(study):.2f} % of each quantity's largest value: both methods confirm each other.")


def _range(study: Study) -> Iterator[Words]:
    """The ranges of the angular velocities asked for, and which change sign, in one sentence."""
    zh, en = [], []
    for key in (k for k in study.outputs if k.startswith("omega_")):
        found, info = study.extremes(key), study.whole.info(key)
        if found.highest is None or found.lowest is None:
            continue
        low, high = (number(info.factor * spot.value, 4) for spot in (found.lowest, found.highest))
        same = found.highest.value * found.lowest.value > 0
        zh.append(f"${info.symbol}$ 在 {low} 至 {high} {info.shown_unit} 之间变化，" + ("转向不变" if same else "转向随位置改变"))
        en.append(f"${info.symbol}$ varies from {low} to {high} {info.shown_unit} " + ("without change of sense" if same else "and changes its sense"))
    if zh:
        yield Words("；".join(zh) + "。", "; ".join(en) + ".")


def _peaked(study: Study, peak: Peak) -> Words:
    info = study.whole.info(peak.key)
    value, times = number(abs(info.factor * peak.spot.value), 4), abs(peak.spot.value) / peak.rms
    unit = info.shown_unit.replace("^2", "²")
    return Words(f"$|{info.symbol}|$ 在 {study.where(peak.spot.phi)} 处达 {value} {unit}，为均方根值的 {times:.1f} 倍，有冲击倾向，高速时应校核惯性载荷。",
                 f"$|{info.symbol}|$ reaches {value} {unit} at {study.where(peak.spot.phi)}, {times:.1f} times its rms: an impact-like peak, so inertia loads should be checked at speed.")
