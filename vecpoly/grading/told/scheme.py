"""What a class is marked by, told: a table of points, and a sentence for each rule that is not the usual one."""

from __future__ import annotations

from collections.abc import Sequence

from ...words import Lang, Words
from ..derive.blocks import ACCELERATION, DIAGRAM, FORCE, OTHER, VELOCITY
from ..key import AnswerKey
from ..rules import USUAL_RULES, Rules

Row = list[str | float]
_HEAD = (
    Words("题号", "problem"),
    Words("量", "quantity"),
    Words("部分", "part"),
    Words("方法分", "method"),
    Words("准确分", "accuracy"),
    Words("方向或转向分", "direction or sense"),
    Words("合计", "total"),
)
_PARTS = {
    DIAGRAM: Words("机构图", "diagram"),
    VELOCITY: Words("速度", "velocities"),
    ACCELERATION: Words("加速度", "accelerations"),
    FORCE: Words("力", "forces"),
    OTHER: Words("其余", "the rest"),
}
SCHEME = Words("分值", "points")
_OF_LINES = Words("（填了表时，出自图线的方法分）", " (where filled in; from the method marks of its lines)")
_SCALE, _SUM = Words("比例尺", "scale"), Words("满分", "all")
_SAID = {
    "close": Words("接近而不够准确的，得准确分的 {v}", "what is close has {v} of its accuracy mark"),
    "own": Words("按自己前面的值正确的，得其分值的 {v}", "what is right by own earlier values has {v} of its points"),
    "slip": Words("错误原因已知的，得方法分的 {v}", "a mistake that is named keeps {v} of the method mark"),
    "turned": Words("方向错的，得方法分的 {v}", "a wrong direction keeps {v} of the method mark"),
    "unit": Words("单位缺或错，每题扣 {v} 分", "missing or wrong units cost {v} points once a problem"),
    "printed": Words("单位没有印在卷上，缺或错要扣分", "units are not printed on the sheet, and cost points"),
    "independent": Words("不据 {v} 连带评分", "nothing is continued from {v}"),
    "first": Words("未答 {v} 的不连带评分", "nothing is continued unless {v} is answered"),
    "reach": Words("与正确值相差 {v} 倍以上的不据以连带", "nothing is continued from what is off by {v} times or more"),
    "following": Words("不连带评分", "nothing is followed through"),
    "drawing": Words("图线的分数：{v}", "points of lines by a drawing: {v}"),
    "compensatory": Words(
        "矢量方程没有列对的部分，数值不得准确分", "no accuracy marks in a part whose vector equations are not right"
    ),
    "open": Words("尚可再交，不给出正确值", "answers may be handed in again; no right values are told"),
}
_DRAWING = {
    "told": Words("不由图给分", "none"),
    "given": Words("交了图的由图给分", "of whoever hands one in"),
    "required": Words("必须交图", "a drawing is required"),
}
_SHARES = ("close", "own", "slip", "turned")


def scheme_rows(keys: Sequence[AnswerKey], rules: Rules, lang: Lang) -> list[Row]:
    """A header; of every problem what each quantity is worth and for what, its scales, the sum; then the rules."""
    told: list[Row] = [[said.of(lang)] for said in rules_told(rules)]
    return [*_point_rows(keys, lang), *told]


def _point_rows(keys: Sequence[AnswerKey], lang: Lang) -> list[Row]:
    rows: list[Row] = [[word.of(lang) for word in _HEAD]]
    for key in keys:
        for one in key.quantities:
            if one.points.total:
                worth = (one.points.method, one.points.accuracy, one.points.sense, one.points.total)
                rows.append([key.problem, one.key, _PARTS[one.block].of(lang), *(round(each, 3) for each in worth)])
        told = [(row, _PARTS[row.block] + _OF_LINES) for row in key.equations if row.points]
        rows += [[key.problem, row.key, part.of(lang), "", "", "", round(row.points, 3)] for row, part in told]
        rows += [[key.problem, mu, _SCALE.of(lang), "", "", "", points] for mu, points in key.stated.items()]
        rows.append([key.problem, "", _SUM.of(lang), "", "", "", round(key.worth, 3)])
    return rows


def rules_told(rules: Rules) -> tuple[Words, ...]:
    """A sentence for each rule that differs from the usual ones."""
    changed = [name for name in _SAID if getattr(rules, name) != getattr(USUAL_RULES, name)]
    return tuple(_put(_SAID[name], _value(name, getattr(rules, name))) for name in changed)


def _put(said: Words, value: Words) -> Words:
    return Words(said.zh.format(v=value.zh), said.en.format(v=value.en))


def _value(name: str, value: object) -> Words:
    match value:
        case tuple():
            return Words.same(", ".join(map(str, value)))
        case float() | int() if name in _SHARES:
            return Words.same(f"{100 * value:g} %")
        case str() if name == "drawing":
            return _DRAWING[value]
        case _:
            return Words.same(f"{value:g}" if isinstance(value, float) else str(value))
