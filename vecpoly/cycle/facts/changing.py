"""Which figure a four-bar with change points makes all the way round."""

from __future__ import annotations

import numpy as np

from ...mechanism.assembly.branch import margin
from ...mechanism.assembly.four_bar import fourth_corner
from ...mechanism.assembly.statements import Form
from ...mechanism.model import Revolute, Shaped
from ...words import Words
from ..columns import dyads
from ..cycle import Cycle
from .closing import INSIDE


def figure_of(cycle: Cycle, links: str) -> Shaped | None:
    """Parallelogram or antiparallelogram, where the dyad of these links (as its column names them) is half of one."""
    dyad = dyads(cycle.mech)[links]
    corner = fourth_corner(cycle.mech, dyad)
    if corner is None or not isinstance(dyad.inner, Revolute):
        return None
    b, d = (joint.point for joint in (dyad.outer_j, dyad.outer_k) if isinstance(joint, Revolute))
    shape = Shaped(corners=(corner, b, dyad.inner.point, d), form=Form.PARALLELOGRAM)
    place = np.array([cycle.low + INSIDE])
    at = {letter: complex(np.asarray(cycle.at(f"p_{letter}", place)).ravel()[0]) for letter in shape.corners}
    return shape if margin(shape, at) > 0 else Shaped(corners=shape.corners, form=Form.ANTIPARALLELOGRAM)


def figure_words(cycle: Cycle, links: str) -> Words:
    """: ABCD remains a parallelogram."""
    if (figure := figure_of(cycle, links)) is None:
        return Words("", "")
    corners = "".join(figure.corners)
    return Words(f"，${corners}$ 始终为{figure.form.words.zh}", f": ${corners}$ remains {figure.form.words.en}")
