"""What the symbols that are asked for stand for: a symbol alone tells a student little."""

from __future__ import annotations

import re
from collections.abc import Mapping

from ...designs.base import Design
from ...designs.grashof import Grashof
from ...designs.limits_found import GuideBarLimits
from ...designs.quick_return import Shaper
from ...devices.balancing.rotor import Rotor
from ...devices.balancing.shaking import ShakingForce
from ...devices.base import Device
from ...devices.dynamics.flywheel import Flywheel
from ...devices.gears.generation import GearGeneration
from ...devices.structure import Structure
from ...words import Words
from . import cam_words
from .device_words import DEVICES

_COUNTS = {
    "n(_low)?": Words("活动构件数", "number of moving links"),
    "p_l(_low)?": Words("低副数", "number of lower pairs"),
    "p_h": Words("高副数", "number of higher pairs"),
    "F_local": Words("局部自由度", "number of passive degrees of freedom"),
    "p_redundant": Words("虚约束", "number of redundant constraints"),
    "F(_low)?": Words("自由度", "degree of freedom"),
}
_ROTOR = {
    "e_per": Words("许用偏心距", "permissible eccentricity"),
    "U_per.*": Words("许用不平衡量", "permissible unbalance"),
    "W_S": Words("静不平衡的质径积", "mass-radius product of the static unbalance"),
    "W_b[^_]*": Words("平衡质径积", "balancing mass-radius product"),
    "W_r.*": Words("剩余质径积", "residual mass-radius product"),
    r"W_\w+": Words("质径积", "mass-radius product"),
    "m_b[^_]*": Words("平衡质量", "balancing mass"),
    r"m_\w+": Words("质量", "mass"),
    "theta_b[^_]*": Words("平衡质量的方位角", "angular position of the balancing mass"),
    "theta_h.*": Words("钻孔的方位角", "angular position of the hole"),
    r"theta_\w+": Words("方位角", "angular position"),
    "d_b.*": Words("孔径", "diameter of the hole"),
    "h_b.*": Words("孔深", "depth of the hole"),
    "C_.*": Words("质径积对基准面的矩", "mass-radius-distance product"),
}
_SHAKING = {
    "m_rot": Words("回转质量", "rotating mass"),
    "m_rec": Words("往复质量", "reciprocating mass"),
    "lambda": Words("曲柄连杆比", "crank-rod ratio"),
    "F_1": Words("一阶惯性力的幅值", "amplitude of the first-order inertia force"),
    "F_2": Words("二阶惯性力的幅值", "amplitude of the second-order inertia force"),
    "m_c": Words("平衡质量", "counterweight"),
    "c": Words("往复质量的平衡系数", "balanced fraction of the reciprocating mass"),
    "F_max": Words("最大振动力", "maximum shaking force"),
    "phi_max": Words("最大振动力的位置", "position of the maximum shaking force"),
    "F": Words("振动力", "shaking force"),
}
_FLYWHEEL = {
    "P": Words("驱动功率", "driving power"),
    "M_d": Words("驱动力矩", "driving moment"),
    "M_r": Words("阻力矩的大小", "magnitude of the resisting moment"),
    "omega_max": Words("最大角速度", "maximum angular velocity"),
    "omega_min": Words("最小角速度", "minimum angular velocity"),
    r"phi_[a-z]\d*": Words("力矩线交点的位置", "place where the curves meet"),
    r"W_\d+": Words("盈亏功", "surplus or deficit of work"),
    "J_need": Words("所需的全部等效转动惯量", "equivalent moment of inertia that is needed in all"),
    "delta": Words("速度不均匀系数", "coefficient of speed fluctuation"),
    "n_max": Words("最大转速", "maximum speed"),
    "n_min": Words("最小转速", "minimum speed"),
    "phi_max": Words("最大转速的位置", "position of maximum speed"),
    "phi_min": Words("最小转速的位置", "position of minimum speed"),
    "E_.*": Words("动能的变化", "change of the kinetic energy"),
    "dW_max": Words("最大盈亏功", "maximum fluctuation of energy"),
    "J_F2": Words("另一轴上飞轮的转动惯量", "moment of inertia of a flywheel on the other shaft"),
    "J_F": Words("飞轮的转动惯量", "moment of inertia of the flywheel"),
    "GD2": Words("飞轮矩", "flywheel moment"),
    "m_rim": Words("轮缘质量", "mass of the rim"),
    "h": Words("轮缘厚度", "thickness of the rim"),
    "b": Words("轮缘宽度", "width of the rim"),
    "v_rim": Words("轮缘的圆周速度", "speed of the rim"),
    "J_rim": Words("轮缘的转动惯量", "moment of inertia of the rim"),
}
_GEAR = {
    "r": Words("分度圆半径", "radius of the reference circle"),
    "rb": Words("基圆半径", "radius of the base circle"),
    "ra": Words("齿顶圆半径", "radius of the tip circle"),
    "rf": Words("齿根圆半径", "radius of the root circle"),
    "x_min": Words("最小变位系数", "minimum profile shift"),
    "z_min": Words("最少齿数", "minimum number of teeth"),
    "s": Words("分度圆齿厚", "tooth thickness on the reference circle"),
    "s_tip": Words("齿顶厚", "tooth thickness at the tip"),
    "r_start": Words("渐开线起始圆半径", "radius at which the involute begins"),
}
_DESIGN = {
    "K": Words("行程速比系数", "time ratio"),
    "psi(_.*)?": Words("摇杆的摆角", "swing of the rocker"),
    "H": Words("行程", "stroke"),
    "epsilon_max": Words("最大结构误差", "maximum structural error"),
    "theta(_.*)?": Words("极位夹角", "angle between the limit positions"),
    "gamma_min(_.*)?": Words("最小传动角", "minimum transmission angle"),
    "alpha_max(_.*)?": Words("最大压力角", "maximum pressure angle"),
}
_GUIDE_BAR = _DESIGN | {"psi(_.*)?": Words("导杆的摆角", "swing of the guide bar")}
_GRASHOF = {
    "ends": Words("最短杆与最长杆长度之和", "sum of the shortest and the longest link"),
    "middle": Words("其余两杆长度之和", "sum of the two remaining links"),
    "CD_min": Words("双摇杆机构机架长度的下限", "lower bound of the frame of the double rocker"),
    "CD_max": Words("双摇杆机构机架长度的上限", "upper bound of the frame of the double rocker"),
}
_CD = _GRASHOF | {  # where other links give a double rocker, too, the one that is varied is told
    "CD_min": Words("以 $CD$ 为机架得双摇杆机构时其长度的下限", "lower bound of $CD$ as the frame of a double rocker"),
    "CD_max": Words("以 $CD$ 为机架得双摇杆机构时其长度的上限", "upper bound of $CD$ as the frame of a double rocker"),
}
_REACTION = re.compile(r"R_(\d)(\d)")
_NAMED: tuple[tuple[type | tuple[type, ...], Mapping[str, Words]], ...] = (
    (Structure, _COUNTS),
    (Rotor, _ROTOR),
    (ShakingForce, _SHAKING),
    (Flywheel, _FLYWHEEL),
    (GearGeneration, _GEAR),
    ((GuideBarLimits, Shaper), _GUIDE_BAR),
    (Grashof, _GRASHOF),
    (Design, _DESIGN),
    *DEVICES,
)


def meant_by(subject: object, key: str, symbol: str) -> Words | None:
    """The quantity with what it is, 低副数 $p_L$; None of one that no table of names has, or that the statement
    tells."""
    if (cam := cam_words.meant_by(subject, key, symbol)) is not None:
        return cam
    names = next((names for kind, names in _NAMED if isinstance(subject, kind)), {})
    if isinstance(subject, Grashof) and not subject.is_found:
        names = _CD
    if isinstance(subject, Device) and (pair := _REACTION.fullmatch(key)) is not None:
        return Words(
            f"构件 {pair[1]} 对构件 {pair[2]} 的力 {symbol}", f"force of link {pair[1]} on link {pair[2]} {symbol}"
        )
    found = next((words for pattern, words in names.items() if re.fullmatch(pattern, key)), None)
    return None if found is None else found + Words.same(f" {symbol}")
