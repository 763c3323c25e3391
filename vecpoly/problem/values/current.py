"""What is given as the mechanism has it now: a length or a rate that was replaced is printed as it is.

A datum is bound where, as loaded, it says what the mechanism says; of a bound datum only the mechanism is believed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import degrees, isclose, remainder, tau

from ...foundation.indices import LETTER
from ...foundation.patterns import pattern
from ...foundation.slotted import replace
from ...mechanism.dimensions.values import Dimension, Led, Part, Placed
from ...mechanism.dimensions.vary import dimensions, upright, value
from ...mechanism.loads import Loads
from ...mechanism.model import Circle, Drive, Mechanism, Prismatic, Rolling
from .given import Datum, Given

_ENDS = pattern(rf"l_({LETTER}\d*)({LETTER}\d*)")
_SAME = 1e-9  # relative
Values = Mapping[str, float]  # symbol -> SI value


def current(given: Given, mech: Mechanism, loads: Loads | None = None) -> Given:
    """The data with every bound one as the mechanism and its loads have it now."""
    if given.bound is None:
        given = replace(given, leads=_leads(given, mech))
    values = _values(given, mech) | (_acting(loads) if loads else {})
    if given.bound is None:
        data = given.data
        same = frozenset(d.symbol for d in data if d.symbol in values and _same(values[d.symbol], d.si))
        return replace(given, bound=same)
    stale = {symbol: values[symbol] for symbol in given.bound if symbol in values}
    return replace(
        given,
        lengths=_renewed(given.lengths, stale, _length),
        motion=_renewed(given.motion, stale, _motion),
        loads=_renewed(given.loads, stale, _load),
    )


def _renewed(data: tuple[Datum, ...], now: Values, written: Callable[[Datum, float], str]) -> tuple[Datum, ...]:
    def anew(datum: Datum) -> Datum:
        to = now.get(datum.symbol, datum.si)
        return datum if _same(to, datum.si) else replace(datum, si=to, text=written(datum, to))

    return tuple(anew(datum) for datum in data)


def _values(given: Given, mech: Mechanism) -> dict[str, float]:
    """Symbol → value of all that the mechanism itself knows."""
    found = {f"r_{circle.link}": circle.radius for circle in _circles(mech)}
    for datum in given.lengths:
        ends = _ENDS.fullmatch(datum.symbol)
        link = next((link for link in mech.links if ends and set(ends.groups()) <= link.points.keys()), None)
        if ends and link:
            found[datum.symbol] = abs(link.points[ends[1]] - link.points[ends[2]])
    for one in dimensions(mech):
        if symbol := _symbol(mech, one):
            found[symbol] = value(mech, one)
    for drive in mech.drives:
        places, rate, accel = _symbols(mech, drive)
        found |= {place: drive.position - given.leads.get(place, 0.0) for place in places}
        found |= {rate: drive.rate, accel: drive.accel}
    return found


def _symbols(mech: Mechanism, drive: Drive) -> tuple[tuple[str, ...], str, str]:
    """How the place (one of these), the rate and the acceleration of a drive are printed."""
    if not drive.slide:
        pair = f"{drive.link}{drive.on}" if drive.between else drive.link
        return (f"φ_{pair}",), f"ω_{pair}", f"α_{pair}"
    slides = (joint for joint in mech.joints if isinstance(joint, Prismatic))
    guide = next((joint for joint in slides if (joint.block, joint.guide) == (drive.link, drive.on)), None)
    if guide is None or not drive.between:
        return (f"s_{drive.link}",), f"v_{drive.link}", f"a_{drive.link}"
    ends = "".join(next(iter(mech.link(name).points)) for name in (drive.on, drive.link))
    pair = f"{guide.pin}{drive.link}{guide.pin}{drive.on}"
    return (f"s_{drive.link}{drive.on}", f"l_{ends}"), f"v_{pair}", f"a^r_{pair}"


def _leads(given: Given, mech: Mechanism) -> dict[str, float]:
    """How far each drive's own coordinate is ahead of its datum: an angle may count from another line."""
    data = {datum.symbol: datum.si for datum in given.motion}
    places = [(place, drive) for drive in mech.drives for place in _symbols(mech, drive)[0]]
    return {place: drive.position - data[place] for place, drive in places if place in data}


def _symbol(mech: Mechanism, one: Dimension) -> str:
    """How an angle of a point on its link, or the place of a fixed guide, is printed; empty for others."""
    match one:
        case Placed(link=name, places=(i,), part=Part.ANGLE):
            placement = mech.link(name).placements[i]
            return f"∠{placement.base[1]}{placement.base[0]}{placement.point}" if len(placement.base) == 2 else ""
        case Led(joint=i, part=Part.PLACE) if isinstance(guide := mech.joints[i], Prismatic):
            return f"{'x' if upright(guide) else 'y'}_{guide.pin}"
        case _:
            return ""


def _acting(loads: Loads) -> dict[str, float]:
    """Symbol → size of the known loads, masses, moments of inertia."""
    sizes = {load.name: load.size for load in loads.all if load.size is not None}
    masses = {f"m_{mass.link}": mass.mass for mass in loads.masses}
    return sizes | masses | {mass.inertia_symbol: mass.inertia for mass in loads.masses}


def _circles(mech: Mechanism) -> list[Circle]:
    rolling = [joint for joint in mech.joints if isinstance(joint, Rolling)]
    pairs = [*((joint.gear, joint.on) for joint in rolling), *((contact.disc, contact.on) for contact in mech.contacts)]
    return [circle for pair in pairs for circle in pair if isinstance(circle, Circle)]


def _same(now: float, before: float) -> bool:
    return isclose(now, before, rel_tol=_SAME, abs_tol=1e-15)


def _length(datum: Datum, value: float) -> str:
    return f"{degrees(value):.6g} deg" if datum.symbol.startswith("∠") else f"{1e3 * value:.6g} mm"


def _load(datum: Datum, value: float) -> str:
    """In the unit in which it was written, if that is one of SI's; a moment with its sense."""
    if datum.symbol.startswith("m_"):
        return f"{value:.6g} kg"
    if datum.symbol.startswith("J_"):
        return f"{value:.6g} kg·m²"
    if "·m" not in datum.text:
        return f"{value:.6g} N"
    return f"{abs(value):.6g} N·m{' ccw' if value > 0 else ' cw' if value < 0 else ''}"


def _motion(datum: Datum, value: float) -> str:
    sense = " ccw" if value > 0 else " cw" if value < 0 else ""
    match datum.symbol[0]:
        case "φ":
            return f"{degrees(remainder(value, tau)):.6g} deg"
        case "ω":
            return f"{abs(value):.6g} rad/s{sense}"
        case "α":
            return f"{abs(value):.6g} rad/s^2{sense}"
        case "s" | "l":
            return f"{1e3 * value:.6g} mm"
    return f"{value:.6g} {'m/s' if datum.symbol[0] == 'v' else 'm/s^2'}"
