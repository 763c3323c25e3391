"""The conditions of the gate, in the order in which they are looked at, and what to relax where one of them fails too
often."""

from __future__ import annotations

from enum import StrEnum

from ..words import Words


class Condition(StrEnum):
    """Why a variant is not given to anybody."""

    REFUSED = "refused"
    ASSEMBLED = "assembled"
    DEAD_POINT = "dead_point"
    SENSES = "senses"
    SHORT = "short"
    ACTS = "acts"
    FRAME = "frame"
    MEETINGS = "meetings"
    VECTORS = "vectors"
    DEVIATION = "deviation"
    SLIPS = "slips"
    APART = "apart"

    @property
    def words(self) -> Words:
        """What fails."""
        return _SAID[self][0]

    @property
    def remedy(self) -> Words:
        """What to change in the file."""
        return _SAID[self][1]


_NARROW = Words("缩小 vary 的范围", "narrow the ranges of vary")
_ALIKE = Words("缩小 vary 的范围，或写 gate: {alike: no}", "narrow the ranges of vary, or write gate: {alike: no}")
_SHORT = Words("减小 gate.vectors（如 10 mm），或缩小范围", "lower gate.vectors (say to 10 mm), or narrow the ranges")
_SAID = {
    Condition.REFUSED: (Words("数据不成立", "the data contradict each other"), _NARROW),
    Condition.ASSEMBLED: (Words("机构不能装配", "the links cannot be assembled"), _NARROW),
    Condition.DEAD_POINT: (
        Words("离死点太近", "too near to a dead point"),
        Words(
            "缩小原动件位置的范围，或减小 gate.dead_point", "narrow the range of the drive, or lower gate.dead_point"
        ),
    ),
    Condition.SENSES: (Words("转向与原题不同", "senses differ from those of the problem"), _ALIKE),
    Condition.SHORT: (
        Words("矢量大小过于悬殊，短者量不准", "vectors so unlike that the short ones cannot be read"),
        _SHORT,
    ),
    Condition.ACTS: (Words("作图过程与原题不同", "the construction is another than that of the problem"), _ALIKE),
    Condition.FRAME: (
        Words("图形超出图框", "figures larger than their frames"),
        Words("去掉 scales 中给定的比例尺，或取较大的比例尺", "leave the scales out, or give larger ones"),
    ),
    Condition.MEETINGS: (
        Words("线与线、弧与弧的交角太小", "lines or arcs meet at too small an angle"),
        Words("减小 gate.meetings，或缩小范围", "lower gate.meetings, or narrow the ranges"),
    ),
    Condition.VECTORS: (Words("所评矢量太短", "a graded vector is too short"), _SHORT),
    Condition.DEVIATION: (
        Words("所评量的作图误差太大", "a graded quantity cannot be drawn well enough"),
        Words("增大 gate.deviation，或不求该量", "raise gate.deviation, or do not ask for it"),
    ),
    Condition.SLIPS: (
        Words("有的错误从读数上看不出", "a slip does not show in the readings"),
        Words("减小 gate.slips，或缩小范围", "lower gate.slips, or narrow the ranges"),
    ),
    Condition.APART: (
        Words("与另一名学生的读数太接近", "readings too near to those of another student"),
        Words(
            "扩大 vary 的范围、减小步长，或减小 gate.apart", "widen the ranges, take smaller steps, or lower gate.apart"
        ),
    ),
}
