"""Inertia forces that are asked although the file says that they are neglected."""

from __future__ import annotations

from ...errors import FaultError
from ...mechanism.asked.forces import inertia_named
from ...mechanism.loads import Loads
from ...words import Words
from .asks import Ask, AskNamed


def kept(ask: Ask, loads: Loads | None) -> Ask:
    """The question; FaultError for F_I2, M_I2, h_2 beside `inertia: no`: there are none to be found."""
    if loads is None or loads.inertia or not isinstance(ask, AskNamed):
        return ask
    key = ask.rel.key
    if key not in {named.key for mass in loads.masses for named in inertia_named(mass)}:
        return ask
    raise FaultError(
        Words(
            f"已写 inertia: no（不计惯性力），{key} 无从求起；请删去 {key}，或改写 inertia: yes",
            f"'inertia: no' neglects the inertia forces, so there is no {key} to be found; leave out {key}, or write "
            "inertia: yes",
        ),
        code="contradiction",
    )
