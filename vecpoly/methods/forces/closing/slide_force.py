"""A link on a fixed guide with a balancing force:
the guide's reaction is inclined by φ, the polygon closes with two magnitudes."""

from __future__ import annotations

import numpy as np

from ....mechanism.loads import Force
from ....mechanism.model import FRAME, Prismatic
from ....plane import Line, Points, Reals, cross, nominal
from ....words import Words
from ...registry import Stage, method
from ..acting import Drawn
from ..groups.reactions import no_force
from ..lines.couples_on_guides import keep_couple
from ..lines.links_of_group import Held
from ..lines.resultant import Resultant, resultant
from ..senses import inclined, slide_words
from ..state import Statics
from .balancing_force import draw_balance, nothing_acts

_SOURCE = "机械原理, friction in sliding pairs"


@method(
    stage=Stage.FORCE,
    group="slide, balancing force",
    source=_SOURCE,
    example="",
    title=Words("滑块：平衡力与导路反力", "Slider: balancing force and reaction of the guide"),
)
def force_on_slide(st: Statics, held: Held) -> None:
    """P + F + R_frame = 0 with the directions of F and R_frame known; ΣM = 0 gives the line of R_frame."""
    assert isinstance(held.joint, Prismatic) and isinstance(st.unknown, Force)
    load, joint = resultant(st, held.link), held.joint
    line = Line(st.desk.at[st.unknown.point], complex(np.exp(1j * st.unknown.direction)))
    if load.is_couple:
        nothing_acts(st, held)
        keep_couple(st, FRAME, held.link, st.desk.at[joint.pin], -load.couple)
        return
    number = st.mech.number(held.link)
    st.board.step(
        Words(
            f"取构件 {number} 为分离体，已知 {load.told.zh}。",
            f"Isolate link {number}: {load.told.en} {'is' if load.is_single else 'are'} known.",
        )
    )
    st.board.remark(slide_words(st, joint, FRAME, held.link))
    rest = draw_balance(st, held, load, line, inclined(st, joint, FRAME, held.link))
    _settle(st, held, rest, _turning(st, load, line, st.desk.at[joint.pin]))


def _turning(st: Statics, load: Resultant, line: Line, about: Points) -> Reals:
    """Moment (mm × mm) of P and F about the block's pin."""
    force = line.along * st.mm(st.balance)
    return cross(load.at - about, load.vector) + cross(line.at - about, force)


def _settle(st: Statics, held: Held, rest: Drawn, turning: Reals) -> None:
    """R_frame on the line where it balances the moments; where it is zero the guide bears the couple."""
    assert isinstance(held.joint, Prismatic)
    pin, vector = st.desk.at[held.joint.pin], rest.end - rest.start
    if no_force(st, rest):
        small = abs(float(nominal(turning))) < 1e-9
        keep_couple(st, FRAME, held.link, pin, 0.0 if small else -st.newton_metres(turning))
        return
    st.settle(FRAME, held.link, vector, pin + 1j * vector * turning / np.square(np.abs(vector)), rest)
