"""The scales of a rotor's figures: shaft and end view as large as a page allows, all polygons of a kind to one μ."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import accumulate

from ....board.construction import Scale, View
from ....board.paper.scales import finer, round_up
from ....board.place import view_named
from ....devices.balancing.asked import LIGHT
from ....devices.balancing.rotor import Rotor
from ....devices.balancing.sought import reference, unknowns
from ....problem.problem import Scales

END_VIEW, COUPLES = view_named("end-view"), view_named("couples")
LONG, WIDE, POLYGON = 110.0, 64.0, 84.0  # mm: along the shaft; across the end view; across the largest polygon
ONE_OF_THREE = 44.0  # mm: across each end view, where both planes have one too
AXIS, LUMP = 7.0, 2.0  # mm: the axes run on; radius of a mass as drawn
SAME = 1e-9  # m: planes nearer to each other are one
FEW = 5  # masses whose angles and distances are written into the figures


def polygon_view(rotor: Rotor) -> View:
    """Products of heavy rotors are drawn in kg·m, those of light ones in g·mm."""
    return view_named("unbalances" if rotor.weighing is LIGHT else "products")


def rotor_scales(rotor: Rotor, given: Scales) -> Mapping[View, Scale]:
    """As given, or round ones that fit."""
    view, radius = polygon_view(rotor), widest(rotor)
    found = {
        View.MECHANISM: given.of(View.MECHANISM.mu) or fitting(max(rotor.length, radius / 4) / LONG),
        END_VIEW: given.of(END_VIEW.mu) or fitting(2 * radius / (ONE_OF_THREE if has_plane_views(rotor) else WIDE)),
        view: given.of(view.mu) or fitting(_largest(rotor) * rotor.weighing.products / POLYGON),
        COUPLES: given.of(COUPLES.mu) or fitting(_couples(rotor) / POLYGON),
    }
    return {kind: Scale.of(kind, value) for kind, value in found.items()}


def has_plane_views(rotor: Rotor) -> bool:
    """Whether each plane of correction is seen from its end, with the parts of the masses: those have radii."""
    return not rotor.static and not rotor.sought and all(mass.r is not None for mass in rotor.masses.values())


def arm_letter(origin: float) -> str:
    """The letter of distances along the axis from this plane: z where z is counted from it, else l."""
    return "l" if abs(origin) > SAME else "z"


def fitting(least: float) -> float:
    """The finest round scale that is not below this; of nothing 1."""
    if least <= 0:
        return 1.0
    scale = round_up(least)
    while finer(scale) >= least:
        scale = finer(scale)
    return scale


def widest(rotor: Rotor) -> float:
    """The largest radius at which something sits (m)."""
    radii = [*(mass.r for mass in rotor.masses.values()), *(plane.r for plane in rotor.correct.values())]
    return max((radius.si for radius in radii if radius is not None), default=0.1)


def _largest(rotor: Rotor) -> float:
    """Across the largest polygon (kg·m), or the circle of what is permitted."""
    if rotor.sought:
        return sum(mass.product for mass in rotor.masses.values() if not mass.unknown) or _any_product(rotor)
    vectors = [mass.vector for mass in rotor.masses.values()]
    chains = [
        vectors,
        *([v * share for v, share in zip(vectors, part.values(), strict=True)] for part in _parts(rotor)),
    ]
    circles = [2 * permitted for permitted in rotor.permitted().values()] if rotor.tolerance is not None else [0.0]
    return max([*map(across, chains), *circles])


def _parts(rotor: Rotor) -> Iterable[dict[str, float]]:
    return rotor.shares.values()


def _any_product(rotor: Rotor) -> float:
    return max((mass.product for mass in rotor.masses.values() if "m" not in mass.unknown), default=1.0)


def across(chain: Iterable[complex]) -> float:
    """The larger side of the box about vectors drawn head to tail."""
    ends = [0j, *accumulate(chain)]
    wide, high = [end.real for end in ends], [end.imag for end in ends]
    return max(max(wide) - min(wide), max(high) - min(high))


def _couples(rotor: Rotor) -> float:
    """Across the couple polygon (kg·m²)."""
    if not rotor.sought:
        middle = (max(rotor.stations) + min(rotor.stations)) / 2
        chain = [mass.vector * (mass.place - middle) for mass in rotor.masses.values()]
        return max(across(chain), sum(map(abs, chain)) / 2)
    first = reference(rotor.masses)
    here = rotor.masses[first].place
    sizes = [mass.product * abs(mass.place - here) for mass in rotor.masses.values() if "m" not in mass.unknown]
    return sum(sizes) / (2 if len(unknowns(rotor.masses)) else 1)
