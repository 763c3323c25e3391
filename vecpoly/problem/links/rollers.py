"""Rollers written as links of their own: turning about their pin is a passive degree of freedom (局部自由度), so they
are welded to the link that carries them."""

from __future__ import annotations

import re
from collections.abc import Iterable

from ...errors import FaultError
from ...foundation.slotted import replace
from ...words import Words
from ..joints.contacts import is_contact
from ..schema.faults import Faults
from ..schema.models import InputSpec, ProblemSpec
from .bodies import Bodies
from .draft import Draft


def weld_rollers(spec: ProblemSpec, bodies: Bodies, faults: Faults) -> None:
    """Give the disc of every roller to the link on its pin; the roller goes, and the bodies remember where."""
    driven = {name for one in _inputs(spec) for name in (one.link, one.on, *(one.cylinder or "").split("-")) if name}
    for name, draft in list(bodies.drafts.items()):
        if name in driven or not _is_roller(draft, spec):
            continue
        with faults.at("links", name):
            host = _host(draft, bodies)
            if host is not None:
                _refuse_named(name, draft.points, host, spec)
                _weld(draft, host, bodies)


def _inputs(spec: ProblemSpec) -> Iterable[InputSpec]:
    return spec.input if isinstance(spec.input, list) else [spec.input]


def _is_roller(draft: Draft, spec: ProblemSpec) -> bool:
    """One pin, in the centre of its disc, and no joint but contacts of that disc."""
    if draft.disc is None or len(draft.points) != 1 or draft.face is not None or draft.line is not None:
        return False
    link = re.compile(
        rf"(?:^|\b(?:of|in|on|along|inside|through|touches) ){re.escape(draft.name)}(?= |$)"
        r"(?! (?:mm|cm|dm|m|km|in|毫米|厘米|米)\b)"
    )
    naming = [text for text in spec.joints if link.search(text)]
    return any(is_contact(text) for text in naming) and all(
        is_contact(text) and " face of " + draft.name not in text for text in naming
    )


def _host(draft: Draft, bodies: Bodies) -> Draft | None:
    """The one link on the roller's pin; None where it is the frame or there is none."""
    (pin,) = draft.points
    carriers = [other for name, other in bodies.drafts.items() if name != draft.name and pin in other.points]
    return carriers[0] if carriers and pin not in bodies.frame else None


def _refuse_named(name: str, draft_points: Iterable[str], host: Draft, spec: ProblemSpec) -> None:
    """What asks more of the roller than to roll: its own turning has no single value, what acts on it acts on its host,
    and where it rolls nothing rubs."""
    asked = next(
        (item for item in spec.find if isinstance(item, str) and re.fullmatch(rf"(omega|alpha|ω|α)_{name}", item)), None
    )
    if asked:
        raise FaultError(
            Words(
                f"滚子 {name} 绕其销轴的转动是局部自由度，{asked} 没有确定的值；请勿求它",
                f"roller {name} turns idly on its pin, so {asked} has no single value; do not ask for it",
            )
        )
    (pin,) = draft_points
    if any(load.on == name for load in spec.loads.values()) or name in spec.masses:
        raise FaultError(
            Words(
                f"滚子 {name} 上有载荷或质量，而滚子已与构件 {host.name} 视为焊成一体；请加在构件 {host.name} "
                f"上（at: {pin}）",
                f"a load or a mass is put on roller {name}, which is taken as welded to link "
                f"{host.name}; put it on link {host.name}, at {pin}",
            ),
            code="roller",
        )
    if rubs := _rubbed(name, pin, spec):
        raise FaultError(
            Words(
                f"滚子 {name} 在接触处作滚动，焊成一体的滚子不能计入 {rubs} 处的摩擦；请删去 {rubs} 的摩擦，"
                f"或将滚子写进构件 {host.name}（disc: {pin}, radius: …）而视为滑动的圆弧",
                f"roller {name} rolls at its contact, so that as a part of link {host.name} "
                f"it has no friction at {rubs}; leave that of {rubs} out, or write the disc "
                f"into link {host.name} (disc: {pin}, radius: ...), as a round tip that "
                "slides",
            ),
            code="roller",
        )


def _rubbed(name: str, pin: str, spec: ProblemSpec) -> str | None:
    """The entry of `friction` that belongs to the roller's pin, to its contact or to itself; None where none does."""
    touching = [text for text in spec.joints if re.search(rf"(?:^| ){name} ", text)]
    contacts = [m[1] for text in touching if (m := re.search(r" at (\w+'?)", text))]
    own = (key for key in spec.friction if key in (pin, *contacts) or name in re.split(r"\s*[-–]\s*", key))
    return next(own, None)


def _weld(draft: Draft, host: Draft, bodies: Bodies) -> None:
    assert draft.disc is not None
    if host.disc is not None:
        raise FaultError(
            Words(
                f"滚子 {draft.name} 应与构件 {host.name} 焊成一体，但该构件已有圆盘；请只保留一个",
                f"roller {draft.name} would be welded to link {host.name}, which has a disc already; keep one of them",
            )
        )
    (pin,) = draft.points
    host.disc = replace(draft.disc, link=host.name)
    symbol = f"r_{draft.name}"
    said = Words(
        f"滚子 {draft.name}（销轴 ${pin}$）的半径 ${symbol}$ = {{}}",
        f"radius of roller {draft.name} (pin ${pin}$) ${symbol}$ = {{}}",
    )
    host.lengths += [replace(datum, words=said) if datum.symbol == symbol else datum for datum in draft.lengths]
    del bodies.drafts[draft.name]
    bodies.welded[draft.name] = host.name
