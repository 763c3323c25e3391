"""The line of the force on a driven link: along a rod between two pins, or across a sliding pair."""

from __future__ import annotations

from ...board.construction import View
from ...mechanism.asked.pressure import Driven
from ...mechanism.model import FRAME, Prismatic
from ...plane import Points
from ...words import Words
from ..desk import Desk
from ..registry import Stage, method
from .told import block_of, bodily, force_key

_SOURCE = "机械原理, pressure angle: the acute angle of the force on the driven link to the velocity of its point"


@method(
    stage=Stage.PRESSURE,
    group="rod",
    source=_SOURCE,
    example="8-2a",
    title=Words("连杆推动从动件的压力角和传动角", "Pressure and transmission angles of a link driven by a rod"),
)
def along_rod(desk: Desk, driven: Driven) -> Points:
    """A rod with two pins is a two-force member: F along the line of its pins."""
    assert isinstance(driven.press, str)
    line, by, on = f"{driven.press}{driven.at}", bodily(desk, driven.by), bodily(desk, driven.link)
    desk.board.step(
        Words(
            f"不计重力和摩擦，{by.zh}为二力杆，作用于从动件（{on.zh}）的力沿 ${line}$，作用于 ${driven.at}$ 点。",
            f"Without weight and friction {by.en} is a two-force member: its force on {on.en} acts along ${line}$ at "
            f"${driven.at}$.",
        ),
        View.MECHANISM,
    )
    return desk.board.parallel(desk.at[driven.at], desk.towards(driven.press, driven.at), key=force_key(driven)).along


@method(
    stage=Stage.PRESSURE,
    group="guide",
    source=_SOURCE,
    example="8-2d",
    title=Words("滑块推动从动件的压力角和传动角", "Pressure and transmission angles of a link driven by a block"),
)
def across_guide(desk: Desk, driven: Driven) -> Points:
    """A sliding pair without friction passes on a force across its guide, here through the pin of the block."""
    assert isinstance(driven.press, Prismatic)
    by, on = bodily(desk, driven.by), bodily(desk, driven.link)
    guide = bodily(desk, driven.press.guide)
    fixed = driven.press.guide == FRAME
    track = Words("固定导路", "fixed guide") if fixed else Words(f"{guide.zh}的滑道", f"slideway of {guide.en}")
    desk.board.step(
        Words(
            f"不计重力和摩擦，{by.zh}（{block_of(driven).zh}）只受两力，移动副中的力垂直于{track.zh}，故作用于从"
            f"动件（{on.zh}）的力过 ${driven.at}$ 点，沿{track.zh}的法线。",
            f"Without weight and friction two forces act on {by.en} ({block_of(driven).en}), and that of the sliding "
            f"pair is normal to the {track.en}: the force on {on.en} acts at ${driven.at}$ along this normal.",
        ),
        View.MECHANISM,
    )
    across = 1j * desk.guide_line(driven.press).along
    return desk.board.parallel(desk.at[driven.at], across, key=force_key(driven)).along
