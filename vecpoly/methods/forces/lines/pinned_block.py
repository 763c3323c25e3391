"""A block pinned to one link and sliding on another, without load: friction circle and friction angle together."""

from __future__ import annotations

from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....mechanism.model import Prismatic, Revolute
from ....names import Named
from ....plane import Line
from ....words import Words
from ...registry import Stage, method
from ..senses import inclined, pin_words, slide_words
from ..state import Statics
from .links_of_group import TwoForce

HALF = 22.0  # mm that a line of action is ruled to each side of its block
_SOURCE = "机械原理, friction in sliding and turning pairs"


@method(
    stage=Stage.FORCE,
    group="two-force block R-P",
    source=_SOURCE,
    example="4-6",
    title=Words("滑块：偏离法线 φ 角且切于摩擦圆", "Pinned block: inclined by φ and tangent to the friction circle"),
)
def line_of_block(st: Statics, two: TwoForce) -> Line:
    """Line of the force of the block on the loaded link, along that force.

    The slide gives its direction (normal of the guide, inclined by φ against the sliding), the pin its place: tangent
    to the friction circle, the moment against the turning of the block in its pin.
    """
    slide, pin = (two.inner, two.outer) if isinstance(two.inner, Prismatic) else (two.outer, two.inner)
    assert isinstance(slide, Prismatic) and isinstance(pin, Revolute)
    slid, pinned = (two.on, two.by) if slide is two.inner else (two.by, two.on)
    st.board.step(_isolated(st, two.link), View.MECHANISM)
    if st.ideal is None:
        guide = Words("槽", "slot") if two.link in st.mech.slot_pins else Words("导路", "guide")
        st.board.remark(
            Words(
                f"不计摩擦，作用线过 ${pin.point}$ 且垂直于{guide.zh}。",
                f" Without friction the line passes through ${pin.point}$, normal to the {guide.en}.",
            )
        )
        line = Line(st.desk.at[pin.point], 1j * st.desk.guide_line(slide).along)
        if st.preliminary:
            _draw(st, line, st.named(slid, two.link))
        return line
    st.board.remark(slide_words(st, slide, slid, two.link))
    u = st.board.turn(inclined(st, slide, slid, two.link))  # force of the guide's link on the block
    sense = st.moment_sense(pin.point, pinned, two.link)  # 0 where the pin itself runs in the slot
    at = st.touch(pin.point, -u, sense)  # the pin's force on the block is along −u
    st.board.remark(pin_words(st, pin.point, pinned, two.link, at))
    _draw(st, Line(at, u), st.named(slid, two.link))
    on_loaded = u if pinned == two.on else -u
    return Line(at, on_loaded)


def _draw(st: Statics, line: Line, named: Named) -> None:
    """The line of action on the diagram, to both sides of the block."""
    over = line.along * HALF
    st.board.join(View.MECHANISM, line.at - over, line.at + over, st.ruled(Role.DIRECTION), key=named.key)
    st.board.plot(View.MECHANISM, line.at + over, named.symbol, Dot.NONE, key=named.key)


def _isolated(st: Statics, block: str) -> Words:
    """Why the line is known: two forces on a block;
    or, where there is no block, the side of a slot presses on a pin."""
    pin = st.mech.slot_pins.get(block)
    if pin is None:
        number = st.mech.number(block)
        return Words(
            f"滑块 {number} 只受两力，两力等值、反向、共线。",
            f"Only two forces act on block {number}; they are equal, opposite and collinear.",
        )
    carrier, guide = st.mech.number(pin.carrier), st.mech.number(pin.guide)
    return Words(
        f"构件 {carrier} 的销 ${pin.point}$ 在构件 {guide} 的槽中，只与槽的一侧接触。",
        f"Pin ${pin.point}$ of link {carrier} runs in the slot of link {guide} and touches one of its sides alone.",
    )
