"""What the heads of the table of verification are, what those mean that do not say all, and how a sentence has it."""

from __future__ import annotations

from ...words import Words

NUMBER = Words("解", "No.")
NONE, YES, NO = Words.same("—"), Words("是", "yes"), Words("否", "no")
MARGIN = Words("杆长余量", "Margin")
ERROR, CIRCUIT = Words("杆长相差", "Length error"), Words("无回路、分支缺陷", "No circuit or branch defect")
GAMMA = Words.same("$γ_{min}$")
BETWEEN = Words("$γ_{min}$（给定位置之间）", "$γ_{min}$ between positions")
TYPE = Words("机构类型", "Type")
DRIVER = Words("原动件，能否整周转动", "Driver, rotates fully")
TYPE_OF, ALL_TURNS = Words("$ABCD$ 的类型", "Type of $ABCD$"), Words("加装杆组后整周转动", "All links rotate fully")
MEANT = {  # heads that do not say all
    ERROR: Words(
        "“杆长相差”为同一杆在各给定位置的最大长度之差",
        "“Length error” is the largest difference of one link's length between the given positions",
    ),
    CIRCUIT: Words(
        "“无回路、分支缺陷”指机构不经重新装配即可依次通过各给定位置",
        "“No circuit or branch defect”: the linkage passes through all given positions without reassembly",
    ),
    MARGIN: Words(
        "“杆长余量”为其余两杆之和减去最短杆与最长杆之和",
        "“Margin” is the sum of the other two lengths minus the sum of the shortest and the longest",
    ),
    ALL_TURNS: Words(
        "“加装杆组后整周转动”：四杆机构 $ABCD$ 的曲柄即使能转整周，加装的杆组也未必能随之转满一周",
        "“All links rotate fully”: what is added to the four-bar linkage $ABCD$ need not follow a full turn of its "
        "crank",
    ),
    GAMMA: Words("$γ_{min}$ 为最小传动角", "$γ_{min}$ is the minimum transmission angle"),
    BETWEEN: Words("$γ_{min}$ 为最小传动角", "$γ_{min}$ is the minimum transmission angle"),
}
ORDER, SWING, STROKE = Words("次序", "Order"), Words("摆角", "Swing"), Words("行程", "Stroke")
BROKEN = Words("不能运动", "does not move")
SAID = {  # the same of a single solution, in a sentence
    ERROR: Words("同一杆在各给定位置的长度最多相差 {}", "the length of a link varies by {} at most"),
    CIRCUIT: Words("机构无回路缺陷和分支缺陷", "the linkage has no circuit or branch defect"),
    ORDER: Words("位置次序为 {}", "it takes them in the order {}"),
    TYPE: Words("为{}", "it is a {}"),
    TYPE_OF: Words("$ABCD$ 为{}", "type of $ABCD$: {}"),
    MARGIN: Words(
        "其余两杆之和减去最短杆与最长杆之和为 {}",
        "the sum of the other two lengths minus the sum of the shortest and the longest is {}",
    ),
    SWING: Words("摆角为 {}", "the swing is {}"),
    STROKE: Words("行程为 {}", "the stroke is {}"),
    BETWEEN: Words(
        "在给定各位置之间最小传动角为 {}", "between the given positions the transmission angle is at least {}"
    ),
}
OF_ALL = Words("各解中，", "In every solution ")
TURNS = {YES: Words("能", "turns"), NO: Words("不能", "does not turn")}
