"""What every key about marking means."""

from __future__ import annotations

from ...words import Words

MARKING = {
    "Problem.rules": Words("批改规则", "rules of marking"),
    "Problem.rubric": Words("各部分的分值", "points by part of a solution"),
    "Problem.points": Words("各量的分值，按题号", "points of single quantities, by problem"),
    "Problem.totals": Words("各题的满分，须与分值相符", "total points by problem, which must come out"),
    "RulesSpec.close": Words("接近而不够准确时所得的准确分：0.5", "share of the accuracy mark for what is close: 0.5"),
    "RulesSpec.own": Words("仅按自己前面的值正确时所得的份额：1", "share for what is right by own values only: 1"),
    "RulesSpec.slip": Words(
        "错误原因已知时所得的方法分：0.5", "share of the method mark where a mistake is named: 0.5"
    ),
    "RulesSpec.turned": Words("方向错时所得的方法分：0.5", "share of the method mark for a wrong direction: 0.5"),
    "RulesSpec.unit": Words("单位缺或错，每题扣一次：0.5", "points lost once a problem for units: 0.5"),
    "RulesSpec.printed": Words("单位已印在卷上，不扣分", "units are printed on the sheet, and cost nothing"),
    "RulesSpec.independent": Words("不据以连带评分的量：[bc2]", "quantities from which nothing is continued: [bc2]"),
    "RulesSpec.first": Words(
        "须先作答、否则不连带评分的量：[v_C]", "quantities without which nothing is continued: [v_C]"
    ),
    "RulesSpec.reach": Words("相差超过几倍的值不据以连带：5", "own values farther off than this factor: 5"),
    "RulesSpec.following": Words("是否连带评分", "whether own values are continued from"),
    "RulesSpec.drawing": Words(
        "图线的分数：只告知（told）、交图者据图（given）、必须据图（required）",
        "points of lines by a drawing: only told, given where one is handed in, required",
    ),
    "RulesSpec.open": Words("尚可再交，反馈不给出正确值", "answers may be handed in again: no right values are told"),
    "RulesSpec.compensatory": Words(
        "没有列出方程表的，数值仍得准确分", "numbers have their accuracy marks without a ticked vector equation too"
    ),
    "RubricSpec.diagram": Words("机构图", "the kinematic diagram"),
    "RubricSpec.velocity": Words("速度分析", "velocities"),
    "RubricSpec.acceleration": Words("加速度分析", "accelerations"),
    "RubricSpec.force": Words("力分析", "forces"),
    "RubricSpec.other": Words("其余", "the rest"),
    "BlockSpec.scale": Words("写出比例尺及其单位", "the scale, stated with its unit"),
    "BlockSpec.drawn": Words("图线", "the lines as drawn"),
    "BlockSpec.equation": Words(
        "图线分中划给方程的方向、大小表的分数（填了表时）",
        "of those for lines, what goes to the rows of the equations where filled in",
    ),
    "BlockSpec.values": Words("读数与比例尺相乘之值", "values read off"),
    "BlockSpec.rates": Words("ω、α 的大小和转向", "ω and α, size and sense"),
    "PointsSpec.method": Words("方法分", "for the way"),
    "PointsSpec.accuracy": Words("准确分", "for the number"),
    "PointsSpec.sense": Words("转向分", "for the sense of turning"),
}
