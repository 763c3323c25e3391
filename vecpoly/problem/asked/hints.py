"""What to say of a problem that asks nothing: which symbols it might ask."""

from __future__ import annotations

from ...mechanism.model import Mechanism
from ...words import Words
from ..problem import Problem


def nothing_asked(problem: Problem) -> Words:
    """'nothing is asked; write e.g. find: [v_C, omega_3]' with letters and links of this problem;
    empty where something is."""
    if problem.asks:
        return Words.same("")
    keys = ", ".join(_worth(problem.subject) if isinstance(problem.subject, Mechanism) else ()) or "v_C, omega_3"
    return Words(
        f"题目没有所求的量；请写 find，如 find: [{keys}]",
        f"nothing is asked; write under 'find' what is wanted, e.g. find: [{keys}]",
    )


def _worth(mech: Mechanism) -> tuple[str, ...]:
    driven = [name for name in mech.numbered if name != mech.drive.link]
    letters = [
        point
        for name in driven
        for point in mech.link(name).points
        if point not in mech.frame and point not in mech.link(mech.drive.link).points
    ]
    return (
        *(f"{kind}_{letter}" for letter in letters[:1] for kind in "va"),
        *(f"{kind}_{driven[-1]}" for kind in ("omega", "alpha") if driven),
    )
