"""What the quantities of devices are called where they are asked for, by their keys."""

from __future__ import annotations

from collections.abc import Mapping

from ...devices.balancing.engine import InlineEngine
from ...devices.balancing.field import FieldBalancing
from ...devices.dynamics.reduced import ReducedTrain
from ...devices.dynamics.run_up import RunUp
from ...devices.eccentric_clamp import EccentricClamp
from ...devices.gears.epicyclic import Epicyclic
from ...devices.incline import Incline
from ...devices.power_train import PowerTrain
from ...devices.ring_spring import RingSpring
from ...devices.screw_jack import ScrewJack
from ...devices.vee_guide import VeeGuide
from ...devices.wedge_clamp import WedgeClamp
from ...devices.wedges import Wedges
from ...words import Words

_ENGINE = {
    "lambda": Words("曲柄连杆比", "crank-rod ratio"),
    "theta_I+": Words("质径积矢量和的方位角", "direction of the vector sum of the products"),
    "theta_MI+": Words("质径积矩矢量和的方位角", "direction of the vector sum of the moments"),
    "W_I+": Words("质径积的矢量和", "vector sum of the products"),
    "F_I+": Words("惯性力", "inertia force"),
    "C_I+": Words("质径积对中间平面之矩的矢量和", "vector sum of the moments of the products"),
    "M_I+": Words("惯性力偶", "inertia couple"),
}
_FIELD = {
    r"V_t(_\d)?": Words("试重引起的振动", "effect of the trial weight"),
    "phi_t": Words("其相位", "its phase"),
    "alpha": Words("影响系数的大小", "size of the influence coefficient"),
    "beta": Words("试重须转过的角", "angle by which the trial weight is to be turned"),
    r"m_b(_\d)?": Words("校正质量", "correction mass"),
    r"theta_b(_\d)?": Words("校正质量的方位角", "angular position of the correction mass"),
    "spread": Words("三弧交成的小三角形的最长边", "longest side of the small triangle in which the three arcs meet"),
}
_FRICTION = {
    "phi": Words("摩擦角", "friction angle"),
    r"phi_\d\d": Words("下标两构件间的摩擦角", "friction angle between the links of the subscript"),
    "F": Words("驱动力", "driving force"),
    "F_0": Words("理想驱动力", "ideal driving force"),
    "eta": Words("效率", "efficiency"),
    "F_r": Words("反行程的力", "force of the return stroke"),
    "eta_r": Words("反行程的效率", "efficiency of the return stroke"),
    "alpha_limit": Words("自锁的极限角", "limit angle of self-locking"),
    "lock_direct": Words("正行程自锁的极限摩擦角", "limit friction angle of the direct stroke"),
    "lock_reverse": Words("反行程自锁的极限摩擦角", "limit friction angle of the return stroke"),
    "alpha_min": Words("不自锁的最小角", "least angle without self-locking"),
    "alpha_max": Words("不自锁的最大角", "maximum angle without self-locking"),
}
_CLAMP = {  # F holds the wedge there
    "phi": Words("摩擦角", "friction angle"),
    "alpha_limit": Words("自锁的极限角", "limit angle of self-locking"),
    "F": Words("阻止楔块退出的力", "force that stops the wedge from slipping out"),
    "F_0": Words("不计摩擦时阻止楔块退出的力", "the same force without friction"),
    "eta": Words("退出（反行程）的效率", "efficiency of slipping out, the return stroke"),
}
_ECCENTRIC = {
    "phi": Words("摩擦角", "friction angle"),
    "F": Words("手柄上的力", "force on the handle"),
    "F_0": Words("不计摩擦时手柄上的力", "force on the handle without friction"),
    "eta": Words("夹紧的效率", "efficiency of clamping"),
    "h": Words("撤去 $F$ 后工件反力对 $A$ 的力臂", "arm about $A$ of the reaction of the work when $F$ is gone"),
    "e_limit": Words("能自锁的最大偏心距", "maximum eccentricity with self-locking"),
}
_JACK = {
    "phi": Words("摩擦角", "friction angle"),
    "tan_alpha": Words("螺纹升角的正切", "tangent of the lead angle"),
    "alpha": Words("螺纹升角", "lead angle"),
    "F": Words("手柄上的力", "force on the lever"),
    "M1(_over_Q)?": Words("环面的摩擦力矩", "friction moment of the ring"),
    "M2(_over_Q)?": Words("螺纹中的力矩", "moment of the thread"),
    "M(_over_Q)?": Words("手柄上的力矩", "moment of the lever"),
    "M0(_over_Q)?": Words("理想力矩", "ideal moment"),
    "eta": Words("效率", "efficiency"),
    "eta_thread": Words("螺纹的效率", "efficiency of the thread"),
    "Q": Words("载荷", "load"),
    "M_r_over_Q": Words("下降时的力矩", "moment of lowering"),
    "eta_r": Words("下降时的效率", "efficiency of lowering"),
}
_GUIDE = {
    "F1|F2": Words("两导轨的支承力", "load on the guides"),
    "N_flank": Words("V 形一侧的法向反力", "normal force on a flank of the V"),
    "f_vee": Words("V 形导轨的当量摩擦系数", "equivalent coefficient of the V guide"),
    "F_f_.*": Words("各导轨的摩擦力", "friction force on the guides"),
    "F_f": Words("总摩擦力", "total friction force"),
    "f_V": Words("整个导轨的当量摩擦系数", "equivalent coefficient of both guides"),
}
_TRAIN = {
    "P_out": Words("输出功率", "power delivered"),
    r"eta_prime(_\d+)?": Words("并联部分的效率", "efficiency of the parallel part"),
    "eta": Words("总效率", "efficiency of the whole"),
    "P": Words("电动机的功率", "power of the motor"),
    r"P_\w+_in": Words("电动机供给该工作机的功率", "share of the motor power"),
    r"P_[A-Z]": Words("工作机的输出功率", "power delivered by the machine"),
}
_REDUCED = {
    "i_.*": Words("传动比的大小", "absolute speed ratio"),
    "J_e": Words("等效转动惯量", "equivalent moment of inertia"),
    "M_r": Words("等效阻力矩的大小", "magnitude of the equivalent resisting moment"),
    "M_d": Words("等效驱动力矩", "equivalent driving moment"),
    "M_e": Words("等效力矩", "equivalent moment"),
    "alpha_.*": Words("角加速度", "angular acceleration"),
    "omega_.*": Words("角速度", "angular velocity"),
    "t": Words("起动时间", "starting time"),
    "N": Words("转数", "number of revolutions"),
    "lift": Words("提升高度", "lift"),
    "F_rope": Words("绳的拉力", "tension of the rope"),
}
_RUN = {
    "M_d0": Words("起动力矩", "starting moment"),
    "omega_s": Words("稳定角速度", "steady angular velocity"),
    "T": Words("机电时间常数", "time constant"),
    "omega_t": Words("给定时刻的角速度", "angular velocity at the given time"),
    "t": Words("达到终了转速的时间", "time to the final speed"),
    "N": Words("其间的转数", "number of revolutions until then"),
    "t_b": Words("制动时间", "time with the brake"),
    "N_b": Words("制动时的转数", "number of revolutions with the brake"),
}
_EPICYCLIC = {
    r"v_\w+": Words("速度（向左为正）", "velocity (positive to the left)"),
    r"omega_\w+": Words("角速度", "angular velocity"),
    r"i_\w+": Words("传动比", "speed ratio"),
}

DEVICES: tuple[tuple[type, Mapping[str, Words]], ...] = (
    (InlineEngine, _ENGINE),
    (FieldBalancing, _FIELD),
    (Incline, _FRICTION),
    (Wedges, _FRICTION),
    (RingSpring, _FRICTION),
    (WedgeClamp, _CLAMP),
    (EccentricClamp, _ECCENTRIC),
    (ScrewJack, _JACK),
    (VeeGuide, _GUIDE),
    (PowerTrain, _TRAIN),
    (ReducedTrain, _REDUCED),
    (RunUp, _RUN),
    (Epicyclic, _EPICYCLIC),
)
