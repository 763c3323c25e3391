"""Tasks of inversion in words: a body in positions, corresponding angles, a chain of stages."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from ...devices.defined import listed, sentence
from ...foundation.slotted import dataclass
from ...words import Words, joined
from ..place import OnLine, carried

_AXES = Words("$A$ 为原点，$D$ 在 $x$ 轴上", "$A$ is the origin, $D$ lies on the $x$ axis")
_COUNTED = Words("方向角自 $x$ 轴正向逆时针量起", "directions count counter-clockwise from the $x$ axis")
_NUMBERS = {2: Words("两个", "two"), 3: Words("三个", "three"), 4: Words("四个", "four")}
_TURNS = {"phi_AB": "AB", "phi_DC": "DC", "phi_AD": "AD"}


@dataclass(frozen=True, slots=True, kw_only=True)
class Pieces:
    """The letters of what is given of a chain of stages."""

    frame: tuple[str, ...]
    links: tuple[str, ...]
    rays: tuple[str, ...]
    points: tuple[str, ...]


def rocker_task(line: OnLine | None, count: int, *, turned: bool) -> Words:
    """Angles of AB and of a line DE of the output link; line: of C in the coordinates of DE, of two pairs;
    turned: whether the angle between pin and line is asked."""
    where = Words.same("")
    if line is not None:
        where = carried("C", line) + Words("（原点 $D$，$x$ 轴沿 $DE$）", " ($x$ axis along $DE$, origin $D$)")
    elif count == 2:
        where = Words("$C$ 在标线 $DE$ 上", "$C$ lies on the line $DE$")
    return sentence(
        Words(
            "用反转法设计铰链四杆机构 $ABCD$，使连架杆 $AB$ 的转角 $φ_i$ 与另一连架杆 $DC$ 上标线 $DE$ 的转角 $ψ_i$ "
            "对应",
            "design by inversion a four-bar linkage $ABCD$ in which the angles $φ_i$ of $AB$ correspond to the "
            "angles $ψ_i$ of a line $DE$ of the other link on the frame, $DC$",
        ),
        _AXES,
        Words("转角自 $x$ 轴逆时针量起", "angles count counter-clockwise from the $x$ axis"),
        where,
        *([_ahead("C", "DE")] if turned else []),
    )


def slider_task(guide: OnLine, line: OnLine | None, count: int, *, turned: bool) -> Words:
    """Angles of a line AE of the input link and places of the slider's pin C along its guide."""
    where = Words.same("")
    if line is not None:
        where = carried("B", line) + Words("（原点 $A$，$x$ 轴沿 $AE$）", " ($x$ axis along $AE$, origin $A$)")
    elif count == 2:
        where = Words("$B$ 在标线 $AE$ 上", "$B$ lies on the line $AE$")
    return sentence(
        Words(
            "用反转法设计曲柄滑块机构 $ABC$，使绕 $A$ 转动的连架杆 $AB$ 上标线 $AE$ 的转角 $φ_i$ 与滑块铰链 $C$ 的坐标 "
            f"${_along(guide)}_{{Ci}}$ 对应",
            "design by inversion a slider-crank $ABC$ in which the angles $φ_i$ of a line $AE$ of the link $AB$, "
            f"which turns about $A$, correspond to the places ${_along(guide)}_{{Ci}}$ of the slider's pin $C$",
        ),
        Words("$A$ 为原点", "$A$ is the origin"),
        Words("$φ_i$ 自 $x$ 轴逆时针量起", "$φ_i$ counts counter-clockwise from the $x$ axis"),
        carried("C", guide),
        where,
        *([_ahead("B", "AE")] if turned else []),
    )


def _along(guide: OnLine) -> str:
    return "x" if guide.along.real else "y"


def _ahead(pin: str, line: str) -> Words:
    return Words(
        f"$δ_{pin}$ 为 ${line[0]}{pin}$ 超前标线 ${line}$ 的角（逆时针为正）",
        f"$δ_{pin}$ is the angle by which ${line[0]}{pin}$ is ahead of the line ${line}$ (counter-clockwise positive)",
    )


def positions_task(count: int, lines: Sequence[tuple[str, OnLine, bool]], asked: Collection[str]) -> Words:
    """A body S in so many positions; lines: of pins, the last told whether in the coordinates of the body."""
    turned = [letters for key, letters in _TURNS.items() if key in asked]
    first = [f"$φ_{{{letters}}}$" for letters in turned]
    told = joined([Words.same(f"${letters}$") for letters in turned])
    return sentence(
        Words(
            f"设计铰链四杆机构 $ABCD$，使连杆平面（刚体）$S$ 通过给定的{_NUMBERS[count].zh}位置",
            f"design a four-bar linkage $ABCD$ that leads a body $S$ through {_NUMBERS[count].en} given positions",
        ),
        Words(
            "$A$、$D$ 为固定铰链，$B$、$C$ 为 $S$ 上的活动铰链，$AB$、$DC$ 为连架杆",
            "its pivots $A$ and $D$ lie on the frame, its pins $B$ and $C$ on $S$; $AB$ and $DC$ are its links on "
            "the frame",
        ),
        *(carried(letter, line, primed=primed) for letter, line, primed in lines),
        _COUNTED,
        *(
            [
                Words(
                    f"{'、'.join(first)} 为{told.zh} 在位置 1 的方向角",
                    f"{', '.join(first)} the directions of {told.en} in position 1",
                )
            ]
            if turned
            else []
        ),
    )


def stages_task(given: Pieces, steps: Sequence[Words], ahead: Sequence[str]) -> Words:
    """A linkage that is found pin by pin; ahead: the pins of which it is asked by how much they are ahead."""
    return sentence(
        Words("用反转法逐步设计多杆机构", "design a linkage by inversion, step by step"),
        *_known(given),
        *steps,
        *(
            Words(
                f"$δ_{pin}$ 为铰链 ${pin}$ 超前所在构件标线的角（逆时针为正）",
                f"$δ_{pin}$ is the angle by which the pin ${pin}$ is ahead of the line of its link (counter-clockwise "
                "positive)",
            )
            for pin in ahead
        ),
    )


def _known(given: Pieces) -> Iterator[Words]:
    """What there is before the first stage."""
    pivots = listed(given.frame)
    many = len(given.frame) > 1
    yield Words(f"{pivots.zh} 为固定铰链", f"{pivots.en} {'are fixed pivots' if many else 'is a fixed pivot'}")
    if given.links:
        bars = listed(given.links)
        yield Words(f"构件 {bars.zh} 的长度已知", f"the lengths of {bars.en} are given")
    for ray in given.rays:
        pinned = ray[0] in given.points
        whose = f"${ray[0]}$ 为滑块铰链" if pinned else f"构件绕 ${ray[0]}$ 转动"
        what = f"${ray[0]}$ being the pin of a slider" if pinned else f"which turns about ${ray[0]}$"
        yield Words(
            f"$φ_{{{ray}}}$ 为构件上标线 ${ray}$ 在各位置的方向角（{whose}）",
            f"$φ_{{{ray}}}$ are the directions of a line ${ray}$ of a link in its positions ({what})",
        )
    for pin in given.points:
        yield Words(
            f"${pin}_i$ 为滑块铰链 ${pin}$ 的各位置", f"${pin}_i$ are the positions of the pin ${pin}$ of a slider"
        )
    yield _COUNTED if given.rays else Words.same("")
