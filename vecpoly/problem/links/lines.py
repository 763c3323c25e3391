"""The line of a slot, a rod, a rack or a face of a link, at an angle or beside a point."""

from __future__ import annotations

import cmath
from collections.abc import Mapping

from ...errors import FaultError
from ...units.reading import Dim, read
from ...words import Words
from ..schema.faults import meant, not_on_link
from ..text.source import Value
from .draft import ANGLE_FROM, ONE, Draft, Line, ray
from .places import aside


def read_line(draft: Draft, data: Mapping[str, Value], what: str) -> Line:
    """{through: D, angle: 60 deg from CD, left: 10 mm}: the line of a slot, of a rod or of a face."""
    for key in data:
        if key not in ("through", "angle", "left", "right"):
            raise FaultError(
                Words(f"“{key}”不是 {what} 的键", f"'{key}' is no key of a {what}")
                + meant(key, ("through", "angle", "left", "right")),
                key,
                code="unknown-key",
            )
    letter = str(data.get("through", ""))
    if not ONE.fullmatch(letter):
        raise FaultError(
            Words(
                f"{what} 过哪一点？如写 {what}: {{through: D, angle: 60 deg from CD}}",
                f"through which point does the {what} pass? write e.g. {what}: {{through: D, angle: 60 deg from CD}}",
            ),
            code="missing",
        )
    if letter not in draft.points:
        raise not_on_link(letter, draft.name, draft.points, "through")
    turn = _turn(draft, str(data["angle"])) if "angle" in data else 0j + 1
    left = aside(data)
    return Line(draft.points[letter] + 1j * left * turn, cmath.phase(turn), letter)


def _turn(draft: Draft, text: str) -> complex:
    """The unit vector of '60 deg from CD'."""
    m = ANGLE_FROM.fullmatch(text)
    if m is None:
        raise FaultError(
            Words(
                "请由构件上的射线量角，如 60 deg from CD", "write the angle from a ray of the link, e.g. 60 deg from CD"
            ),
            "angle",
            code="missing",
        )
    return ray(draft, m[2])[2] * cmath.exp(1j * read(m[1], Dim.ANGLE).si)
