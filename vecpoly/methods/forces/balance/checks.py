"""The frictionless balancing load found in two more ways where they are asked for:
virtual power and the Zhukovsky lever."""

from __future__ import annotations

from ....problem.problem import Problem
from ...registry import Stage
from ..doors import BALANCING
from ..state import Statics


def check_methods(st: Statics, problem: Problem) -> None:
    """Draw the methods whose keys are asked, but for one by which the load was found already."""
    asked = {ask.rel.key for ask in problem.asks} - st.board.readings.keys()
    for way, group in (("power", "virtual power"), ("lever", "lever")):
        if f"{st.unknown.name}_{way}" in asked:
            BALANCING.find(Stage.FORCE, group).draw(st, None)
