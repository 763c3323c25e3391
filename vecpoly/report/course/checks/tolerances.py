"""Section 7.3, how the output depends on the given dimensions:
each a little larger than given, and how far it may go."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from math import degrees
from typing import Any

from ....algebra.columns import significant
from ....algebra.quantity import number
from ....findings.given_lengths import Dimension
from ....findings.study.study import Study
from ....words import Words
from ..numbering import SMALL, Press
from .influences import CHANGE, NOTHING, Influence, Span, influences, targets

_LED = 0.5  # of the greatest influence: what is called great
_SLIGHT = 0.01  # of the largest value: a change that needs no care
_NAMED = 3  # dimensions in a sentence
_SHOWN = 0.001  # per cent: less is told to be less
_SIZE, _FEW = re.compile(r"([\d.]+)(.*)"), 2  # a number and its unit; figures of one in a sentence


def section(study: Study, press: Press) -> dict[str, Any]:
    """The table and what follows from it."""
    keys, found = targets(study), influences(study)
    if not any(one.matters and not one.fitted for one in found):
        return {"sensitivity": "", "judged": []}
    listed = [one for one in found if one.matters and not one.fitted]  # what cannot be changed alone a sentence tells
    bounded = any(one.least or one.most for one in found)
    header = [
        Words("尺寸", "Dimension"),
        Words("给定值", "Given"),
        *(Words.same(f"$Δ{study.turn.info(key).symbol}$") for key in keys),
        *([Words("不能整周装配的界限", "No full cycle from")] if bounded else []),
    ]
    rows = [_row(study, keys, one, press, bounded) for one in listed]
    by = _either(found, Words("0.1 mm", "0.1 mm"), Words("（角度 0.1°）", " (of an angle by 0.1°)"))
    title = Words(
        f"各给定尺寸增大 {by.zh}时输出的最大改变",
        f"The largest change of the output when a dimension is increased by {by.en}",
    )
    table = press.table(
        title, [w.of(press.lang) for w in header], rows, "ld" + "d" * len(keys) + "l" * bounded, style=SMALL
    )
    return {"sensitivity": table, "judged": [w.of(press.lang) for w in judged(study, keys, found)]}


def _either(found: Iterable[Influence], length: Words, angle: Words) -> Words:
    """An amount of a length, with that of an angle where angles are among the dimensions."""
    return length + (angle if any(one.dimension.is_angle for one in found) else Words(" ", ""))


def _row(study: Study, keys: tuple[str, ...], one: Influence, press: Press, bounded: bool) -> tuple[str, ...]:
    d = one.dimension
    size = (
        f"{degrees(d.size):.6g}°".replace("-", "−")
        if d.is_angle
        else f"{number(1e3 * d.size if abs(d.size) > NOTHING else 0.0, 5)} mm"
    )
    if one.lost:
        where = _span(study, one.lost)
        lost = Words(f"不能装配（{where}）", f"cannot be assembled ({where})")
        told = (lost.of(press.lang), *["—"] * (len(keys) - 1))
    else:
        told = tuple(_changed(study, key, gap) for key, gap in zip(keys, one.gaps, strict=True))
    limits = "；" if press.lang == "zh" else "; "
    return (
        d.name.of(press.lang),
        size,
        *told,
        *([limits.join(_signed(d, limit[0]) for limit in (one.least, one.most) if limit) or "—"] if bounded else []),
    )


def _changed(study: Study, key: str, gap: float) -> str:
    """Angles in degrees, places in mm, rates in per cent of their largest value in the cycle (of zero: no share)."""
    if key.startswith("phi"):
        return f"{degrees(gap):.3f}°"
    if key[0] in "sp":
        return f"{1e3 * gap:.3f} mm"
    whole = largest(study, key)
    if not whole:
        return "—"
    share = 100 * gap / whole
    if share < NOTHING:
        return "0"
    return f"{share:.3f} %" if share >= _SHOWN else f"< {_SHOWN} %"


def largest(study: Study, key: str) -> float:
    """The largest |value| of a column over the cycle, as the table of extremes has it."""
    found = study.extremes(key)
    return max(abs(spot.value) for spot in (found.highest, found.lowest) if spot is not None)


def _span(study: Study, span: Span) -> str:
    low, high = (study.where(phi) for phi in span)
    return f"{low} … {high.split(' = ')[1]}"


def _signed(d: Dimension, change: float) -> str:
    return f"{degrees(change):+.2f}°".replace("-", "−") if d.is_angle else f"{1e3 * change:+.2f} mm".replace("-", "−")


def judged(study: Study, keys: tuple[str, ...], found: tuple[Influence, ...]) -> Iterator[Words]:
    """Which dimensions matter most and least for the acceleration of the output,
    and which lose positions when they change by little."""
    idle = [one.dimension.name for one in found if not one.matters]
    if idle:
        yield Words(
            f"{'、'.join(w.zh for w in idle)} 与表中各量无关，不列入。",
            _upper(
                f"{', '.join(the(w.en) for w in idle)} {'has' if len(idle) == 1 else 'have'} no influence on these."
            ),
        )
    if fitted := [one.dimension.name for one in found if one.fitted]:
        yield Words(
            f"{'、'.join(w.zh for w in fitted)} 由其他尺寸确定（齿轮与齿条须保持啮合），不能单独改变。",
            f"{_upper(', '.join(the(w.en) for w in fitted))} cannot be changed alone: the other dimensions fix "
            f"{'it' if len(fitted) == 1 else 'them'}, for gears and racks must stay in mesh.",
        )
    ranked = sorted(
        (one for one in found if one.gaps and one.gaps[-1] > NOTHING * largest(study, keys[-1])),
        key=lambda one: -one.gaps[-1],
    )
    still = [one.dimension.name for one in found if one.matters and one.gaps and one not in ranked]
    if still and len(ranked) > 1:
        symbol = study.turn.info(keys[-1]).symbol
        yield Words(
            f"{'、'.join(w.zh for w in still)} 对 ${symbol}$ 没有影响；以下只比较其余尺寸。",
            _upper(
                f"{', '.join(the(w.en) for w in still)} {'does' if len(still) == 1 else 'do'} not change ${symbol}$; "
            )
            + "the others are compared.",
        )
    if len(ranked) > 1:
        yield _weighed(study, keys, ranked)
    yield from _limited(study, found)


def _limited(study: Study, found: tuple[Influence, ...]) -> Iterator[Words]:
    """The dimensions with which positions are lost soonest; that there is none."""
    span = Words(
        "一个运动循环内" if study.whole.whole else "工作范围内",
        "throughout the cycle" if study.whole.whole else "throughout its working range",
    )
    limits = sorted(
        (
            (abs(limit[0]) / CHANGE[one.dimension.is_angle], one.dimension, limit)
            for one in found
            for limit in (one.least, one.most)
            if limit
        ),
        key=lambda item: item[0],
    )
    if not limits and study.model.closed and not any(one.fitted for one in found):
        by = _either(found, Words("±2 mm", "±2 mm"), Words("（角度 ±2°）", " (of an angle ±2°)"))
        yield Words(
            f"单独改变任一尺寸，在 {by.zh}以内机构在{span.zh}均能装配。",
            f"With any one dimension changed by up to {by.en} the mechanism can still be assembled {span.en}.",
        )
    if not limits:
        return
    told = [
        Words(
            f"{d.name.zh} 改变 {_signed(d, at[0])}（失去的位置在 {study.where(at[1])} 附近）",
            f"{the(d.name.en)} by {_signed(d, at[0])} (positions about {study.where(at[1])} are lost)",
        )
        for _, d, at in limits[:_NAMED]
    ]
    yield Words(
        f"单独改变一个尺寸而使机构不再能在{span.zh}装配的界限，最近的是：{'；'.join(w.zh for w in told)}。"
        "因此这些尺寸的误差首先须远小于此界限。",
        "The smallest changes of one dimension with which the mechanism can no longer be assembled "
        f"{span.en}: {'; '.join(w.en for w in told)}. Errors must first of all stay far below these.",
    )


def _weighed(study: Study, keys: tuple[str, ...], ranked: list[Influence]) -> Words:
    """The dimensions of great and of small influence, or that all are of a size."""
    symbol, top = study.turn.info(keys[-1]).symbol, ranked[0].gaps[-1]
    great = [one for one in ranked if one.gaps[-1] >= _LED * top]
    small = [one for one in reversed(ranked) if one.gaps[-1] < _LED * top]
    told = [_listed(study, keys, some[:_NAMED]) for some in (great, small)]
    zh, en = [words.zh for words in told], [words.en for words in told]
    ends = _ends(study, keys, ranked)
    if top < _SLIGHT * largest(study, keys[-1]):
        by = _either(ranked, Words("0.1 mm", "0.1 mm"), Words("（0.1°）", " (0.1°)"))
        return Words(
            f"尺寸误差 {by.zh}对 ${symbol}$ 的影响都不到 1 %，按一般公差制造即可；{ends.zh}。",
            f"Errors of {by.en} change ${symbol}$ by less than 1 %, so ordinary tolerances suffice; {ends.en}.",
        )
    if not small:
        return Words(
            f"以 ${symbol}$ 的改变衡量，各尺寸的影响相差不到一倍，{ends.zh}，各尺寸的公差应同样严格。",
            f"Measured by the change of ${symbol}$ all dimensions have effects of one size, within a factor of "
            f"two: {ends.en}; all need tolerances of the same grade.",
        )
    return Words(
        f"以 ${symbol}$ 的改变衡量，影响最大的是 {zh[0]}，须从严控制公差；影响最小的是 {zh[1]}，可以放宽。",
        f"Measured by the change of ${symbol}$ the greatest effect is that of {en[0]}, which need "
        f"close tolerances; the least that of {en[1]}.",
    )


def _ends(study: Study, keys: tuple[str, ...], ranked: list[Influence]) -> Words:
    """Those of the greatest and those of the least effect, as they are told; of one effect all are equal."""
    sizes = [_rounded(study, keys[-1], one.gaps[-1]) for one in ranked]
    first, last = ([one for one, size in zip(ranked, sizes, strict=True) if size == sizes[n]] for n in (0, -1))
    most, least = (_listed(study, keys, some) for some in (first, last))
    if sizes[0] == sizes[-1]:
        return Words(f"影响相同：{most.zh}", f"the effects are equal: {most.en}")
    return Words(
        f"影响最大的是 {most.zh}，最小的是 {least.zh}",
        f"the greatest effect is that of {most.en}, the least that of {least.en}",
    )


def _listed(study: Study, keys: tuple[str, ...], some: Iterable[Influence]) -> Words:
    """Each with its effect to two figures; those of one effect together, for none of them has the greater."""
    alike = dict[str, list[Words]]()
    for one in some:
        alike.setdefault(_rounded(study, keys[-1], one.gaps[-1]), []).append(one.dimension.name)
    told = [
        Words(
            f"{'、'.join(w.zh for w in names)}（{'均为 ' if len(names) > 1 else ''}{share}）",
            f"{' and '.join(the(w.en) for w in names)} ({share}{' each' if len(names) > 1 else ''})",
        )
        for share, names in alike.items()
    ]
    return Words("、".join(w.zh for w in told), ", ".join(w.en for w in told))


def the(name: str) -> str:
    """A dimension in a sentence: the angle of the guide; a symbol as it is."""
    return name if name.startswith("$") else f"the {name}"


def _upper(text: str) -> str:
    return text[0].upper() + text[1:]


def _rounded(study: Study, key: str, gap: float) -> str:
    """As in the table, to two figures."""
    text = _changed(study, key, gap)
    found = _SIZE.fullmatch(text)
    return text if found is None or not float(found[1]) else f"{significant(float(found[1]), _FEW)}{found[2]}"
