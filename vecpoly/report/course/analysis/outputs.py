"""How the output links and the points move, in a sentence each: what a reader takes home of chapter 5."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

from ....cycle import Extremes, Shape, Spot
from ....cycle.facts.found import Stroke
from ....findings.motion import evenness
from ....findings.output_links import motions
from ....findings.shown import alike, places, shown, span
from ....findings.strokes import is_repeated
from ....findings.study.study import Study
from ....names import subscripted
from ....words import Words
from .stated import output_pins

_EVEN, _MARKED = 1.0005, 1.05  # ratio of the strokes: from where there is a quick return, and one worth the name
_ALIKE = 1e-6  # of the maximum value


def output(study: Study, link: str) -> Iterator[Words]:
    """How an output link moves, and how fast at most."""
    name, how, rates = study.name(link), [*_ways(study, link)], [*_rates(study, link)]
    if not how and not rates:
        return
    zh, en = "，".join(w.zh for w in rates), ", ".join(w.en for w in rates)
    ways_zh, ways_en = "，".join(w.zh for w in how), ", ".join(w.en for w in how)
    between = ("；", "; ") if how and rates else ("", "")
    lead = (" ", " ") if how else ("：", ": ")
    if rates and study.sense_only:
        rate = f"$|ω_{{{study.mech.drive.link}}}|$ = 1 rad/s"
        zh, en = f"{rate} 时 {zh}", f"for {rate} {en}"
    yield Words(
        f"输出构件 {name}{lead[0]}{ways_zh}{between[0]}{zh}。", f"Output link {name}{lead[1]}{ways_en}{between[1]}{en}."
    )


def _ways(study: Study, link: str) -> Iterator[Words]:
    """To and fro, round and round."""
    name, frame = study.name(link), study.mech.frame_number
    slides = (f"{name}{frame}", f"{frame}{name}", f"{link}{frame}", f"{frame}{link}")
    own = {f"phi_{link}", *(f"s_{one}" for one in slides)}
    yield from (_stroke(study, s) for s in study.facts.strokes if s.key in own)
    yield from (_repeated(study, s.key) for s in study.facts.swings if s.key in own and is_repeated(study, s))
    yield from (_turning(study, link) for _ in evenness(study, link))


def _rates(study: Study, link: str) -> Iterator[Words]:
    """The greatest sizes of what changes its sense, the ranges of what does not, and where."""
    for key in motions(study, link):
        found, symbol = study.extremes(key), study.whole.info(key).symbol
        high, low = found.highest, found.lowest
        if high is None or low is None:
            continue
        if low.value < 0 < high.value:
            yield _greatest(study, found, key, high, low)
            continue
        (a, at), (b, to) = ((shown(study, key, one.value), _placed(study, found, one)) for one in (low, high))
        yield Words(
            f"${symbol}$ 在 {a}（{at.zh}）至 {b}（{to.zh}）之间变化",
            f"${symbol}$ varies from {a} ({at.en}) to {b} ({to.en})",
        )


def _greatest(study: Study, found: Extremes, key: str, high: Spot, low: Spot) -> Words:
    """The greatest size, at one end or at both."""
    size = max(high.value, -low.value)
    tops = [one for one in (high, low) if abs(one.value) == size or (1 - _ALIKE) * size <= abs(one.value) < size]
    symbol, told = study.whole.info(key).symbol, shown(study, key, size)
    every = sorted((s for one in tops for s in alike(study, found, one)), key=lambda s: study.reduced(s.phi))
    first, *others = dict.fromkeys(study.where(s.phi) for s in every)
    listed = [first, *(place.split(" = ")[1] for place in others)]
    where = Words("、".join(listed), " and ".join(listed)) if others else _placed(study, found, tops[0])
    zh, en = where.zh, where.en
    return Words(f"$|{symbol}|$ 最大 {told}（{zh}）", f"the maximum $|{symbol}|$ is {told}, at {en}")


def _turning(study: Study, link: str) -> Words:
    """A link that turns right round, and whether it ever turns back."""
    found = study.extremes(f"omega_{link}")
    if found.highest is not None and found.lowest is not None and found.highest.value * found.lowest.value > 0:
        return Words("整周转动，无极限位置，无急回", "makes full revolutions, without limits or quick return")
    return Words("整周转动，但中途反转", "makes full revolutions, but reverses on the way")


def _stroke(study: Study, stroke: Stroke) -> Words:
    """To and fro, how far, and whether it returns more quickly."""
    turns, swing = study.whole.info(stroke.key).unit == "rad", shown(study, stroke.key, stroke.swing)
    quick, k, theta = Words("无急回特性", "no quick return"), f"$K$ = {stroke.ratio:.3f}", degrees(stroke.theta)
    if stroke.ratio > _EVEN:
        weak = stroke.ratio < _MARKED
        quick = Words(
            f"行程速比系数 {k}（$θ$ = {theta:.1f}°），{'急回不明显' if weak else '有急回特性'}",
            f"{'a weak' if weak else 'a'} quick return, {k} ($θ$ = {theta:.1f}°)",
        )
    return Words(
        f"往复{'摆动，摆角' if turns else '移动，行程'} {swing}，{quick.zh}",
        f"{'oscillates through an angle of' if turns else 'reciprocates with a stroke of'} {swing}, with {quick.en}",
    )


def _repeated(study: Study, key: str) -> Words:
    swing = next(s for s in study.facts.swings if s.key == key)
    assert swing.highest is not None and swing.lowest is not None
    size = shown(study, key, swing.highest.value - swing.lowest.value)
    often = Words(f"每循环往复 {len(swing.maxima)} 次", f"reciprocates {len(swing.maxima)} times a cycle")
    if not study.whole.whole:
        often = Words("在工作区间内往复运动", "reciprocates in the working range")
    return Words(
        f"{often.zh}，总{'摆角' if study.whole.info(key).unit == 'rad' else '行程'} {size}（各行程见 8.1）",
        f"{often.en} within {size} (strokes in 8.1)",
    )


def points(study: Study) -> Iterator[Words]:
    """The path, and the greatest velocity and acceleration, of every point told."""
    blocks = output_pins(study)
    for letter in (letter for letter in study.points if letter not in blocks):  # of an output block all is told
        found = study.path(letter)
        of_v, of_a = (study.extremes(f"{stem}_{letter}") for stem in "va")
        v, a = of_v.highest, of_a.highest
        if v is None or a is None or found.shape is Shape.STILL or not study.varies(f"v_{letter}"):
            continue
        length = shown(study, f"p_{letter}", found.length)
        within = Words(f"在{span(study).zh}内", "in a cycle" if study.whole.whole else "in the working range")
        if study.whole.once is not study.whole:  # a path is that of one turn
            within = Words("在原动件每转一周内", "in a turn of the input link")
        at = subscripted(letter)
        zh = f"${at}$ 点{within.zh}走过的路程为 {length}，" if found.length else f"${at}$ 点："
        en = f"Point ${at}$ travels {length} {within.en}; " if found.length else f"Of point ${at}$: "
        top = [(shown(study, e.key, spot.value), _placed(study, e, spot)) for e, spot in ((of_v, v), (of_a, a))]
        yield Words(
            f"{zh}$|v_{{{letter}}}|$ 最大 {top[0][0]}（{top[0][1].zh}），$|a_{{{letter}}}|$ 最大 {top[1][0]}（"
            f"{top[1][1].zh}）。",
            f"{en}$|v_{{{letter}}}|$ has its maximum, {top[0][0]}, at {top[0][1].en}, "
            f"$|a_{{{letter}}}|$, {top[1][0]}, at {top[1][1].en}.",
        )


def _placed(study: Study, found: Extremes, spot: Spot) -> Words:
    """The positions; that one is an end of the range told, where it is."""
    at, near = places(study, found, spot), 1e-6 * (study.whole.high - study.whole.low)
    end = not study.whole.whole and min(spot.phi - study.whole.low, study.whole.high - spot.phi) < near
    return at + Words("，工作范围的端部" if end else "", ", an end of the working range" if end else "")
