"""What may be asked of counterweights, by key.

``W_c1`` the mass–radius product of the one on link 1 (kg·m), ``theta_c1`` its angle from the link's line, which goes
out from its pivot (0 to 360 deg, counter-clockwise), ``m_c1`` its mass (kg); ``m_c`` the mass of all, ``ratio_c`` that
over the mass of the linkage.
"""

from __future__ import annotations

from ...foundation.patterns import pattern
from ...names import Named, Sort
from ..counterweights import Counterweights
from ..model import Mechanism

HUNG = pattern(r"(?:W|theta|m)_c[1-9]\d*[a-z']?|m_c|ratio_c")  # how these keys are written
ADDED = Named("m_c", "Σm_c", "kg", sort=Sort.BALANCE)
SHARE = Named("ratio_c", "Σm_c/Σm", "", sort=Sort.BALANCE)


def product(number: str) -> Named:
    """W_c1 (kg·m)."""
    return Named(f"W_c{number}", f"W_{{c{number}}}", "kg·m", sort=Sort.BALANCE)


def bearing(number: str) -> Named:
    """theta_c1 (deg)."""
    return Named(f"theta_c{number}", f"θ_{{c{number}}}", "deg", sort=Sort.BALANCE)


def weight(number: str) -> Named:
    """m_c1 (kg)."""
    return Named(f"m_c{number}", f"m_{{c{number}}}", "kg", sort=Sort.BALANCE)


def counterweight_quantities(mech: Mechanism, asked: Counterweights) -> dict[str, Named]:
    """Every quantity of the counterweights by its key."""
    numbers = [mech.number(one.link) for one in asked.mounts]
    each = [named for number in numbers for named in (product(number), bearing(number), weight(number))]
    return {named.key: named for named in (*each, ADDED, SHARE)}
