"""How the joints of a chain are told in the line of what is given: revolute joints A (frame–1), B (1–2)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..names import subscripted
from ..words import Words
from .structure_pairs import Form

THE_FRAME = Words("机架", "frame")
_FORMS = {
    Form.R: Words("转动副", "revolute joint"),
    Form.P: Words("移动副", "prismatic joint"),
    Form.H: Words("高副", "higher pair"),
    Form.G: Words("齿轮副", "gear pair"),
}


def told_joints(form: Form, joints: Mapping[str, Sequence[Words]]) -> Words | None:
    """The joints of one kind, each with the links that it joins; None where there are none."""
    if not joints:
        return None
    zh = "、".join(f"${subscripted(at)}$（{'—'.join(one.zh for one in links)}）" for at, links in joints.items())
    en = ", ".join(f"${subscripted(at)}$ ({'–'.join(one.en for one in links)})" for at, links in joints.items())
    many = "s" if len(joints) > 1 else ""
    return Words(f"{_FORMS[form].zh} {zh}", f"{_FORMS[form].en}{many} {en}")


def told_drivers(sets: Sequence[Sequence[str]]) -> Words:
    """Which links drive; of several possibilities each."""
    zh = "，或 ".join("、".join(links) for links in sets)
    en = " or ".join(" and ".join(links) for links in sets)
    many = "s" if len(sets) == 1 and len(sets[0]) > 1 else ""
    return Words(f"原动件为构件 {zh}", f"input link{many} {en}")
