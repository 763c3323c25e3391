"""The order in which the model is solved at every position of the input link:
what each group takes over, and what it gives."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ....analytic.equations import GroupModel
from ....analytic.expr import Var
from ....findings.study.study import Study
from ....mechanism.groups.assur import decompose
from ....mechanism.model import FRAME, Prismatic
from ....names import subscripted
from ....words import Words
from ..numbering import Press

_HEADER = {
    "zh": ["步骤", "求解", "已知", "求出（位置、速度、加速度）"],
    "en": ["Step", "Solved", "Known", "Found (position, velocity, acceleration)"],
}


def order(study: Study, press: Press) -> str:
    """One line for the driving link, one for each group; left out of a long report."""
    if study.dense:
        return ""
    mech, known = study.mech, {*study.mech.frame}
    drive = mech.drive
    own = [] if drive.between else [letter for letter in mech.link(drive.link).points if letter not in known]
    rows = [
        (
            "1",
            study.model.groups[0].title.of(press.lang),
            f"${study.turn.drive.symbol}$",
            _listed(press, (f"${subscripted(letter)}$" for letter in own)),
        )
    ]
    known |= {*own}
    for i, (group, told) in enumerate(zip(decompose(mech), study.model.groups[1:], strict=True), 2):
        taken = [
            f"${out.joint.point}$"
            if not isinstance(out.joint, Prismatic)
            else Words(f"构件 {study.name(out.parent)} 的导路", f"the guide on link {study.name(out.parent)}").of(
                press.lang
            )
            if out.parent != FRAME
            else Words("固定导路", "the fixed guide").of(press.lang)
            for out in group.outer
        ]
        letters = [letter for link in group.links for letter in mech.link(link).points if letter not in known]
        known |= {*letters}
        rows.append(
            (
                str(i),
                told.title.of(press.lang),
                _listed(press, taken),
                _listed(press, [*_coordinates(told), *(f"${subscripted(letter)}$" for letter in letters)]),
            )
        )
    return press.table(
        Words("每一位置的求解次序", "The order of solution at every position"), _HEADER[press.lang], rows, "clll"
    )


def _coordinates(group: GroupModel) -> Iterator[str]:
    """The angles and travels that the group's formulas give, in order;
    a piston on a fixed guide has no angle to be found."""
    own = [
        *(group.loops.unknowns if group.loops else ()),
        *(
            e.left.symbol
            for part in group.stages[0].parts
            for e in part.equations
            if e.gives and isinstance(e.left, Var)
        ),
    ]
    return (f"${symbol}$" for symbol in own if symbol[0] in "φs")


def _listed(press: Press, parts: Iterable[str]) -> str:
    return ("、" if press.lang == "zh" else ", ").join(dict.fromkeys(parts)) or "—"
