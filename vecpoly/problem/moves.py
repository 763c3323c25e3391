"""Whether the mechanism of a file moves as it must."""

from __future__ import annotations

from ..errors import VecpolyError
from ..mechanism.groups import mobility
from ..mechanism.model import Mechanism
from .links.standing import check_starts
from .schema.faults import Faults, Place
from .text.source import Tree


def settle(mechanism: Mechanism, tree: Tree, faults: Faults) -> None:
    """Tell every fault of the file; then whether the mechanism moves as it must, and stands where it is told to."""
    faults.settle()
    _check_mobility(mechanism, tree)
    check_starts(mechanism, faults)
    faults.settle()


def _check_mobility(mechanism: Mechanism, tree: Tree) -> None:
    """Degrees of freedom and inputs must agree; the mechanism's own error, with the file's name in front."""
    try:
        mobility.check(mechanism)
    except VecpolyError as error:
        place = tree.places.get(("input",), Place(tree.name))
        raise error.at(Place(place.file, place.line), "input") from None
