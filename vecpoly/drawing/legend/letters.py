"""Letters of a drawing that no textbook has in the same place: what they stand for."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence

from ...board.construction import Figure, View
from ...board.paper.marks import Dot, Mark, Point, Vector
from ...board.paper.titled import CURVATURES, SMALLER_CURVATURES
from ...foundation.slotted import dataclass
from ...typeset import layout_words
from ...words import Lang, Words
from ..scene import TextBox
from ..style import NOTE
from .entry import WIDE, Entry

_RESTING = (
    (View.VELOCITY, "", Words("速度瞬心（速度为零）", "instant centre, at rest")),
    (View.ACCELERATION, "^′", Words("加速度瞬心（加速度为零）", "acceleration pole")),
)
_OF_LINK = re.compile(r"[A-Z]_\{?\d+\}?")  # M_2: a point of link 2
_NEAR = 1e-6  # mm
_MORE = "…"  # after letters for which a sample has no room


@dataclass(frozen=True, slots=True)
class Letter:
    """Letters that look so, on such a figure; {} in the words is what the group holds. sample: what stands for them
    all, where they are one letter with many indices."""

    on: Callable[[Figure], bool]
    written: str
    words: Words
    sample: str = ""


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
            yield Entry((_sample([letter.sample] if letter.sample else list(found)),), words)


def resting_met(figures: Sequence[Figure], lang: Lang) -> Iterator[Entry]:
    """An entry for the points of links that were found at rest, and one for those without acceleration: their images
    lie at the pole."""
    lettered = (one for figure in figures if _with_centres(figure) for one in figure.marks if isinstance(one, Point))
    found = dict.fromkeys(one.label for one in lettered if one.dot is Dot.POINT and _OF_LINK.fullmatch(one.label))
    for view, prime, words in _RESTING:
        held = {_label(one) for figure in figures if figure.view is view for one in figure.marks if _at_pole(one)}
        if some := [label for label in found if f"{label[0].lower()}{label[1:]}{prime}" in held]:
            yield Entry((_sample(some),), words)


def _at_pole(mark: Mark) -> bool:
    return isinstance(mark, Point) and abs(mark.at) < _NEAR


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
    """Whether curvatures are constructed on it; of their points some may stand on the reduced figure beside it."""
    return figure.view is View.MECHANISM and figure.title in (CURVATURES, SMALLER_CURVATURES)


def _motion(figure: Figure) -> bool:
    return figure.view.name in ("displacement", "swing")


def _named(*names: str) -> Callable[[Figure], bool]:
    return lambda figure: figure.view is View.MECHANISM and figure.name in names


def _seen(name: str) -> Callable[[Figure], bool]:
    return lambda figure: figure.view.name == name


def is_of_cam(figure: Figure) -> bool:
    """Whether the profile of a cam is drawn on it, by the places of its follower."""
    labels = set(_labels(figure)) if figure.view is View.MECHANISM and not figure.name else set[str]()
    return {"O", "ω"} <= labels and any(re.fullmatch(r"B_0|r_\{\d+\}", label) for label in labels)


def _of_flat_arm(figure: Figure) -> bool:
    return is_of_cam(figure) and {"T_1", "T_2"} <= set(_labels(figure))


def _of_flat_face(figure: Figure) -> bool:
    return is_of_cam(figure) and not _of_flat_arm(figure)


def _acted_on(figure: Figure) -> bool:
    """Whether forces stand on a mechanism or a body."""
    forces = (mark for mark in figure.marks if isinstance(mark, Vector | Point) and mark.label[:1] in ("R", "F"))
    return (figure.view is View.MECHANISM or figure.view.bodies) and any(forces)


def _pressed(figure: Figure) -> bool:
    """Whether bodies that press on each other are drawn with the normals of their contact."""
    return figure.view is View.BODY or _named("released")(figure)


def _with_centres(figure: Figure) -> bool:
    """Whether instant centres are found on a mechanism."""
    return figure.view is View.MECHANISM and not is_of_curvature(figure)


def _with_poles(figure: Figure) -> bool:
    """Whether poles one after another are carried into a moving plane; Q may be a point of a link else."""
    return _with_centres(figure) and any(label.startswith("Q^{′}") for label in _labels(figure))


def _projected(figure: Figure) -> bool:
    """Whether velocities are projected on the lines of springs and dampers."""
    return figure.view is View.VELOCITY and not figure.name


def _of_lever(figure: Figure) -> bool:
    return figure.view is View.VELOCITY and figure.name == "lever"


def _taken_apart(figure: Figure) -> bool:
    return figure.view is View.MECHANISM and figure.name.startswith(("group ", "left ", "low"))


def is_of_gear(figure: Figure) -> bool:
    """Whether the tooth of a gear is generated on it."""
    return figure.view is View.MECHANISM and {"r_a", "r_f", "N"} <= set(_labels(figure))


LETTERS: tuple[Letter, ...] = (
    Letter(is_of_curvature, r"P_\{\d+\}", Words("速度瞬心", "instant centre")),
    Letter(is_of_curvature, r"W_\{\d\}", Words("拐点极", "inflection pole")),
    Letter(is_of_curvature, r"t", Words("极切线", "pole tangent")),
    Letter(is_of_curvature, r"n", Words("极法线", "pole normal")),
    Letter(is_of_curvature, r"J_\{\w+\}", Words("法线与拐点圆的交点", "on the inflection circle")),
    Letter(is_of_curvature, r"W\^\{r\}_\{\d\}", Words("回归极", "return pole")),
    Letter(is_of_curvature, r"[a-d]", Words("平行线作图的辅助点", "auxiliary points")),
    Letter(is_of_curvature, r"O_\{\w+\}", Words("轨迹的曲率中心", "centre of curvature")),
    Letter(is_of_curvature, r"q", Words("曲率驻点曲线的直线", "line of the cubic")),
    Letter(is_of_curvature, r"Z_\{\w+\}", Words("直线 $q$ 上的点", "points of the line $q$")),
    Letter(is_of_curvature, r"U_\{\d\}", Words("鲍尔点", "Ball's point")),
    Letter(_with_centres, r"P_\{?\d\d\}?(\^\{∞\})?", Words("速度瞬心", "instant centre")),
    Letter(_with_poles, r"Q_\{?\d+\}?", Words("瞬心在定平面上的位置", "pole positions, fixed plane")),
    Letter(_with_poles, r"Q\^\{′\}_\{?\d+\}?", Words("瞬心在动平面上的位置", "pole positions, moving plane")),
    Letter(_acted_on, r"h(_?\{?[\w,′]+\}?)?", Words("力臂", "arm of a force")),
    Letter(_pressed, r"n(_\{?\d+\}?)?", Words("接触面的法线", "normal of a contact")),
    Letter(_pressed, r"φ(_\{?\w+\}?)?", Words("摩擦角", "angle of friction"), "φ"),
    Letter(_pressed, r"F['′]", Words("阻止滑动的力", "force that prevents sliding")),
    Letter(_projected, r"[a-z]_\{[a-z]′?\}", Words("$v$ 在力作用线上的投影", "$v$ projected on a force")),
    Letter(_of_lever, r"d_\{[a-z]′?\}", Words("力到 $p$ 的距离", "arm of a force about $p$")),
    Letter(_taken_apart, r"O_\{?\d+\}?", Words("接触处的曲率中心", "centre of curvature at a contact")),
    Letter(is_of_gear, r"P", Words("节点", "pitch point")),
    Letter(is_of_gear, r"N", Words("啮合极限点", "limit of contact")),
    Letter(is_of_gear, r"E|F", Words("节线上的齿槽宽", "space width on the rolling line")),
    Letter(is_of_gear, r"S", Words("过渡曲线与渐开线的交点", "fillet meets involute")),
    Letter(is_of_gear, r"S′", Words("切出 $S$ 时的齿条角点", "rack's corner as it cuts $S$")),
    Letter(is_of_gear, r"K", Words("齿顶的啮合点", "contact at the tip")),
    Letter(_seen("torque"), r"a′?", Words("一个周期的始、末", "ends of the period")),
    Letter(_seen("torque"), r"[b-z]", Words("两力矩线的交点", "the curves of both moments meet")),
    Letter(_seen("torque"), r"S_\d", Words("力矩线下的面积", "area under the moments")),
    Letter(_motion, r"m_1", Words("推程压力角最大处", "maximum $α$ of the rise")),
    Letter(_motion, r"m_2", Words("回程压力角最大处", "maximum $α$ of the return")),
    Letter(_motion, r"m_3", Words("曲率半径最小处", "minimum radius of curvature")),
    Letter(is_of_cam, r"r_\{(\d+)\}", Words("$φ$ = {}° 处的向径", "radius at $φ$ = {}°")),
    Letter(_of_flat_face, r"P_[12]", Words("推程、回程中离 $O$ 最远的瞬心", "farthest instant centre, rise, return")),
    Letter(_of_flat_arm, r"T_[12]", Words("离垂足最近、最远的切点", "nearest, farthest contact")),
    Letter(_of_flat_arm, r"A_[12]\^′", Words("$A$ 在相应平底上的垂足", "foot of $A$ on that face")),
    Letter(_of_flat_arm, r"A_[12]", Words("相应的摆轴位置", "pivot in that position")),
    Letter(is_of_cam, r"C_0", Words("起始导路的垂足", "foot of the first guide")),
    Letter(is_of_cam, r"B_0", Words("推程起始点", "start of the rise")),
    Letter(_named("alpha_rise", "alpha_return", "rho_min"), r"P", Words("相对瞬心", "relative instant centre")),
    Letter(_named("alpha_rise", "alpha_return", "rho_min"), r"n", Words("公法线", "common normal")),
    Letter(_named("rho_min"), r"K", Words("曲率中心", "centre of curvature")),
    Letter(_named("rho_min"), r"u′", Words("$P$ 换位速度 $u$ 的分量", "component of the velocity $u$ of $P$")),
)
