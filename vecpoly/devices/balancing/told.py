"""What is given of the planes of correction in words: where weights may sit there, and how holes are drilled."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import degrees

from ...units.reading import Quantity
from ...words import Words
from .plane import RotorPlane

_ONLY = {"add": Words("只许加重", "weights may only be added"), "remove": Words("只许去重", "mass may only be removed")}


def planes_told(planes: Mapping[str, RotorPlane]) -> tuple[Words, ...]:
    """One sentence for each plane of which there is something to say."""
    return tuple(_told(name, plane) for name, plane in planes.items() if [*_rules(plane)])


def _told(name: str, plane: RotorPlane) -> Words:
    rules = [*_rules(plane)]
    return Words(
        f"校正平面 {name}：{'，'.join(one.zh for one in rules)}",
        f"plane of correction {name}: {', '.join(one.en for one in rules)}",
    )


def _rules(plane: RotorPlane) -> Iterator[Words]:
    if plane.places is not None:
        yield _places(plane.places)
    if plane.use is not None:
        zh, en = (mark.join(_degrees(one.text) for one in plane.use) for mark in ("、", " and "))
        yield Words(f"用其中 {zh} 两处", f"of these the places at {en} are used")
    if plane.only is not None:
        yield _ONLY[plane.only]
    if plane.step is not None:
        yield Words(f"配重按 {plane.step.text} 分级", f"weights come in steps of {plane.step.text}")
    if plane.spread is not None:
        spread = _degrees(plane.spread.text)
        yield Words(
            f"在所求方位两侧各 {spread} 处钻两个相同的孔",
            f"two equal holes, {spread} to either side of the direction found",
        )


def _places(places: Sequence[Quantity]) -> Words:
    """Two or three of them, or the pitch of a circle of holes."""
    pitch = degrees(places[1].si - places[0].si)
    if len(places) > 2 and places[0].si == 0.0 and round(pitch * len(places), 6) == 360.0:
        return Words(
            f"配重只能装在自 x 轴起每隔 {pitch:g}° 的孔处", f"weights can sit only every {pitch:g}° from the x axis on"
        )
    zh, en = (mark.join(_degrees(one.text) for one in places) for mark in ("、", ", "))
    return Words(f"配重只能装在方位 {zh} 处", f"weights can sit only at {en}")


def _degrees(text: str) -> str:
    return text.replace(" deg", "°")
