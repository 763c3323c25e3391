"""That pressure and transmission angles are asked: of which driven link, by the point at which the force acts."""

from __future__ import annotations

from ...errors import FaultError
from ...foundation.patterns import pattern
from ...mechanism.asked.pressure import pressure_quantities
from ...mechanism.model import Mechanism
from ...names import Named
from ...words import Words
from ..schema.faults import Faults, meant
from ..schema.models import ProblemSpec
from ..text.spelling import plain

PRESSED = pattern(r"(alpha|gamma)(_[A-Z]\w*)?")  # how they are written


def pressed_quantities(spec: ProblemSpec, mech: Mechanism, faults: Faults) -> dict[str, Named]:
    """Every pressure and transmission angle of the mechanism, where one is asked or printed; what has none is a fault
    at its place."""
    asked = [(("find", i), plain(item)) for i, item in enumerate(spec.find) if isinstance(item, str)]
    asked += [(("printed", i), plain(entry.symbol)) for i, entry in enumerate(spec.printed)]
    wanted = [(place, key) for place, key in asked if PRESSED.fullmatch(key)]
    if not wanted or faults.found:
        return {}
    known = pressure_quantities(mech)
    for place, key in wanted:
        if key not in known:
            with faults.at(*place):
                raise FaultError(_unknown(key, known), code="unknown-name" if known else "not-asked")
    return known


def _unknown(key: str, known: dict[str, Named]) -> Words:
    """Why there is no such angle, and which there are."""
    if not known:
        return Words(
            f"此机构没有 {key}：没有由二力构件（连杆或滑块）驱动的连架杆；齿轮和凸轮的压力角不在此列",
            f"this mechanism has no {key}: no link on the frame is driven by a link of two forces (a rod or a block); "
            "pressure angles of teeth and cams are not among these",
        )
    if key in ("alpha", "gamma"):
        return Words(
            f"此机构有几个从动件，请写明力作用点：{'、'.join(known)}",
            f"several links are driven here; say at which point: {', '.join(known)}",
        )
    return Words(
        f"“{key}”不是从动件受力点的压力角或传动角",
        f"'{key}' is no pressure or transmission angle at the point on which a driven link is acted",
    ) + meant(key, known)
