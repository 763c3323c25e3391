"""All that is sought: what is asked for, what was printed, and the scales to which is drawn."""

from __future__ import annotations

from collections.abc import Sequence

from ...errors import FaultError
from ...mechanism.asked.centres import centre_quantities
from ...mechanism.asked.counterweights import counterweight_quantities
from ...mechanism.asked.curvature import Centrodes, Curvature
from ...mechanism.asked.forces import quantities
from ...mechanism.asked.machine import machine_quantities
from ...mechanism.counterweights import Counterweights
from ...mechanism.loads import Loads
from ...mechanism.machine import Machine
from ...mechanism.model import Mechanism
from ...names import At, Named, is_centre
from ...words import Words
from ..joints.motion import numbered
from ..links.bodies import Bodies
from ..problem import Printed, Scales
from ..schema.faults import Faults
from ..schema.models import FindSpec, ProblemSpec
from .asks import Ask, AskNamed
from .curved import centrode_asks, curvature_of, curved_quantities, is_curved, known_quantities, read_centrodes
from .drawn_to import plottable, read_scales
from .neglected import kept
from .pressed import pressed_quantities
from .printed import read_printed
from .unasked import default_asks
from .wanted import CENTRAL, read_find, read_point
from .written import names_centre

ALL_CENTRES = "centres"  # find: [centres] asks for every instant centre


def read_wanted(
    spec: ProblemSpec,
    bodies: Bodies,
    mechanism: Mechanism,
    loads: Loads | None,
    machine: Machine | None,
    weighed: Counterweights | None,
    faults: Faults,
) -> tuple[tuple[Ask, ...], Curvature | None, tuple[Printed, ...], Scales]:
    """What is asked for, of which curvatures, what was printed, and the scales;
    every fault is noted at its place."""
    forces = _geometric(spec, mechanism, faults) | _acting(mechanism, loads, machine)
    forces |= _hung(mechanism, weighed) | pressed_quantities(spec, mechanism, faults)
    forces = known_quantities(forces, centrodes := _centrodes(spec, mechanism, faults), mechanism)
    named, asks, printed = list[At](), list[Ask](), list[Printed]()
    for i, item in enumerate(spec.find):
        if isinstance(item, FindSpec) and item.point:
            with faults.at("find", i):
                named.append(read_point(item, bodies).at)
    clean = not faults.found
    for i, item in enumerate(spec.find):
        if item == ALL_CENTRES:
            asks += [AskNamed(rel=named) for named in forces.values() if is_centre(named)]
        elif isinstance(item, FindSpec) and item.centrodes is not None:
            asks += centrode_asks(mechanism, centrodes) if centrodes else ()
        elif clean:
            with faults.at("find", i):
                asks.append(kept(numbered(read_find(item, bodies, named, forces), spec), loads))
    for i, entry in enumerate(spec.printed):
        with faults.at("printed", i):
            printed.append(read_printed(entry, bodies, named, forces))
    if loads and not spec.find:
        asks.extend(default_asks(mechanism, loads, forces))
    scales = Scales()
    with faults.at("scales"):
        scales = read_scales(spec.scales)
        plottable(scales, mechanism)
    clean = not faults.found
    curvature = curvature_of(spec, mechanism, _once(asks), centrodes, faults) if clean else None
    return _once(asks), curvature, tuple(printed), scales


def _once(asks: Sequence[Ask]) -> tuple[Ask, ...]:
    """Each question once, P_13 beside all centres too."""
    return tuple(dict.fromkeys(asks))


def _hung(mechanism: Mechanism, weighed: Counterweights | None) -> dict[str, Named]:
    return counterweight_quantities(mechanism, weighed) if weighed else {}


def _acting(mechanism: Mechanism, loads: Loads | None, machine: Machine | None) -> dict[str, Named]:
    """What follows from what acts: an equilibrium, a machine."""
    return (quantities(mechanism, loads) if loads else {}) | (machine_quantities(mechanism, machine) if machine else {})


def _centrodes(spec: ProblemSpec, mechanism: Mechanism, faults: Faults) -> Centrodes | None:
    """The centrodes that are asked, one pair at most."""
    found = None
    for i, item in enumerate(spec.find):
        if isinstance(item, FindSpec) and item.centrodes is not None and is_curved(spec) and not faults.found:
            with faults.at("find", i):
                if found is not None:
                    raise FaultError(Words("一题只作一个构件的瞬心线", "one problem draws the centrodes of one link"))
                found = read_centrodes(item, mechanism)
    return found


def _geometric(spec: ProblemSpec, mechanism: Mechanism, faults: Faults) -> dict[str, Named]:
    """What curvatures, or the instant centres, give."""
    if faults.found:
        return {}
    curved = curved_quantities(spec, mechanism, faults)  # tells what is asked without its method
    return curved if is_curved(spec) or faults.found else _by_centres(spec, mechanism)


def _by_centres(spec: ProblemSpec, mechanism: Mechanism) -> dict[str, Named]:
    """What the instant centres give, where one of these is asked for or printed."""
    keys = [item for item in spec.find if isinstance(item, str)] + [entry.symbol for entry in spec.printed]
    wanted = any(key == ALL_CENTRES or CENTRAL.match(key) or names_centre(key) for key in keys)
    return centre_quantities(mechanism) if wanted else {}
