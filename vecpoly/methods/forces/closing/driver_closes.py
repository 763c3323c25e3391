"""The driving link where the balancing load acts elsewhere and is known already:
the frame alone answers what acts on it."""

from __future__ import annotations

from ....board.construction import View
from ....mechanism.model import FRAME, Prismatic, Revolute
from ....plane import Reals, cross, dot, nominal
from ....words import Words
from ...registry import Stage, method
from ..acting import Drawn
from ..bodies.link_polygon import answered, pane_of, unread
from ..couples import couples_on
from ..groups.reactions import no_force
from ..lines.couples_on_guides import keep_couple
from ..lines.links_of_group import Held
from ..lines.resultant import Resultant, resultant
from ..senses import inclined, pin_words, velocity_of
from ..state import Statics
from .balancing_force import frame_free

_SOURCE = "机械原理, equilibrium of the driving link; the balancing load by virtual power"


@method(
    stage=Stage.FORCE,
    group="crank, balanced",
    source=_SOURCE,
    example="",
    title=Words("主动曲柄：机架反力", "Driving crank: the frame's reaction"),
)
def crank_closes(st: Statics, held: Held) -> None:
    """R_frame = −P; P passes through the fixed pin (or touches its friction circle), for no moment drives the crank."""
    assert isinstance(held.joint, Revolute)
    load, pin = resultant(st, held.link), held.joint.point
    pace = st.turning(held.link, FRAME)
    if load.is_couple:
        st.rest = load.couple * pace
        frame_free(st, held)
        return
    drawn, sense = _closing_side(st, held, load), st.moment_sense(pin, FRAME, held.link)
    at = st.touch(pin, -load.line.along, sense)
    st.board.remark(pin_words(st, pin, FRAME, held.link, at))
    st.rest = st.newton_metres(cross(load.at - at, load.vector)) * pace
    st.settle(FRAME, held.link, -load.vector, at, drawn, sense, computed=unread(st, load))


@method(
    stage=Stage.FORCE,
    group="slide, balanced",
    source=_SOURCE,
    example="",
    title=Words("主动滑块：导路反力", "Driving slide: the reaction of its guide"),
)
def slide_closes(st: Statics, held: Held) -> None:
    """R_frame = −P on the line of P, normal to the guide (or at φ to that); a couple is borne by the guide."""
    assert isinstance(held.joint, Prismatic)
    load, pin = resultant(st, held.link), st.desk.at[held.joint.pin]
    if load.is_couple:
        frame_free(st, held)
        keep_couple(st, FRAME, held.link, pin, -load.couple)
        return
    drawn = _closing_side(st, held, load)
    st.rest = _rest_along(st, held, load)
    if drawn is not None and no_force(st, drawn):
        keep_couple(st, FRAME, held.link, pin, -st.newton_metres(cross(load.at - pin, load.vector)))
        return
    st.settle(FRAME, held.link, -load.vector, load.at, drawn, computed=unread(st, load))


def _rest_along(st: Statics, held: Held, load: Resultant) -> Reals:
    """The power (W) of what P is short of along the guide, the guide's reaction taken at its friction angle."""
    joint = held.joint
    assert isinstance(joint, Prismatic)
    along, u = st.desk.guide_line(joint).along, inclined(st, joint, FRAME, held.link)
    normal = 1j * along
    missing = dot(load.vector, along) - dot(load.vector, normal) * dot(u, along) / dot(u, normal)
    speed = dot(velocity_of(st, held.link, st.desk.at[joint.pin]), along) * st.board.scales[View.VELOCITY].value
    return missing * st.scale.value * float(nominal(speed))


def _closing_side(st: Statics, held: Held, load: Resultant) -> Drawn | None:
    """The frame's reaction: the only force turned round, or the side that closes the polygon."""
    st.board.step(_closed_by_frame(st, held, load), View.MECHANISM if len(load.forces) == 1 else pane_of(st, held.link))
    return answered(st, FRAME, held.link, load)


def _closed_by_frame(st: Statics, held: Held, load: Resultant) -> Words:
    """The frame alone answers the known forces: in their line, or beside it where couples act too."""
    number, frame = st.mech.number(held.link), st.named(FRAME, held.link).symbol
    couples = [f"${symbol}$" for symbol, size in couples_on(st, held.link) if nominal(size)]
    several = len(load.forces) > 1
    if couples:
        return Words(
            f"取构件 {number} 为分离体：机架反力 ${frame}$ 与 {load.symbols.zh}{' 的合力' if several else ' '}"
            f"等值、反向，二者构成的力偶与 {'、'.join(couples)} 平衡。",
            f"Isolate link {number}: the frame's reaction ${frame}$ is equal and opposite to "
            f"{'the resultant of ' if several else ''}{load.symbols.en}; the couple of the two balances "
            f"{', '.join(couples)}.",
        )
    return Words(
        f"取构件 {number} 为分离体：平衡力（矩）已求出，作用于他处，故 {load.symbols.zh} 只由机架反力 "
        f"${frame}$ 平衡，{f'其合力与 ${frame}$ ' if several else '二者'}等值、反向、共线。",
        f"Isolate link {number}: the balancing load is known and acts elsewhere, so {load.symbols.en} and the frame's "
        f"reaction ${frame}$ alone balance{f': the resultant of the former and ${frame}$ are' if several else ','} "
        "equal and opposite in one line.",
    )
