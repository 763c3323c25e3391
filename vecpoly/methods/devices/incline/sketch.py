"""A block on an inclined plane as drawn: the plane with its angle, the block, F as a pull or a push."""

from __future__ import annotations

from ....board.construction import Pane, View
from ....diagram.owners import FIXED
from ....diagram.single import number, rail
from ....plane import Points, nominal
from ..bench import Bench
from ..inclined import between, body, haul, numbered, ray

PLANE, LONG, HIGH = 72.0, 24.0, 13.0  # mm: the plane; the block
ARM, STEEP = 24.0, 0.2  # mm: the arrow of F; sine of its angle over the plane from which it is drawn as a pull


def block_on(along: Points, foot: Points) -> tuple[Points, ...]:
    """Corners of a block whose base lies along the plane, its middle at `foot`."""
    low = foot - along * LONG / 2
    return low, low + along * LONG, low + along * (LONG + 1j * HIGH), low + along * 1j * HIGH


def on_plane(bench: Bench, place: View | Pane, along: Points, label: str) -> Points:
    """The plane with its angle, and a block on it; gives the middle of the block."""
    foot = along * PLANE * 0.62
    bench.board.depict(place, rail(0j, along * PLANE))
    ray(bench, place, 0j, 1 + 0j, PLANE * 0.62)
    between(bench, place, 0j, 1 + 0j, along, 30.0, label)
    body(bench, place, "link 1", *block_on(along, foot))
    return foot + 0.5j * along * HIGH


def sketch(bench: Bench, along: Points, force: Points) -> None:
    """The plane with the block, F and Q on it, and the angles α and β."""
    view = View.MECHANISM
    middle = on_plane(bench, view, along, "α")
    side = draw_drive(bench, view, middle, along, force)
    haul(bench, view, middle, -1j, "Q", 20.0)
    ray(bench, view, middle, side, 24.0)
    numbered(bench, view, (middle - along * 0.32 * LONG, "1"))
    bench.board.depict(view, number("2", along * (PLANE - 4) - 4j, owner=FIXED))  # the plane, which is the frame
    between(bench, view, middle, side, side * force, 15.0, "β")


def draw_drive(bench: Bench, place: View | Pane, middle: Points, along: Points, force: Points) -> complex:
    """Draw F through the block as a pull, or as a push where a pull would point into the plane;
    gives the side of its arrow, 1 or −1."""
    pulls = float(nominal((force / along).imag)) > STEEP
    haul(bench, place, middle if pulls else middle - force * ARM, force, "F", ARM)
    return 1 + 0j if pulls else -1 + 0j
