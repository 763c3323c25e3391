"""The rotor seen from its end: all masses with r and θ; and each plane of correction with the parts that fall to it."""

from __future__ import annotations

from cmath import rect
from math import degrees, isnan, tau

from .....board.construction import Place
from .....board.paper.marks import Dot, Lump, Role
from .....board.place import Pane
from .....devices.balancing.asked import mass_of, product_of
from .....devices.balancing.mass import RotorMass
from .....devices.balancing.plane import RotorPlane
from .....devices.balancing.rotor import Rotor
from .....devices.balancing.sought import found_bearing, found_mass
from .....diagram.single import disc, rod
from .....foundation.slotted import replace
from .....plane import nominal
from .....words import Words
from ...bench import Bench
from ..polygon import heading
from ..scales import AXIS, END_VIEW, FEW, LUMP, arm_letter, has_plane_views, widest
from .missing import drilled, void

RIM = 6.0  # mm from the outermost mass to the rim of a disc
FIRST, STEP = 8.0, 4.5  # mm: radius of the first angle, from one to the next
READ = 7.0  # mm: a shorter arm has no room for the letter of its radius
NO_PART = 1e-12  # of a mass: so small a part falls to a plane only by rounding


def from_its_end(bench: Bench, rotor: Rotor) -> None:
    """Every mass at its radius and in its direction."""
    board, view = bench.board, _whole_view(bench, rotor)
    board.step(_SEEN if view is END_VIEW else _DIRECTIONS, view)
    _axes(bench, rotor, view)
    mm = board.scale_of(END_VIEW).value
    reach = widest(rotor) / mm
    seen = [(name, mass) for name, mass in rotor.masses.items() if "at" not in mass.unknown]
    arms = [(reach if mass.r is None else mass.r.si / mm, name, mass) for name, mass in seen]
    arms.sort(key=lambda one: one[0])
    for away, name, mass in arms:
        label = product_of(name, rotor.weighing).symbol if mass.r is None else f"m_{{{name}}}"
        _mass_seen(bench, view, mass, away, label, missing=mass.removed, within=_is_disc(rotor))
        if mass.r is not None and away > READ:
            board.plot(view, rect((away - LUMP) / 2, mass.at.si), f"r_{{{name}}}", Dot.NONE)
    rings = [FIRST + STEP * i for i in range(len(arms))]
    if len(seen) <= FEW and all(ring < away for ring, (away, _, _) in zip(rings, arms, strict=True)):
        for ring, (_, _, mass) in zip(rings, arms, strict=True):
            _angle(bench, view, mass, ring)


_SEEN = Words(
    "画出端视图：各质量的半径 $r$ 和方位角 $θ$（自 $x$ 轴逆时针为正）。",
    "Draw the end view: radius $r$ and direction $θ$ of every mass, counter-clockwise from the $x$ axis.",
)
_DIRECTIONS = Words(
    "画出端视图：各质径积的方位角 $θ$（自 $x$ 轴逆时针为正）；长度不按比例。",
    "Sketch the end view: the direction $θ$ of every product, counter-clockwise from the $x$ axis; lengths are not "
    "to scale.",
)


def _whole_view(bench: Bench, rotor: Rotor) -> Place:
    """Where all masses are seen; where nothing has a radius this has no scale."""
    radii = [*(mass.r for mass in rotor.masses.values()), *(plane.r for plane in rotor.correct.values())]
    if any(radius is not None for radius in radii):
        return END_VIEW
    scale = replace(bench.board.scale_of(END_VIEW), symbol="")
    return bench.board.open_pane(END_VIEW, "directions", Words("端视图（示意）", "End view (sketch)"), scale)


def planes_from_their_end(bench: Bench, rotor: Rotor) -> None:
    """Of every plane the parts of the masses that fall to it, each where its mass is: m_iI = m_i (L − l_i)/L at r_i."""
    if not has_plane_views(rotor):
        return
    board, mm = bench.board, bench.board.scale_of(END_VIEW).value
    one, other = rotor.correct
    letter = arm_letter(rotor.correct[one].at)
    for end, shares in rotor.shares.items():
        view = plane_view(bench, end)
        board.step(_parts_in(one, other, letter) if end == one else _likewise(other), view)
        _axes(bench, rotor, view)
        for name, mass in rotor.masses.items():
            if abs(shares[name]) > NO_PART and mass.r is not None:
                label = mass_of(f"{name}{end}", rotor.weighing).symbol
                _mass_seen(bench, view, mass, mass.r.si / mm, label, missing=mass.removed is (shares[name] > 0.0))


def solved_from_its_end(bench: Bench, rotor: Rotor, which: str) -> None:
    """The masses in the directions that were found; of several answers each has a view of its own."""
    board, mm, found = bench.board, bench.board.scale_of(END_VIEW).value, bench.board.found
    view: Place = END_VIEW
    if which:
        told = Words(f"端视图（解 {which[1:]}）", f"End view, solution {which[1:]}")
        view = board.open_pane(END_VIEW, which[1:], told)
        _axes(bench, rotor, view)
    of = Words(f"解 {which[1:]} ", f" of solution {which[1:]}") if which else Words("求得", " that were found")
    board.step(Words(f"把{of.zh}的质量画入端视图。", f"Draw the masses{of.en} in the end view."), view)
    for name, mass in rotor.masses.items():
        turn, size = found.get(found_bearing(name, which).key), found.get(found_mass(name, which, rotor.weighing).key)
        at = degrees(mass.at.si) if turn is None else float(nominal(turn))
        if (turn is None and not which) or mass.r is None or isnan(at):
            continue
        missing = mass.removed or (size is not None and float(nominal(size)) < 0)
        placed = mass.r.si / mm * complex(heading(at))
        _mass_at(bench, view, mass, placed, f"m_{{{name}}}", missing=missing, within=_is_disc(rotor))


def _parts_in(one: str, other: str, arm: str) -> Words:
    return Words(
        f"画出平面 ${one}$ 的端视图：各质量在两平面内的分量 $m_{{i{one}}}$ = $m_i$($L$ − ${arm}_i$)/$L$、"
        f"$m_{{i{other}}}$ = $m_i {arm}_i$/$L$ 位于原来的半径和方位上。",
        f"Draw plane ${one}$ from its end: the parts of the masses in the two planes, $m_{{i{one}}}$ = "
        f"$m_i$($L$ − ${arm}_i$)/$L$ and $m_{{i{other}}}$ = $m_i {arm}_i$/$L$, sit at the radius and in the "
        "direction of the mass itself.",
    )


def _likewise(end: str) -> Words:
    return Words(f"同样画出平面 ${end}$ 的端视图。", f"Draw plane ${end}$ from its end in the same way.")


def plane_view(bench: Bench, end: str) -> Pane:
    """The end view of a plane of correction."""
    return bench.board.open_pane(END_VIEW, end, Words(f"平面 ${end}$ 端视图", f"End view of plane ${end}$"))


def added_seen(bench: Bench, rotor: Rotor, end: str, plane: RotorPlane, turns: list[float], labels: list[str]) -> None:
    """What balances a plane, in the end view of that plane where it has one; turns in degrees."""
    board = bench.board
    assert plane.r is not None
    view: Place = plane_view(bench, end) if has_plane_views(rotor) else END_VIEW
    away = plane.r.si / board.scale_of(END_VIEW).value
    for turn, label in zip(turns, labels, strict=True):
        at = complex(heading(turn)) * away
        board.join(view, 0j, at, Role.HIDDEN)
        if plane.hole is None:
            board.circle(view, at, LUMP, Role.RESULT)
        else:
            drilled(bench, view, at, plane, end)
        board.plot(view, at, label, Dot.NONE)


def _axes(bench: Bench, rotor: Rotor, view: Place) -> None:
    board = bench.board
    reach = widest(rotor) / board.scale_of(END_VIEW).value
    beyond = reach + (RIM if _is_disc(rotor) else 0.0) + AXIS
    for way in (1, 1j):
        board.join(view, -way * beyond, way * beyond, Role.CENTRE)
    if _is_disc(rotor):
        board.circle(view, 0j, reach + RIM, Role.GIVEN)
    board.plot(view, beyond + 0j, "x", Dot.NONE)
    board.plot(view, 0j, "O", Dot.JOINT)


def _is_disc(rotor: Rotor) -> bool:
    """Whether it is one disc, in which there are holes, or is to be one: its rim is drawn, to no scale."""
    holes = (*(mass.removed for mass in rotor.masses.values()), *(plane.hole for plane in rotor.correct.values()))
    return rotor.static and any(holes)


def _mass_seen(
    bench: Bench, view: Place, mass: RotorMass, away: float, label: str, *, missing: bool, within: bool = False
) -> None:
    """A mass on its arm; what is missing (of a hole, of a part that counts as negative) is a ring."""
    at = rect(away, mass.at.si)
    if mass.r is None:
        bench.board.arrow(view, 0j, at, Role.GIVEN, label=label)
    else:
        _mass_at(bench, view, mass, at, label, missing=missing, within=within)


def _mass_at(
    bench: Bench, view: Place, mass: RotorMass, at: complex, label: str, *, missing: bool, within: bool
) -> None:
    """Within a disc a thin line leads to it, and what is missing is a hole or a keyway; else it sits on an arm."""
    board = bench.board
    if within:
        board.join(view, 0j, at, Role.CONSTRUCTION)
    else:
        board.depict(view, rod(f"mass {label}", 0j, at * (1 - LUMP / abs(at))))
    if missing and within:
        void(bench, view, at, mass, Role.GIVEN)
    elif missing:
        board.circle(view, at, LUMP, Role.HIDDEN)
    else:
        board.depict(view, disc(f"mass {label}", at, LUMP, Lump.OWN))
    board.plot(view, at, label, Dot.NONE)


def _angle(bench: Bench, view: Place, mass: RotorMass, ring: float) -> None:
    turn = mass.at.si % tau
    if 1e-6 < turn < tau - 1e-6:
        bench.board.angle(view, 0j, 1 + 0j, turn, ring, f"{degrees(turn):.4g}°")
