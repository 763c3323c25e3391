"""Counterweights that balance a linkage, as written: ``counterweights: {1: {r: 60 mm}, 3: {r: 100 mm}}``."""

from __future__ import annotations

from ...errors import FaultError
from ...mechanism.counterweights import Counterweights, counterweights_of, translating
from ...mechanism.loads import Loads
from ...mechanism.model import FRAME, Mechanism
from ...mechanism.yokes import half_left
from ...units.reading import Quantity, positive
from ...words import Words
from ..problem import Datum
from ..schema.faults import Faults, meant
from ..schema.models import ProblemSpec


def read_counterweights(
    spec: ProblemSpec, mech: Mechanism, loads: Loads | None, faults: Faults, *, rate: bool
) -> tuple[Counterweights | None, tuple[Datum, ...]]:
    """The counterweights and their data for 已知; None where the file knows none. rate: ω is given as a number."""
    if faults.found or not spec.counterweights:
        return None, ()
    radii: dict[str, Quantity] = {}
    for link, one in spec.counterweights.items():
        with faults.at("counterweights", link):
            _refuse(mech, link)
            radii[link] = _radius(one.r)
    if faults.found:
        return None, ()
    with faults.at("counterweights"):
        if loads is None or not loads.masses:
            raise FaultError(
                Words("没有给出质量；请在 masses 中给出各构件的质量", "no link has a mass; give them under 'masses'"),
                code="missing",
            )
        half_left(mech, loads, rate=rate)
        found = counterweights_of(mech, loads, {link: r.si for link, r in radii.items()})
        return found, tuple(Datum(symbol=f"r_{{c{link}}}", si=r.si, text=r.text) for link, r in radii.items())
    return None, ()


def _refuse(mech: Mechanism, link: str) -> None:
    if link not in mech.numbered:
        frame = link in (FRAME, mech.frame_number)
        raise FaultError(
            Words(f"构件 {link} 是机架，不转动", f"link {link} is the frame, which does not turn")
            if frame
            else Words(f"构件“{link}”不存在", f"link '{link}' does not exist") + meant(link, mech.numbered),
            code="unknown-name",
        )
    if link in translating(mech):
        raise FaultError(
            Words(
                f"构件 {link} 只作平动，其上的配重不能起平衡作用；请写在转动的构件上",
                f"link {link} only translates: a counterweight on it balances nothing; write it on a link that turns",
            ),
            code="contradiction",
        )


def _radius(text: str) -> Quantity:
    try:
        return positive(text)
    except FaultError as fault:
        raise fault.under("r") from None
