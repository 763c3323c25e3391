"""What a sliding joint says of its links: the data of its guide for 已知, and that a piston belongs into a cylinder."""

from __future__ import annotations

import re
from collections.abc import Mapping
from math import degrees

from ..errors import FaultError
from ..units import Dim, read
from ..words import Words
from .draft import LETTER, Draft
from .problem import Shape


def check_cylinder(guide: str, block: Draft, drafts: Mapping[str, Draft]) -> None:
    """A piston runs in a cylinder, and nothing else does."""
    barrel = guide in drafts and drafts[guide].shape is Shape.CYLINDER
    if barrel != (block.shape is Shape.PISTON):
        raise FaultError(Words(f"缸体（cylinder）与活塞（piston）须成对出现；请将构件 {guide} 写成 {{cylinder: …}}、构件 {block.name} 写成 {{piston: …}}，或改用 slot 与 block",
                               f"a piston slides in a cylinder and in nothing else: write link {guide} as {{cylinder: ...}} and link {block.name} as {{piston: ...}}, or use slot and block"))


def note_slide(m: re.Match[str], block: Draft, pin: str) -> None:
    """Remember the data of a sliding joint for 已知."""
    zh_side = "左" if m["side"] == "left" else "右"
    if m["offset"]:
        block.say(
            Words(
                f"偏距 $e$ = {m['offset']}（${pin}$ 在导路{zh_side}侧）",
                f"offset $e$ = {m['offset']} (${pin}$ to the {m['side']} of the guide)",
            )
        )
    if fixed := re.fullmatch(r"([xy]) = (.+)", m["guide"]):
        block.note(f"{fixed[1]}_{pin}", read(fixed[2], Dim.LENGTH).si, fixed[2])
    elif fixed := re.fullmatch(rf"line through ({LETTER}) at (.+)", m["guide"]):
        block.say(
            Words(
                f"导路过 ${fixed[1]}$，与水平方向成 {fixed[2]}",
                f"the guide through ${fixed[1]}$ is at {fixed[2]} to the horizontal",
            )
        )
    if m["turn"]:
        turn = round(degrees(read(m["turn"], Dim.ANGLE).si) % 180, 9)
        acute = min(turn, 180 - turn)
        block.say(
            Words(
                f"构件 {block.name} 的槽与导路成 {acute:g}°",
                f"the slot of link {block.name} is at {acute:g}° to the guide",
            )
        )
