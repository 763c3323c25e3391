"""A link on a fixed pin with a balancing force of given line:
three forces through one point; moments where they do not meet."""

from __future__ import annotations

import numpy as np

from ....board.construction import View
from ....mechanism.loads import Force
from ....mechanism.model import FRAME, Revolute
from ....plane import Line, cross, lines_meet, nominal
from ....words import Words
from ...registry import Stage, method
from ..lines.links_of_group import Held
from ..lines.meeting import (
    draw_meeting,
    draw_resultant,
    in_point,
    known_forces,
    line_of_load,
    meeting_letter,
    resultant_of,
)
from ..lines.parallel_forces import PARALLEL, about_pin, keep_pin, off_sheet
from ..lines.resultant import Resultant, resultant
from ..lines.three_forces import direction_through
from ..state import Statics
from .balancing_force import close_polygon, keep_force, nothing_acts

_SOURCE = "机械原理, three forces through one point"


@method(
    stage=Stage.FORCE,
    group="crank, balancing force",
    source=_SOURCE,
    example="hand-lever",
    title=Words("曲柄：平衡力，三力汇交", "Crank: balancing force, three forces through one point"),
)
def force_on_crank(st: Statics, held: Held) -> None:
    """P + F + R_frame = 0: P and F meet in a point, R_frame passes through it, tangent to the friction circle.

    Where P is parallel to F, or a couple:
    F b = P a, or F b = M, about the point where R_frame touches the friction circle.
    """
    load, force = resultant(st, held.link), st.unknown
    assert isinstance(force, Force) and isinstance(held.joint, Revolute)
    line = Line(st.desk.at[force.point], complex(np.exp(1j * force.direction)))
    if load.is_couple and not nominal(load.couple):
        nothing_acts(st, held)
    elif load.is_couple or off_sheet(load, line, st.desk.at[held.joint.point]):
        _by_moments(st, held, load, line)
    else:
        _by_meeting(st, held, load, line)


def _by_meeting(st: Statics, held: Held, load: Resultant, line: Line) -> None:
    """The lines of P and F meet; R_frame passes through that point."""
    assert isinstance(held.joint, Revolute)
    number, frame, pin = st.mech.number(held.link), st.named(FRAME, held.link), st.desk.at[held.joint.point]
    letter, known, sought = (
        meeting_letter(st, lines_meet(load.line, line), pin),
        known_forces(st, held.link, load),
        f"${st.unknown_named.symbol}$",
    )
    spot, short = in_point(letter), known if load.is_single else Words.same(f"${resultant_of(st, held.link)}$")
    there = Words(f" ${letter}$" if letter else "此点", f"${letter}$" if letter else "it")
    joined = Words("", "") if load.is_single else Words(f"先求{known.zh}；", f"find {known.en}; ")
    st.board.step(
        Words(
            f"取构件 {number} 为分离体：{joined.zh}{short.zh} 与 {sought} 的作用线交{spot.zh}，三力必汇交于一点，"
            f"故机架反力 ${frame.symbol}$ 过{there.zh}。",
            f"Isolate link {number}: {joined.en}the lines of {short.en} and {sought} cross "
            f"{spot.en}; three forces in equilibrium are concurrent, so the frame's reaction "
            f"${frame.symbol}$ passes through {there.en}.",
        ),
        View.MECHANISM,
    )
    draw_resultant(st, held.link, load)
    x = st.board.meet(load.line, line, f"link {number}: load and balancing force")
    u, sense = direction_through(st, held.joint, FRAME, held.link, x)
    touch = st.at_joint(held.joint, Line(x, u))
    draw_meeting(st, x, (line_of_load(load), (st.unknown_named, line.at)), (u, touch), (letter, frame))
    close_polygon(st, held, load, line, (u, touch, sense))


def _by_moments(st: Statics, held: Held, load: Resultant, line: Line) -> None:
    """P is parallel to F, or only couples act."""
    number, named, frame = st.mech.number(held.link), st.unknown_named, st.named(FRAME, held.link)
    if load.is_couple:
        st.board.step(
            Words(
                f"取构件 {number} 为分离体：除 ${named.symbol}$、${frame.symbol}$ 外只有力偶，故二力等值、反向、"
                "平行，构成力偶与之平衡。",
                f"Isolate link {number}: but for ${named.symbol}$ and ${frame.symbol}$ only "
                "couples act; the two are equal, opposite and parallel and balance them.",
            )
        )
    elif abs(float(nominal(cross(load.line.along, line.along)))) > PARALLEL:
        st.board.step(
            Words(
                f"取构件 {number} 为分离体：{load.symbols.zh} 与 ${named.symbol}$ 的作用线交于图纸之外，改对铰链取矩。",
                f"Isolate link {number}: the lines of {load.symbols.en} and of ${named.symbol}$ "
                "meet off the sheet; moments about the pin take the place of their meeting "
                "point.",
            )
        )
    else:
        st.board.step(
            Words(
                f"取构件 {number} 为分离体：{load.symbols.zh} 与 ${named.symbol}$ 平行，机架反力 ${frame.symbol}$ "
                "亦与之平行。",
                f"Isolate link {number}: {load.symbols.en} and ${named.symbol}$ are parallel, "
                f"and so is the frame's reaction ${frame.symbol}$.",
            )
        )
    found = about_pin(st, held, load, line, named)
    keep_pin(st, held, found)
    keep_force(st, named, found.size)
