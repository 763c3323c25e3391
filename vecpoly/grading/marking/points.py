"""Points for an outcome."""

from __future__ import annotations

from ..compare.measured import Measured
from ..compare.outcome import Basis, Outcome
from ..key import NOTHING, Graded, Kind, Points
from ..rules import Rules


def earned(one: Graded, outcome: Outcome, basis: Basis, mine: Measured | None, named: bool, rules: Rules) -> Points:
    """Method, accuracy and sense, each by itself; named: a mistake is told that explains what is wrong."""
    worth = one.points
    sense = worth.sense if mine is not None and mine.sense and (mine.sense > 0) is (one.exact > 0) else 0.0
    if outcome.is_right and (not one.exact or one.kind is Kind.VECTOR):
        sense = worth.sense  # of nothing there is none; a direction that is wrong is no right outcome
    match outcome:
        case Outcome.RIGHT | Outcome.CLOSE | Outcome.UNSAID:
            own = basis in (Basis.OWN, Basis.DRAWN)
            share = rules.own if own else rules.close if outcome is Outcome.CLOSE else 1.0
            method = worth.method * (rules.own if own else 1.0)
            return Points(method=method, accuracy=worth.accuracy * share, sense=sense)
        case Outcome.SENSE | Outcome.DIRECTION:
            method = worth.method * (1.0 if worth.sense else rules.turned)
            return Points(method=method, accuracy=worth.accuracy, sense=0.0)
        case Outcome.WRONG:
            return Points(method=worth.method * rules.slip if named else 0.0, sense=sense if named else 0.0)
        case Outcome.BLANK | Outcome.NONE | Outcome.UNREADABLE | Outcome.AMBIGUOUS:
            return NOTHING
