"""A link on a fixed guide with a balancing force: the guide's reaction is inclined by φ, the polygon closes with two magnitudes."""

from __future__ import annotations

import numpy as np

from ...mechanism.loads import Force
from ...mechanism.model import FRAME, Prismatic
from ...plane import Line, cross, lines_meet, nominal
from ...words import Words
from ..registry import Stage, method
from .balancing_force import close_polygon
from .pieces import Held
from .resultant import resultant
from .senses import inclined, slide_words
from .state import Statics

_SOURCE = "机械原理, friction in sliding pairs"


@method(stage=Stage.FORCE, group="slide, balancing force", source=_SOURCE, example="",
        title=Words("滑块：平衡力与导路反力", "Slider: balancing force and reaction of the guide"))
def force_on_slide(st: Statics, held: Held) -> None:
    """P + F + R_frame = 0 with the directions of F and R_frame known."""
    assert isinstance(held.joint, Prismatic) and isinstance(st.unknown, Force)
    load, joint = resultant(st, held.link), held.joint
    line = Line(st.desk.at[st.unknown.point], complex(np.exp(1j * st.unknown.direction)))
    number = st.mech.number(held.link)
    st.board.step(Words(f"取构件 {number} 为分离体，已知 {load.symbols.zh}。", f"Isolate link {number}: {load.symbols.en} {'is' if len(load.forces) == 1 else 'are'} known."))
    st.board.remark(slide_words(st, joint, FRAME, held.link))
    u = inclined(st, joint, FRAME, held.link)
    parallel = abs(float(nominal(cross(load.line.along, line.along)))) < 1e-9
    x = st.desk.at[joint.pin] if parallel else lines_meet(load.line, line)
    close_polygon(st, held, load, line, (u, x, 0))
