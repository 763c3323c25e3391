"""Chapter 9: what was found of what the task asks for, each item short."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import degrees
from typing import Any

from ....cycle.facts.transmission_range import USUAL
from ....findings.conditioning import Conditioning
from ....findings.output_links import ends
from ....findings.shown import dead_points, span
from ....findings.study.study import Study
from ....findings.transmission import least_places
from ....mechanism.groups.mobility import mobility
from ....words import Words
from ..checks.comparison import Compared
from ..checks.influences import CHANGE, influences
from ..structure.special_joints import concluded
from . import forces as force_analysis
from .outputs import output, points
from .stated import stated

_STEADY = 1e-9  # of the largest determinant
_ASKED, _FORCES = Words("所求各量", "Required quantities"), Words("所求各量与受力", "Required quantities and forces")
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
    outputs = [said for link in ends(study) for said in output(study, link)]
    yield _MOTION, [_built(study), *outputs, *points(study)]
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


def _wanting(one: Conditioning) -> Words:
    """A group with the measure by which it is found wanting."""
    if one.gamma:
        least = f"{degrees(one.gamma.least.value):.1f}°"
        measure = Words(f"的最小传动角为 {least}，小于 40°", f": minimum transmission angle {least}, below 40°")
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
        yield _near_dead(study)
    elif poor and (study.whole.whole or not all(study.facts.unlimited)):
        told = [_wanting(one) for one in poor]
        cured = any(not one.is_none for one in poor)  # of a change point there is no more than what it means
        more = Words("改进的办法见", "Remedies: see") if cured else Words("见", "See")
        yield Words(
            f"杆组方程组的病态（奇异）性：{'；'.join(w.zh for w in told)}"
            f"{f'；{more.zh} {mending}' if mending else ''}。",
            f"Conditioning of the groups: {'; '.join(w.en for w in told)}."
            f"{f' {more.en} {mending}.' if mending else ''}",
        )
    elif groups and not poor:
        yield _sound(study, groups)


def _near_dead(study: Study) -> Words:
    """That what is greatest at an end of the working range is no maximum: beyond it lie dead points."""
    dead, slides = dead_points(study), study.mech.drive.slide
    return Words(
        f"{'原动件的行程有限' if slides else '原动件不能整周转动'}，接近死点（{dead.zh}）时各速度、加速度急剧增大，"
        "故工作范围端部的最大值并非极大值；机构不宜在死点附近工作。",
        f"The input link {'has a limited stroke' if slides else 'cannot make full revolutions'}, and towards its dead "
        f"points, at {dead.en}, velocities and accelerations grow without bound: values at the ends of the working "
        "range are not true maxima, and the mechanism should not work near the dead points.",
    )


def _sound(study: Study, groups: list[Conditioning]) -> Words:
    """How far all groups keep from singular places: by the minimum transmission angle, or the least determinant."""
    gammas, many = [one.gamma for one in groups if one.gamma is not None], len(groups) > 1
    link = study.mech.drive.link
    zh, en = (f"（以构件 {link} 为原动件）", f" (link {link} being the driver)") if study.forces else ("", "")
    if gammas:
        worst = min(gammas, key=lambda one: one.least.value)
        size, steady = degrees(worst.least.value), worst.greatest.value - worst.least.value < _STEADY
        where = least_places(study, worst)
        at = ("", "") if steady else (f"（{where.zh}）", f" ({where.en})")
        told = Words(
            f"最小传动角为 {size:.1f}°{at[0]}，{'不小于' if size >= USUAL else '略低于'}一般要求的 40°{zh}",
            f"the minimum transmission angle is {size:.1f}°{at[1]}, {'above' if size >= USUAL else 'just below'} the "
            f"40° usually demanded{en}",
        )
    elif (ratio := min(one.ratio for one in groups)) > 1 - _STEADY:
        told = Words("行列式为常数", "their determinants are constant" if many else "its determinant is constant")
    else:
        share = f"{100 * ratio:.0f} %"
        told = Words(
            f"行列式最小时仍为其最大值的 {share}",
            f"{'no determinant falls' if many else 'its determinant does not fall'} below {share} of its largest value",
        )
    return Words(
        f"{'各杆组' if many else '杆组'}在{span(study).zh}内{'均' * many}为良态：{told.zh}。",
        f"{'All groups are' if many else 'The group is'} well-conditioned throughout the {span(study).en}: {told.en}.",
    )
