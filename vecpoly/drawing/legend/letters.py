"""Letters of a drawing that no textbook has in the same place: what they stand for."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence

from ...board.construction import Figure, View
from ...board.paper.marks import Mark
from ...foundation.slotted import dataclass
from ...typeset import layout_words
from ...words import Lang, Words
from ..scene import TextBox
from ..style import NOTE
from .entry import WIDE, Entry

_MORE = "…"  # after letters for which a sample has no room


@dataclass(frozen=True, slots=True)
class Letter:
    """Letters that look so, on such a figure; {} in the words is what the group holds."""

    on: Callable[[Figure], bool]
    written: str
    words: Words


def letters_met(figures: Sequence[Figure], lang: Lang) -> Iterator[Entry]:
    """An entry for the letters of each kind that these figures have, in the order of LETTERS."""
    for letter in LETTERS:
        found: dict[str, str] = {}
        for figure in figures:
            if letter.on(figure):
                met = map(re.compile(letter.written).fullmatch, _labels(figure))
                found |= {one[0]: one[one.lastindex or 0] for one in met if one}
        if found:
            told = next(iter(found.values()))
            words = Words(letter.words.zh.replace("{}", told), letter.words.en.replace("{}", told))
            yield Entry((_sample(list(found)),), words)


def _labels(figure: Figure) -> list[str]:
    return [label for mark in figure.marks if (label := _label(mark))]


def _label(mark: Mark) -> str:
    return getattr(mark, "label", "")


def _sample(names: Sequence[str]) -> TextBox:
    """As many of these letters as a sample has room for, in its middle."""
    for n in range(len(names), 0, -1):
        told = ", ".join(f"${name}$" for name in names[:n]) + ("" if n == len(names) else _MORE)
        box = layout_words(told, NOTE)
        if box.width <= WIDE:
            break
    return TextBox(box=box, x=(WIDE - box.width) / 2, y=-0.28 * NOTE)


def is_of_curvature(figure: Figure) -> bool:
    """Whether an inflection circle stands on it, with the inflection pole and the instant centre."""
    labels = _labels(figure) if figure.view is View.MECHANISM else []
    return all(any(re.fullmatch(one, label) for label in labels) for one in (r"W_\{\d\}", r"P_\{\d+\}"))


def _motion(figure: Figure) -> bool:
    return figure.view.name in ("displacement", "swing")


def _named(*names: str) -> Callable[[Figure], bool]:
    return lambda figure: figure.view is View.MECHANISM and figure.name in names


def _seen(name: str) -> Callable[[Figure], bool]:
    return lambda figure: figure.view.name == name


def is_of_cam(figure: Figure) -> bool:
    """Whether the profile of a cam is drawn on it, by the places of its follower."""
    return figure.view is View.MECHANISM and not figure.name and {"B_0", "ω"} <= set(_labels(figure))


LETTERS: tuple[Letter, ...] = (
    Letter(is_of_curvature, r"P_\{\d+\}", Words("速度瞬心", "instant centre")),
    Letter(is_of_curvature, r"W_\{\d\}", Words("拐点极", "inflection pole")),
    Letter(is_of_curvature, r"t", Words("极切线", "pole tangent")),
    Letter(is_of_curvature, r"n", Words("极法线", "pole normal")),
    Letter(is_of_curvature, r"J_\{\w+\}", Words("法线与拐点圆的交点", "on the inflection circle")),
    Letter(is_of_curvature, r"O_\{\w+\}", Words("轨迹的曲率中心", "centre of curvature")),
    Letter(is_of_curvature, r"q|Z_\{\w+\}", Words("曲率驻点曲线的直线及其点", "line of the cubic, its points")),
    Letter(is_of_curvature, r"U_\{\d\}", Words("鲍尔点", "Ball's point")),
    Letter(_seen("torque"), r"S_\d", Words("力矩线下的面积", "area under the moments")),
    Letter(_motion, r"m_1", Words("推程压力角最大处", "maximum $α$ of the rise")),
    Letter(_motion, r"m_2", Words("回程压力角最大处", "maximum $α$ of the return")),
    Letter(_motion, r"m_3", Words("曲率半径最小处", "minimum radius of curvature")),
    Letter(is_of_cam, r"r_\{(\d+)\}", Words("$φ$ = {}° 处的向径", "radius at $φ$ = {}°")),
    Letter(_named("alpha_rise", "alpha_return", "rho_min"), r"P", Words("相对瞬心", "relative instant centre")),
    Letter(_named("alpha_rise", "alpha_return", "rho_min"), r"n", Words("公法线", "common normal")),
    Letter(_named("rho_min"), r"K", Words("曲率中心", "centre of curvature")),
    Letter(_named("rho_min"), r"u′", Words("$P$ 的换位速度分量", "part of the velocity of $P$")),
)
