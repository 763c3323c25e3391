"""Why a linkage that was found on paper is no solution."""

from __future__ import annotations

from enum import Enum

from ..words import Words


class Verdict(Enum):
    """What is said of a candidate."""

    VALID = Words("可用", "valid")
    OPPOSITE = Words(
        "$C_1$、$C_2$ 不在 $AD$ 的同一侧，$A$ 在禁用弧上，摇杆不能连续摆过",
        "$C_1$ and $C_2$ do not lie on one side of $AD$: $A$ is on the forbidden arc, the rocker cannot swing across",
    )
    FAR_ARC = Words(
        "此处弦 $C_{1}C_{2}$ 所张的角是 $180° − θ$ 而不是 $θ$",
        "from there the chord $C_{1}C_{2}$ is seen under $180° − θ$",
    )
    AT_LIMIT = Words(
        "$A$ 与摇杆极限位置的 $C$ 重合：$l_{AB} = l_{BC}$、$l_{AD} = l_{CD}$，机构在此折叠，运动不确定",
        "$A$ coincides with $C$ in a limit position: $l_{AB} = l_{BC}$ and $l_{AD} = l_{CD}$, so the linkage folds up "
        "there and its motion is not determined",
    )
    NO_CRANK = Words(
        "$A$ 在 $C_{1}C_{2}$ 的中垂线上，$l_{AB} = 0$", "$A$ lies on the bisector of $C_{1}C_{2}$: $l_{AB} = 0$"
    )
    ACROSS = Words(
        "$A$ 到导路的垂足在 $C_1$、$C_2$ 之间，滑块不能连续滑过此行程；应使 $e < H cot θ$",
        "the foot of the perpendicular from $A$ to the guide lies between $C_1$ and $C_2$: the slider cannot pass "
        "from one "
        "to the other; take $e < H cot θ$",
    )
    CIRCUIT = Words(
        "各位置不在同一装配回路中，须拆开机构才能通过",
        "its positions belong to different circuits: it would have to be taken apart",
    )
    BRANCH = Words(
        "各位置之间原动件经过死点，运动不连续", "between the positions its driver meets a dead point (branch defect)"
    )
    NO_LINK = Words("有两个铰链重合，构件长度为零", "two of its pins coincide: a link has no length")
    ORDER = Words("通过各位置的次序不对（错序）", "it comes through the positions in another order")
    OTHER_SIDE = Words(
        "两位置中 $C$ 不在 $BD$ 的同一侧，机构不能连续到达", "$C$ lies on different sides of $BD$ in the two positions"
    )
    NO_DOUBLE_CRANK = Words(
        "不是双曲柄机构，$AB$ 与 $CD$ 不能都整周转动",
        "no double crank: $AB$ and $CD$ do not both make full revolutions",
    )
    REVERSED = Words(
        "$C_1$ 在给定射线 $DC_1$ 的反向延长线上，$DC_1$ 的方向角为 $ψ_1 ± 180°$；此机构须取 $ψ_1 ± 180°$ 为 $ψ_1$",
        "$C_1$ lies on the given ray $DC_1$ produced backwards beyond $D$: $DC_1$ would stand at $ψ_1 ± 180°$, which "
        "is to be given as $ψ_1$ if this linkage is meant",
    )
    RANGE = Words(
        "在所给范围内经过死点，不能走完全程",
        "it meets a dead point within the given range and cannot pass through all of it",
    )
