"""A plate cam as a link: ``1: {cam: profile of cam-roller-offset about O}``.

The data of the cam problem stand in the link when the file has been read (`load.py`). Until its profile is drawn, or
solved, the link has the base circle, whose centre of curvature is the pivot.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from ...errors import FaultError, ProblemFileError
from ...foundation.indices import LETTER
from ...mechanism.model import Circle
from ...words import Words
from ..schema.faults import Faults
from ..text.source import Value
from ..values.seen import Round
from .bodies import Bodies
from .draft import Draft

if TYPE_CHECKING:
    from ...devices.cams.cam import Cam

EXAMPLE = "profile of cam-roller-offset about O"
CENTRES = ("K", "Q", "W", "U", *(f"K{letter}" for letter in "abcdefghijklmnopqrstuvwxyz"))
OWN = ("about", "profile of")  # what belongs to the link; the rest are the cam's data


def give_profile(draft: Draft, data: Mapping[str, Value]) -> None:
    """The pivot, the centre of curvature of the base circle, the cam."""
    if len(data) > 1:
        other = next(key for key in data if key != "cam")
        raise FaultError(
            Words(
                f"凸轮 {draft.name} 除 cam 外又写了 {other}；凸轮的形状全由 cam 给出，请删去",
                f"cam {draft.name} has {other} besides: its shape comes from 'cam' alone; leave that out",
            ),
            other,
            code="contradiction",
        )
    given = data["cam"]
    about = str(given.get("about", "")) if isinstance(given, dict) else ""
    if not isinstance(given, dict) or not re.fullmatch(LETTER, about):
        raise FaultError(
            Words(
                f"“{given}”不是凸轮的写法；应写凸轮题和机架上的转动中心，如 {EXAMPLE}",
                f"'{given}' is no cam; name the cam problem and the pivot on the frame, e.g. {EXAMPLE}",
            ),
            "cam",
            code="spelling",
        )
    draft.cam = _read({key: value for key, value in given.items() if key not in OWN}, draft.name)
    draft.points[about] = 0j
    base = None if draft.cam.r0 is None else Round(symbol="r_0", radius=draft.cam.r0.si)
    draft.say(_told(draft, about, draft.cam), base)


def letter_centres(bodies: Bodies, joints: Iterable[object]) -> None:
    """Give every cam the disc of its base circle, about a centre of curvature with a letter that nothing else has."""
    at = {m[1] for text in joints if (m := re.search(rf" at ({LETTER})\b", str(text)))}
    for draft in bodies.drafts.values():
        if draft.cam is not None:
            centre = next(letter for letter in CENTRES if letter not in {*at, *bodies.letters()})
            draft.points[centre] = 0j
            draft.disc = Circle(link=draft.name, centre=centre, radius=_base_circle(draft.cam))


def _read(data: Mapping[str, Value], name: str) -> Cam:
    from ...devices.cams.cam import Cam
    from ..schema.validate import validate

    try:
        cam = validate(Cam, data, Faults(name))
    except ProblemFileError as error:
        raise FaultError(error.words, "cam", code=error.code) from None
    if cam.r0 is None:
        raise FaultError(
            Words(
                "凸轮题只给出许用压力角，没有廓线；请先求出 r0，写在凸轮题中",
                "the cam problem gives allowed pressure angles alone and has no profile; find r0 first and write it "
                "there",
            ),
            "cam",
            code="no-profile",
        )
    return cam


def _base_circle(cam: Cam) -> float:
    assert cam.r0 is not None
    return cam.r0.si - cam.follower.radius


def _told(draft: Draft, about: str, cam: Cam) -> Words:
    from ...devices.cams.told import shape_told

    assert cam.r0 is not None
    turning = Words(
        f"构件 {draft.name} 为绕 ${about}$ 转动的盘形凸轮，$φ_{draft.name}$ = 0 时从动件在最低位置",
        f"link {draft.name} is a plate cam that turns about ${about}$; at $φ_{draft.name}$ = 0 the follower is lowest",
    )
    return turning + Words("，", "; ") + shape_told(cam.r0.text, cam.pieces, swings=cam.arm is not None)
