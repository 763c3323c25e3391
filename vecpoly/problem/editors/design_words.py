"""A description of every datum of every task of synthesis, in both languages."""

from __future__ import annotations

from ...words import Words
from .position_words import POSITIONS

_TAKE = Words("取第几个解（按编号），默认 1", "which of the solutions is meant, by its number; 1 where nothing is said")

_OMEGA = Words(
    "所得机构作分析时曲柄的角速度，默认 1 rad/s", "of the crank, where what is found is analysed; else 1 rad/s"
)
_K = Words("行程速比系数", "coefficient of the quick return: time of the slow stroke over the quick one")

DESIGNS = {
    **POSITIONS,
    "crank-rocker.omega": _OMEGA,
    "crank-rocker.take": _TAKE,
    "crank-rocker.K": Words(
        "行程速比系数", "coefficient of the quick return: time of the slow stroke over the quick one"
    ),
    "crank-rocker.CD": Words("摇杆长", "the rocker"),
    "crank-rocker.swing": Words("摇杆摆角", "swing of the rocker"),
    "crank-rocker.ADC": Words("一个极限位置的 ∠ADC", "angle ADC in one limit position"),
    "crank-rocker.AD": Words("机架长", "the frame"),
    "crank-rocker.AB": Words("曲柄长", "the crank"),
    "crank-rocker.BC": Words("连杆长", "the coupler"),
    "crank-rocker.gamma_min": Words("最小传动角", "minimum transmission angle"),
    "crank-rocker.A": Words(
        "A 所在的直线，如 on y = -20 mm（D 为原点）", "the line of A, D being the origin: on y = -20 mm"
    ),
    "crank-rocker.best": Words("使最小传动角最大", "gamma_min: the maximum minimum transmission angle"),
    "slider-crank.take": _TAKE,
    "slider-crank.omega": _OMEGA,
    "slider-crank.K": _K,
    "slider-crank.H": Words("滑块行程", "stroke of the slider"),
    "slider-crank.e": Words("偏距", "offset of the guide from A"),
    "slider-crank.AB": Words("曲柄长", "the crank"),
    "slider-crank.BC": Words("连杆长", "the coupler"),
    **{
        f"{kind}.{key}": words
        for kind in ("shaper", "whitworth")
        for key, words in {
            "take": _TAKE,
            "omega": _OMEGA,
            "K": _K,
            "H": Words("滑枕或滑块的行程", "stroke of the ram, or of the slider"),
            "AB": Words("曲柄长", "the crank"),
            "AC": Words("机架长", "the frame"),
            "DE": Words("连杆长", "the rod to the ram, or to the slider"),
        }.items()
    },
    "limit-lines.take": _TAKE,
    "limit-lines.omega": _OMEGA,
    "limit-lines.C1": Words("C 的一个极限位置，如 (0, 0) mm", "C in one limit position: (0, 0) mm"),
    "limit-lines.C2": Words("C 的另一极限位置", "C in the other limit position"),
    "limit-lines.line_1": Words("C1 处连杆线的方向角", "direction of the coupler's line at C1"),
    "limit-lines.line_2": Words("C2 处连杆线的方向角", "direction of the coupler's line at C2"),
    "limit-lines.alpha_1": Words("C1 处的压力角", "pressure angle at C1"),
    **{
        f"{kind}.{key}": words
        for kind in ("crank-rocker-limits", "slider-crank-limits", "guide-bar-limits", "dead-centre", "drag-link")
        for key, words in {
            "take": _TAKE,
            "omega": _OMEGA,
            "AB": Words("曲柄长", "the crank"),
            "BC": Words("连杆长", "the coupler"),
            "CD": Words("摇杆长", "the rocker"),
            "AD": Words("机架长", "the frame"),
            "AC": Words("机架长", "the frame"),
            "e": Words("偏距", "offset: of the guide from A, of the guide bar from C"),
            "K": _K,
            "psi_1": Words("DC 在第一位置的方向角", "direction of DC in the first position"),
            "psi_2": Words("DC 在死点位置的方向角", "direction of DC at the dead centre"),
            "phi_12": Words(
                "曲柄由位置 1 到位置 2 的转角（逆时针为正）",
                "turn of the crank from the first position to the dead centre",
            ),
            "phi_1": Words("AB 在第一位置的方向角", "direction of AB in the first position"),
        }.items()
    },
}
