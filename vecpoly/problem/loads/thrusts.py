"""The thrust of a cylinder as a load: ``F: {cylinder: 2-3, size: "?"}``."""

from __future__ import annotations

from ...errors import FaultError
from ...foundation.patterns import pattern
from ...mechanism.loads import Force
from ...units.reading import Dim, read
from ...words import Words
from ..links.bodies import Bodies
from ..links.guides import LINK
from ..problem import Shape
from ..schema.faults import meant
from ..schema.models import LoadSpec, TableSpec

_PAIR = pattern(rf"({LINK})\s*[-–,]\s*({LINK})")


def _barrel_and_rod(one: str, other: str, bodies: Bodies) -> tuple[str, str]:
    """Of two links the one with the cylinder, then the one with the piston."""
    for link in (one, other):
        if link not in bodies.drafts:
            raise FaultError(
                Words(f"没有构件 {link}", f"link '{link}' does not exist") + meant(link, bodies.numbers), "cylinder"
            )
    shapes = {bodies.drafts[link].shape: link for link in (one, other)}
    if set(shapes) != {Shape.CYLINDER, Shape.PISTON}:
        raise FaultError(
            Words(
                f"构件 {one}、{other} 不是缸体与活塞；请写 {{cylinder: …}} 与 {{piston: …}}",
                f"links {one} and {other} are no cylinder and piston; "
                "write them as {cylinder: ...} and {piston: ...}",
            ),
            "cylinder",
        )
    return shapes[Shape.CYLINDER], shapes[Shape.PISTON]


def read_thrust(name: str, spec: LoadSpec, bodies: Bodies) -> Force:
    """The force by which the medium pushes both links apart; raises FaultError."""
    extra = [key for key in ("on", "at", "direction") if getattr(spec, key) is not None]
    if extra:
        raise FaultError(
            Words(
                f"油缸推力沿油缸轴线，请删去 {'、'.join(extra)}",
                f"a cylinder's thrust acts along it; leave out {', '.join(extra)}",
            ),
            extra[0],
        )
    m = _PAIR.fullmatch(str(spec.cylinder))
    if m is None:
        raise FaultError(
            Words(
                f"“{spec.cylinder}” 不是两个构件号；请写 cylinder: 2-3",
                f"'{spec.cylinder}' is no pair of links; write cylinder: 2-3",
            ),
            "cylinder",
        )
    barrel, rod = _barrel_and_rod(m[1], m[2], bodies)
    if spec.size is None:
        raise FaultError(
            Words(
                '缺少大小；请写 size: 1000 N 或 size: "?"',
                'the size is missing; write e.g. size: 1000 N, or size: "?" for the load that balances',
            )
        )
    size = 0.0 if isinstance(spec.size, TableSpec) else None if spec.size == "?" else read(spec.size, Dim.FORCE).si
    foot, point = (next(iter(bodies.drafts[link].points)) for link in (barrel, rod))
    return Force(
        name=name, link=rod, point=point, direction=0.0, size=size, role=spec.role or "", against=barrel, foot=foot
    )
