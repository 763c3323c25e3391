"""The angle of a drive as it is written: 60 deg, or 60 deg from AD, of a ray from the pivot."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from math import sin

from ...errors import FaultError
from ...foundation.indices import LETTER
from ...foundation.patterns import pattern
from ...mechanism.model import ToldRay
from ...units.reading import Dim, Quantity, read
from ...words import Words
from ..links.draft import letters_of
from ..problem import Datum
from ..schema.faults import meant

_FROM = pattern(rf"(.+?)\s+from\s+({LETTER}{LETTER})")
SAME = 1e-12  # of half a turn: an angle that is told so is the link's own


def ray_of(to: str, lean: float, line: str, zero: float) -> ToldRay | None:
    """How the angle is told; None where it comes to the angle of the link's x axis from that of the frame."""
    return ToldRay(to=to, lean=lean, line=line, zero=zero) if abs(sin((zero - lean) / 2)) > SAME else None


def placed(name: str, phi: Quantity, ray: ToldRay | None) -> Datum:
    """φ of the drive, and from which line it counts where that is not the x axis."""
    symbol, line = f"φ_{name}", ray.line if ray is not None else ""
    words = Words(f"${symbol}$ = {{}}（由 ${line}$ 量起）", f"${symbol}$ = {{}} (from ${line}$)") if line else None
    return Datum(symbol=symbol, si=phi.si, text=phi.text, words=words)


def read_angle(text: str, frame: Mapping[str, complex]) -> tuple[Quantity, float, str]:
    """'127 deg from AD' to the angle, the direction from which it counts and its line (else the x axis)."""
    m = _FROM.fullmatch(text)
    if m is None:
        return _read(text), 0.0, ""
    first, second = letters_of(m[2])
    for letter in (first, second):
        if letter not in frame:
            raise FaultError(
                Words(f"点“{letter}”不在机架上", f"point '{letter}' is not on the frame") + meant(letter, frame),
                "phi",
                code="unknown-name",
            )
    if frame[first] == frame[second]:
        raise FaultError(
            Words(
                f"“{text}”：{first} 与 {second} 位置相同，不能由此量角；请用机架上的另外两点",
                f"'{text}': {first} and {second} are one place, from which no direction counts; name two points "
                "of the frame",
            ),
            "phi",
        )
    zero = cmath.phase(frame[second] - frame[first])
    return _read(m[1]), zero, first + second


def _read(text: str) -> Quantity:
    try:
        return read(text, Dim.ANGLE)
    except FaultError as fault:
        raise fault.under("phi") from None
