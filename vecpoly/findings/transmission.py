"""What the transmission angles of a mechanism are, and where the least one stands."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees, radians

import numpy as np
import numpy.typing as npt

from ..cycle.facts.transmission_range import ABOUT, USUAL, Transmission
from ..mechanism.groups.assur import Dyad, decompose
from ..mechanism.model import Mechanism, Revolute
from ..words import Words
from .shown import span
from .study.study import Study

_EQUAL = 1e-6  # rad


def transmission(study: Study, told: Sequence[Transmission]) -> Words:
    """For every dyad which angle it is, its formula, its minimum value and the verdict."""
    dyads = {group.label: group.dyad for group in decompose(study.mech) if group.dyad is not None}
    said = [_one(study, t, dyads[t.links]) for t in told if t.links in dyads]
    right = {t.links for t in study.facts.transmissions if t.least.value > radians(90.0) - 1e-6}
    square = [d for links, d in dyads.items() if d.kind == "RPR" and links in right]
    if square:
        links = [f"{study.name(d.link_j)}、{study.name(d.link_k)}" for d in square]
        said.append(
            Words(
                f"由构件 {'；'.join(links)} 组成的 RPR 杆组，不计摩擦时滑块对导杆的力垂直于导路，导杆的压力角恒为 "
                "0°（传动角恒为 90°）。",
                f"In the RPR group of links {'; '.join(links).replace('、', ' and ')} the block "
                "presses at right angles to the guide when friction is neglected: the pressure "
                "angle of the swinging guide is always 0°.",
            )
        )
    return Words("".join(w.zh for w in said), " ".join(w.en for w in said))


def _one(study: Study, t: Transmission, d: Dyad) -> Words:
    symbol = f"${study.whole.info(t.key).symbol}$"
    what, least, most = _defined(study.mech, d, symbol), degrees(t.least.value), degrees(t.greatest.value)
    verdict, where = _judged(least), least_places(study, t)
    top = (
        _square(study, t)
        if most > 90.0 - 1e-6
        else Words(
            f"；最大为 {most:.1f}°（{study.where(t.greatest.phi)}）",
            f"; its greatest is {most:.1f}° at {study.where(t.greatest.phi)}",
        )
    )
    return Words(
        f"{what.zh}最小传动角为 {least:.1f}°（{where.zh}），{verdict.zh}{top.zh}。",
        f"{what.en} Its minimum value is {least:.1f}° at {where.en}, {verdict.en}{top.en}.",
    )


def _square(study: Study, t: Transmission) -> Words:
    """How often the angle is 90°, its maximum value."""
    off = study.turn.real(t.key) - radians(90.0)
    off = off[np.isfinite(off) & (off != 0.0)]
    side = np.sign(off)
    ring = np.append(side, side[:1]) if study.whole.whole and _closes(off) else side
    times = int(np.count_nonzero(ring[1:] != ring[:-1]))
    if not times:
        return Words("；最大为 90°", "; its greatest is 90°")
    often = {1: "once", 2: "twice"}.get(times, f"{times} times")
    return Words(
        f"；{span(study).zh}内有 {times} 次达到最大值 90°",
        f"; it reaches 90°, its greatest, {often} {'a' if study.whole.whole else 'within the'} {span(study).en}",
    )


def _closes(values: npt.NDArray[np.float64]) -> bool:
    """Whether a curve ends where it began: that of a pinion on a rack does not after a turn."""
    steps = np.abs(np.diff(values))
    return bool(steps.size) and abs(float(values[-1] - values[0])) <= 2.0 * float(steps.max())


def _judged(least: float) -> Words:
    """A least angle (degrees) beside the usual bound; what rounds to it is no fault that a change could mend."""
    if least < ABOUT:
        return Words(
            "小于许用值 [$γ$] = 40°，传力性能较差", "below the usual bound of 40°: force is transmitted poorly there"
        )
    if least < USUAL:
        return Words("约等于许用值 [$γ$] = 40°，传力性能合格", "about the usual bound of 40°, which is acceptable")
    return Words("大于许用值 [$γ$] = 40°，传力性能良好", "above the usual bound of 40°: force is transmitted well")


def least_places(study: Study, t: Transmission) -> Words:
    """All the places of the least γ: symmetrical mechanisms have two."""
    found = study.extremes(t.key)
    spots = sorted(
        study.reduced(s.phi)
        for s in (*found.minima, *found.maxima, t.least)
        if abs(min(s.value, radians(180.0) - s.value) - t.least.value) < _EQUAL
    )
    places = list(dict.fromkeys(study.where(phi) for phi in spots))
    told = [places[0], *(place.split(" = ")[1] for place in places[1:])]
    return Words("、".join(told), " and ".join(told))


def _defined(mech: Mechanism, d: Dyad, symbol: str) -> Words:
    """The angle between both bars, or between the bar and the normal of the guide."""
    if (
        d.kind == "RRR"
        and isinstance(d.outer_j, Revolute)
        and isinstance(d.inner, Revolute)
        and isinstance(d.outer_k, Revolute)
    ):
        j, c, k = d.outer_j.point, d.inner.point, d.outer_k.point
        formula = (
            f"$cos γ = (l_{{{_line(j, c)}}}^2 + l_{{{_line(c, k)}}}^2 − {j}{k}^2) / (2 l_{{{_line(j, c)}}} "
            f"l_{{{_line(c, k)}}})$"
        )
        return Words(
            f"传动角 {symbol} 为 ${j}{c}$ 与 ${c}{k}$ 所夹的锐角，由余弦定理 {formula} 计算（大于 90° 时取补角）。",
            f"The transmission angle {symbol} is the acute angle between ${j}{c}$ and ${c}{k}$: "
            f"{formula}, its supplement where it exceeds 90°.",
        )
    if d.kind == "RRP" and isinstance(d.outer_j, Revolute) and isinstance(d.inner, Revolute):
        j, c = d.outer_j.point, d.inner.point
        contact = next((one.point for one in mech.contacts if one.substitute == d.link_j), None)
        if contact is not None:
            return Words(
                f"传动角 {symbol} 为连心线 ${j}{c}$（接触点 ${contact}$ 处的公法线）与导路法线所夹的锐角。",
                f"The transmission angle {symbol} at the contact ${contact}$ is the acute angle between "
                f"${j}{c}$, which is the common normal there, and the normal of the guide.",
            )
        return Words(
            f"传动角 {symbol} 为连杆 ${j}{c}$ 与导路法线所夹的锐角。",
            f"The transmission angle {symbol} is the acute angle between the coupler ${j}{c}$ and the normal of "
            "the guide.",
        )
    return Words(f"{symbol} 为该杆组的传动角。", f"{symbol} is the transmission angle of that group.")


def _line(one: str, two: str) -> str:
    return "".join(sorted((one, two)))
