"""A description of every key of a machine, in both languages."""

from __future__ import annotations

from ...words import Words

MACHINE = {
    "Problem.machine": Words(
        "机器如何运转：平均转速与不均匀系数，或初始状态",
        "how the machine runs: mean speed and coefficient of speed fluctuation, or a start",
    ),
    "MachineSpec.n": Words("平均转速：60 r/min", "the mean speed: 60 r/min"),
    "MachineSpec.delta": Words("许用不均匀系数：0.05", "the allowed coefficient of speed fluctuation: 0.05"),
    "MachineSpec.J_F": Words("已有的飞轮转动惯量：6 kg*m^2", "the flywheel that is there: 6 kg*m^2"),
    "MachineSpec.start": Words("初始状态：{phi: 30 deg, omega: 0 rad/s}", "where and how fast it starts"),
    "MachineSpec.until": Words("原动件转过多大角度为止：360 deg", "how far the drive is followed: 360 deg"),
    "MachineSpec.at": Words(
        "转过这些角度时的速度与时间：[90 deg]", "speed and time asked after these angles: [90 deg]"
    ),
    "StartSpec.phi": Words("原动件的初始位置", "where the driving link starts"),
    "StartSpec.omega": Words("原动件的初始角速度", "how fast it turns there"),
    "Problem.counterweights": Words(
        "平衡惯性力的配重：构件号与到其转动中心的距离，{1: {r: 60 mm}, 3: {r: 100 mm}}",
        "counterweights that balance the inertia forces: link and distance from its pivot, {1: {r: 60 mm}}",
    ),
    "CounterweightSpec.r": Words("配重到该构件转动中心的距离：60 mm", "its distance from the pivot of its link: 60 mm"),
}
