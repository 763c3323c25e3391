"""A description of every datum of the linkages through given positions, in both languages."""

from __future__ import annotations

from ...words import Words

_ONTO = Words("在第几个位置取该构件为机架，默认 1", "in which position the link is taken for the frame; 1 by default")
_TAKE = Words("取第几个解（按编号），默认 1", "which of the solutions is meant, by its number; 1 where nothing is said")
_OMEGA = Words(
    "所得机构作分析时原动件的角速度，默认 1 rad/s", "of the driver, where what is found is analysed; else 1 rad/s"
)

POSITIONS = {
    **{f"{kind}.omega": _OMEGA for kind in ("positions", "angle-pairs", "stages", "cognates")},
    "positions.take": _TAKE,
    "positions.poses": Words(
        "平面 S 的二至四个位置，如 (30, 5) mm at 20 deg", "two to four positions of the body S: (30, 5) mm at 20 deg"
    ),
    "positions.body": Words("S 上已知的铰链 B、C（随 S 的坐标）", "the pins B, C given on S, in the coordinates of S"),
    "positions.frame": Words("已知的固定铰链 A、D", "the pivots A, D that are given"),
    **{
        f"positions.{letter}": Words(f"{letter} 所在的机架上的直线", f"the line of the frame that carries {letter}")
        for letter in "AD"
    },
    **{
        f"positions.{letter}": Words(f"{letter} 所在的 S 上的直线", f"the line of S that carries {letter}")
        for letter in "BC"
    },
    "positions.onto": _ONTO,
    "angle-pairs.take": _TAKE,
    "angle-pairs.pairs": Words(
        "两组或三组对应位置：40 deg -> 30 deg，或 40 deg -> 62 mm（滑块）",
        "two or three corresponding positions: 40 deg -> 30 deg, or 40 deg -> 62 mm of a slider",
    ),
    "angle-pairs.AB": Words("主动连架杆长", "the input link"),
    "angle-pairs.AD": Words("机架长", "the frame"),
    "angle-pairs.guide": Words("滑块铰链 C 的导路，如 on y = -10 mm", "the guide of the slider's pin C: on y = -10 mm"),
    "angle-pairs.C": Words(
        "两组时 C 所在的直线（以 D 为原点、DE 为 x 轴），默认 DE",
        "of two pairs the line of C, from D with DE for the x axis; DE itself by default",
    ),
    "angle-pairs.B": Words(
        "两组时 B 所在的直线（以 A 为原点、AE 为 x 轴），默认 AE",
        "of two pairs the line of B, from A with AE for the x axis; AE itself by default",
    ),
    "angle-pairs.onto": _ONTO,
    "stages.take": _TAKE,
    "stages.frame": Words("固定铰链", "the fixed pivots"),
    "stages.links": Words("已知的构件长度", "the lengths of links that are given"),
    "stages.rays": Words(
        "由标线方向给定的构件，AB 自 A 起，原动件在先",
        "links known by the directions of a line of theirs, AB from A; the driver first",
    ),
    "stages.points": Words("滑块铰链的各位置", "the places of the pins of sliders"),
    "stages.stages": Words("依次求出的铰链", "the pins that are found, in order"),
    "Step.find": Words("反转法所求的铰链", "the pin that is found by inversion"),
    "Step.on": Words("该铰链所在的构件", "the link that it is on"),
    "Step.from": Words("与它相联的已知铰链", "the known pin that a bar joins it to"),
    "Step.line": Words("它所在直线上的两铰链", "two pins, where it lies on the line between them"),
    "Step.onto": _ONTO,
    "Step.join": Words("由两已知长度联接的铰链", "the pin of two links of known length"),
    "Step.to": Words("这两构件另一端的铰链", "the pins at their other ends"),
    "Step.side": Words("在这两铰链射线的哪一侧", "on which side of the ray between these"),
    "Step.limits": Words("求其另一极限位置的摇杆铰链", "the rocker's pin whose other limit is found"),
    "Step.crank": Words("曲柄", "the crank"),
    "Step.K": Words("行程速比系数", "coefficient of the quick return"),
    "Step.first": Words("给定的极限位置", "the limit position that is given"),
    "Step.limit": Words("给定的是左极限还是右极限", "whether it is the left limit or the right one"),
    "cognates.take": _TAKE,
    "cognates.AB": Words("连架杆长", "the first link on the frame"),
    "cognates.BC": Words("连杆长", "the coupler"),
    "cognates.CD": Words("另一连架杆长", "the other link on the frame"),
    "cognates.AD": Words("机架长", "the frame"),
    "cognates.E": Words("连杆上的点（以 B 为原点、BC 为 x 轴）", "the coupler's point, from B with BC for the x axis"),
    "cognates.phi": Words("AB 的转角", "the angle of AB"),
    "cognates.side": Words("C 在射线 BD 的哪一侧", "on which side of the ray BD C lies"),
    "function-generator.take": _TAKE,
    "function-generator.omega": _OMEGA,
    "function-generator.AD": Words("机架长", "the frame"),
    "function-generator.pairs": Words(
        "三组对应角，如 35 deg -> 50 deg（AB 的转角 -> DC 的转角，均自 x 轴量起）",
        "three pairs of angles, of AB -> of DC, both from the x axis: 35 deg -> 50 deg",
    ),
    "function-generator.function": Words("要发生的函数，如 log10(x)", "the function to be generated: log10(x)"),
    "function-generator.x": Words("自变量的范围，如 [1, 2]", "the range of x: [1, 2]"),
    "function-generator.phi": Words("AB 的起始角和终止角", "the angles of AB at both ends of the range"),
    "function-generator.psi": Words("DC 的起始角和终止角", "the angles of DC at both ends of the range"),
    "straight-line.take": _TAKE,
    "straight-line.omega": _OMEGA,
    "straight-line.AB": Words("主动连架杆长", "the input link"),
    "straight-line.BC": Words("连杆长", "the coupler"),
    "straight-line.CD": Words("从动连架杆长", "the output link"),
    "straight-line.AD": Words("机架长", "the frame"),
    "straight-line.E": Words("连杆点（随 BC 的坐标）", "the coupler point, in the coordinates of BC"),
    "straight-line.phi": Words("AB 转角的范围", "from which angle of AB to which"),
    "straight-line.side": Words("C 在射线 BD 的左侧还是右侧", "on which side of the ray BD the pin C lies"),
    "grashof.take": _TAKE,
    "grashof.omega": _OMEGA,
    "grashof.AB": Words("AB 长，AB、BC、AD 中最短者", "AB, the shortest of AB, BC and AD"),
    "grashof.BC": Words("BC 长", "BC"),
    "grashof.CD": Words("CD 长", "CD"),
    "grashof.AD": Words("AD 长", "AD"),
}
