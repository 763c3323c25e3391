"""Chapter 2, the structure: links, joints and freedom counted, the groups in order, each drawn apart."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from ....board.construction import Figure
from ....drawing.figure import draw_figure
from ....drawing.scene import Scene, TextBox
from ....findings.study.study import Study
from ....foundation.roman import NUMERALS
from ....mechanism.groups.assur import Group, decompose, hinges, joint_letter
from ....mechanism.groups.mobility import mobility
from ....mechanism.model import FRAME, Joint, Mechanism, Prismatic, Rolling
from ....names import subscripted
from ....typeset import layout_words
from ....words import Lang, Words
from ...flow.style import CAPTION
from ...statement.structure import kind_of
from ..numbering import Press
from .groups_apart import apart
from .kinds import ROLLING, members, pairs_told
from .other_drives import others
from .special_joints import concluded, special

_SLOT = Words("销在槽中（高副，以滑块低代）", "pin in a slot (higher pair, replaced by a block)")
_JOINTS = {"zh": ["运动副", "类型", "相连的构件"], "en": ["Joint", "Kind", "Links joined"]}
_GROUPS = {
    "zh": ["次序", "组成", "类型", "级别", "外接副", "内接副"],
    "en": ["Order", "Links", "Kind", "Class", "Outer joints", "Inner joint"],
}
_UNDER = 7.0  # mm from a group to its name
_GAP = 12.0  # mm between two groups drawn apart
_ROOM = 165.0  # mm


def chapter(study: Study, press: Press) -> dict[str, Any]:
    """Counts, tables of joints and groups, figure."""
    press.chapter = "2"
    return told(study, press)


def told(study: Study, press: Press) -> dict[str, Any]:
    """The same within any chapter."""
    count = mobility(study.mech)
    said = {
        "words": "".join(w.of(press.lang) for w in special(study)),
        "concluded": concluded(study).of(press.lang),
        "count": str(count)
        .replace("·", " × ")
        .replace("F = 3n - 2p_L - p_H", "$F = 3n − 2p_L − p_H$")
        .replace(" - ", " − "),
        "joints": _joints(study, press),
        "groups": _groups(study, press),
        "figure": press.figure(
            _side_by_side(study, press), Words("原动件与各基本杆组", "The driving link and the Assur groups")
        ),
        "n": count.links,
        "lower": count.lower,
        "higher": count.higher,
        "freedom": count.freedom,
    }
    table, sentence = others(study, press)  # last, as it stands: tables are numbered as they are made
    return said | {"others": table, "other": sentence}


def _joints(study: Study, press: Press) -> str:
    rows: list[tuple[str, ...]] = []
    comma = "、" if press.lang == "zh" else ", "
    for letter, kind, names in (*_pins(study.mech), *_pairs(study.mech)):
        links = comma.join(_link(study, name).of(press.lang) for name in names)
        rows.append((f"${subscripted(letter)}$", kind.of(press.lang), links))
    return press.table(Words("运动副", "Joints"), _JOINTS[press.lang], rows, "cll")


Told = tuple[str, Words, tuple[str, ...]]  # the letter of a joint, its kind, its links


def _pins(mech: Mechanism) -> Iterator[Told]:
    """Every hinge of links that are seen."""
    thought = {*mech.substitutes, *mech.slot_pins}
    for point, names in sorted(hinges(mech).items()):
        real = tuple(name for name in names if name not in thought)
        if len(real) == 2:
            yield point, Words("转动副", "revolute"), real
        elif len(real) > 2:
            count = len(real) - 1
            yield point, Words(f"复合铰链（{count} 个转动副）", f"multiple joint, {count} revolutes"), real


def _pairs(mech: Mechanism) -> Iterator[Told]:
    """Slides, rolling pairs, higher pairs."""
    thought, slots = mech.substitutes, mech.slot_pins
    for joint in mech.joints:
        if isinstance(joint, Rolling):
            yield joint.point, Words("纯滚动副", "pure rolling"), (joint.gear.link, joint.on.link)
        elif isinstance(joint, Prismatic) and not {joint.block, joint.guide} & thought:
            slot = slots.get(joint.block)
            kind = Words("移动副", "prismatic") if slot is None else _SLOT
            yield slide_letter(mech, joint), kind, (joint.block if slot is None else slot.carrier, joint.guide)
    for contact in mech.contacts:
        yield contact.point, Words("高副", "higher pair"), contact.links


def _link(study: Study, name: str) -> Words:
    number = study.mech.number(name)
    return Words(f"机架 {number}", f"frame {number}") if name == FRAME else Words(f"构件 {number}", f"link {number}")


def _groups(study: Study, press: Press) -> str:
    comma = "、" if press.lang == "zh" else ", "
    groups = decompose(study.mech)
    rows = [] if study.mech.drive.between and any(group.ram for group in groups) else [_drive(study, press)]
    for i, group in enumerate(groups, 1):
        outer = comma.join(_joint(study.mech, out.joint) for out in group.outer)
        inner = comma.join(
            _joint(study.mech, joint) for joint in group.inner if not group.ram or joint != group.ram.pair
        )
        kind = (
            kind_of(group).of(press.lang)
            if group.dyad or group.ram
            else ROLLING[group.kind].of(press.lang)
            if group.kind in ROLLING
            else pairs_told(group)
        )
        names = comma.join(members(study, group))
        rows.append((str(i), names, kind, _class(group, press.lang), outer, inner))
    return press.table(
        Words("基本杆组（按求解次序）", "The Assur groups in order of solution"), _GROUPS[press.lang], rows, "cccccc"
    )


def _drive(study: Study, press: Press) -> tuple[str, ...]:
    """The row of the driving link, or of the cylinder or motor that drives."""
    drive = study.mech.drive
    if drive.between:
        name = f"{study.name(drive.on)}-{study.name(drive.link)}"
        what = Words("油缸", "cylinder") if drive.slide else Words("电机", "motor")
        return ("0", name, what.of(press.lang), "—", "—", "P" if drive.slide else "R")
    pivot = next((p for p, names in hinges(study.mech).items() if FRAME in names and drive.link in names), "")
    pair = "P" if drive.slide else f"R (${pivot}$)"
    first = "I" if press.lang == "en" else "Ⅰ"
    return ("0", study.name(drive.link), Words("原动件", "driving link").of(press.lang), first, pair, "—")


def slide_letter(mech: Mechanism, joint: Prismatic) -> str:
    """The letter of a prismatic joint: C′ where C is a revolute joint, for two joints need two letters; C″ of a second
    one at this place."""
    thought = mech.substitutes
    same = [
        j for j in mech.joints if isinstance(j, Prismatic) and j.pin == joint.pin and not {j.block, j.guide} & thought
    ]
    taken = any(point == joint.pin for point, _, _ in _pins(mech))
    return joint.pin + "′" * (taken + (same.index(joint) if joint in same else 0))


def _joint(mech: Mechanism, joint: Joint) -> str:
    letter = joint_letter(joint)
    point = slide_letter(mech, joint) if isinstance(joint, Prismatic) else joint.point
    return f"{letter} (${point}$)"


def _class(group: Group, lang: str) -> str:
    if group.dyad is None and group.ram is None and not group.kind.startswith("class"):
        return "—"
    told = "II" if group.dyad or group.ram else group.kind.removeprefix("class ")
    return told if lang == "en" else NUMERALS.get(told, told)


def _captioned(figure: Figure, lang: Lang) -> Scene:
    """A group with its name under it, in the size of a caption."""
    scene = draw_figure(figure, lang=lang, caption=False)
    e, box = scene.extents, layout_words(figure.title.of(lang), CAPTION.em)
    return Scene.of((*scene.items, TextBox(box=box, x=e.centre.real - box.width / 2, y=e.y0 - _UNDER)))


def _side_by_side(study: Study, press: Press) -> Scene:
    """All groups in rows, each with its name."""
    scenes = [_captioned(figure, press.lang) for figure in apart(study)]
    lines: list[list[Scene]] = [[]]
    for scene in scenes:
        used = sum(s.extents.width + _GAP for s in lines[-1])
        if lines[-1] and used + scene.extents.width > _ROOM:
            lines.append([])
        lines[-1].append(scene)
    placed, y = Scene((), scenes[0].extents), 0.0
    for line in lines:
        x, foot = 0.0, max(s.extents.height for s in line)
        for scene in line:
            e = scene.extents
            placed = Scene((*placed.items, *scene.moved(complex(x - e.x0, y - foot - e.y0)).items), e)
            x += e.width + _GAP
        y -= foot + _GAP / 2
    return Scene.of(placed.items)
