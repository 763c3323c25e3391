"""Symbols that the words, the tables and the template of a course report use beside those of its formulas."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from ...words import Words
from ..flow.table import DataTable

Row = tuple[str, Words, str]

COUNTED: tuple[Row, ...] = (  # in the chapter on the structure, which every report has
    ("$n$、$p_L$、$p_H$", Words("活动构件数、低副数、高副数", "numbers of moving links, lower, higher pairs"), "—"),
    ("$F$", Words("机构的自由度", "degrees of freedom"), "—"),
)
_ROWS: tuple[tuple[str, Row], ...] = (
    ("$K$ = ", ("$K$", Words("行程速比系数", "time ratio of the strokes"), "—")),
    ("$θ$ = ", ("$θ$", Words("极位夹角", "angle between the limit positions of the drive"), "°")),
    ("$J_e$", ("$J_e$", Words("等效转动惯量", "equivalent moment of inertia"), "kg·m²")),
    ("$M_e$", ("$M_e$", Words("等效力矩", "equivalent moment"), "N·m")),
    ("∫$M$", ("$E$", Words("动能的增量", "change of the kinetic energy"), "J")),
    ("$ΔW", ("$ΔW$", Words("盈亏功", "surplus or deficit of work"), "J")),
    ("$ω_m", ("$ω_m$", Words("平均角速度", "mean angular velocity"), "rad/s")),
    ("$δ$", ("$δ$", Words("速度不均匀系数", "coefficient of speed fluctuation"), "—")),
    ("$J_F$", ("$J_F$", Words("飞轮的转动惯量", "moment of inertia of the flywheel"), "kg·m²")),
    ("$r_{Si}$", ("$r_{Si}$", Words("由简化中心到质心 $S_i$ 的矢径", "position vector of the centre $S_i$"), "m")),
    ("$m_c r_c$", ("$m_c r_c$", Words("配重的质径积", "mass-radius product of a counterweight"), "kg·m")),
    ("$F_I$", ("$F_I$", Words("总惯性力", "resultant inertia force"), "N")),
    ("$M_I$", ("$M_I$", Words("总惯性力矩", "resultant inertia moment"), "N·m")),
)


def used(told: str) -> Iterator[Row]:
    """The rows of those that stand in these words."""
    yield from (row for token, row in _ROWS if token in told)


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
