"""What may be asked of the structure of a mechanism, by key."""

from __future__ import annotations

from ..names import Named

N, P_L, P_H = Named("n", "n", ""), Named("p_l", "p_L", ""), Named("p_h", "p_H", "")
F_LOCAL, P_REDUNDANT, F = Named("F_local", "F′", ""), Named("p_redundant", "p′", ""), Named("F", "F", "")
N_LOW, P_LOW, F_LOW = Named("n_low", "n_1", ""), Named("p_l_low", "p_{L1}", ""), Named("F_low", "F_1", "")
DETERMINED = Named("determined", "F", "yes/no")


def class_(drivers: tuple[str, ...]) -> Named:
    """The class of the mechanism with these drivers: 2, 3, 4; 0 where it cannot be taken apart."""
    name = "+".join(drivers)
    return Named(f"class_{name}", f"J_{{{name}}}", "")


def groups(drivers: tuple[str, ...]) -> Named:
    """How many Assur groups it has with these drivers."""
    name = "+".join(drivers)
    return Named(f"groups_{name}", f"m_{{{name}}}", "")
