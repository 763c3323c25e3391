"""A description of every datum of a machine in motion: flywheel, run-up, train reduced to a shaft."""

from __future__ import annotations

from ...words import Words

MOVING = {
    "flywheel.M_d": Words("等效驱动力矩；略去：由面积相等求出的常数", "the driving moment; left out: constant"),
    "flywheel.M_r": Words("等效阻力矩；略去：由面积相等求出的常数", "the resisting moment; left out: constant"),
    "flywheel.period": Words("周期，应与曲线终点一致", "the period, where the curves end"),
    "flywheel.areas": Words("各块面积（mm²），盈为正、亏为负", "areas (mm²), positive where work is gained"),
    "flywheel.mu_A": Words("面积比例尺", "the work of a square millimetre"),
    "flywheel.powers": Words("各段的转角和功率", "angles, each with its power"),
    "flywheel.n": Words("平均转速", "the mean speed"),
    "flywheel.delta": Words("许用速度不均匀系数", "the allowed coefficient of speed fluctuation"),
    "flywheel.J": Words(
        "飞轮以外（没有 delta 时：全部）的转动惯量",
        "moment of inertia without the flywheel; without delta: of all that turns",
    ),
    "flywheel.shaft": Words("另一可装飞轮的轴的转速", "speed of another shaft on which the flywheel may sit"),
    "flywheel.rim": Words("轮缘", "the rim"),
    "flywheel.measured": Words(
        "量面积的方法：squares 数方格，planimeter 求积仪", "how areas are read: squares, planimeter"
    ),
    "reduced-train.shafts": Words("各轴", "the shafts"),
    "reduced-train.pairs": Words("各对轮：1 to 2 by 20/30", "the pairs of wheels: 1 to 2 by 20/30"),
    "reduced-train.to": Words("等效构件所在的轴", "the shaft to which all is reduced"),
    "reduced-train.start": Words("该轴的初角速度", "its speed at the start"),
    "reduced-train.until": Words("起动到该轴的此转速", "the speed at which the run-up ends"),
    "reduced-train.after": Words("起动的时间", "the time for which it runs up"),
    "Shaft.J": Words("轴上零件的转动惯量，可列出几个", "moment of inertia of what sits on it, several in brackets"),
    "Shaft.drives": Words("驱动力矩", "the moment that drives it"),
    "Shaft.resists": Words("阻力矩", "the moment that resists"),
    "Shaft.drum": Words("卷筒直径（量到绳心）", "diameter of its drum, to the middle of the rope"),
    "Shaft.lifts": Words("提升的质量", "the mass that it lifts"),
    "run-up.motor": Words("电动机的机械特性；停车时略去", "characteristic of the motor; left out: it runs down"),
    "run-up.load": Words("阻力矩的特性", "characteristic of the load"),
    "run-up.brake": Words("制动力矩", "moment of the brake"),
    "run-up.J": Words("等效转动惯量", "equivalent moment of inertia"),
    "run-up.start": Words("初角速度", "speed at the start"),
    "run-up.to": Words("终了转速，或稳定转速的百分数", "speed at the end, or a share of the steady one"),
    "run-up.at": Words("要求其转速的时刻", "a time at which the speed is asked for"),
    "Rim.D": Words("平均直径", "mean diameter"),
    "Rim.b/h": Words("宽高比", "width over height"),
    "Rim.density": Words("密度", "density"),
    "Rim.v_max": Words("许用线速度", "the speed that is allowed"),
}
