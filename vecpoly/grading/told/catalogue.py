"""Every sentence that a student may be told about an answer."""

from __future__ import annotations

from collections.abc import Mapping

from ...words import Words
from .named import Told

SENTENCES: Mapping[Told, Words] = {
    Told.OK: Words("正确（误差 {e} mm，允许 ±{t} mm）", "Correct (error {e} mm, allowed ±{t} mm)"),
    Told.OK_RECKONED: Words("正确（误差 {e}，允许 ±{t}）", "Correct (error {e}, allowed ±{t})"),
    Told.OK_ROUNDED: Words(
        "正确（误差 {e}；允许 ±{t}，所写末位的舍入使之放宽到 ±{w}）",
        "Correct (error {e}; allowed ±{t}, and ±{w} with the rounding of the last digit written)",
    ),
    Told.OK_OWN: Words(
        "按你前面的 ${src}$ = {v} 计算，本步正确，不重复扣分",
        "Right when continued from your ${src}$ = {v}; not penalised again",
    ),
    Told.OK_SLIP: Words(
        "与 ${src}$ 处的错误一致，不重复扣分", "Follows from the mistake at ${src}$; not penalised again"
    ),
    Told.OK_DRAWN: Words(
        "与你图上的线（{v}）一致，读数正确，不重复扣分", "Read rightly off your own line ({v}); not penalised again"
    ),
    Told.CLOSE: Words(
        "接近：相差 {e}，作图或量取不够准确（允许 ±{t}）",
        "Close: off by {e}; drawing or reading not accurate enough (allowed ±{t})",
    ),
    Told.WRONG: Words("不正确：与正确值相差 {e}（允许 ±{t}）", "Not correct: off by {e} (allowed ±{t})"),
    Told.BESIDE: Words(
        "不正确：作图误差沿 {a} 方向较大，而此点偏在一侧 {e}（允许 ±{t}）",
        "Not correct: drawings scatter along {a}, and it lies {e} to the side (allowed ±{t})",
    ),
    Told.WRONG_FROM: Words("按你的 ${src}$ = {v} 应得 {own}", "From your ${src}$ = {v} follows {own}"),
    Told.SENSE: Words(
        "大小正确，转向相反：请在图上重新判断转向（如将切向矢量移到机构图上）",
        "Magnitude right, sense reversed: judge it again on the drawing (place the tangential vector on the link)",
    ),
    Told.SENSE_TOO: Words("转向也相反", "Its sense is reversed, too"),
    Told.SENSE_MISSING: Words("没有写转向", "Its sense is not stated"),
    Told.SIGN: Words("大小正确，符号相反", "Magnitude right, sign reversed"),
    Told.SIGN_FREE: Words(
        "此量取大小，正负号只是约定，不影响判定", "Asked as a magnitude; its sign is a convention and costs nothing"
    ),
    Told.REVERSED: Words(
        "大小正确，方向相反：请检查箭头由哪一点指向哪一点",
        "Magnitude right, direction reversed: check from which point to which the arrow runs",
    ),
    Told.DIRECTION: Words("大小正确，但方向差 {d}°", "Magnitude right, direction off by {d}°"),
    Told.SIZE_OWN: Words(
        "（大小按你前面的 ${src}$ = {v} 判定）", "(the magnitude judged by your earlier ${src}$ = {v})"
    ),
    Told.UNIT_MISSING: Words("缺单位（应为 {u}），同题只扣一次", "Unit missing ({u}); deducted once per question"),
    Told.UNIT_WRONG: Words(
        "单位“{given}”不是此量的单位（应为 {u}），同题只扣一次",
        "'{given}' is no unit of this quantity ({u}); deducted once per question",
    ),
    Told.UNIT_NONE: Words(
        "此量没有单位，所写的“{given}”多余，同题只扣一次",
        "This quantity has no unit, and '{given}' is written; deducted once per question",
    ),
    Told.POW10: Words(
        "数字对，差 10 的 {n} 次方：检查单位换算、比例尺或小数点",
        "Digits right, off by 10^{n}: check the unit, the scale, the decimal point",
    ),
    Told.TURNS: Words(
        "与少乘（或多乘）2π 的结果一致：r/s 不是 rad/s", "Matches a 2π left out (or too many): r/s is not rad/s"
    ),
    Told.PER_MINUTE: Words(
        "与把 r/min 当作 rad/s（或相反）的结果一致", "Matches r/min taken for rad/s, or the other way round"
    ),
    Told.DEGREES: Words(
        "与把度当作弧度（或相反）的结果一致", "Matches degrees taken for radians, or the other way round"
    ),
    Told.SCALE_CONST: Words(
        "各结果同乘 {k}：比例尺 ${mu}$ 用错，只扣一次",
        "All results differ by the same factor {k}: wrong scale ${mu}$; deducted once",
    ),
    Told.EVERYTHING: Words("全部结果同乘 {k}，只扣一次", "All is {k} times what it should be; deducted once"),
    Told.SCALE_UNDECLARED: Words("没有写比例尺 ${mu}$ 及其单位", "The scale ${mu}$ and its unit are not stated"),
    Told.SCALE_ODD: Words(
        "比例尺 ${mu}$ = {v} 不是推荐值（1、2、2.5、5 × 10ⁿ）", "The scale ${mu}$ = {v} is none of 1, 2, 2.5, 5 × 10ⁿ"
    ),
    Told.SLIP: Words("与“${what}$ {mistake}”的结果一致", "Matches what follows when ${what}$ is {mistake}"),
    Told.EITHER: Words(
        "与{ways}的结果一致（这几种错误给出同样的数值）",
        "Matches what follows when {ways} (these give the same numbers)",
    ),
    Told.CORIOLIS: Words(
        "与漏掉哥氏加速度 2$ω$·$v_r$（${what}$）的结果一致",
        "Matches the result without the Coriolis term 2$ω$·$v_r$ (${what}$)",
    ),
    Told.CORIOLIS_2: Words(
        "与哥氏加速度 ${what}$ = 2$ω$·$v_r$ 漏乘 2 的结果一致", "Matches the 2 of ${what}$ = 2$ω$·$v_r$ left out"
    ),
    Told.TWO_SLIPS: Words(
        "不止一种错误能得到这些结果，不能断定原因",
        "More than one mistake gives these results; which one cannot be told",
    ),
    Told.SWAPPED: Words(
        "这是 ${other}$ 的值：是否取错了量？", "This is the value of ${other}$: was the wrong one taken?"
    ),
    Told.EXCHANGED: Words("与 ${other}$ 互换：名称写反，或{ways}", "Exchanged with ${other}$: the names, or {ways}"),
    Told.COORDINATE_SIGN: Words("坐标的正负号不对", "The sign of a coordinate is wrong"),
    Told.DIVIDED: Words(
        "与把 ${line}$ 内分（应为外分），或外分（应为内分）的结果一致",
        "Matches ${line}$ divided between its ends in place of beyond them, or the other way round",
    ),
    Told.TRANSLATES: Words("构件 {link} 平动，此量为 0", "Link {link} does not turn here, it translates: this is 0"),
    Told.ZERO: Words("此量为零", "This quantity is zero"),
    Told.NOT_ZERO: Words("不正确：此量不为零", "Not correct: this quantity is not zero"),
    Told.READ: Words(
        "与你自己量得的 {mm} mm × {mu} = {own} 不一致", "Does not agree with your own reading: {mm} mm × {mu} = {own}"
    ),
    Told.NOT_FOLLOWED: Words(
        "你的 ${src}$ 为零、单位不对或相差 5 倍以上，不能据以连带计分",
        "Your ${src}$ is zero, of another dimension or off by more than a factor 5; nothing is continued from it",
    ),
    Told.UNDRAWABLE: Words(
        "按你前面的结果图形不能闭合，已转人工批改",
        "With your earlier results the figure does not close; sent to manual marking",
    ),
    Told.FEW_DIGITS: Words(
        "有效数字太少（{n} 位），图解法宜取 3 位", "Too few significant digits ({n}); 3 suit a drawing"
    ),
    Told.MANY_DIGITS: Words(
        "有效数字太多（{n} 位），图解法宜取 3 位", "Too many significant digits ({n}); 3 suit a drawing"
    ),
    Told.DEMOTED: Words(
        "此处作图对误差极敏感：手工作图本身就散布 ±{t}（{share}%），不能判得更细；此量宜计算求得",
        "Drawings scatter by ±{t} ({share} %) here: it can be judged no more finely, and is better computed",
    ),
    Told.BLANK: Words("没有作答", "Not answered"),
    Told.NONE: Words("写作“{raw}”，按没有作答处理", "Written as '{raw}': taken as not answered"),
    Told.UNREADABLE: Words(
        "无法识别“{raw}”，已转人工批改：{why}", "Could not read '{raw}'; sent to manual marking: {why}"
    ),
    Told.AMBIGUOUS: Words(
        "“{raw}”自相矛盾，已转人工批改：{why}", "'{raw}' contradicts itself; sent to manual marking: {why}"
    ),
    Told.RIGHT: Words("正确", "Correct"),
    Told.NEARLY: Words("接近，作图或量取不够准确", "Close; drawing or reading not accurate enough"),
    Told.NOT_RIGHT: Words("不正确", "Not correct"),
    Told.TICK_GIVEN: Words(
        "{terms} 的{row}是已知的（已作出，或可由已知量算出）",
        "The {row} of {terms} is given: drawn already, or found from what is known",
    ),
    Told.TICK_UNKNOWN: Words(
        "{terms} 的{row}是未知的，要由图求出", "The {row} of {terms} is unknown: the drawing finds it"
    ),
    Told.NO_EQUATION: Words(
        "矢量方程没有列对，此值不得准确分", "The vector equation is not right: no accuracy mark for this value"
    ),
    Told.TURNED: Words("大小正确，但方向不对", "Magnitude right, direction wrong"),
    Told.RENUMBERED: Words(
        "各解的先后不作规定，所写的编号按此对应：{pairs}", "Solutions have no order; yours are taken so: {pairs}"
    ),
    Told.OTHER_SOLUTION: Words(
        "所答的是第 {n} 个解，同样满足题目条件", "This is solution {n}, which satisfies the conditions as well"
    ),
    Told.NOT_READ: Words("无法识别“{raw}”：{why}", "Could not read '{raw}': {why}"),
    Told.CONTRADICTION: Words("“{raw}”自相矛盾：{why}", "'{raw}' contradicts itself: {why}"),
    Told.NOT_CLOSED: Words("按你前面的结果图形不能闭合", "With your earlier results the figure does not close"),
    Told.NO_UNIT_OF_IT: Words(
        "“{given}”不是此量的单位（应为 {u}）", "'{given}' is no unit of this quantity (it should be {u})"
    ),
    Told.HAS_NO_UNIT: Words("此量没有单位，所写的“{given}”多余", "This quantity has no unit, and '{given}' is written"),
    Told.NO_UNIT: Words("缺单位（应为 {u}）", "Unit missing ({u})"),
    Told.NUMBER_RIGHT: Words("数值正确，但单位不对", "The number is right, its unit is not"),
    Told.FOLLOWS_OWN: Words("按你前面的 ${src}$ = {v} 计算，本步正确", "Right when continued from your ${src}$ = {v}"),
    Told.FOLLOWS_SLIP: Words("与 ${src}$ 处的错误一致，本步正确", "Follows rightly from the mistake at ${src}$"),
    Told.FOLLOWS_DRAWN: Words("与你图上的线（{v}）一致，读数正确", "Read rightly off your own line ({v})"),
    Told.ONE_FACTOR: Words(
        "各结果同乘 {k}：比例尺 ${mu}$ 用错", "All results differ by the same factor {k}: wrong scale ${mu}$"
    ),
}
