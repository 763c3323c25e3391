"""The least base circle under given pressure angles: the nearest place of O under the bounds in the s–ds/dφ plane."""

from __future__ import annotations

from itertools import combinations
from math import hypot, inf, tan

from ....devices.cams.cam import Cam
from .laws import greatest, raised

Bound = tuple[float, float, float]


def least(device: Cam) -> dict[str, float]:
    """r0, e, s0 of the least circle, of the apex of the bounds, and r0 without offset (mm).

    On the rise s′ − x ≤ (y + s) tan [α], on the return x − s′ ≤ (y + s) tan [α]: with x the offset and y = s0 each is a
    bound a x + b y ≥ c, of which only the greatest c counts. Where the rise begins x ≤ y tan [α] is one more, if it is
    asked for.
    """
    assert device.alpha is not None
    one, two = tan(device.alpha.rise.si), tan(device.alpha.back.si)
    rises, backs = ([p for p in device.pieces if p.rises == way] for way in (1, -1))
    up = greatest(lambda p, phi: raised(p, phi)[1] - one * raised(p, phi)[0], rises)[0]
    down = greatest(lambda p, phi: -raised(p, phi)[1] - two * raised(p, phi)[0], backs)[0]
    bounds: tuple[Bound, ...] = ((1.0, one, up), (-1.0, two, down))
    apex = _corner(bounds[0], bounds[1])
    central = max(c / b for _, b, c in bounds)
    if device.alpha.start:
        bounds = (*bounds, (-1.0, tan(device.alpha.start.si), 0.0))
    feet = [(a * c / (a * a + b * b), b * c / (a * a + b * b)) for a, b, c in bounds]
    corners = [_corner(one, other) for one, other in combinations(bounds, 2)]
    allowed = [(x, y) for x, y in (*corners, *feet) if all(a * x + b * y >= c - 1e-12 for a, b, c in bounds)]
    x, y = min(allowed, key=lambda spot: hypot(*spot))
    found = {"r0": hypot(x, y), "e": device.sense * x, "s0": y, "r0_central": central}
    found |= {"r0_apex": hypot(*apex), "e_apex": device.sense * apex[0], "s0_apex": apex[1]}
    return {key: 1e3 * value for key, value in found.items()}


def _corner(one: Bound, other: Bound) -> tuple[float, float]:
    """Where two bounds meet; far above what is allowed where they never do."""
    (a, b, c), (d, e, f) = one, other
    det = a * e - b * d
    return ((c * e - b * f) / det, (a * f - c * d) / det) if det else (0.0, -inf)
