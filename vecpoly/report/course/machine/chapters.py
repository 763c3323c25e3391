"""The chapters on the machine that the data allow."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

from ....findings.machine.running import Running, running
from ....findings.machine.shaking import Shaking, shaking
from ....findings.study.study import Study
from ....words import Words
from ..numbering import Press
from . import balance, motion

FIRST = 9  # the number of the first of them
_MOTION = Words("机械的运转与飞轮", "Motion of the machine, flywheel")
_BALANCE = Words("平衡", "Balancing")


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Machine:
    """What is found of the machine, or why nothing is; None of a mechanism that is none."""

    motion: Running | Words | None
    balance: Shaking | Words | None


def found(study: Study) -> Machine:
    """The same in both languages."""
    return Machine(motion=running(study.problem), balance=shaking(study))


def chapters(study: Study, press: Press, machine: Machine) -> dict[str, Any]:
    """`told`: number, title and sections of each; `next`: the number that follows."""
    made: list[tuple[Words, Callable[[], list[dict[str, Any]]]]] = []
    if isinstance(run := machine.motion, Running):
        made.append((_MOTION, partial(motion.sections, study, press, run)))
    if isinstance(shaken := machine.balance, Shaking):
        made.append((_BALANCE, partial(balance.sections, study, press, shaken)))
    told = []
    for n, (title, sections) in enumerate(made, FIRST):
        press.chapter = str(n)
        every = [one | {"shown": press.shown(one["tables"], one["figures"])} for one in sections()]
        told.append({"n": n, "title": title.of(press.lang), "sections": every})
    return {"told": told, "next": FIRST + len(made)}


def conclusion(study: Study, machine: Machine) -> list[Words]:
    """The flywheel, and the greatest shaking force, in a sentence each."""
    said = []
    if isinstance(machine.motion, Running):
        said += motion.conclusion(study, machine.motion)
    if isinstance(machine.balance, Shaking):
        said += balance.conclusion(study, machine.balance)
    return said
