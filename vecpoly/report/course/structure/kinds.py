"""What groups and their links are called."""

from __future__ import annotations

from collections import Counter

from ....findings.study.study import Study
from ....mechanism.groups.assur import Group, joint_letter
from ....words import Words
from ...statement.structure import group_zh, kind_of

ROLLING = {"gear": Words("齿轮", "gear"), "rack": Words("齿条", "rack"), "gear train": Words("轮系", "gear train")}


def members(study: Study, group: Group) -> list[str]:
    """The links of a group; a cylinder of given length is one of them, 2-3."""
    ram = group.ram
    if ram is None:
        return [study.name(link) for link in group.links]
    return sorted([study.name(ram.link), "-".join(sorted(map(study.name, (ram.near, ram.far))))])


def kind_told(group: Group) -> Words:
    """RRR 杆组, class III group; of what is no Assur group of lower pairs its own word."""
    if group.kind in ROLLING:
        return ROLLING[group.kind]
    if group.kind == "driven":
        return Words(group_zh(group), kind_of(group).en)
    return Words(group_zh(group), f"{kind_of(group).en} group")


def pairs_told(group: Group) -> str:
    """How many pairs of which kind a group has that is no dyad: 5R + P."""
    found = Counter(joint_letter(joint) for joint in (*(out.joint for out in group.outer), *group.inner))
    return " + ".join(f"{count if count > 1 else ''}{letter}" for letter, count in found.most_common())
