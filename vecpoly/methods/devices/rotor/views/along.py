"""The rotor along its axis: the shaft, every plane on it, the masses as they are seen from the side."""

from __future__ import annotations

from math import sin

from .....board.construction import View
from .....board.paper.marks import Dot, Lump, Role
from .....devices.balancing.asked import product_of
from .....devices.balancing.mass import RotorMass
from .....devices.balancing.plane import RotorPlane
from .....devices.balancing.rotor import Rotor, RotorBody
from .....diagram.single import disc, outline, rod
from .....words import Words
from ...bench import Bench
from ...sketches.dimensions import dimension
from ..scales import AXIS, FEW, LUMP, SAME, arm_letter, widest

SHAFT, RUN = 1.6, 9.0  # mm: half the shaft, how far it runs on
LOW, TALL = 9.0, 17.0  # mm: arms shorter than LOW on the scale of the shaft are drawn TALL, to no scale
DEEP, APART = 9.0, 7.0  # mm: the first line of dimensions under the arms, from line to line
OVER, UNDER, PAST = 6.0, 4.0, 1.5  # mm by which a plane stands out over and under the arms, a line past a dimension
THIRD = "P"  # the plane of the check


def along(bench: Bench, rotor: Rotor) -> None:
    """Draw it to the scale of lengths; radially too, where the arms are not too short for that."""
    board, true = bench.board, _is_true(bench, rotor)
    sought = any("at" in mass.unknown for mass in rotor.masses.values())
    board.step(
        Words(
            "按 $μ_l$ 画出转子的轴向简图：各质量和校正平面的轴向位置"
            + ("，半径方向取投影 $r sin θ$" if true else "（半径方向不按比例）")
            + ("；方位待求的质量只画其所在平面。" if sought else "。"),
            "Draw the rotor along its axis to the scale $μ_l$: the planes of the masses and those of the correction"
            + (", radially the projections $r sin θ$" if true else " (radial dimensions not to scale)")
            + ("; of a mass whose direction is sought its plane alone." if sought else "."),
        ),
        View.MECHANISM,
    )
    _shaft(bench, _foot(bench, rotor, max(rotor.stations)).real)
    for body in rotor.bodies:
        _body(bench, rotor, body)
    for name, mass in rotor.masses.items():
        if "at" in mass.unknown:
            continue  # it stands nowhere yet
        high = _arm(bench, rotor, None if mass.r is None else mass.r.si) * sin(mass.at.si)
        _mass_beside(bench, name, _foot(bench, rotor, mass.place), high, mass, product_of(name, rotor.weighing).symbol)
    for name, plane in rotor.correct.items():
        _plane(bench, rotor, plane.at, name, Role.HIDDEN)
    corrected = [plane.at for plane in rotor.correct.values()]
    for name, mass in rotor.masses.items():
        if all(abs(mass.place - at) > SAME for at in corrected):
            _plane(bench, rotor, mass.place, name, Role.CENTRE)
    _distances(bench, rotor)


def third_plane(bench: Bench, rotor: Rotor, at: float) -> None:
    """The plane about which the couples are checked."""
    _plane(bench, rotor, at, THIRD, Role.CENTRE)


def added_beside(bench: Bench, rotor: Rotor, plane: RotorPlane, turns: list[float], labels: list[str]) -> None:
    """What balances a plane, as it is seen from the side; turns in rad."""
    if rotor.length <= 0:
        return
    assert plane.r is not None
    board, view, foot = bench.board, View.MECHANISM, _foot(bench, rotor, plane.at)
    for turn, label in zip(turns, labels, strict=True):
        at = foot + 1j * _arm(bench, rotor, plane.r.si) * sin(turn)
        board.circle(view, at, LUMP, Role.RESULT)
        board.plot(view, at, label, Dot.NONE)


def _is_true(bench: Bench, rotor: Rotor) -> bool:
    return widest(rotor) / bench.board.scale_of(View.MECHANISM).value >= LOW


def _arm(bench: Bench, rotor: Rotor, radius: float | None) -> float:
    """How long an arm is drawn (mm); None: of a product without a radius."""
    if not _is_true(bench, rotor):
        return TALL
    return (widest(rotor) if radius is None else radius) / bench.board.scale_of(View.MECHANISM).value


def _foot(bench: Bench, rotor: Rotor, place: float) -> complex:
    """A place on the axis, from the first of all."""
    return complex((place - min(rotor.stations)) / bench.board.scale_of(View.MECHANISM).value, 0.0)


def _plane(bench: Bench, rotor: Rotor, place: float, name: str, role: Role) -> None:
    board, view, at, reach = bench.board, View.MECHANISM, _foot(bench, rotor, place), _arm(bench, rotor, None)
    board.join(view, at - 1j * (reach + UNDER), at + 1j * (reach + OVER), role)
    board.plot(view, at + 1j * (reach + OVER), name, Dot.NONE)


def _shaft(bench: Bench, long: float) -> None:
    view = View.MECHANISM
    ends = (-RUN - SHAFT * 1j, long + RUN - SHAFT * 1j, long + RUN + SHAFT * 1j, -RUN + SHAFT * 1j)
    bench.board.depict(view, outline("shaft", *ends))
    bench.board.join(view, complex(-RUN - AXIS, 0), complex(long + RUN + AXIS, 0), Role.CENTRE)


def _body(bench: Bench, rotor: Rotor, body: RotorBody) -> None:
    """A drum or a pulley in thin lines, so that masses in it are seen."""
    left, right = (_foot(bench, rotor, place.si).real for place in (body.start, body.end))
    high = _arm(bench, rotor, body.r.si)
    corners = (complex(left, -high), complex(right, -high), complex(right, high), complex(left, high))
    for a, b in zip(corners, corners[1:] + corners[:1], strict=True):
        bench.board.join(View.MECHANISM, a, b, Role.GIVEN)


def _mass_beside(bench: Bench, name: str, foot: complex, high: float, mass: RotorMass, product: str) -> None:
    """The mass at the end of its arm; a hole is a ring; of what is known by its product alone the product's symbol."""
    board, view, at = bench.board, View.MECHANISM, foot + 1j * high
    if abs(high) > SHAFT + LUMP:
        way = 1j if high > 0 else -1j
        board.depict(view, rod(f"mass {name}", foot + way * SHAFT, at - way * LUMP))
    if mass.removed:
        board.circle(view, at, LUMP, Role.HIDDEN)
    else:
        board.depict(view, disc(f"mass {name}", at, LUMP, Lump.OWN))
    board.plot(view, at, product if mass.U is not None else f"m_{{{name}}}", Dot.NONE)


def _distances(bench: Bench, rotor: Rotor) -> None:
    """l_i (z_i) from the first plane, L between the planes; of few masses, each on a line of its own."""
    if rotor.static or len(rotor.masses) > FEW:
        return
    origin = rotor.masses[next(iter(rotor.masses))].place if rotor.sought else next(iter(rotor.correct.values())).at
    arm = arm_letter(origin)
    spans = [
        (f"{arm}_{{{name}}}", mass.place) for name, mass in rotor.masses.items() if abs(mass.place - origin) > SAME
    ]
    if not rotor.sought:
        whole = [*rotor.correct.values()][1].at
        equal = "".join(f"{symbol} = " for symbol, place in spans if abs(place - whole) <= SAME)
        spans = [span for span in spans if abs(span[1] - whole) > SAME] + [(f"{equal}L", whole)]
    board, view, reach = bench.board, View.MECHANISM, _arm(bench, rotor, None)
    start, top, level = _foot(bench, rotor, origin), -1j * (reach + UNDER), -1j * (reach + DEEP)
    for i, (symbol, place) in enumerate(sorted(spans, key=lambda one: (one[0].endswith("L"), abs(one[1] - origin)))):
        line, end = level - 1j * i * APART, _foot(bench, rotor, place)
        board.join(view, end + top, end + line - 1j * PAST, Role.CONSTRUCTION)
        dimension(bench, view, start + line, end + line, symbol)
    if spans:
        lowest = level - 1j * (len(spans) - 1) * APART
        board.join(view, start + top, start + lowest - 1j * PAST, Role.CONSTRUCTION)
