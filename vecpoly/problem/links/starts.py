"""Where links stand in the given position because gears leave it open:
a link's ``phi`` or ``s``, the angle of a point of a gear."""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Mapping

from ...errors import FaultError
from ...foundation.indices import LETTER
from ...foundation.patterns import pattern
from ...mechanism.assembly.start import Start
from ...mechanism.model import Joint, Prismatic
from ...mechanism.travel import travel_words
from ...units.reading import Dim, Quantity, positive, read
from ...words import Words
from ..problem import Shape
from ..text.source import Value
from ..values.leaning import X_AXIS, at_angle
from ..values.seen import Leaning, counted
from .draft import Draft

_FROM = pattern(rf"(.+?)\s+from\s+({LETTER})({LETTER})")


def read_start(draft: Draft, data: Mapping[str, Value]) -> None:
    """The keys phi and s of a link: as in `input`, but of a link that does not drive. Raises FaultError."""
    told = [key for key in ("phi", "s") if key in data]
    if len(told) > 1:
        raise FaultError(
            Words(
                "phi 与 s 只能写一个：转动构件写 phi，移动构件写 s",
                "a link turns (phi) or slides (s), not both; keep one of them",
            ),
            "s",
        )
    if told and draft.start is not None:
        raise FaultError(
            Words(
                f"构件 {draft.name} 的位置已由点的 angle 给出；请去掉 {told[0]} 或该 angle",
                f"the angle of a point already tells where link {draft.name} stands; leave "
                f"out {told[0]}, or that angle",
            ),
            told[0],
        )
    if "s" in data:
        travel = read(str(data["s"]), Dim.LENGTH)
        draft.start = Start(link=draft.name, value=travel.si, slide=True)
        draft.note(f"s_{draft.name}", travel.si, travel.text)
    if "phi" in data:
        _turned(draft, str(data["phi"]))


def _turned(draft: Draft, text: str) -> None:
    """The direction from the gear's centre, or from the link's first point, to its next point."""
    start = draft.gear.centre if draft.gear and draft.gear.centre in draft.points else next(iter(draft.points))
    other = next((place for letter, place in draft.points.items() if letter != start), None)
    if other is None:
        raise FaultError(
            Words(
                f"构件 {draft.name} 除 {start} 外没有别的点，phi 没有意义；请去掉 phi，或先给出另一点",
                f"link {draft.name} has no point but {start}, so phi says nothing; leave it "
                "out, or set out another point",
            ),
            "phi",
        )
    angle, ray = _angle(text, "phi")
    lean = cmath.phase(other - draft.points[start])
    draft.start = Start(link=draft.name, value=angle.si - lean, ray=ray)
    draft.note(f"φ_{draft.name}", angle.si, text)


def say_travels(drafts: Iterable[Draft], joints: Iterable[Joint]) -> None:
    """Tell from where the given travels of links that do not drive are counted."""
    slides = [joint for joint in joints if isinstance(joint, Prismatic)]
    for draft in drafts:
        slide = next((joint for joint in slides if draft.name in (joint.block, joint.guide)), None)
        if draft.start is not None and draft.start.slide and slide is not None:
            draft.say(travel_words(draft.name, slide), counted(draft.name, slide))


def is_phased(draft: Draft, text: str) -> bool:
    """Whether the angle of a gear's point counts from the x axis, or from a line that is not the gear's own."""
    m = _FROM.fullmatch(text)
    return (
        draft.shape is Shape.GEAR and " from line" not in text and (m is None or not {m[2], m[3]} <= set(draft.points))
    )


def phased(draft: Draft, point: str, key: str, length: Value, text: str) -> complex:
    """A point of a gear at `length` from its centre,
    in the given position at an angle from the x axis or from a line of other points.

    Gives the point in the gear's coordinates, whose x axis is that line. Raises FaultError.
    """
    centre = next(iter(draft.points))
    if key not in (centre + point, point + centre):
        raise FaultError(
            Words(
                f"长度应为 {centre}{point}，即从轮心量起", f"the length must be {centre}{point}, from the gear's centre"
            ),
            key,
        )
    (angle, ray), distance = _angle(text, "angle"), positive(length)
    if draft.start is not None and draft.start.ray != ray:
        raise FaultError(
            Words(
                f"齿轮 {draft.name} 各点的角度应从同一直线量起；其余点可写成自 {centre}{point} 量起",
                f"the angles of gear {draft.name} count from two lines; count those of "
                "further points from a line on the gear, or from the same line",
            ),
            "angle",
        )
    draft.start = Start(link=draft.name, value=0.0, ray=ray)
    draft.note(f"l_{key}", distance.si, distance.text)
    zero = Words(f" ${ray[0]}{ray[1]}$ ", f"${ray[0]}{ray[1]}$") if ray else X_AXIS
    lies = at_angle(str(angle.text).replace(" deg", "°"), angle.si, zero)
    draft.say(
        Words(f"图示位置 ${centre}{point}$ {lies.zh}", f"in the given position ${centre}{point}$ is {lies.en}"),
        None if ray else Leaning(at=centre, turn=angle.si),
    )
    return cmath.rect(distance.si, angle.si)


def _angle(text: str, key: str) -> tuple[Quantity, tuple[str, ...]]:
    """'40 deg' or '40 deg from OC'."""
    m = _FROM.fullmatch(text)
    try:
        return read(m[1] if m else text, Dim.ANGLE), (m[2], m[3]) if m else ()
    except FaultError as fault:
        raise FaultError(fault.words, key) from None
