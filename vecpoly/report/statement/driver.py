"""Which link is the driving link (原动件), as the structure is told; where the driving load acts on another, that."""

from __future__ import annotations

from ...foundation.slotted import replace
from ...mechanism.asked.forces import load_symbol
from ...mechanism.loads import Force, Load, Loads
from ...mechanism.model import Mechanism
from ...mechanism.rams import driver_words
from ...problem.problem import Problem
from ...words import Words


def driver(problem: Problem) -> Words:
    """A sentence without its end: link 1 drives; or gives the position only, where it carries the resistance."""
    mech = problem.mechanism
    if len(mech.drives) > 1:
        return _several(mech)
    told, loads = driver_words(mech), driving_elsewhere(mech, loads_of(problem))
    en = told.en[0].upper() + told.en[1:]
    if not loads:
        return Words(f"{told.zh}为原动件", f"{en} drives")
    kind = (
        Words("力", "force")
        if all(isinstance(load, Force) for load in loads)
        else Words("力矩", "moment")
        if not any(isinstance(load, Force) for load in loads)
        else Words("力（矩）", "load")
    )
    names = "$、$".join(load_symbol(load.name) for load in loads), "$, $".join(load_symbol(load.name) for load in loads)
    links = list(dict.fromkeys(mech.number(load.link) for load in loads))
    several = len(loads) > 1
    return Words(
        f"机构的位置由{told.zh}给定，取其为原动件拆分杆组（驱动{kind.zh} ${names[0]}$ 作用于构件 {'、'.join(links)}）",
        f"{en} gives the position and is taken as the input link, though the driving {kind.en}{'s' * several} "
        f"${names[1]}$ act{'s' * (not several)} on link{'s' * (len(links) > 1)} {', '.join(links)}",
    )


def _several(mech: Mechanism) -> Words:
    """Of a mechanism of several degrees of freedom: links 1 and 4 drive."""
    if not any(drive.between for drive in mech.drives):
        links = [drive.link for drive in mech.drives]
        return Words(f"构件 {'、'.join(links)} 为原动件", f"Links {', '.join(links[:-1])} and {links[-1]} drive")
    told = [driver_words(replace(mech, drives=(drive,))) for drive in mech.drives]
    en = " and ".join(one.en for one in told)
    return Words(f"{'、'.join(one.zh.strip() for one in told)} 为原动件", f"{en[0].upper()}{en[1:]} drive")


def loads_of(problem: Problem) -> Loads | None:
    """What acts on the mechanism, also where it is a machine whose equivalent link is sought."""
    return problem.loads if problem.machine is None else problem.machine.loads


def driving_elsewhere(mech: Mechanism, loads: Loads | None) -> tuple[Load, ...]:
    """The loads that drive, where none of them acts on the link by which the position is given, which is resisted.

    A moment that resists over the whole period takes up the work of all loads of which nothing is said.
    """
    if loads is None:
        return ()
    here, own = mech.drive.link, [load for load in loads.all if load.link == mech.drive.link]
    constant = loads.constant if loads.constant is not None and loads.constant.link == here else None
    roles = {load.role for load in own} | ({constant.role} if constant is not None else set())
    if "resisting" not in roles or "driving" in roles:
        return ()
    told = {"driving"} if constant is None else {"driving", ""}
    return tuple(load for load in loads.all if load.link != here and load.role in told)
