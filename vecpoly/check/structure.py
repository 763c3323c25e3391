"""Where counting and rank disagree about a structure: which joints' constraints depend on each other, in words."""

from __future__ import annotations

from ..devices.structure import Structure
from ..names import subscripted
from ..oracle.devices.structure.structure import surplus
from ..words import Words


def dependence(device: object) -> Words | None:
    """The redundant constraints that the rank shows, with their joints and,
    where there are such, links that may go; None where it shows none."""
    if not isinstance(device, Structure):
        return None
    number, letters, gone = surplus(device)
    if not number:
        return None
    names = [f"${subscripted(letter)}$" for letter in letters]
    told = Words(
        f"独立检验：约束方程组有 {number} 个约束不独立，运动副 {'、'.join(names)} 的约束线性相关（在其他位置也如"
        f"此），即含有 {number} 个虚约束",
        f"By rank {number} constraint{'s are' if number > 1 else ' is'} redundant: those of joints "
        f"{', '.join(names)} depend on each other, in other positions too",
    )
    if not gone:
        return told + Words("。", ".")
    links = [device.number(link) for link in gone]
    return told + Words(
        f"；例如去掉构件 {'、'.join(links)}，其余构件的运动不变。",
        f"; without link{'s' * (len(links) > 1)} {', '.join(links)}, for example, the others move as before.",
    )
