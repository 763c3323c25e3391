"""What may be asked of a flywheel, a run-up and a reduced train."""

from __future__ import annotations

from ...names import Named

M_D, M_R = Named("M_d", "M_d", "N·m"), Named("M_r", "M_r", "N·m", is_size=True)
POWER = Named("P", "P", "kW")
DW = Named("dW_max", "ΔW_{max}", "J")
J_NEED, J_F = Named("J_need", "J_{Σ}", "kg·m^2"), Named("J_F", "J_F", "kg·m^2")
J_SHAFT, GD2 = Named("J_F2", "J_{F2}", "kg·m^2"), Named("GD2", "GD^2", "N·m^2")
DELTA = Named("delta", "δ", "")
PHI_MAX, PHI_MIN = Named("phi_max", "φ_{max}", "deg"), Named("phi_min", "φ_{min}", "deg")
OMEGA_MAX, OMEGA_MIN = Named("omega_max", "ω_{max}", "rad/s"), Named("omega_min", "ω_{min}", "rad/s")
N_MAX, N_MIN = Named("n_max", "n_{max}", "r/min"), Named("n_min", "n_{min}", "r/min")
RIM_MASS, RIM_H, RIM_B = Named("m_rim", "m", "kg"), Named("h", "h", "m"), Named("b", "b", "m")
RIM_SPEED, RIM_SAFE = Named("v_rim", "v", "m/s"), Named("v_allowed", "v ≤ [v]", "yes/no")
RIM_J = Named("J_rim", "J_{rim}", "kg·m^2")

_LETTERS = "abcdefghijklmnopqrstuvwxyz"


def letter(number: int) -> str:
    """Of the places where the curves meet: a at the beginning of the period, b, c, ... z, a_1, b_1 ..."""
    again, at = divmod(number, len(_LETTERS))
    return f"{_LETTERS[at]}_{again}" if again else _LETTERS[at]


def work(number: int) -> Named:
    """W_1: of the first area, positive where it is a surplus."""
    return Named(f"W_{number}", f"W_{number}", "J")


def place(number: int) -> Named:
    """φ_b: where the curves meet (deg)."""
    key = letter(number).replace("_", "")
    return Named(f"phi_{key}", f"φ_{{{key}}}", "deg")


def level(number: int) -> Named:
    """E_b: the energy over that at a (J)."""
    key = letter(number).replace("_", "")
    return Named(f"E_{key}", f"E_{{{key}}}", "J")
