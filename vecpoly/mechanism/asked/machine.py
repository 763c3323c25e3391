"""What may be asked of a mechanism as a machine, by key.

``J_e``, ``M_e`` moment of inertia and moment that, on the driving link, stand for all masses and all given loads;
``m_e``, ``F_e`` mass and force of a driving slider; ``J_e3``, ``m_e5`` ... the same on another link. M_e is
counter-clockwise positive, F_e positive along the motion of its slider.

Of a machine that runs at a mean speed: ``dW_max`` the greatest surplus of work (J), from the lowest point of the energy
to the highest; ``J_F`` the flywheel with which it is as uneven as is allowed, ``J_F_areas`` the same as if J_e were
constant, J_F = ΔW_max / (ω_m² [δ]); ``phi_max``, ``phi_min`` where it is fastest and slowest; ``omega_max``,
``omega_min``, ``delta``.
Of one that is followed from a state: ``omega_end``, ``t_end``, ``alpha_0``, ``phi_end``, ``omega_at_90``,
``t_at_90`` ... (degrees from the start), ``T_cycle`` the period of a steady motion or of an
oscillation, and its extremes; ``power_F``, ``dT_2`` what a load gives and a link gains at the start (W).
"""

from __future__ import annotations

from math import degrees
from typing import assert_never

from ...errors import DeadPointError, EquilibriumError
from ...foundation.patterns import pattern
from ...foundation.slotted import dataclass
from ...names import Named, Sort
from ...words import Words
from ..groups.assur import ends
from ..machine import Machine, Started, Steady
from ..model import FRAME, Mechanism, Prismatic
from .forces import load_symbol

REDUCED = pattern(r"[JMmF]_e(?:[1-9]\d*[a-z']?)?")  # how these keys are written

RUN_KEYS = pattern(
    r"dW_max|J_F|J_F_areas|phi_(?:max|min|end)|T_cycle|omega_(?:max|min|end|at_\S+)|dT_\w+|power_\w+|t_(?:end|at_\S+)|delta|alpha_0"
)


@dataclass(frozen=True, slots=True)
class Equivalent:
    """A link on which everything is thought: the driving link itself (`key` has no number), or another.

    slide: it is a slider on the frame, to which m_e and F_e belong; J_e and M_e to any other.
    """

    link: str
    number: str = ""
    slide: bool = False

    @property
    def inertia(self) -> Named:
        """J_e (kg·m²), or m_e (kg)."""
        return self._named("m", "kg") if self.slide else self._named("J", "kg·m^2")

    @property
    def load(self) -> Named:
        """M_e (N·m, counter-clockwise), or F_e (N, along the motion)."""
        return self._named("F", "N") if self.slide else self._named("M", "N·m")

    def _named(self, stem: str, unit: str) -> Named:
        return Named(f"{stem}_e{self.number}", f"{stem}_{{e{self.number}}}", unit, sort=Sort.REDUCED)


def equivalents(mech: Mechanism) -> tuple[Equivalent, ...]:
    """The driving link, then every numbered link."""
    sliders = {link for joint in mech.joints if isinstance(joint, Prismatic) and FRAME in (pair := ends(joint))
               for link in pair}  # fmt: skip
    own = () if mech.drive.between else (Equivalent(mech.drive.link, "", mech.drive.slide),)
    return (*own, *(Equivalent(link, mech.number(link), link in sliders) for link in mech.numbered))


def reduced_quantities(mech: Mechanism) -> dict[str, Named]:
    """Every equivalent quantity by its key."""
    return {named.key: named for one in equivalents(mech) for named in (one.inertia, one.load)}


def equivalent_of(mech: Mechanism, key: str) -> Equivalent:
    """The link to which an equivalent quantity belongs."""
    return next(one for one in equivalents(mech) if key in (one.inertia.key, one.load.key))


def machine_quantities(mech: Mechanism, machine: Machine) -> dict[str, Named]:
    """Every quantity of the machine by its key."""
    found = {named.key: named for named in (*constant_of(machine), *_of_run(machine))}
    return reduced_quantities(mech) | found


def constant_of(machine: Machine) -> tuple[Named, ...]:
    """The unknown moment that is the same all through the period, M_d (N·m)."""
    one = machine.loads.constant
    return () if one is None else (_run(one.name, load_symbol(one.name), "N·m"),)


def _of_run(machine: Machine) -> tuple[Named, ...]:
    match machine.run:
        case None:
            return ()
        case Steady():
            return STEADY
        case Started(stations=stations):
            return (*STARTED, *(named for one in stations for named in at_station(one)), *_flow(machine))
        case _:
            assert_never(machine.run)


def _flow(machine: Machine) -> tuple[Named, ...]:
    """The power of every load, and the rate at which every link gains energy, at the start (W)."""
    loads = [*(one.name for one in machine.loads.all), *(one.name for one in machine.loads.springs)]
    gains = [_run(f"dT_{mass.link}", f"(dT/dt)_{{{mass.link}}}", "W") for mass in machine.loads.masses]
    return (*(_run(f"power_{name}", f"P_{{{name.replace('_', '')}}}", "W") for name in loads), *gains)


def _run(key: str, symbol: str, unit: str) -> Named:
    return Named(key, symbol, unit, sort=Sort.REDUCED)


DW, J_F, J_F_AREAS = (
    _run("dW_max", "ΔW_{max}", "J"),
    _run("J_F", "J_F", "kg·m^2"),
    _run("J_F_areas", "J_{F,A}", "kg·m^2"),
)
PHI_MAX, PHI_MIN = _run("phi_max", "φ_{max}", "deg"), _run("phi_min", "φ_{min}", "deg")
OMEGA_MAX, OMEGA_MIN = _run("omega_max", "ω_{max}", "rad/s"), _run("omega_min", "ω_{min}", "rad/s")
DELTA = _run("delta", "δ", "")
STEADY = (DW, J_F, J_F_AREAS, PHI_MAX, PHI_MIN, OMEGA_MAX, OMEGA_MIN, DELTA)
OMEGA_END, T_END, ALPHA_0 = (
    _run("omega_end", "ω_{end}", "rad/s"),
    _run("t_end", "t_{end}", "s"),
    _run("alpha_0", "α_0", "rad/s^2"),
)
PHI_END, PERIOD = _run("phi_end", "φ_{end}", "deg"), _run("T_cycle", "T", "s")
STARTED = (OMEGA_END, T_END, PHI_END, ALPHA_0, PERIOD, PHI_MAX, PHI_MIN, OMEGA_MAX, OMEGA_MIN, DELTA)


def at_station(turned: float) -> tuple[Named, Named]:
    """ω and t where the drive has turned by so much (rad)."""
    deg = f"{degrees(turned):.10g}"
    return _run(f"omega_at_{deg}", f"ω_{{{deg}}}", "rad/s"), _run(f"t_at_{deg}", f"t_{{{deg}}}", "s")


def at_rest(mech: Mechanism, to: Equivalent) -> DeadPointError:
    """Why nothing can be thought on this link: it stands still."""
    number, key = mech.number(to.link), to.inertia.key
    return DeadPointError(
        Words(
            f"{key}：构件 {number} 在此位置的速度为零（极限位置），其余构件的动能不能由它等效；请另取位置或等效构件",
            f"{key}: link {number} stands still in this position (a limit position), so that it cannot have the "
            "energy of the others; choose another position, or another link",
        ),
        code="at-rest",
        numbers={"link": number},
    )


def equally(key: str, one: float, other: float) -> EquilibriumError:
    """Why nobody can say where a machine is fastest, or slowest: it is so at two places (deg)."""
    fast = key == PHI_MAX.key
    return EquilibriumError(
        Words(
            f"{key}：机器在 {one:.2f}° 和 {other:.2f}° 处同样{'快' if fast else '慢'}，由舍入误差决定取哪一个，"
            f"没有唯一的答案；请改求 {'omega_max' if fast else 'omega_min'}，或改变载荷",
            f"{key}: the machine is as {'fast' if fast else 'slow'} at {one:.2f}° as at {other:.2f}°, and rounding "
            f"alone would decide which is told; ask {'omega_max' if fast else 'omega_min'}, or change the loads",
        ),
        code="equal-places",
        numbers={"one": one, "other": other},
    )
