"""An epicyclic train as textbooks draw it beside its velocities: the half above its axis, cut along the shafts.

Heights are radii (mm on paper), so that every mesh stands level with its velocity; widths tell nothing.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from ..board.paper.marks import FixedGuide, Mark, Role, Segment
from ..board.paper.symbols import Symbol
from .owners import FIXED, link
from .single import number

FACE, GAP = 4.0, 0.7  # mm: half the width of a wheel; from a mesh to the rim on either side of it
SHAFT, STEP, OVER = 15.0, 12.0, 6.0  # mm: of a shaft; from wheel to wheel; of a ring's body over all wheels
SLEEVE = 2.5  # mm: radius of a hollow shaft about another
BEARING = 5.0  # mm: half the width of a hatched place


def width(stepped: bool) -> float:
    """From the end of the left shaft to that of the right one."""
    return 2 * SHAFT + STEP * (2 if stepped else 1)


def half_section(at: float, radii: Mapping[str, float], *, ring: bool, stepped: bool, fixed: str) -> Iterator[Symbol]:
    """The train, its right end here. fixed: the central gear that is held, if one is."""
    first = at - width(stepped) + SHAFT
    second = first + STEP * (0 if not stepped else 1 if ring else 2)
    arm = (second if ring else first) + STEP
    yield Symbol.of("", (_line(first - SHAFT - 3.0, 0.0, at + 3.0, 0.0, Role.CENTRE),))
    yield Symbol.of(link("1"), _sun(first, radii["1"], first - SHAFT))
    yield Symbol.of(link("2"), _planets({first: radii["2"], second: radii["2′"]}, radii["H"]))
    yield Symbol.of(link("H"), _carrier(radii["H"], min(first, arm) - FACE, max(second, arm), arm, at if ring else arm))
    top = max(radii["3"], radii["H"] + max(radii["2"], radii["2′"])) + OVER
    if ring:
        yield Symbol.of(link("3"), _ring(second, radii["3"], top, first - STEP if fixed != "3" else None))
    else:
        yield Symbol.of(link("3"), _sun(second, radii["3"], at))
    yield from _held(fixed, first, second, at, top if ring else 0.0)
    yield from _numbers(first, second, arm, radii, top if ring else 0.0, stepped)


def _line(x0: float, y0: float, x1: float, y1: float, role: Role = Role.LINK) -> Segment:
    return Segment(a=complex(x0, y0), b=complex(x1, y1), role=role)


def _rim(x: float, y: float) -> Segment:
    return _line(x - FACE, y, x + FACE, y)


def _sun(x: float, radius: float, end: float) -> Iterator[Mark]:
    """A central gear with teeth outside, on a shaft up to this end."""
    yield _rim(x, radius - GAP)
    yield _line(x, radius - GAP, x, 0.0)
    yield _line(min(x, end), 0.0, max(x, end), 0.0)


def _planets(wheels: Mapping[float, float], arm: float) -> Iterator[Mark]:
    for x, radius in wheels.items():
        for side in (1, -1):
            yield _rim(x, arm + side * (radius - GAP))
        yield _line(x, arm - radius + GAP, x, arm + radius - GAP)


def _carrier(radius: float, left: float, right: float, x: float, end: float) -> Iterator[Mark]:
    """The planets' pin, and the arm down to its shaft."""
    yield _line(left, radius, max(right, x), radius)
    yield _line(x, radius, x, 0.0)
    if end > x:
        yield _line(x, 0.0, end, 0.0)


def _ring(x: float, radius: float, top: float, down: float | None) -> Iterator[Mark]:
    """A central gear with teeth inside; one that turns reaches down to a hollow shaft there."""
    yield _rim(x, radius + GAP)
    yield _line(x, radius + GAP, x, top)
    if down is not None:
        yield _line(down, top, x, top)
        yield _line(down, top, down, SLEEVE)
        yield _line(down - FACE, SLEEVE, down + FACE, SLEEVE)


def _held(fixed: str, first: float, second: float, end: float, top: float) -> Iterator[Symbol]:
    """The hatching of a central gear that stands still: over a ring's body, at the end of a shaft."""
    match fixed:
        case "3" if top:
            marks = FixedGuide(a=complex(second + BEARING, top), b=complex(second - BEARING, top))
        case "3":
            marks = FixedGuide(a=complex(end, -BEARING), b=complex(end, BEARING))
        case "1":
            marks = FixedGuide(a=complex(first - SHAFT, BEARING), b=complex(first - SHAFT, -BEARING))
        case _:
            return
    yield Symbol.of(FIXED, (marks,))


def _numbers(
    first: float, second: float, arm: float, radii: Mapping[str, float], top: float, stepped: bool
) -> Iterator[Symbol]:
    yield number("1", complex(first, 0.35 * radii["1"]), complex(first, 0.65 * radii["1"]))
    upper = radii["H"] + radii["2"] / 2
    yield number("2", complex(first, upper), complex(first, upper + 2.0))
    if stepped:
        upper = radii["H"] + radii["2′"] / 2
        yield number("2′", complex(second, upper), complex(second, upper + 2.0))
    low = 0.4 * radii["H"]
    yield number("H", complex(arm, low), complex(arm, low + 2.0))
    high = (radii["3"] + top) / 2 if top else radii["3"] / 2
    yield number("3", complex(second, high), complex(second, high + 2.0))
