"""A rotor in words: the masses that are out of balance, where weights may sit, and how holes are drilled."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from math import degrees

from ...units.reading import Quantity
from ...words import Words
from ..defined import defined, sentence
from .plane import RotorPlane

_ONLY = {"add": Words("只许加重", "weights may only be added"), "remove": Words("只许去重", "mass may only be removed")}


def planes_told(planes: Mapping[str, RotorPlane]) -> tuple[Words, ...]:
    """One sentence for each plane of which there is something to say."""
    return tuple(_told(name, plane) for name, plane in planes.items() if [*_rules(plane)])


def _told(name: str, plane: RotorPlane) -> Words:
    rules = [*_rules(plane)]
    return Words(
        f"校正平面 {name}：{'，'.join(one.zh for one in rules)}",
        f"plane of correction {name}: {', '.join(one.en for one in rules)}",
    )


def _rules(plane: RotorPlane) -> Iterator[Words]:
    if plane.places is not None:
        yield _places(plane.places)
    if plane.use is not None:
        zh, en = (mark.join(_degrees(one.text) for one in plane.use) for mark in ("、", " and "))
        yield Words(f"用其中 {zh} 两处", f"of these the places at {en} are used")
    if plane.only is not None:
        yield _ONLY[plane.only]
    if plane.step is not None:
        yield Words(f"配重按 {plane.step.text} 分级", f"weights come in steps of {plane.step.text}")
    if plane.spread is not None:
        spread = _degrees(plane.spread.text)
        yield Words(
            f"在所求方位两侧各 {spread} 处钻两个相同的孔",
            f"two equal holes, {spread} to either side of the direction found",
        )


def _places(places: Sequence[Quantity]) -> Words:
    """Two or three of them, or the pitch of a circle of holes."""
    pitch = degrees(places[1].si - places[0].si)
    if len(places) > 2 and places[0].si == 0.0 and round(pitch * len(places), 6) == 360.0:
        return Words(
            f"配重只能装在自 x 轴起每隔 {pitch:g}° 的孔处", f"weights can sit only every {pitch:g}° from the x axis on"
        )
    zh, en = (mark.join(_degrees(one.text) for one in places) for mark in ("、", ", "))
    return Words(f"配重只能装在方位 {zh} 处", f"weights can sit only at {en}")


def _degrees(text: str) -> str:
    return text.replace(" deg", "°")


_MASSES = {
    r"m_\{.*\}": Words("质量", "mass"),
    r"W_\{.*\}": Words("质径积", "mass-radius product"),
    r"d_\{[^b].*\}": Words("孔（视为负质量）的直径", "diameter of a hole (a negative mass)"),
    r"w_\{.*\}": Words("键槽（视为负质量）的宽度", "width of a keyway (a negative mass)"),
    r"h_\{.*\}": Words("孔或键槽的深度", "depth of a hole or keyway"),
    r"r_\{(?!b).*\}": Words("回转半径", "radius"),
    r"θ_\{.*\}": Words("自 $x$ 轴起逆时针的方位角", "angular position counter-clockwise from the $x$ axis"),
    r"z_\{(?!b).*\}": Words("轴向位置", "axial position"),
    r"b(_\{.*\})?": Words("圆盘在孔处的厚度", "thickness of the disc at the holes"),
    r"ρ(_\{.*\})?": Words("圆盘的密度", "density of the disc"),
    r"z_\{b.*\}": Words("校正平面的轴向位置", "axial position of the plane of correction"),
    r"r_\{b.*\}": Words("校正半径", "radius of the correction"),
    r"d_\{b.*\}": Words("钻头直径", "diameter of the drill"),
    "G": Words("平衡品质等级（$e ω$ 的许用值）", "grade of balance quality, the permissible $e ω$"),
    "m": Words("转子的质量", "mass of the rotor"),
    "n": Words("工作转速", "working speed"),
    "z_S": Words("质心的轴向位置", "axial position of the centre of mass"),
}


def rotor_task(
    given: Sequence[str], ends: Sequence[str] | None, planes: Sequence[str], asked: Collection[str]
) -> Words:
    """Of a rotor with these symbols; ends: subscripts of the planes, None of masses that balance each other."""
    rest = _residual(ends, asked) if ends is not None else _answers(asked)
    return sentence(_head(ends, planes), *defined(given, _MASSES), *rest)


def _head(ends: Sequence[str] | None, planes: Sequence[str]) -> Words:
    if ends is None:
        return Words(
            "转轴上装有几个偏心质量，标“?”者待求，使转子达到动平衡",
            "a shaft carries several masses; what is marked “?” is sought, so that the rotor is in dynamic balance",
        )
    if len(ends) == 1:
        return Words(
            f"转子的不平衡质量在一个平面 {planes[0]} 内校正（静平衡）",
            f"the unbalanced masses of a rotor are corrected in one plane, {planes[0]} (static balance)",
        )
    return Words(
        f"转子的不平衡质量在两个平面 {'、'.join(planes)} 内校正（动平衡）",
        f"the unbalanced masses of a rotor are corrected in two planes, {' and '.join(planes)} (dynamic balance)",
    )


def _answers(asked: Collection[str]) -> Iterator[Words]:
    """Where couples count from, and which subscript is that of a solution."""
    if any(key.startswith("C_") for key in asked):
        yield Words(
            "质径积的矩 $C$ 以质量和方位均待求的偏心质量所在平面为基准面",
            "the couples $C$ count from the plane of the mass of which neither size nor direction is given",
        )
    if any(key.endswith("_2") for key in asked):
        yield Words("第二个下标为解的序号", "the second subscript is the number of the solution")


def _residual(ends: Sequence[str], asked: Collection[str]) -> Iterator[Words]:
    """What the subscripts of what is asked say."""
    shared = [end for end in ends if end and any(re.fullmatch(rf"W_(?!b|r).+{re.escape(end)}", key) for key in asked)]
    if shared:
        signs = [f"$W_{{i{end}}}$" for end in shared]
        yield Words(
            f"{'、'.join(signs)} 为各质径积 $W_i$ 分解到校正平面 {'、'.join(shared)} 的部分",
            f"{' and '.join(signs)} are the parts of the products $W_i$ in the planes {' and '.join(shared)}",
        )
    if any(key.startswith("within") for key in asked):
        signs = [f"$W_{{r{end}}}$" for end in ends]
        yield Words(
            f"{'、'.join(signs)} 为校正平面内的剩余质径积",
            f"{' and '.join(signs)} what unbalance there is in the plane of correction",
        )
    if any(re.fullmatch(r"theta_b.*_[12]", key) for key in asked):
        yield Words("下标 1、2 为所用的两处", "the subscripts 1 and 2 are the two places that are used")
