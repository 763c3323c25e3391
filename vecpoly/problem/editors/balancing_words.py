"""A description of every datum of a rotor, and of one that is balanced in place, in both languages."""

from __future__ import annotations

from ...words import Words

BALANCING = {
    "rotor.masses": Words("各不平衡质量，以下标为键", "the unbalanced masses, by their subscripts"),
    "rotor.correct": Words("校正平面，一个或两个", "the planes of correction, one or two"),
    "rotor.disc": Words("开孔圆盘的厚度和密度", "thickness and density of the disc with holes"),
    "rotor.bodies": Words("轴上的鼓体、轮体，只用于简图", "drums and pulleys on the shaft, for the sketch only"),
    "rotor.tolerance": Words("平衡品质等级", "the grade of balance quality"),
    "RotorMass.m": Words("质量；? 为待求", "mass; ? where it is sought"),
    "RotorMass.hole": Words("孔的直径（负质量）", "diameter of a hole (a negative mass)"),
    "RotorMass.keyway": Words("键槽的宽度（负质量）", "width of a keyway (a negative mass)"),
    "RotorMass.depth": Words("键槽或盲孔的深度", "depth of a keyway, or of a blind hole"),
    "RotorMass.U": Words("质径积，代替 m 和 r", "product of mass and radius, in place of m and r"),
    "RotorMass.r": Words("回转半径", "radius at which it sits"),
    "RotorMass.at": Words(
        "方位角，自 x 轴逆时针；? 为待求", "direction, counter-clockwise from x; ? where it is sought"
    ),
    "RotorMass.z": Words("轴向位置", "place along the axis"),
    "RotorMass.b": Words("该处的厚度", "thickness there"),
    "RotorMass.density": Words("该处的密度", "density there"),
    "RotorPlane.z": Words("平面的轴向位置", "place of the plane along the axis"),
    "RotorPlane.r": Words("校正半径", "radius of the correction"),
    "RotorPlane.hole": Words(
        "钻孔校正：through 求孔径，或写钻头直径求孔深", "drilled: through, or the diameter of the drill"
    ),
    "RotorPlane.spread": Words(
        "以两个相同的孔代替一个：每孔偏离所求方位的角",
        "two equal holes in place of one: angle of each from the direction found",
    ),
    "RotorPlane.b": Words("钻孔处的厚度", "thickness where it is drilled"),
    "RotorPlane.density": Words("钻孔处的密度", "density where it is drilled"),
    "RotorPlane.places": Words("允许加重的方位，或孔距", "the places where weights may sit, or their pitch"),
    "RotorPlane.use": Words("从中选用的两个方位", "two of these places"),
    "RotorPlane.only": Words("只许加重 add 或只许去重 remove", "weights may only be added (add), or removed (remove)"),
    "RotorPlane.step": Words("配重的级差", "by how much the weights there are differ"),
    "RotorDisc.b": Words("圆盘厚度", "thickness of the disc"),
    "RotorDisc.density": Words("圆盘密度", "density of the disc"),
    "RotorBody.from": Words("鼓体、轮体的一端（沿轴线）", "one end of a drum or pulley along the axis"),
    "RotorBody.to": Words("鼓体、轮体的另一端", "its other end"),
    "RotorBody.r": Words("鼓体、轮体的半径（只用于简图）", "its radius, for the sketch only"),
    "RotorTolerance.G": Words("等级 G = e ω", "the grade G = e ω"),
    "RotorTolerance.mass": Words("转子质量", "mass of the rotor"),
    "RotorTolerance.n": Words("工作转速", "working speed"),
    "RotorTolerance.z": Words("质心的轴向位置", "place of the centre of mass along the axis"),
    "field-balancing.initial": Words("初始振动，有相位时写 8.6 um at 63 deg", "the first vibration, 8.6 um at 63 deg"),
    "field-balancing.trials": Words("各次试重", "the trial runs"),
    "field-balancing.correct": Words("校正", "the correction"),
    "in-line-engine.cranks": Words("各曲柄的方向角", "directions of the cranks"),
    "in-line-engine.pitch": Words("缸距", "distance from cylinder to cylinder"),
    "in-line-engine.m": Words("每缸的往复质量", "reciprocating mass of a cylinder"),
    "in-line-engine.r": Words("曲柄半径", "crank radius"),
    "in-line-engine.l": Words("连杆长", "length of the connecting rod"),
    "in-line-engine.n": Words("转速", "speed"),
    "in-line-engine.order": Words("发火顺序", "firing order"),
    "shaking-force.r": Words("曲柄半径", "crank radius"),
    "shaking-force.l": Words("连杆长", "length of the connecting rod"),
    "shaking-force.n": Words("转速", "speed"),
    "shaking-force.m1": Words("曲柄换算到 B 点的不平衡质量", "unbalance of the crank, as a mass at B"),
    "shaking-force.m2": Words("连杆质量", "mass of the rod"),
    "shaking-force.BS2": Words("连杆质心到 B 的距离", "distance of its centre of mass from B"),
    "shaking-force.m3": Words("滑块质量", "mass of the slider"),
    "shaking-force.r_c": Words("配重的半径", "radius of the counterweight"),
    "shaking-force.c": Words(
        "往复质量被平衡的部分；best 为求最佳值", "part of the reciprocating mass that is balanced; or best"
    ),
    "shaking-force.at": Words("曲柄自外死点的转角", "angle of the crank from the outer dead centre"),
    "Trial.m": Words("试重的质量", "mass of the trial weight"),
    "Trial.r": Words("试重的半径", "its radius"),
    "Trial.at": Words("试重的方位", "its direction"),
    "Trial.reading": Words("加试重后的振动", "the vibration with it"),
    "FieldCorrection.r": Words("校正半径", "radius of the correction"),
    "FieldCorrection.trial": Words("试重取下 removed 或保留 left", "the trial weight is removed, or left"),
}
