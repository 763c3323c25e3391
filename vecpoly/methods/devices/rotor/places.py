"""A correction at fixed places: parallels to the two directions through the ends of W_b cut off the shares."""

from __future__ import annotations

from math import degrees

import numpy as np

from ....algebra.quantity import Quantity
from ....board.construction import Pane
from ....board.paper.marks import Role
from ....devices.balancing.asked import share, share_bearing, share_weight
from ....devices.balancing.plane import RotorPlane
from ....devices.balancing.refused import check_signs, nothing_to_share, parallel_places
from ....devices.balancing.rotor import Rotor
from ....names import Named
from ....plane import Points, nominal
from ....words import Words
from ..bench import Bench
from ..equilibrium import signed
from .polygon import Polygon, free_letters, heading, in_plane
from .products import radius
from .rounding import rounded_shares
from .views.sketch import placed

ALIKE = 1e-6  # sine of the angle between two places along which nothing can be resolved


def at_places(bench: Bench, rotor: Rotor, end: str, polygon: Polygon) -> Points:
    """W_b = W_b1 + W_b2 along two allowed directions; gives the unbalance that is left (mm from the pole)."""
    plane, board = rotor.planes[end], bench.board
    if float(nominal(np.abs(polygon.tip))) <= polygon.least:
        raise nothing_to_share(end)
    at, letter = _chosen(plane, -complex(nominal(polygon.tip))), free_letters(bench, polygon.place)[0]
    board.step(
        in_plane(
            end,
            Words(
                f"只能装在 {at[0]:g}° 和 {at[1]:g}° 处。过 $W_b$ 的两端作这两个方向的平行线，交于 ${letter}$，$W_b$ "
                "即分解为沿这两个方向的分量；负值表示在该处去重。",
                f"Weights can only sit at {at[0]:g}° and {at[1]:g}°. Parallels to these directions through the ends "
                f"of $W_b$ meet at ${letter}$ and resolve $W_b$ into its components; a negative one means that mass is "
                "removed there.",
            ),
        ),
        polygon.place,
    )
    corner = _corner(bench, polygon, at, letter)
    sides = ((polygon.tip, corner, f"{polygon.letter} {letter}"), (corner, 0j * corner, f"{letter} O"))
    shares, weights = [], []
    for which, (turn, (start, stop, letters)) in enumerate(zip(at, sides, strict=True), 1):
        bench.stated(share_bearing(end, which), turn + 0.0 * np.abs(corner))
        found = _share(bench, share(end, which, rotor.weighing), polygon.place, (start, stop), turn, letters)
        shares.append(found)
        assert plane.r is not None
        weights.append(
            bench.worked(share_weight(end, which, rotor.weighing), found / radius("r_b", plane.r.si, rotor.weighing))
        )
    _refuse(rotor, plane, at, polygon, shares)
    placed(bench, rotor, end, at, plane)
    return polygon.tip if plane.step is None else rounded_shares(bench, rotor, end, polygon, (at, tuple(weights)))


def _chosen(plane: RotorPlane, needed: complex) -> tuple[float, float]:
    """The two asked for; else the neighbours between which the direction needed lies, or, where mass may only be
    removed, the opposite one (deg)."""
    if plane.use is not None:
        return degrees(plane.use[0].si), degrees(plane.use[1].si)
    assert plane.places is not None
    if len(plane.places) == 2:
        return degrees(plane.places[0].si), degrees(plane.places[1].si)
    turn = float(np.degrees(np.angle(-needed if plane.only == "remove" else needed)))
    ahead = sorted((degrees(one.si) - turn - 1e-9) % 360.0 for one in plane.places)
    return round((turn + 1e-9 + ahead[-1]) % 360.0, 9), round((turn + 1e-9 + ahead[0]) % 360.0, 9)


def _corner(bench: Bench, polygon: Polygon, at: tuple[float, float], letter: str) -> Points:
    board, place = bench.board, polygon.place
    one = board.parallel(polygon.tip, heading(at[0]), key=f"{place.name}_1")
    other = board.parallel(0j * polygon.tip, heading(at[1]), key=f"{place.name}_2")
    if abs(float(np.sin(np.radians(at[1] - at[0])))) < ALIKE:
        raise parallel_places(at)
    corner = board.meet(one, other, Words("两个允许的方位", "the two places"))
    board.rule(place, one, corner)
    board.rule(place, other, corner)
    corner = board.locate(place, letter, corner)
    board.plot(place, corner, letter)
    return corner


def _share(bench: Bench, named: Named, place: Pane, ends: tuple[Points, Points], turn: float, letters: str) -> Quantity:
    bench.board.arrow(place, *ends, Role.RESULT, key=named.key, label=named.symbol)
    return signed(bench, named, place, ends, heading(turn), letters)


def _refuse(rotor: Rotor, plane: RotorPlane, at: tuple[float, float], polygon: Polygon, shares: list[Quantity]) -> None:
    """Where only one sign is allowed the other is refused, with the pairs that work."""
    factor = rotor.weighing.products
    found = tuple(
        (float(np.radians(turn)), float(nominal(one.value)) / factor) for turn, one in zip(at, shares, strict=True)
    )
    needed = sum((value * complex(np.exp(1j * turn)) for turn, value in found), 0j)
    check_signs(plane, needed, found)
