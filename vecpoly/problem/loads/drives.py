"""Loads on a mechanism of several drives: equilibrium finds one for each drive, and forces are drawn with one."""

from __future__ import annotations

from ...errors import FaultError
from ...mechanism.loads import Load
from ...words import Words
from ..schema.models import InputSpec, ProblemSpec


def one_drive(spec: ProblemSpec, unknown: list[Load]) -> None:
    """Raises FaultError where loads act and several drives are given, with what can be done: to hold all but one of
    them leaves what balances on this one as it is, for what is held does no virtual work."""
    drives = spec.input if isinstance(spec.input, list) else [spec.input]
    if len(drives) < 2:
        return
    count, listed = len(drives), ", ".join(_moved(drive) for drive in drives)
    names = ", ".join(load.name for load in unknown)
    sought = Words(f"（{names.replace(', ', '、')}）", f" ({names})") if len(unknown) == count else Words("", "")
    kept = next((drive for load in unknown for drive in drives if drive.link == load.link), drives[0])
    first = unknown[0].name if unknown else f"M_{_moved(kept)}"
    held = [_held(drive) for drive in drives if drive is not kept]
    raise FaultError(
        Words(
            f"原动件有 {count} 个（{listed.replace(', ', '、')}），机构有 {count} 个自由度，平衡要由 {count} 个待求载荷"
            f"来实现{sought.zh}，而力分析只用于一个原动件；请逐个来求：求 {first} 时，"
            f"{'，'.join(one.zh for one in held)}（被固定者不作虚功，不计惯性力时结果不变），再求其余",
            f"{count} drives are given ({listed}), so the mechanism has {count} degrees of freedom and {count} loads "
            f"must balance it{sought.en}, but forces are solved with one drive only; find them one after the other: "
            f"for {first} {', '.join(one.en for one in held)} (what is held does no virtual work: without inertia "
            "forces the result is the same), then the rest likewise",
        ),
        code="out-of-range",
    )


def _moved(drive: InputSpec) -> str:
    """The link that it moves; of a cylinder both."""
    return str(drive.cylinder or drive.link)


def _held(drive: InputSpec) -> Words:
    """How it is held: a link on the frame becomes part of it, two moving links become one."""
    if drive.cylinder or drive.on:
        pair = drive.cylinder or f"{drive.on}-{drive.link}"
        return Words(f"把构件 {pair} 写成一个构件", f"write links {pair} as one link")
    return Words(
        f"把构件 {drive.link} 的各点按此位置写入 frame，并删去该构件",
        f"write the points of link {drive.link} into the frame where they stand, and leave the link out",
    )
