"""What the steps of a flywheel say."""

from __future__ import annotations

from ....algebra.quantity import number
from ....devices.dynamics.curve import Curve
from ....devices.dynamics.given import Torques
from ....words import Words

SECTION = Words("力矩线图", "Diagram of moments")
GIVEN_SECTION = Words("各段盈亏功", "Surpluses and deficits")
GIVEN = Words(
    "各块面积乘以 $μ_A$ 即为该段的盈亏功，盈功为正，亏功为负。",
    "Each area times $μ_A$ is the work gained, negative where it is lost.",
)
AREAS = Words(
    "$M_d$ 与 $M_r$ 的交点顺次标以字母。$M_d > M_r$ 处为盈功（斜线右上），$M_d < M_r$ 处为亏功（斜线右下）。"
    "量出各块面积（亏功取负），乘以 $μ_A$（$μ_{φ}$ 须以弧度计）。",
    "Letter the points where $M_d$ and $M_r$ meet. Where $M_d > M_r$ there is a surplus of work (hatched upwards to "
    "the right), where $M_d < M_r$ a deficit. Measure the areas, those of deficits negative, and multiply by $μ_A$ "
    "($μ_{φ}$ in radians).",
)


def curves_drawn(load: Torques) -> Words:
    """Which curves are laid off."""
    names = {"d": "$M_r$", "r": "$M_d$", "": ""}[load.sought]
    zh = f"{names} 线" if names else "$M_d$、$M_r$ 两线"
    en = f"the curve of {names}" if names else "the curves of $M_d$ and $M_r$"
    return Words(
        f"取转角比例尺 $μ_{{φ}}$ 和力矩比例尺 $μ_M$，由各点的力矩作一个周期的 {zh}。",
        f"Choose scales $μ_{{φ}}$ and $μ_M$, lay off the moments and draw {en} over a period.",
    )


def constant(load: Torques) -> Words:
    """Why the other one has this height."""
    one, other = ("M_d", "M_r") if load.sought == "d" else ("M_r", "M_d")
    dips = load.highest[0] < 0
    below = Words("（横轴以下为负）", " (areas below the axis are negative)") if dips else Words("", "")
    less = _against(one, load.driving if load.sought == "d" else load.resisting)
    return Words(
        f"稳定运转时一个周期内驱动功等于阻力功，故常数力矩 ${one}$ 的矩形与 ${other}$ 线下的面积相等{below.zh}。"
        f"量出 ${other}$ 线与横轴所围的面积 $S_i$ 和周期的长度 $OT${less.zh}：",
        f"In steady motion the driving and the resisting moment do equal work in a period, so the rectangle under the "
        f"constant ${one}$ has the same area as ${other}$ encloses{below.en}. "
        f"Measure the areas $S_i$ between ${other}$ and the axis, and the length $OT$ of the period{less.en}:",
    )


def _against(name: str, moment: Curve) -> Words:
    """That a constant moment is negative, and does what the other one is called after."""
    if min(moment.sizes) >= 0:
        return Words("", "")
    zh, en = ("阻碍", "resists") if name == "M_d" else ("驱动", "drives")
    return Words(f"（${name}$ 为负，实际上起{zh}作用）", f" (${name}$ is negative: it {en})")


def shared(left: float) -> Words:
    """What the works miss zero by."""
    return Words(
        f"各功之和应为零，量得 {number(left)} J，为量面积的误差，按各块大小分摊。",
        f" Their sum should be zero and is {number(left)} J; this error of reading is distributed over the areas in "
        "proportion to their sizes.",
    )


def extremes(top: str, bottom: str) -> Words:
    """Which tip is the highest, and which the lowest."""
    return Words(
        f"最高点 ${top}$ 处动能最大，转速为 $ω_{{max}}$；最低点 ${bottom}$ 处动能最小，转速为 $ω_{{min}}$。"
        "两点之间的能量差即最大盈亏功：",
        f" The energy is greatest at ${top}$, the highest point, and so is the speed, $ω_{{max}}$; both are least at "
        f"${bottom}$, the lowest, $ω_{{min}}$. Between them lies the maximum surplus of work:",
    )


def read_off_bar(top: str, bottom: str, between: float) -> Words:
    """What the energies themselves give for the swing that is read off the bar."""
    difference = f"$E_{{{top}}}$ − $E_{{{bottom}}}$ = {number(between)} J"
    return Words(
        f"图上量得；由各点能量相减，{difference}", f"read off the bar; by the energies themselves {difference}"
    )


BAR_SECTION = Words("能量指示图", "Energy-fluctuation diagram")
BAR = Words(
    "取能量比例尺 $μ_E$，从基线起顺次画各功：盈功向上，亏功向下；一个周期后应回到基线。",
    "Choose a scale $μ_E$. Beginning at the base line, lay off the works one after the other, surpluses upwards and "
    "deficits downwards; after a period the last one ends on the base line.",
)
INERTIA_SECTION = Words("飞轮的转动惯量", "Moment of inertia of the flywheel")
UNEVEN_SECTION = Words("速度不均匀系数", "Coefficient of speed fluctuation")
SPEED_SECTION = Words("平均角速度", "Mean angular velocity")
SPEED = Words("由平均转速求平均角速度：", "The mean speed gives the mean angular velocity:")
POWERS = Words(
    "角速度变化不大，各段的等效阻力矩按 $M_r = P / ω_m$ 计算：",
    "The speed changes little, so in each part of the cycle the resisting moment is $M_r = P / ω_m$:",
)
ENOUGH = Words(
    "已有的转动惯量足以使 $δ$ 不超过许用值，不需要飞轮。",
    " What turns already keeps $δ$ below what is allowed: no flywheel is needed.",
)
UNEVEN = Words("速度不均匀系数与最大、最小转速：", "The coefficient of speed fluctuation and the extreme speeds are:")
EXTREME = Words("装上飞轮后 $δ$ = [$δ$]，最大、最小转速为：", "With the flywheel $δ$ = [$δ$]; the extreme speeds are:")
