"""What may be asked of a cam: lengths in mm, angles in degrees."""

from __future__ import annotations

from ...names import Named

S0, PSI0 = Named("s0", "s_0", "mm"), Named("psi0", "ψ_0", "deg")
ALPHA = Named("alpha_max", "α_{max}", "deg")
ALPHA_RISE, ALPHA_BACK = Named("alpha_rise", "α_{max1}", "deg"), Named("alpha_return", "α_{max2}", "deg")
RHO, RHO_PROFILE = Named("rho_min", "ρ_{min}", "mm"), Named("rho_profile", "ρ_{a min}", "mm")
UNDERCUT, UNDERCUT_FLAT = Named("undercut", "ρ_{a min} < 0", "yes/no"), Named("undercut", "ρ_{min} ≤ 0", "yes/no")
REACH_RISE, REACH_BACK = Named("b_rise", "b_1", "mm"), Named("b_return", "b_2", "mm")
NEAREST, FARTHEST = Named("l_min", "l_{min}", "mm"), Named("l_max", "l_{max}", "mm")
R0, E, CENTRAL = Named("r0", "r_0", "mm"), Named("e", "e", "mm"), Named("r0_central", "r_{0c}", "mm")
APEX = Named("r0_apex", "r_{0D}", "mm"), Named("e_apex", "e_D", "mm"), Named("s0_apex", "s_{0D}", "mm")


def travel(phi: float, *, swings: bool) -> Named:
    """s or ψ at a station (deg): s_45, psi_22.5."""
    stem, symbol, unit = ("psi", "ψ", "deg") if swings else ("s", "s", "mm")
    return Named(f"{stem}_{phi:g}", f"{symbol}_{{{phi:g}}}", unit)


def pressure(phi: float) -> Named:
    """The pressure angle at a station (deg): alpha_45."""
    return Named(f"alpha_{phi:g}", f"α_{{{phi:g}}}", "deg")


def radius(phi: float) -> Named:
    """How far the profile's point of a station is from O: r_45."""
    return Named(f"r_{phi:g}", f"r_{{{phi:g}}}", "mm")


def polar(phi: float) -> Named:
    """From the profile's first point round to that of a station, counter-clockwise as seen from O (deg): theta_45."""
    return Named(f"theta_{phi:g}", f"θ_{{{phi:g}}}", "deg")


def least_polar(phi: float, sense: int) -> float:
    """Where the turn begins in which θ is told, of a station that the cam reaches after φ (deg): about the place where
    the inversion has the follower, so that a point just before the first one is a little under nothing, not under 360°.
    """
    return ((-sense * phi) % 360.0 - 180.0) / 6.0
