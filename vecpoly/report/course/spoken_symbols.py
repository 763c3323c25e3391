"""Symbols that the words, the tables and the template of a course report use beside those of its formulas."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from ...words import Words
from ..flow.table import DataTable

Row = tuple[str, Words, str]

COUNTED: tuple[Row, ...] = (  # in the chapter on the structure, which every report has
    ("$n$、$p_L$、$p_H$", Words("活动构件数、低副数、高副数", "numbers of moving links, lower, higher pairs"), "—"),
    ("$F$", Words("机构的自由度", "degrees of freedom"), "—"),
)
_OF_FORCES: tuple[tuple[str, Row], ...] = (  # where none act these letters are points and their images
    (r"\$m_\{?[\di]", ("$m_i$", Words("构件 $i$ 的质量", "mass of link $i$"), "kg")),
    (r"\$S_\{?[\di]", ("$S_i$", Words("构件 $i$ 的质心", "centre of mass of link $i$"), "—")),
    (
        r"\$J_\{?S",
        ("$J_{Si}$", Words("构件 $i$ 对质心的转动惯量", "moment of inertia of link $i$ about $S_i$"), "kg·m²"),
    ),
    (r"\$h(_[^$]+)?\$", ("$h$", Words("力（力偶）的力臂", "arm of a force or couple"), "m")),
)
_ROWS: tuple[tuple[str, Row], ...] = (  # what they follow from is how they are written
    (r"\$K\$ = ", ("$K$", Words("行程速比系数", "time ratio of the strokes"), "—")),
    (r"\$θ\$ = ", ("$θ$", Words("极位夹角", "angle between the limit positions of the drive"), "°")),
    (r"\$J_e\$", ("$J_e$", Words("等效转动惯量", "equivalent moment of inertia"), "kg·m²")),
    (r"\$M_e\$", ("$M_e$", Words("等效力矩", "equivalent moment"), "N·m")),
    (r"∫\$M\$", ("$E$", Words("动能的增量", "change of the kinetic energy"), "J")),
    (r"\$ΔW", ("$ΔW$", Words("盈亏功", "surplus or deficit of work"), "J")),
    (r"\$ω_m", ("$ω_m$", Words("平均角速度", "mean angular velocity"), "rad/s")),
    (r"\$δ\$", ("$δ$", Words("速度不均匀系数", "coefficient of speed fluctuation"), "—")),
    (r"\$J_F\$", ("$J_F$", Words("飞轮的转动惯量", "moment of inertia of the flywheel"), "kg·m²")),
    (r"\$r_\{Si\}\$", ("$r_{Si}$", Words("由简化中心到质心 $S_i$ 的矢径", "position vector of the centre $S_i$"), "m")),
    (r"\$m_c r_c\$", ("$m_c r_c$", Words("静平衡配重的质径积", "mass-radius product, static balance"), "kg·m")),
    (r"\$F_I\$", ("$F_I$", Words("总惯性力", "resultant inertia force"), "N")),
    (r"\$M_I\$", ("$M_I$", Words("总惯性力矩", "resultant inertia moment"), "N·m")),
    (
        r"\$k\$ = \d",
        ("$N$、$k$", Words("瞬心数、构件数（含机架）", "numbers of centres, of links with the frame"), "—"),
    ),
    *_OF_FORCES,
    (r"\$W_\{?c", ("$W_{ci}$", Words("构件 $i$ 上配重的质径积", "mass-radius product on link $i$"), "kg·m")),
    (r"\$P_\{?[FM]", ("$P_F$、$P_M$", Words("力、力矩的功率", "powers of a force, of a moment"), "W")),
)


def used(told: str, *, loaded: bool) -> Iterator[Row]:
    """The rows of those that stand in these words; loaded: whether forces act, or masses are given."""
    rows = (row for row in _ROWS if loaded or row not in _OF_FORCES)
    yield from (row for written, row in rows if re.search(written, told))


def words_in(thing: object) -> str:
    """All words of chapters, and of tables among the objects of a report."""
    match thing:
        case str():
            return thing
        case DataTable():
            return "\n".join((thing.caption, *thing.header, *(cell for row in thing.rows for cell in row)))
        case Mapping():
            return "\n".join(map(words_in, thing.values()))
        case Sequence():
            return "\n".join(map(words_in, thing))
        case _:
            return ""
