"""What a count of freedoms has to watch for, and the class that follows from the groups: sentences of chapter 2."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ....findings.study.study import Study
from ....foundation.roman import NUMERALS
from ....mechanism.groups.assur import Group, decompose, hinges
from ....mechanism.model import Prismatic, Rack, Rolling
from ....mechanism.rams import driver_words
from ....words import Words
from ...statement.structure import welded
from .kinds import kind_told, members

_CYLINDER = Words(
    "原动件为油缸，其长度给定时计为一个构件。", "The cylinder drives; at a given length it counts as one link. "
)


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
    slots = [j.pin for j in mech.joints if isinstance(j, Prismatic) and j.pin_in_slot and j.block not in thought]
    if slots:
        zh, en = "、".join(f"${p}$" for p in slots), ", ".join(f"${p}$" for p in slots)
        yield Words(
            f"{zh} 处的销在槽中滑动为高副，以滑块低代，计为一个转动副和一个移动副。",
            f"The pin in the slot at {en} is a higher pair; replaced by a block it counts as one revolute and one "
            "prismatic joint. ",
        )
    if any(isinstance(j, Rolling) for j in mech.joints):
        yield Words(
            "纯滚动副限制两个自由度，按低副计；中心距由构件保证的齿轮副，按高副计。",
            "Pure rolling removes two degrees of freedom and counts as a lower pair; where links hold the two centres "
            "at their distance it counts as a higher pair. ",
        )
    yield from (_replaced(flat, some) for flat in (False, True) if (some := _contacts(study, flat=flat)))
    if mech.welded:
        yield welded(mech)
    absent = [
        *([] if compound else [Words("复合铰链", "multiple joint")]),
        *([] if mech.contacts else [Words("局部自由度", "passive degree of freedom")]),
        Words("虚约束", "redundant constraint"),
    ]
    yield Words(f"机构中无{'、'.join(w.zh for w in absent)}。", f"There is {_none_of([w.en for w in absent])}.")


def _contacts(study: Study, *, flat: bool) -> list[str]:
    """The points of contact on a flat face, or those of two curved profiles."""
    return [f"${one.point}$" for one in study.mech.contacts if isinstance(one.on, Rack) is flat]


def _replaced(flat: bool, points: list[str]) -> Words:
    """What stands for a higher pair where the motion is found."""
    zh, en = "、".join(points), " and ".join(points)
    pair = "is a higher pair" if len(points) == 1 else "are higher pairs"
    if flat:
        return Words(
            f"{zh} 为高副；作运动分析时高副低代：以铰接于接触处廓线的曲率中心、沿平底移动的滑块代替。",
            f"{en} {pair}; for the kinematics a block stands for it, pinned at the centre of curvature of the profile "
            "and sliding along the flat face. ",
        )
    return Words(
        f"{zh} 为高副；作运动分析时高副低代：以铰接于接触处两廓线曲率中心的构件代替。",
        f"{en} {pair}; for the kinematics a link stands for it, pinned at the centres of curvature of both profiles. ",
    )


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


def concluded(study: Study) -> Words:
    """The class of the mechanism: that of its highest group."""
    groups, driver = decompose(study.mech), driver_words(study.mech)
    told = _parts(study, groups)
    if any(group.kind == "driven" for group in groups):
        return told + Words(
            f"组成，驱动副（{driver.zh.strip()}）在杆组之内。", f"; what drives, {driver.en}, is inside the group."
        )
    if any(group.dyad is None and group.ram is None and not group.kind.startswith("class") for group in groups):
        return told + Words("组成；齿轮的转动由纯滚动条件直接确定。", "; rolling tells directly how a held gear turns.")
    return (_CYLINDER if any(group.ram for group in groups) else Words("", "")) + told + _classed(groups)


def _parts(study: Study, groups: Sequence[Group]) -> Words:
    """What drives, and every group with its links."""
    zh, en = [], []
    for group in groups:
        names, kind = members(study, group), kind_told(group)
        zh.append(f"{kind.zh}（构件 {'、'.join(names)}）")
        en.append(f"the {kind.en.removeprefix('the ')} (link{'s' * (len(names) > 1)} {', '.join(names)})")
    driven = _driver(study, groups)
    return Words(f"因此机构由{driven.zh}{'、'.join(zh)}", f"So the mechanism consists of {driven.en}{_listed(en)}")


def _driver(study: Study, groups: Sequence[Group]) -> Words:
    """What drives, before the groups; a cylinder is a link of one of them."""
    driver = driver_words(study.mech)
    if not study.mech.drive.between:
        link = study.mech.drive.link
        return Words(f"原动件 {link} 和", f"the driving link {link} and ")
    if any(group.ram or group.kind == "driven" for group in groups):
        return Words("", "")
    return Words(f"{driver.zh.strip()}和", f"{driver.en} and ")


def _classed(groups: Sequence[Group]) -> Words:
    """The class of the highest group, which is that of the mechanism."""
    top, one = _highest(groups), len(groups) == 1
    roman = NUMERALS.get(top, top)
    said = f", of class {top}" if one and top == "II" else "" if one else f", of which the highest class is {top}"
    return Words(
        f"组成，{'该杆组为' if one else '所含杆组的最高级别为'} {roman} 级，故为 {roman} 级机构。",
        f"{said}; it is therefore a class {top} mechanism.",
    )


def _listed(names: Sequence[str]) -> str:
    """The RRR group (links 2, 3), the RRP group (links 4, 5) and the RPR group (links 6, 7)."""
    return " and ".join(filter(None, (", ".join(names[:-1]), names[-1]))) if names else ""
