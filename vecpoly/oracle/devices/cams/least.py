"""The least base circle under given pressure angles: the nearest place of O under the bounds in the s–ds/dφ plane."""

from __future__ import annotations

from math import hypot, tan

from ....devices.cams.cam import Cam
from .laws import greatest, raised


def least(device: Cam) -> dict[str, float]:
    """r0, e, s0 of the least circle, of the apex of the bounds, and r0 without offset (mm).

    On the rise s′ − x ≤ (y + s) tan [α], on the return x − s′ ≤ (y + s) tan [α]: with x the offset and y = s0 each is a
    bound a x + b y ≥ c, of which only the greatest c counts.
    """
    assert device.alpha is not None
    one, two = tan(device.alpha.rise.si), tan(device.alpha.back.si)
    rises, backs = ([p for p in device.pieces if p.rises == way] for way in (1, -1))
    up = greatest(lambda p, phi: raised(p, phi)[1] - one * raised(p, phi)[0], rises)[0]
    down = greatest(lambda p, phi: -raised(p, phi)[1] - two * raised(p, phi)[0], backs)[0]
    bounds = ((1.0, one, up), (-1.0, two, down))
    low = (up + down) / (one + two)
    apex = up - one * low, low
    feet = [(a * c / (a * a + b * b), b * c / (a * a + b * b)) for a, b, c in bounds]
    allowed = [(x, y) for x, y in (apex, *feet) if all(a * x + b * y >= c - 1e-12 for a, b, c in bounds)]
    x, y = min(allowed, key=lambda spot: hypot(*spot))
    central = max(c / b for _, b, c in bounds)
    found = {"r0": hypot(x, y), "e": device.sense * x, "s0": y, "r0_central": central}
    found |= {"r0_apex": hypot(*apex), "e_apex": device.sense * apex[0], "s0_apex": apex[1]}
    return {key: 1e3 * value for key, value in found.items()}
