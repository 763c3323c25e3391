"""Assur groups taken off and drawn apart, one after another, until the drivers are left."""

from __future__ import annotations

from ....board.construction import Pane, Reading, View
from ....devices.structure import Structure
from ....devices.structure_named import class_, groups
from ....devices.structure_pairs import Chain
from ....foundation.roman import chinese, latin
from ....names import subscripted
from ....words import Words
from ..bench import Bench
from .groups import Group, Taken, take_apart
from .replacement import Replaced
from .sketch import draw_apart, pane


def draw_groups(bench: Bench, device: Structure, low: Replaced, drivers: tuple[str, ...]) -> None:
    """Take the groups off for these drivers; class of each, and of the mechanism."""
    board, told = bench.board, "、".join(drivers)
    board.section(
        Words(
            f"拆分杆组（原动件 {told}）", f"Assur groups (link{'s' * (len(drivers) > 1)} {', '.join(drivers)} driving)"
        )
    )
    taken, chain = take_apart(low.chain, drivers), low.chain
    left, places = _panes(bench, taken, drivers, len(device.drive_sets) > 1)
    for index, (group, place) in enumerate(zip(taken.groups, places, strict=True), start=1):
        board.step(_told(group, index, chain), place, again=_told(group, 0, chain) if index == 1 else None)
        draw_apart(board, place, device, low.chain, group.links, left=chain.links)
        chain = chain.without(group.links)
    if left is not None:
        board.step(
            Words(
                f"剩下原动件 {told} 与机架，拆分正确。",
                f"{_drivers(drivers)} and the frame remain: all groups are detached.",
            ),
            left,
        )
        draw_apart(board, left, device, low.chain, drivers, frame=True)
    _class(bench, taken, drivers)


def _panes(bench: Bench, taken: Taken, drivers: tuple[str, ...], several: bool) -> tuple[Pane | None, list[Pane]]:
    """The figures of what is left and of the groups as they were taken off. They lie on the sheet as the mechanism is
    put together and moves: the drivers first, the group farthest from them last."""
    board, told, sort = bench.board, "、".join(drivers), "+".join(drivers)
    title = Words(f"原动件 {told} 与机架", f"{_drivers(drivers)} with the frame")
    left = pane(board, View.MECHANISM, f"left {sort}", title) if taken.complete else None
    backwards = [
        pane(board, View.MECHANISM, f"group {sort} {index}", _title(group, drivers, several))
        for index, group in reversed([*enumerate(taken.groups, start=1)])
    ]
    return left, backwards[::-1]


def no_groups(bench: Bench, drivers: tuple[str, ...]) -> None:
    """Drivers and freedoms differ in number: nothing can be taken apart, and both answers are 0."""
    for named in (groups(drivers), class_(drivers)):
        bench.board.keep(
            Reading(
                key=named.key,
                symbol=named.symbol,
                unit=named.unit,
                scalar=0.0,
                remark=Words(
                    f"以构件 {'、'.join(drivers)} 为原动件时，原动件数与自由度不等，不能拆分杆组",
                    f"with link{'s' * (len(drivers) > 1)} {', '.join(drivers)} driving, the number of inputs differs "
                    "from the mobility: no groups can be detached",
                ),
            ),
            0.0,
        )


def _title(group: Group, drivers: tuple[str, ...], several: bool) -> Words:
    """Class, links, letters; the driver where there are several possibilities."""
    kind = Words(f"（{group.kind}）", f" ({group.kind})") if group.kind else Words.same("")
    when = Words(f"原动件 {'、'.join(drivers)}：", f"{_drivers(drivers)}: ") if several else Words.same("")
    return (
        when
        + Words(
            f"{group.roman} 级杆组 {'-'.join(group.links)}",
            f"{'class' if several else 'Class'} {latin(group.rank)} group {', '.join(group.links)}",
        )
        + kind
    )


def _told(group: Group, index: int, chain: Chain) -> Words:
    """How it comes off, and why it has its class; index 0: the first, as with the drivers before."""
    zh, en = "、".join(group.links), ", ".join(group.links)
    inner, outer = ([f"${subscripted(pair.letter)}$" for pair in pairs] for pairs in (group.inner, group.outer))
    begun = (
        Words("从远离原动件处开始：", "Start farthest from the input: detach")
        if index == 1
        else Words("", "Detach")
        if index
        else Words("同样从远离原动件处开始，先", "Here, too, first detach")
    )
    lead = Words(
        f"{begun.zh}拆下构件 {zh}，内接副 {'、'.join(inner)}，外接副 {'、'.join(outer)}，",
        f"{begun.en} links {en}, with the inner pair{'s' * (len(inner) > 1)} {', '.join(inner)} "
        f"and the outer pairs {', '.join(outer)}: ",
    )
    if group.rank == 2:
        return lead + Words(f"为 {group.kind} 型 Ⅱ 级杆组。", f"a class II group {group.kind}.")
    why = Words(
        "（不能再拆出Ⅱ级杆组，只能拆出含四个构件、六个低副的杆组；其中一个构件有三个内接副）"
        if group.rank == 3 and len(group.links) == 4
        else "（不能再分为更低级的杆组）",
        " (no two links can be detached by themselves; one link of it has three inner pairs)"
        if group.rank == 3 and len(group.links) == 4
        else " (no smaller group can be detached)",
    )
    return lead + Words(f"为 {group.roman} 级杆组", f"a class {latin(group.rank)} group") + why + Words("。", ".")


def _grouped(taken: Taken) -> Words:
    """How many groups of which class: 4 个 Ⅱ 级杆组."""
    ranks = sorted({group.rank for group in taken.groups})
    counts = [(sum(group.rank == rank for group in taken.groups), rank) for rank in ranks]
    zh = "、".join(f"{count} 个 {chinese(rank)} 级杆组" for count, rank in counts)
    en = " and ".join(f"{count} class {latin(rank)} group{'s' * (count > 1)}" for count, rank in counts)
    return Words(f"含 {zh}" if counts else "不含杆组", en or "no groups")


def _drivers(drivers: tuple[str, ...]) -> str:
    """Driver 1; Drivers 1 and 3."""
    return f"Driver{'s' * (len(drivers) > 1)} {' and '.join(drivers)}"


def _class(bench: Bench, taken: Taken, drivers: tuple[str, ...]) -> None:
    """The class of the mechanism: the highest of its groups."""
    board = bench.board
    board.step(
        Words(
            f"机构{_grouped(taken).zh}，机构的级别等于所含杆组的最高级别。",
            f"The mechanism has {_grouped(taken).en}; its class is that of its highest group. ",
        )
        + _concluded(taken, drivers)
        + Words("杆组数：", " The number of groups is:")
    )
    bench.stated(groups(drivers), float(len(taken.groups)))
    _keep_class(bench, drivers, taken.rank, None if taken.complete else _concluded(taken, drivers))


def _concluded(taken: Taken, drivers: tuple[str, ...]) -> Words:
    """Of which class the mechanism is with these drivers."""
    told, rank = "、".join(drivers), taken.rank
    many = "s" * (len(drivers) > 1)
    if not taken.complete:
        return Words(
            f"以构件 {told} 为原动件时，剩下的构件不能组成杆组。",
            f"With link{many} {', '.join(drivers)} driving the remaining links form no Assur groups.",
        )
    return Words(
        f"以构件 {told} 为原动件时，该机构为 {chinese(rank)} 级机构。",
        f"With link{many} {', '.join(drivers)} driving this is a class {latin(rank)} mechanism.",
    )


def _keep_class(bench: Bench, drivers: tuple[str, ...], rank: int, remark: Words | None) -> None:
    """The class is told in words, and kept as a number."""
    named = class_(drivers)
    bench.board.keep(
        Reading(key=named.key, symbol=named.symbol, unit=named.unit, scalar=float(rank), remark=remark), float(rank)
    )
