"""The pressure angle of the teeth of a gear or a rack: ``alpha: 20 deg``."""

from __future__ import annotations

from collections.abc import Mapping
from math import degrees, pi

from ...errors import FaultError
from ...mechanism.joints import STANDARD
from ...units.reading import Dim, read
from ...words import Words
from ..text.source import Value
from .draft import Draft

MOST = pi / 4  # rad: no teeth have more


def read_pressure_angle(draft: Draft, data: Mapping[str, Value]) -> None:
    """The key alpha of a link; raises FaultError where the link has no teeth, or for no pressure angle."""
    if "alpha" not in data:
        return
    if draft.gear is None and draft.rack is None:
        raise FaultError(
            Words(
                f"构件 {draft.name} 既非齿轮又非齿条，没有压力角；请去掉 alpha，或写 gear: C, radius: 60 mm",
                f"link {draft.name} is neither gear nor rack and has no pressure angle; leave out alpha, or write "
                "gear: C, radius: 60 mm",
            ),
            "alpha",
            code="contradiction",
        )
    angle = read(str(data["alpha"]), Dim.ANGLE)
    if not 0.0 <= angle.si < MOST:
        raise FaultError(
            Words(
                f"压力角 {angle.text} 应在 0° 与 {degrees(MOST):g}° 之间；标准值为 20 deg",
                f"a pressure angle lies between 0° and {degrees(MOST):g}°, not at {angle.text}; write the standard "
                "20 deg",
            ),
            "alpha",
            code="range",
        )
    draft.alpha = angle.si
    kind, kind_en = ("齿轮", "gear") if draft.gear else ("齿条", "rack")
    draft.say(
        Words(f"{kind} {draft.name} 的压力角为 {angle.text}", f"pressure angle of {kind_en} {draft.name}: {angle.text}")
    )


def pressure_angle(one: Draft, other: Draft | None) -> float:
    """That of two links that mesh (rad): as one gives it, else the standard one; FaultError where they differ."""
    told = [draft for draft in (one, other) if draft is not None and draft.alpha is not None]
    if len(told) == 2 and told[0].alpha != told[1].alpha:
        (i, a), (j, b) = ((draft.name, f"{degrees(draft.alpha or 0.0):g}°") for draft in told)
        raise FaultError(
            Words(
                f"构件 {i} 的压力角为 {a}，构件 {j} 的为 {b}，不能啮合；请写成同一个值",
                f"link {i} has the pressure angle {a} and link {j} {b}, so their teeth do not mesh; write one of them",
            ),
            code="contradiction",
        )
    return STANDARD if not told or told[0].alpha is None else told[0].alpha
