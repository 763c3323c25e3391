"""What is drawn over a period: the French curve with this hand's readings at twelve positions, and the sheet."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...algebra.quantity import Expr, Quantity
from ...algebra.worked import worked
from ...board.board import Board
from ...board.construction import Reading
from ...foundation.slotted import replace
from ...mechanism.loads import Loads
from ...mechanism.machine import Steady
from ...names import Named
from ...plane import Reals, nominal
from ...words import Words
from ..desk import Desk
from .french import French
from .turn import Station, drawn, station

STEP = np.radians(30.0)
NEAR = 1e-9  # rad: the drive stands in one position
Factors = tuple[Reals, ...]


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Period:
    """run: None where only the constant moment is sought. read: the stations as this hand drew them, in the order of ψ
    from 0 on, the last at the end of the period; that of the given position tells what the steps before came to.

    moments, inertias: what this hand read there over what an exact hand reads; between them in proportion. lead: by how
    much the drive's angle is ahead of what is told of it (rad).
    """

    board: Board
    run: Steady | None
    curve: French
    read: tuple[Station, ...]
    moments: Factors
    inertias: Factors
    lead: float = 0.0

    def moment(self, psi: float, *, before: bool = False) -> Reals:
        """M of the given loads (N·m), positive where it drives."""
        return self.curve.moment(psi, before=before) * self._between(self.moments, psi)

    def inertia(self, psi: float) -> Reals:
        """J_e (kg·m²)."""
        return self.curve.inertia(psi) * self._between(self.inertias, psi)

    def factor(self, psi: float) -> Reals:
        """By how much this hand's moments are off about a place."""
        return self._between(self.moments, psi)

    def degrees(self, psi: float) -> float:
        """The drive's angle there as the problem tells it, within the period."""
        whole = np.degrees(self.curve.period)
        return float(np.round(np.degrees(self.curve.sense * psi - self.lead) % whole, 10) % whole)

    @property
    def beginning(self) -> Words:
        """Where the diagrams begin, if that is not 0°."""
        if not (first := self.degrees(0.0)):
            return Words.same("")
        return Words(f"各线图自 $φ$ = {first:.6g}° 画起。", f" The diagrams begin at $φ$ = {first:.6g}°.")

    def _between(self, factors: Factors, psi: float) -> Reals:
        step = self.curve.period / (len(factors) - 1)
        number = min(int(psi / step), len(factors) - 2)
        share = psi / step - number
        return factors[number] * (1 - share) + factors[number + 1] * share


def period_of(desk: Desk, run: Steady | None, curve: French, loads: Loads) -> Period:
    """Draw the twelve positions by this hand."""

    count = round(curve.period / STEP)
    places = [curve.sense * curve.period * k / count for k in range(count)]
    exact = [station(desk.mech, loads, phi) for phi in places]
    steady = desk.board.hand.name == "exact" and not desk.board.hand.repeats
    read = exact if steady else [drawn(desk.mech, loads, phi, desk.board.hand) for phi in places]
    moments = _over([one.moment for one in read], [one.moment for one in exact])
    inertias = _over([one.inertia for one in read], [one.inertia for one in exact])
    told = [_as_found(desk, one, curve.period) for one in read]
    return Period(
        board=desk.board,
        run=run,
        curve=curve,
        read=(*told, told[0]),
        moments=moments,
        inertias=inertias,
        lead=desk.mech.drive.lead,
    )


def _as_found(desk: Desk, one: Station, period: float) -> Station:
    """The station of the given position with what was found there on the sheet, where that was sought; any other as it
    is: one position has one J_e and one M_e."""
    off = one.phi - desk.mech.drive.position
    if abs(off - period * round(off / period)) > NEAR:
        return one
    inertia, moment = (desk.board.found.get(key, own) for key, own in (("J_e", one.inertia), ("M_e", one.moment)))
    return replace(one, inertia=inertia, moment=moment)


def _over(read: Sequence[Reals], exact: Sequence[Reals]) -> Factors:
    """Each over the exact one; 1 where nothing acts."""
    found = [value / float(true) if float(true) else 1.0 for value, true in zip(read, exact, strict=True)]
    return (*found, found[0])


def shown(value: Reals) -> float:
    """On the nominal sheet."""
    return float(nominal(value))


def kept(board: Board, named: Named, expr: Expr, sign: float = 1.0) -> Quantity:
    """Compute an answer and keep it; sign: of its sense."""
    found = board.compute(named.symbol, expr, named.unit)
    value = sign * found.value
    formula = worked(found.node, expr, named.unit)
    board.keep(
        Reading(key=named.key, symbol=named.symbol, unit=named.unit, scalar=shown(value), formula=formula), value
    )
    return found
