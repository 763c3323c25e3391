"""A rotor: its sketch, its products, its polygons; what balances it and what may remain."""

from __future__ import annotations

from ....board.paper.titled import ALONG_AXIS
from ....devices.balancing.rotor import Rotor
from ....words import Words
from ..bench import Bench
from ..registry import device_method
from .dalby import dalby
from .products import products
from .scales import rotor_scales
from .static import in_one_plane
from .two_planes import in_two_planes
from .views.sketch import sketch


@device_method(
    Rotor,
    title=Words("转子的平衡（质径积多边形）", "Balance of a rotor by mass–radius polygons"),
    source="机械原理, balance of rotors: mass–radius polygons, two planes, Dalby's couple polygon, ISO 21940-11",
    example="6-4",
    scales=rotor_scales,
    called=ALONG_AXIS,
)
def draw_rotor(bench: Bench, rotor: Rotor) -> None:
    """Static in one plane, dynamic in two, or by the masses that are sought."""
    sketch(bench, rotor)
    sizes = products(bench, rotor)
    if rotor.sought:
        dalby(bench, rotor, sizes)
    elif rotor.static:
        in_one_plane(bench, rotor, sizes)
    else:
        in_two_planes(bench, rotor, sizes)
