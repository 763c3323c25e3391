"""The same linkage with another link driven: its groups and its class change."""

from __future__ import annotations

from collections.abc import Iterator

from ....errors import VecpolyError
from ....findings.study.study import Study
from ....foundation.roman import NUMERALS
from ....foundation.slotted import replace
from ....mechanism.groups.assur import decompose, ends, hinges
from ....mechanism.model import FRAME, Drive, Mechanism, Prismatic
from ....names import subscripted
from ....words import Words
from ..numbering import Press

_HEADER = {
    "zh": ["原动件", "与机架的运动副", "杆组（按求解次序）", "机构级别"],
    "en": ["Driving link", "Joint with the frame", "Groups in order of solution", "Class"],
}


def others(study: Study, press: Press) -> tuple[str, str]:
    """A table with one line for every link on the frame that could drive instead, or a sentence about the only one;
    nothing where there is none."""
    rows = [row for link, joint in _on_frame(study.mech) if (row := _row(study, press, link, joint))]
    if len(rows) < 2:
        return "", _only(*rows[0]).of(press.lang) if rows else ""
    title = Words("改变原动件时的杆组和级别", "Groups and class with another link driven")
    return press.table(title, _HEADER[press.lang], rows, "cclc"), ""


def _only(link: str, joint: str, groups: str, top: str) -> Words:
    return Words(
        f"机构的级别与原动件的选取有关。若改以另一连架构件 {link}（{joint}）为原动件，则杆组（按求解次序）为 {groups}，"
        f"机构为 {top} 级机构。",
        f"The class depends on which link drives. With another link on the frame, link {link} ({joint}), as the driver "
        f"the groups in order of solution would be {groups}, and this would be a class {top} mechanism.",
    )


def _on_frame(mech: Mechanism) -> Iterator[tuple[str, Words]]:
    """Links hinged to the frame, or sliding on it, beside the driving one."""
    thought = {*mech.substitutes, *mech.slot_pins}
    for letter, names in hinges(mech).items():
        for name in names if FRAME in names else ():
            if name not in (FRAME, mech.drive.link, *thought):
                yield name, Words(f"转动副 ${subscripted(letter)}$", f"revolute ${subscripted(letter)}$")
    for joint in mech.joints:
        if isinstance(joint, Prismatic) and FRAME in ends(joint):
            name = next(end for end in ends(joint) if end != FRAME)
            if name not in (mech.drive.link, *thought):
                yield name, Words("移动副", "prismatic")


def _row(study: Study, press: Press, link: str, joint: Words) -> tuple[str, ...] | None:
    slide = joint.en == "prismatic"
    try:
        groups = decompose(replace(study.mech, drives=(Drive(link=link, position=0.0, rate=1.0, slide=slide),)))
    except VecpolyError:
        return None
    if any(group.dyad is None and not group.kind.startswith("class") for group in groups):
        return None
    comma = "、" if press.lang == "zh" else ", "
    told = [
        f"{group.kind if group.dyad else _class(group.kind, press.lang)} "
        f"({comma.join(study.name(name) for name in group.links)})"
        for group in groups
    ]
    top = max(
        ("II" if group.dyad else group.kind.removeprefix("class ") for group in groups),
        key=[*NUMERALS].index,
        default="II",
    )
    return link, joint.of(press.lang), comma.join(told), NUMERALS[top] if press.lang == "zh" else top


def _class(kind: str, lang: str) -> str:
    told = kind.removeprefix("class ")
    return f"{NUMERALS.get(told, told)} 级" if lang == "zh" else kind
