"""Springs and dampers between two points or two links; what one does is linear in its length and its speed."""

from __future__ import annotations

from ...foundation.slotted import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Spring:
    """A straight spring with a damper beside it, between `foot` of the link `against` and `point` of the link `link`.

    T = F_0 + k (l - l_0) + c dl/dt pulls its ends together where it is positive (N; k in N/m, l in m, c in N·s/m).
    A damper alone has k = 0; a spring alone c = 0.
    """

    name: str
    link: str
    point: str
    against: str
    foot: str
    stiffness: float = 0.0
    free: float = 0.0
    preload: float = 0.0
    damping: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Coil:
    """A torsion spring with a damper beside it, between the links `against` and `link`.

    M = -(M_0 + k (φ - φ_0) + c (ω - ω')) on `link`, the opposite on `against` (N·m; k in N·m/rad, c in N·m·s). φ is the
    angle of the link's x axis from that of the other, within half a turn of φ_0.
    """

    name: str
    link: str
    against: str
    stiffness: float = 0.0
    free: float = 0.0
    preload: float = 0.0
    damping: float = 0.0


Elastic = Spring | Coil
