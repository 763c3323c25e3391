"""What a count of freedoms has to watch for, and the class that follows from the groups: sentences of chapter 2."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ....findings.study.study import Study
from ....foundation.roman import NUMERALS
from ....mechanism.groups.assur import Group, decompose, hinges
from ....mechanism.model import Prismatic, Rolling
from ....mechanism.rams import driver_words
from ....words import Words
from ...statement.structure import group_zh, kind_of, welded
from .kinds import ROLLING


def special(study: Study) -> Iterator[Words]:
    """Multiple joints, pins in slots, rolling and higher pairs; and that nothing else is special."""
    mech = study.mech
    thought = {contact.substitute for contact in mech.contacts}
    shared = {p: [n for n in names if n not in thought] for p, names in hinges(mech).items()}
    compound = {p: len(names) - 1 for p, names in shared.items() if len(names) > 2}
    if compound:
        zh = "、".join(f"${p}$（{count} 个转动副）" for p, count in compound.items())
        en = ", ".join(f"${p}$ ({count} revolutes)" for p, count in compound.items())
        yield Words(f"复合铰链：{zh}。", f"Multiple joints: {en}. ")
    slots = [j.pin for j in mech.joints if isinstance(j, Prismatic) and j.pin_in_slot]
    if slots:
        zh, en = "、".join(f"${p}$" for p in slots), ", ".join(f"${p}$" for p in slots)
        yield Words(
            f"{zh} 处的销在槽中滑动为高副，以滑块低代，计为一个转动副和一个移动副。",
            f"The pin in the slot at {en} is a higher pair; replaced by a block it counts as one hinge and one slide. ",
        )
    if any(isinstance(j, Rolling) for j in mech.joints):
        yield Words(
            "纯滚动副限制两个自由度，按低副计；两轮中心距已由构件保持者，按高副计。",
            "Pure rolling removes two degrees of freedom and counts as a lower pair; where links hold the two centres "
            "at their distance it counts as a higher pair. ",
        )
    if mech.contacts:
        zh, en = "、".join(f"${c.point}$" for c in mech.contacts), ", ".join(f"${c.point}$" for c in mech.contacts)
        yield Words(
            f"{zh} 为高副；作运动分析时高副低代：以铰接于接触处两曲率中心（或沿平底移动）的构件代替。",
            f"{en} is a higher pair; for the kinematics it is replaced by a link pinned at both "
            "centres of curvature (or sliding on the flat face). ",
        )
    if mech.welded:
        yield welded(mech)
    absent = [
        *([] if compound else [Words("复合铰链", "multiple joint")]),
        *([] if mech.contacts else [Words("局部自由度", "passive degree of freedom")]),
        Words("虚约束", "redundant constraint"),
    ]
    yield Words(f"机构中无{'、'.join(w.zh for w in absent)}。", f"There is {_none_of([w.en for w in absent])}.")


def _none_of(names: Sequence[str]) -> str:
    """No a; no a and no b; no a, no b and no c."""
    *before, last = [f"no {name}" for name in names]
    return f"{', '.join(before)} and {last}" if before else last


def _highest(groups: Sequence[Group]) -> str:
    """The highest class among these groups: II, III ..."""
    return max(
        (group.kind.removeprefix("class ") if group.dyad is None and group.ram is None else "II" for group in groups),
        key=lambda c: len(NUMERALS) if c not in NUMERALS else [*NUMERALS].index(c),
        default="I",
    )


def _kind(group: Group, inside: bool) -> str:
    """RRR, Ⅲ 级; inside: beside a group in which the input acts, 杆组 follows."""
    if inside:
        return group_zh(group)
    if group.dyad or group.ram:
        return kind_of(group).zh
    if group.kind in ROLLING:
        return ROLLING[group.kind].zh
    return f"{NUMERALS.get(group.kind.removeprefix('class '), group.kind)} 级"


def concluded(study: Study) -> Words:
    """The class of the mechanism: that of its highest group."""
    groups = decompose(study.mech)
    inside = any(group.kind == "driven" for group in groups)
    zh, en = [], []
    for group in groups:
        names = [study.name(link) for link in group.links]
        zh.append(f"{_kind(group, inside)}（构件 {'、'.join(names)}）")
        en.append(f"{kind_of(group).en} ({', '.join(names)})")
    driver = driver_words(study.mech)
    driven = (
        driver
        if study.mech.drive.between
        else Words(f"原动件 {study.mech.drive.link} ", f"the driving link {study.mech.drive.link}")
    )
    if inside:
        return Words(
            f"因此机构由{'、'.join(zh)}组成，驱动副（{driver.zh.strip()}）在杆组之内。",
            f"So the mechanism consists of {', '.join(en)}; what drives, {driver.en}, is inside the group.",
        )
    if any(group.dyad is None and group.ram is None and not group.kind.startswith("class") for group in groups):
        return Words(
            f"因此机构由{driven.zh}和 {'、'.join(zh)}组成；齿轮的转动由纯滚动条件直接确定。",
            f"So the mechanism consists of {driven.en} and {', '.join(en)}; rolling tells directly "
            "how a held gear turns.",
        )
    top = _highest(groups)
    roman, one = NUMERALS.get(top, top), len(groups) == 1
    return Words(
        f"因此机构由{driven.zh}和 {'、'.join(zh)}{_assur(groups)}组成，"
        f"{'该杆组为' if one else '所含杆组的最高级别为'} {roman} 级，故为 {roman} 级机构。",
        f"So the mechanism consists of {driven.en} and the group{'s' * (not one)} {_listed(en)}"
        + (f", which is of class {top}" if one else f", of which the highest class is {top}")
        + f"; it is therefore a class {top} mechanism.",
    )


def _assur(groups: Sequence[Group]) -> str:
    """杆组 after names that are without it."""
    return "" if any(g.kind.startswith("class") for g in groups) else "杆组"


def _listed(names: Sequence[str]) -> str:
    """RRR (2, 3), RRP (4, 5) and RPR (6, 7)."""
    return " and ".join(filter(None, (", ".join(names[:-1]), names[-1]))) if names else ""
