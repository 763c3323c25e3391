"""What acts on a mechanism: its loads with their friction, the machine that it is, its counterweights."""

from __future__ import annotations

from ...foundation.slotted import replace
from ...mechanism.counterweights import Counterweights
from ...mechanism.loads import Loads, Mass
from ...mechanism.machine import Machine
from ...mechanism.model import Mechanism
from ..joints.motion import sense_only
from ..links.bodies import Bodies
from ..links.counterweights import read_counterweights
from ..problem import Datum
from ..schema.faults import Faults
from ..schema.models import ProblemSpec
from .driven import driven_by
from .friction import read_friction
from .load_data import data_of_loads
from .loads import acts, read_loads
from .machine import needs_balance, read_machine

Moved = tuple[Mechanism, tuple[Datum, ...]]  # the mechanism, and the data of its input
Weights = tuple[tuple[Mass, ...], tuple[Datum, ...]]  # the masses, and what is printed of them
Acting = tuple[Loads | None, Machine | None, Counterweights | None, tuple[Datum, ...]]


def read_acting(spec: ProblemSpec, bodies: Bodies, moved: Moved, weights: Weights, faults: Faults) -> Acting:
    """The loads with friction (none where nothing balances them), the machine, the counterweights, and what is printed
    of all of them after 已知."""
    mechanism, rated = moved[0], not sense_only(spec)
    loads = read_loads(spec, bodies, weights[0], driven_by(*moved, rated), faults)
    counterweights, hung = read_counterweights(spec, mechanism, loads, faults, rate=rated)
    if not acts(spec):
        read_machine(spec, mechanism, None, faults)  # refused, where one is asked for
        return None, None, counterweights, ()
    faults.settle()  # which quantities may be asked for is known only where the mechanism and its loads are right
    assert loads is not None
    friction, rubbing = read_friction(spec.friction, mechanism, faults)
    faults.settle()
    loads = replace(loads, friction=friction)
    machine, running = read_machine(spec, mechanism, loads, faults)
    faults.settle()
    told = (*data_of_loads(spec, loads, mechanism), *rubbing, *weights[1], *hung, *running)
    balanced = loads.balancing and ((machine is None and not spec.counterweights) or needs_balance(spec))
    return loads if balanced else None, machine, counterweights, told
