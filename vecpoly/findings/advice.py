"""Where a group is poorly conditioned, what that is in the mechanism, and which lengths would mend it:
derived numbers."""

from __future__ import annotations

from collections.abc import Iterator
from math import atan, ceil, cos, degrees, hypot, radians, sqrt

import numpy as np

from ..algebra.quantity import number
from ..cycle import Spot
from ..mechanism.groups.assur import Dyad, decompose, pivot_of
from ..mechanism.model import FRAME, Revolute
from ..words import Words
from .conditioning import Conditioning
from .other_lengths import Side, trial
from .study.study import Study
from .transmission import least_places

_LEAST = radians(40.0)
_EQUAL = 1e-6


def advice(study: Study, one: Conditioning) -> Iterator[Words]:
    """What the least determinant of a group is in the mechanism, and how to raise it;
    nothing of a good group or of one of class III."""
    dyad = next((g.dyad for g in decompose(study.mech) if g.dyad is not None and g.links == one.group.links), None)
    if dyad is None or not one.is_poor:
        return
    if dyad.kind == "RPR":
        where = study.where(one.phi)
        square = (
            Words(
                "不计摩擦时滑块的力垂直于导路，传动角恒为 90°：这里的“较差”指运动方程和角速度，不指传力。"
                if not one.is_ill
                else "",
                " Without friction the block presses at right angles to the guide and the transmission angle is "
                "always 90°: the verdict concerns the equations and ω, not the transmission of force."
                if not one.is_ill
                else "",
            )
            if is_square(study, one)
            else Words.same("")
        )
        yield Words(
            f"{one.group.title.zh}：$|{one.symbol}|$ 为滑块销到导杆支点沿导路的距离，在 {where} 处最短，"
            f"为 {_mm(one.least)} mm，导杆的角速度与之成反比；要减小由此产生的峰值，须使导杆支点离滑块销的轨迹更"
            f"远，但导杆的转数和运动规律也随支点位置改变，须重新校核全循环。{square.zh}",
            f"{one.group.title.en}: $|{one.symbol}|$ is the distance of the block's pin from the "
            f"pivot of the guide along the guide. It is shortest, {_mm(one.least)} mm, at {where}, "
            "and the guide's ω is inversely proportional to it: to lower the peak there the pivot "
            "must be moved away from the path of the pin; but the turns and the motion of the guide "
            "change with the place of its pivot, and the whole cycle must be computed "
            f"again.{square.en}",
        )
    elif one.gamma is not None:
        yield _bars(study, one, dyad) if dyad.kind == "RRR" else _rod(study, one, dyad)


def is_square(study: Study, one: Conditioning) -> bool:
    """Whether the group's transmission angle is 90° in every position."""
    dyad = next((g.dyad for g in decompose(study.mech) if g.dyad is not None and g.links == one.group.links), None)
    if dyad is None or dyad.kind != "RPR":
        return False
    gamma = study.turn.real("gamma_" + "".join(one.group.links).replace("pin", ""))
    return bool(np.nanmax(np.abs(gamma - np.pi / 2), initial=0.0) < _EQUAL)


def _bars(study: Study, one: Conditioning, d: Dyad) -> Words:
    """An RRR group: the distance of its outer pins at the least γ,
    the range it has and may have, and the best equal lengths."""
    assert one.gamma is not None and isinstance(d.inner, Revolute)
    assert isinstance(d.outer_j, Revolute) and isinstance(d.outer_k, Revolute)
    p, c, q = d.outer_j.point, d.inner.point, d.outer_k.point
    first, second = study.mech.link(d.link_j).points, study.mech.link(d.link_k).points
    l1, l2 = abs(first[p] - first[c]), abs(second[q] - second[c])
    found = study.extremes(one.gamma.key)
    assert found.highest is not None and found.lowest is not None
    low, high = (sqrt(l1 * l1 + l2 * l2 - 2 * l1 * l2 * cos(spot.value)) for spot in (found.lowest, found.highest))
    least, most = (sqrt(l1 * l1 + l2 * l2 + sign * 2 * l1 * l2 * cos(_LEAST)) for sign in (-1, 1))
    best, equal = degrees(2 * atan(low / high)), hypot(low, high) / 2
    la, lb = (f"$l_{{{''.join(sorted(pair))}}}$" for pair in ((p, c), (q, c)))
    square = "$" + f"{la}^2 + {lb}^2 − 2 {la} {lb} cos γ".replace("$", "") + "$"
    if one.is_none:  # at a change point: its lengths are equal on purpose
        return _worst(study, one, d, (low, high))
    told = _worst(study, one, d, (low, high)) + Words(
        f"由 ${p}{q}^2$ = {square}，要使 $γ$ ≥ 40°，${p}{q}$ 须在 {_mm(least)} 至 {_mm(most)} mm 之间，"
        f"而现为 {_mm(low)} 至 {_mm(high)} mm。",
        f"By ${p}{q}^2$ = {square}, for $γ$ ≥ 40° ${p}{q}$ has to stay "
        f"between {_mm(least)} and {_mm(most)} mm; now it varies from {_mm(low)} to {_mm(high)} mm. ",
    )
    sizes = f"{la} = {lb} = {_mm(equal)} mm"
    if best < degrees(_LEAST):
        return told + Words(
            f"只改这两杆长，即使取 {sizes}，最小传动角也只有 2 arctan({_mm(low)}/{_mm(high)}) = {best:.1f}°，"
            f"仍小于 40°，还须改变其他尺寸以缩小 ${p}{q}$ 的变化范围。",
            f"Changing these two lengths alone gives 2 arctan({_mm(low)}/{_mm(high)}) = {best:.1f}° at best (with "
            f"{sizes}), still below 40°: other dimensions must change too, so that ${p}{q}$ varies less.",
        )
    size = float(_mm(equal)) / 1e3
    ways = tuple(
        (Side(d.link_j, *pair, size), Side(d.link_k, *other, size))
        for pair, other in (((c, p), (c, q)), ((p, c), (q, c)))
    )
    return told + trial(study, ways, one.gamma.key, Words(f"取 {sizes}", sizes), best)


def _worst(study: Study, one: Conditioning, d: Dyad, between: tuple[float, float]) -> Words:
    """How an RRR group stands at its least γ; between: least and greatest distance (m) of its outer pins."""
    assert one.gamma is not None and isinstance(d.inner, Revolute)
    assert isinstance(d.outer_j, Revolute) and isinstance(d.outer_k, Revolute)
    p, c, q = d.outer_j.point, d.inner.point, d.outer_k.point
    low, high = between
    lowest = study.extremes(one.gamma.key).lowest
    folded = lowest is not None and one.gamma.least.phi == lowest.phi
    what = Words("最短" if folded else "最长", "shortest" if folded else "longest")
    near = Words("", "") if one.is_none else Words("接近", "nearly ")
    how = near + (Words("重叠", "folded") if folded else Words("拉直", "stretched"))
    gamma, at = degrees(one.gamma.least.value), least_places(study, one.gamma)
    symbol, lines = study.whole.info(one.gamma.key).symbol, _in_line(study, d, one.gamma.least)
    grown = _magnified(study, one)
    return Words(
        f"{one.group.title.zh}：${symbol}$ 在 {at.zh} 处最小，为 {gamma:.1f}°，此时 ${p}{q}$ {what.zh}（"
        f"{_mm(low if folded else high)} mm{lines.zh}），${p}{c}$ 与 ${c}{q}$ {how.zh}，"
        f"{grown.zh}。",
        f"{one.group.title.en}: ${symbol}$ is least, {gamma:.1f}°, at {at.en}. There ${p}{q}$ is {what.en} "
        f"({_mm(low if folded else high)} mm{lines.en}), ${p}{c}$ and ${c}{q}$ are {how.en}, and "
        f"{grown.en}. ",
    )


def _magnified(study: Study, one: Conditioning) -> Words:
    """What errors come to at the least γ; at a change point, or at a dead point, they have no bound."""
    if one.is_none:
        what = Words("变点", "a change point") if study.entire.whole else Words("死点", "a dead point")
        return Words(
            f"此处机构处于{what.zh}，微小的误差就使位置、速度和加速度不能确定",
            f"the mechanism is at {what.en}: the least error leaves its position, velocities and accelerations open",
        )
    times = f"1/$sin γ$ = {one.times}"
    return Words(
        f"尺寸和读数的误差对位置的影响放大到 {times} 倍，对速度、加速度的影响更大",
        f"errors of lengths and readings are magnified {times} times in the position, and more in the velocities and "
        "accelerations",
    )


def _rod(study: Study, one: Conditioning, d: Dyad) -> Words:
    """An RRP group: the coupler's length that gives 40°."""
    assert one.gamma is not None and isinstance(d.outer_j, Revolute) and isinstance(d.inner, Revolute)
    p, c = d.outer_j.point, d.inner.point
    link = study.mech.link(d.link_j)
    length, gamma, at = abs(link.points[p] - link.points[c]), one.gamma.least.value, least_places(study, one.gamma)
    needed, symbol = 1e-6 * ceil(1e6 * length * cos(gamma) / cos(_LEAST)), study.whole.info(one.gamma.key).symbol
    line, grown = f"$l_{{{''.join(sorted(p + c))}}}$", _magnified(study, one)
    told = Words(
        f"{one.group.title.zh}：${symbol}$ 在 {at.zh} 处最小，为 {degrees(gamma):.1f}°，此时连杆 ${p}{c}$ "
        f"对导路偏斜最大，{grown.zh}。要使 $γ$ ≥ 40°，须 {line} ≥ {line}·$cos γ_{{min}}$/$cos 40°$ = {_mm(needed)} "
        f"mm（现为 {_mm(length)} mm）。",
        f"{one.group.title.en}: ${symbol}$ is least, {degrees(gamma):.1f}°, at {at.en}, where the "
        f"coupler ${p}{c}$ is inclined most; {grown.en}. $γ$ ≥ 40° "
        f"needs {line} ≥ {line}·$cos γ_{{min}}$/$cos 40°$ = {_mm(needed)} mm (now {_mm(length)} mm). ",
    )
    ways = tuple((Side(d.link_j, *pair, needed),) for pair in ((c, p), (p, c)))
    return told + trial(
        study,
        ways,
        one.gamma.key,
        Words(f"取 {line} = {_mm(needed)} mm", f"{line} = {_mm(needed)} mm"),
        degrees(_LEAST),
    )


def _in_line(study: Study, d: Dyad, spot: Spot) -> Words:
    """Crank and frame in one line, where the group hangs on a pivoted link and on the frame."""
    assert isinstance(d.outer_j, Revolute) and isinstance(d.outer_k, Revolute)
    (moving, parent), (fixed, other) = sorted(
        ((d.outer_j.point, d.parent_j), (d.outer_k.point, d.parent_k)), key=lambda pair: pair[1] == FRAME
    )
    pivot = pivot_of(study.mech, parent)
    if other != FRAME or not pivot:
        return Words.same("")
    at = complex(study.whole.at(f"p_{moving}", spot.phi))
    crank, frame = at - study.mech.frame[pivot], study.mech.frame[fixed] - study.mech.frame[pivot]
    if abs((crank.conjugate() * frame).imag) > _EQUAL * abs(crank) * abs(frame):
        return Words.same("")
    return Words(f"，${pivot}$、${moving}$、${fixed}$ 共线", f", ${pivot}$, ${moving}$ and ${fixed}$ being in one line")


def _mm(value: float) -> str:
    return number(round(1e3 * value, 9), 4)
