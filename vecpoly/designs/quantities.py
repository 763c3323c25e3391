"""What is asked of a linkage that is found: its lengths (mm) and its angles (deg)."""

from __future__ import annotations

from ..names import Named
from ..words import Words

AB, BC = Named("AB", "l_{AB}", "mm"), Named("BC", "l_{BC}", "mm")
CD, AD = Named("CD", "l_{CD}", "mm"), Named("AD", "l_{AD}", "mm")
FOUR_BAR = (AB, BC, CD, AD)
THETA = Named("theta", "θ", "deg")  # 极位夹角
K = Named("K", "K", "")  # 行程速比系数
SWING = Named("psi", "ψ", "deg")  # of the rocker
GAMMA_MIN = Named("gamma_min", "γ_{min}", "deg")  # least transmission angle
TURN_AB = Named("phi_AB", "φ_{AB}", "deg")  # directions in the first position, from the x axis
TURN_DC = Named("phi_DC", "φ_{DC}", "deg")
TURN_AD = Named("phi_AD", "φ_{AD}", "deg")
OFFSET, STROKE = Named("e", "e", "mm"), Named("H", "H", "mm")
ALPHA_MAX = Named("alpha_max", "α_{max}", "deg")  # greatest pressure angle
AC = Named("AC", "l_{AC}", "mm")
HEIGHT = Named("h", "h", "mm")  # of the ram's guide above the pivot of the lever
RETURN = Words(
    "行程速比系数 $K$（慢行程与快行程的时间之比）", "the time ratio $K$ (of the slow stroke to the quick one)"
)
