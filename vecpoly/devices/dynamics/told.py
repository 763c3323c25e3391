"""The tasks of a flywheel and of a train that is reduced to a shaft, in words."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping

from ...words import Words
from ..defined import defined, listed, sentence
from .shafts import Pair, Shaft

_STEADY = {
    "n": Words("平均转速", "mean speed"),
    r"\[δ\]": Words("许用速度不均匀系数", "allowed coefficient of speed fluctuation"),
    "n_2": Words("另一可装飞轮的轴的转速", "speed of another shaft on which the flywheel may sit"),
    "D": Words("飞轮轮缘的平均直径", "mean diameter of the flywheel's rim"),
    "b/h": Words("轮缘的宽高比", "width of the rim over its height"),
    "ρ": Words("轮缘的密度", "density of the rim"),
    r"\[v\]": Words("轮缘的许用圆周速度", "speed allowed for the rim"),
}
_START = ("ω_0", "n_0")
_WHOLE = Words("全部等效转动惯量", "equivalent moment of inertia of all that turns")
_REST = Words("飞轮以外的等效转动惯量", "equivalent moment of inertia without the flywheel")
_MEETING = re.compile(r"(?:E|phi)_[a-z]\d*")
_PARTS = re.compile(r"W_\d+")


def flywheel_task(given: Collection[str], asked: Collection[str]) -> Words:
    """Of one whose data have these symbols: what it does in a period, what is known of it."""
    inertia = _REST if "[δ]" in given else _WHOLE
    known = defined(given, _STEADY | {"J": inertia})
    return sentence(_period(given), *known, *_lettered(given, asked))


def _period(given: Collection[str]) -> Words:
    if "A" in given:
        return Words(
            "机器稳定运转一个周期内，等效驱动力矩线与等效阻力矩线之间的面积 $A$ 依次给出（正为盈功，负为亏功），面积"
            "比例尺为 $μ_A$",
            "in a period of steady motion the areas $A$ between the curves of the driving and of the resisting moment "
            "follow each other (surpluses positive, deficits negative), their scale being $μ_A$",
        )
    if "M_d" not in given and "M_r" not in given:
        powers = listed([one for one in given if one.startswith("P_")])
        return Words(
            f"机器在一个周期内依次消耗功率 {powers.zh}（其后为相应的转角），电动机的驱动功率恒定",
            f"in a period a machine takes the powers {powers.en} one after the other (each with its angle of turn), "
            "while its motor drives it with constant power",
        )
    return _moments(given)


def _moments(given: Collection[str]) -> Words:
    names = {"M_d": Words("等效驱动力矩", "driving moment"), "M_r": Words("等效阻力矩", "resisting moment")}
    own = [one for one in names if one in given]
    zh, en = (
        " 和".join(f"{names[one].zh} ${one}$" for one in own),
        " and the ".join(f"{names[one].en} ${one}$" for one in own),
    )
    flat = next((f"，{names[one].zh} ${one}$ 为常数" for one in names if one not in given), "")
    flat_en = next((f"; the {names[one].en} ${one}$ is constant" for one in names if one not in given), "")
    return Words(
        f"机器稳定运转的周期为 $φ_T$，{zh} 随等效构件的转角 $φ$ 变化，在给定各点之间为直线{flat}",
        f"in a period $φ_T$ of steady motion the equivalent {en} depend{'s' * (len(own) == 1)} on the angle $φ$ of the "
        f"equivalent link, straight between the given places{flat_en}",
    )


def _lettered(given: Collection[str], asked: Collection[str]) -> Iterator[Words]:
    """Which places are a, b, c, and which works are W_1, W_2, where they are asked."""
    if any(_MEETING.fullmatch(key) for key in asked):
        where = (
            Words("各块面积的分界", "the borders of the areas")
            if "A" in given
            else Words("两力矩线的交点", "the meetings of the two curves")
        )
        yield Words(
            f"$a$ 为周期的起点，其后{where.zh}依次为 $b$、$c$ 等，动能 $E$ 自 $a$ 处起算",
            f"$a$ is the beginning of the period, {where.en} after it are $b$, $c$ and so on, and the energy $E$ "
            "counts from $a$",
        )
    if any(_PARTS.fullmatch(key) for key in asked):
        yield Words("$W_i$ 为第 $i$ 块面积的盈亏功", "$W_i$ is the work of the area $i$, a surplus positive")


def reduced_task(
    shafts: Mapping[str, Shaft],
    wheels: Collection[tuple[Pair, str, str]],
    main: str,
    run: Collection[str],
    asked: Collection[str],
) -> Words:
    """What joins the shafts, what acts on them; run: the symbols of the run's start and end that are given."""
    trains = [_joined(*one) for one in wheels]
    loads = [one for name, shaft in shafts.items() for one in _acting(name, shaft)]
    inertia = Words(
        "$J_i$ 为轴 $i$ 连同其上零件的转动惯量", "$J_i$ is the moment of inertia of shaft $i$ with all that sits on it"
    )
    own = [inertia] if any(shaft.J for shaft in shafts.values()) else []
    to = Words(f"以轴 {main} 为等效构件", f"shaft {main} is the equivalent link")
    ratios = Words(
        "$i$ 为前一下标的轴与后一下标的轴的角速度之比",
        "$i$ is the speed of the shaft told first over that of the second",
    )
    told = [ratios] if any(key.startswith("i_") for key in asked) else []
    return sentence(*trains, *own, *loads, to, *told, *_run(main, run))


def _joined(pair: Pair, one: str, two: str) -> Words:
    if pair.belt:
        return Words(
            f"轴 {pair.first} 与轴 {pair.second} 间为带传动，带轮直径 ${one}$、${two}$",
            f"a belt joins the pulleys of shafts {pair.first} and {pair.second}, of the diameters ${one}$ and ${two}$",
        )
    return Words(
        f"轴 {pair.first} 上齿数为 ${one}$ 的齿轮与轴 {pair.second} 上齿数为 ${two}$ 的齿轮啮合",
        f"a gear on shaft {pair.first} with ${one}$ teeth meshes with one on shaft {pair.second} with ${two}$",
    )


def _acting(name: str, shaft: Shaft) -> Iterator[Words]:
    if shaft.drives is not None:
        yield Words(f"轴 {name} 上作用驱动力矩 $M_{{d{name}}}$", f"the moment $M_{{d{name}}}$ drives shaft {name}")
    if shaft.resists is not None:
        yield Words(f"轴 {name} 上作用阻力矩 $M_{{r{name}}}$", f"the moment $M_{{r{name}}}$ resists on shaft {name}")
    if shaft.lifts is not None:
        yield Words(
            f"轴 {name} 上直径为 $D_{{{name}}}$（量到绳心）的卷筒提升质量 $m$",
            f"a drum of the diameter $D_{{{name}}}$ (to the middle of the rope) on shaft {name} lifts the mass $m$",
        )


def _run(main: str, run: Collection[str]) -> Iterator[Words]:
    """From which speed, to which, or how long."""
    ends = [one for one in run if one not in _START]
    if not ends:
        return
    start = next((Words(f"自 ${one}$", f"from ${one}$") for one in run if one in _START), Words("由静止", "from rest"))
    goal = (
        Words("经时间 $t$", "for the time $t$")
        if "t" in run
        else Words(f"运转到轴 {main} 的转速 ${ends[0]}$", f"to the speed ${ends[0]}$ of shaft {main}")
    )
    yield Words(f"{start.zh}起{goal.zh}", f"it runs {start.en} {goal.en}")
