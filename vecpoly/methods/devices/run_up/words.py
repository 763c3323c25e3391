"""What the steps of a run say."""

from __future__ import annotations

from ....algebra.quantity import number
from ....board.construction import View
from ....devices.dynamics.run_up import RunUp
from ....words import Words
from .course import Course

SECTIONS = {
    "run": Words("起动", "Run-up"),
    "free": Words("自由停车", "Running down"),
    "braked": Words("制动停车", "Braking"),
}
_OF = {"run": Words("", ""), "free": Words("（自由停车）", ", running down"), "braked": Words("（制动）", ", braked")}
HEAD = (
    Words.same("$ω$ /(rad/s)"),
    Words.same("$M_d$ /(N·m)"),
    Words.same("$M_r$ /(N·m)"),
    Words.same("$ΔM$ /(N·m)"),
    Words.same("$1/|ΔM|$ /(N·m)^{−1}"),
)
DRIVING, RESISTING = 1, 2  # the columns of M_d and M_r
INVERSES = Words(
    "由 $J$ d$ω$/d$t$ = $ΔM$ 得 $t$ = $J$ ∫ d$ω$/$ΔM$。由两曲线间的距离求 $y = 1/|ΔM|$，作 $y$–$ω$ 线图，"
    "线下的面积 $A_y$ 即为所求的积分，量得：",
    "From $J$ d$ω$/d$t$ = $ΔM$ follows $t$ = $J$ ∫ d$ω$/$ΔM$. Take $ΔM$ off the characteristics, plot "
    "$y = 1/|ΔM|$ versus $ω$; the area $A_y$ below it is the integral. It is measured:",
)
INVERSES_AGAIN = Words(
    "同样作 $y = 1/|ΔM|$ 随 $ω$ 变化的线图，量得线下的面积 $A_y$，求时间：",
    "In the same way plot $y = 1/|ΔM|$ versus $ω$ and measure the area $A_y$ below it, which gives the time:",
)
SPEEDS = Words(
    "曲线下到转速 $ω$ 为止的面积，即达到该转速所需的时间 $t$；由此作 $ω$–$t$ 线图，线下的面积 $A_φ$ 即为转过的角度 "
    "$φ$：",
    "The area under the curve up to the speed $ω$ is the time $t$ taken to reach it, which gives the curve $ω(t)$; the "
    "area $A_φ$ under $ω(t)$ is the angle $φ$ turned:",
)
SPEEDS_AGAIN = Words(
    "由此再作 $ω$–$t$ 线图，量得线下的面积 $A_φ$，求转角：",
    "From it again plot the curve of $ω$ versus $t$ and measure the area $A_φ$ below it, which gives the angle:",
)


def resisting(course: Course) -> str:
    """What slows the machine down: M_r, and the moment of the brake where it is on."""
    return "M_r + M_b" if course.name == "braked" else "M_r"


def head(course: Course) -> tuple[Words, ...]:
    """The columns of the table of a run."""
    return (*HEAD[:RESISTING], Words.same(f"${resisting(course)}$ /(N·m)"), *HEAD[RESISTING + 1 :])


def drawn(course: Course) -> Words:
    """Which curves are drawn."""
    if course.name == "run":
        return Words(
            "作电动机的机械特性 $M_d$ 和阻力矩 $M_r$ 随转速变化的曲线。静止时（$A$ 点）驱动力矩为：",
            "Draw the characteristics of the motor, $M_d$, and of the load, $M_r$, over the speed. At rest (point $A$) "
            "the motor has:",
        )
    brake = Words("与制动力矩之和", " together with the brake") if course.name == "braked" else Words("", "")
    return (
        Words("作阻力矩", "Draw the resisting moment")
        + brake
        + Words(f" ${resisting(course)}$ 随 $ω$ 变化的曲线。", f", ${resisting(course)}$, versus $ω$.")
    )


def steady() -> Words:
    """Why the motion is stable at the crossing."""
    return Words(
        "两曲线交于 $S$ 点（其在 $ω$ 轴上的垂足为 $S′$），$M_d = M_r$，转速稳定。转速略升则 $M_d < M_r$，略降则 "
        "$M_d > M_r$（d$M_d$/d$ω$ < d$M_r$/d$ω$），机组具有自调性，$S$ 为稳定工作点：",
        "At $S$, where the curves cross (its foot on the axis of $ω$ is $S′$), $M_d = M_r$ and the speed is steady. A "
        "little above it $M_d < M_r$, a little below $M_d > M_r$ (d$M_d$/d$ω$ < d$M_r$/d$ω$): operation at $S$ is "
        "stable:",
    )


def goal(device: RunUp, course: Course) -> Words:
    """Where the run-up ends."""
    share = 100 * device.share
    return Words(
        f"起动计算到稳定转速的 {share:g} %，即 $ω_1$ = {number(course.goal)} rad/s。",
        f" The run-up is followed to {share:g} % of it, $ω_1$ = {number(course.goal)} rad/s.",
    )


def then(at: str) -> Words:
    """Where the speed at a given time is read."""
    return Words(
        f"在 $t$ 轴上取 $t_1$ = {at} 得 $H$，其正上方曲线上的点为 $P$，$HP$ 代表该时刻的角速度 $ω_t$。",
        f" At $t_1$ = {at} on the axis of $t$ lies $H$, and $P$ on the curve right above it; $HP$ stands for the speed "
        "$ω_t$ at that time.",
    )


def titles(view: View, name: str) -> Words:
    """The title of a figure."""
    return view.title + _OF[name]
