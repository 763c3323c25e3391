"""Chapter 9: what was found of what the task asks for, each item short."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import degrees
from typing import Any

from ....cycle import Extremes, Shape, Spot
from ....cycle.facts.found import Stroke
from ....findings.conditioning import Conditioning
from ....findings.motion import evenness
from ....findings.output_links import ends, motions
from ....findings.shown import places, shown, span
from ....findings.strokes import is_repeated
from ....findings.study.study import Study
from ....mechanism.groups.mobility import mobility
from ....names import subscripted
from ....words import Words
from ..checks.comparison import Compared
from ..checks.influences import CHANGE, influences
from ..structure.special_joints import concluded
from . import forces as force_analysis
from .stated import output_pins, stated

_EVEN = 1.0005
_ASKED, _FORCES = Words("所求各量", "What was asked"), Words("所求各量与受力", "What was asked, and the forces")
_MOTION, _QUALITY = Words("结构与运动", "Structure and motion"), Words("工作质量与精度", "Quality and accuracy")


def conclusion(
    study: Study, groups: list[Conditioning], drawn: Compared, tables: Sequence[dict[str, Any]], mending: str
) -> Iterator[Words]:
    """What a reader takes home, sentence by sentence."""
    for _, said in themes(study, groups, drawn, tables, mending):
        yield from said


def themes(
    study: Study, groups: list[Conditioning], drawn: Compared, tables: Sequence[dict[str, Any]], mending: str
) -> Iterator[tuple[Words, list[Words]]]:
    """The same by themes: what was asked at the given position and the forces; structure, output links, points;
    conditioning, printed tables, drawn against exact.

    tables: the printed tables as checked; mending:
    the number of the section that tells better dimensions, nothing where none does.
    """
    yield _FORCES if study.problem.loads else _ASKED, [*stated(study), *force_analysis.conclusion(study)]
    outputs = [said for link in ends(study) for said in _output(study, link)]
    yield _MOTION, [_built(study), *outputs, *_points(study)]
    shaped = [*_conditioned(study, groups, mending), *_margin(study)]
    yield _QUALITY, [*shaped, *_checked(tables), *_drawn(study, drawn)]


def _built(study: Study) -> Words:
    """Its degree of freedom and its class."""
    made = concluded(study)
    return Words(
        f"机构的自由度为 {mobility(study.mech).freedom}，" + made.zh.removeprefix("因此机构"),
        f"The mechanism has {mobility(study.mech).freedom} degree of freedom. "
        + made.en.removeprefix("So the mechanism").join(("It", "")),
    )


def _checked(tables: Sequence[dict[str, Any]]) -> Iterator[Words]:
    """The printed tables, in a sentence each."""
    for table in tables:
        if table["whole"]:
            yield Words(
                f"印刷数据表 {table['name']} 各列的核对结论（错误的原因见第 7 章）：{table['short']}。",
                f"The printed table {table['name']}, column by column (the slips behind it are in chapter 7): "
                f"{table['short']}.",
            )


def _drawn(study: Study, drawn: Compared) -> Iterator[Words]:
    """Drawn against exact, at all positions."""
    if drawn.stations and drawn.keys:
        count, all_ = len(drawn.stations), len(drawn.stations) + len(drawn.refused)
        places = Words(
            f"均布的 {all_} 个位置" + (f"中的 {count} 个" if count < all_ else ""),
            f"{count} of {all_}" if count < all_ else f"{count}",
        )
        worst = f"{100 * drawn.worst(study):.2f} %"
        yield Words(
            f"在{places.zh}作图，若只计 0.1 mm 的读数舍入，图解结果与解析结果的偏差不超过各量在"
            f"{span(study).zh}内最大值的 {worst}，两种方法互相印证；计入手工作图误差时见 6.2 的预期误差。",
            f"Drawings at {places.en} equally spaced positions, with nothing but readings rounded to "
            f"0.1 mm, agree with the analysis within {worst} of each quantity's largest value in "
            f"the {span(study).en}; for the errors of a drawing hand see 6.2.",
        )


def _margin(study: Study) -> Iterator[Words]:
    """The smallest change of one dimension with which the cycle can no longer be run through."""
    limits = [
        (abs(limit[0]) / CHANGE[one.dimension.is_angle], one.dimension, *limit)
        for one in influences(study)
        for limit in (one.least, one.most)
        if limit
    ]
    if limits:
        _, d, change, phi = min(limits, key=lambda item: item[0])
        size = f"{degrees(change):+.2f}°" if d.is_angle else f"{1e3 * change:+.2f} mm"
        size, at = size.replace("-", "−"), study.where(phi)
        yield Words(
            f"机构对尺寸误差敏感：{d.name.zh} 单独改变 {size} 时，在 {at} 附近已不能装配（见 7.3）。",
            f"The mechanism is sensitive to its dimensions: with {d.name.en} alone changed by "
            f"{size} it can no longer be assembled about {at} (see 7.3).",
        )


def _output(study: Study, link: str) -> Iterator[Words]:
    """How an output link moves, and the ranges of its rates."""
    name, frame = study.name(link), study.mech.frame_number
    own = {
        f"phi_{link}",
        *(f"s_{one}" for one in (f"{name}{frame}", f"{frame}{name}", f"{link}{frame}", f"{frame}{link}")),
    }
    zh, en = [], []
    for w in (
        *(_stroke(study, s) for s in study.facts.strokes if s.key in own),
        *(_repeated(study, s.key) for s in study.facts.swings if s.key in own and is_repeated(study, s)),
        *(_turning(study, link) for _ in evenness(study, link)),
    ):
        zh.append(w.zh)
        en.append(w.en)
    for key in motions(study, link):
        found, symbol = study.extremes(key), study.whole.info(key).symbol
        if found.highest is None or found.lowest is None:
            continue
        low, high = shown(study, key, found.lowest.value), shown(study, key, found.highest.value)
        a, b = _placed(study, found, found.lowest), _placed(study, found, found.highest)
        zh.append(f"${symbol}$ 在 {low}（{a.zh}）至 {high}（{b.zh}）之间变化")
        en.append(f"${symbol}$ varies from {low} ({a.en}) to {high} ({b.en})")
    if zh:
        yield Words(f"输出构件 {name}：{'；'.join(zh)}。", f"Output link {name}: {'; '.join(en)}.")


def _turning(study: Study, link: str) -> Words:
    """A link that turns right round, and whether it ever turns back."""
    found = study.extremes(f"omega_{link}")
    if found.highest is not None and found.lowest is not None and found.highest.value * found.lowest.value > 0:
        return Words("整周转动，无极限位置，无急回", "makes full revolutions, without limits or quick return")
    return Words("整周转动，但中途反转", "makes full revolutions, but reverses on the way")


def _stroke(study: Study, stroke: Stroke) -> Words:
    info, swing = study.whole.info(stroke.key), shown(study, stroke.key, stroke.swing)
    what = Words("摆角" if info.unit == "rad" else "行程", "angle of swing" if info.unit == "rad" else "stroke")
    quick = (
        Words(
            f"$K$ = {stroke.ratio:.3f}，$θ$ = {degrees(stroke.theta):.1f}°",
            f"$K$ = {stroke.ratio:.3f}, $θ$ = {degrees(stroke.theta):.1f}°",
        )
        if stroke.ratio > _EVEN
        else Words("无急回特性", "no quick return")
    )
    return Words(
        f"往复{'摆动' if info.unit == 'rad' else '移动'}，{what.zh} {swing}，{quick.zh}",
        f"{'oscillates' if info.unit == 'rad' else 'reciprocates'}, {what.en} {swing}, {quick.en}",
    )


def _repeated(study: Study, key: str) -> Words:
    swing = next(s for s in study.facts.swings if s.key == key)
    assert swing.highest is not None and swing.lowest is not None
    size = shown(study, key, swing.highest.value - swing.lowest.value)
    return Words(
        f"每循环往复 {len(swing.maxima)} 次，总{'摆角' if study.whole.info(key).unit == 'rad' else '行程'} "
        f"{size}（各行程见 8.1）",
        f"goes to and fro {len(swing.maxima)} times a cycle, through {size} in all (strokes in 8.1)",
    )


def _points(study: Study) -> Iterator[Words]:
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
        at = subscripted(letter)
        zh = f"${at}$ 点{within.zh}走过的路程为 {length}，" if found.length else f"${at}$ 点："
        en = f"Point ${at}$ travels {length} {within.en}; " if found.length else f"Of point ${at}$: "
        top = [(shown(study, e.key, spot.value), places(study, e, spot)) for e, spot in ((of_v, v), (of_a, a))]
        yield Words(
            f"{zh}$|v_{{{letter}}}|$ 最大 {top[0][0]}（{top[0][1].zh}），$|a_{{{letter}}}|$ 最大 {top[1][0]}（"
            f"{top[1][1].zh}）。",
            f"{en}$|v_{{{letter}}}|$ is greatest, {top[0][0]}, at {top[0][1].en}, "
            f"$|a_{{{letter}}}|$, {top[1][0]}, at {top[1][1].en}.",
        )


def _placed(study: Study, found: Extremes, spot: Spot) -> Words:
    """The positions; that one is an end of the range told, where it is."""
    at, near = places(study, found, spot), 1e-6 * (study.whole.high - study.whole.low)
    end = not study.whole.whole and min(spot.phi - study.whole.low, study.whole.high - spot.phi) < near
    return at + Words("，工作范围的端部" if end else "", ", an end of the working range" if end else "")


def _wanting(one: Conditioning) -> Words:
    """A group with the measure by which it is found wanting."""
    if one.gamma:
        least = f"{degrees(one.gamma.least.value):.1f}°"
        measure = Words(f"的最小传动角为 {least}，小于 40°", f": least transmission angle {least}, below 40°")
    else:
        share = f"{100 * one.measure:.0f} %"
        measure = Words(
            f"的 $|{one.symbol}|$ 最小时为最大值的 {share}", f": $|{one.symbol}|$ falls to {share} of its largest"
        )
    return one.group.title + measure + Words(f"（{one.verdict.zh}）", f" ({one.verdict.en})")


def _conditioned(study: Study, groups: list[Conditioning], mending: str) -> Iterator[Words]:
    """The verdict on every group that 8.3 finds wanting, by its one measure."""
    poor = sorted((one for one in groups if one.is_poor), key=lambda one: one.measure)
    if poor and study.facts.dead:
        yield Words(
            f"{'原动件的行程有限' if study.mech.drive.slide else '原动件不能整周转动'}，"
            "接近行程端部的死点时各速度、加速度急剧增大，机构不宜在其附近工作。",
            f"The input link {'has a limited stroke' if study.mech.drive.slide else 'cannot make full revolutions'}, "
            "and towards the dead points at the ends of its stroke velocities and accelerations grow without bound: "
            "the mechanism should not work near them.",
        )
    elif poor and (study.whole.whole or not all(study.facts.unlimited)):
        told = [_wanting(one) for one in poor]
        yield Words(
            f"杆组方程组的病态（奇异）性：{'；'.join(w.zh for w in told)}"
            f"{f'；改进的办法见 {mending}' if mending else ''}。",
            f"Conditioning of the groups: {'; '.join(w.en for w in told)}."
            f"{f' Remedies: see {mending}.' if mending else ''}",
        )
    elif groups and not poor:
        link, angles = study.mech.drive.link, any(one.gamma for one in groups)
        zh_, en_ = (f"（以构件 {link} 为原动件）", f" (link {link} being the driver)") if study.forces else ("", "")
        yield Words(
            f"各杆组在{span(study).zh}内均为良态{'，传动角均不小于 40°' + zh_ if angles else ''}。",
            "All groups are well-conditioned "
            f"throughout{', with transmission angles of 40° and more' + en_ if angles else ''}.",
        )
