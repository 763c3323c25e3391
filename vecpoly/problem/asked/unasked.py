"""What is asked of a loaded mechanism where the file does not say."""

from __future__ import annotations

from collections.abc import Mapping

from ...errors import MobilityError
from ...mechanism.asked.forces import pairs, press_named
from ...mechanism.groups.assur import decompose
from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from ...names import Named
from .asks import AskNamed


def default_asks(mech: Mechanism, loads: Loads, forces: Mapping[str, Named]) -> tuple[AskNamed, ...]:
    """What is asked where the file does not say:
    the unknown load, with friction also without it and η, and every reaction.

    Of gears and of groups above class II the reactions are not drawn: there the load alone.
    """
    name = loads.unknown.name
    if not loads.friction and not _of_dyads(mech):
        return (AskNamed(rel=forces[name]),)
    keys = [name, *([f"{name}_0", "eta"] if loads.friction else [])]
    # between a cylinder and its piston there is only the thrust
    rams = [{force.link, force.against} for force in loads.forces]
    keys += [press_named(mech, by, on).key for by, on in pairs(mech) if {by, on} not in rams]
    return tuple(AskNamed(rel=forces[key]) for key in keys)


def _of_dyads(mech: Mechanism) -> bool:
    """Whether the mechanism consists of dyads of hinges and slides, and cylinders."""
    try:
        return all(
            (group.dyad is not None or group.ram is not None) and "G" not in group.kind for group in decompose(mech)
        )
    except MobilityError:
        return True  # what is wrong with it is told elsewhere
