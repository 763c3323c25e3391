"""What may be asked of a loaded mechanism, by key.

``M_1`` the balancing load; ``M_1_0`` the same without friction; ``M_1_lever``, ``M_1_power`` without friction by the
Zhukovsky lever and by virtual power; ``R_12`` the force of link 1 on link 2 (frame: its printed number), ``R_12_0``
without friction; ``h`` the arm of the couple on the link that a balancing moment acts on; ``eta`` the efficiency;
``F_I2``, ``M_I2`` inertia force and couple of link 2, ``h_2`` the arm by which they join into one force; ``m_2``,
``J_2`` its mass and its moment of inertia about the centre of mass, which are data (`given_value`). A moment that is
constant over the period has its own name, ``M_d``; what balances at a position is then ``M_b``. Loads that depend on
the motion, and springs, have their sizes by their own names.
"""

from __future__ import annotations

from itertools import combinations

from ...names import Named, reaction
from ..groups.assur import ends, hinges
from ..laws.springs import Coil, Elastic
from ..loads import Force, Load, Loads, Mass, slide_name
from ..model import Mechanism, Prismatic, Revolute


def load_symbol(name: str) -> str:
    """A load's name in the notation of `formula`: M_1 → M_{1}, F_r → F_{r}."""
    stem, _, sub = name.partition("_")
    return f"{stem}_{{{sub}}}" if sub else stem


def load_named(load: Load) -> Named:
    """The load as a quantity: N along its direction, or N·m counter-clockwise."""
    return Named(load.name, load_symbol(load.name), "N" if isinstance(load, Force) else "N·m")


def spring_named(spring: Elastic) -> Named:
    """What a spring does: N where it pulls, or N·m on its link."""
    return Named(spring.name, load_symbol(spring.name), "N·m" if isinstance(spring, Coil) else "N")


def without_friction(named: Named) -> Named:
    """The same reaction or balancing load without friction: R_12,0, M_1,0."""
    stem, _, sub = named.key.partition("_")
    zero = f"{sub},0" if sub[-1:].isdigit() else f"{sub}0"  # M_1,0 and not M_10, which would be of a link 10
    symbol = f"{named.symbol[:-1]},0}}" if named.is_vector else f"{stem}_{{{zero}}}"
    return Named(f"{named.key}_0", symbol, named.unit, named.is_vector)


def pairs(mech: Mechanism) -> tuple[tuple[str, str], ...]:
    """Links that press on each other in a joint or a contact, as names; each pair once.

    At a multiple joint these are the link that carries the pin and each of the others (`seats`). A pin in a slot is
    told by the slot's link and the block that is thought about the pin,
    for two pins of one link may press on another; `press_named` has the true links.
    """
    thought = {*mech.substitutes, *mech.slot_pins}
    found = [pair for joint in mech.joints if isinstance(joint, Revolute) and not thought & set(pair := ends(joint))]
    found += [
        pair
        for joint in mech.joints
        if not isinstance(joint, Revolute) and not mech.substitutes & set(pair := ends(joint))
    ]
    found += [contact.links for contact in mech.contacts]
    return tuple(dict.fromkeys(found))


def press_named(mech: Mechanism, by: str, on: str) -> Named:
    """R_12 of two links that press on each other;
    a block that is only thought about a pin in a slot stands for the pin.

    Where two pins of one link run in slots of another, or a pin in a slot and a hinge join the same two links, the
    pin's letter tells the two forces apart: R_12B.
    """
    pins = mech.slot_pins
    pin = pins.get(by) or pins.get(on)
    if pin is None:
        return reaction(mech.number(by), mech.number(on))
    away = (by == pin.block and on != pin.carrier) or by == pin.carrier  # from the pin on the slot
    named = reaction(*map(mech.number, (pin.carrier, pin.guide) if away else (pin.guide, pin.carrier)))
    joined = {pin.carrier, pin.guide}
    alike = sum({other.carrier, other.guide} == joined for other in pins.values())
    alike += sum(set(ends(joint)) == joined for joint in mech.joints)
    return (
        named
        if alike == 1
        else Named(f"{named.key}{pin.point}", f"{named.symbol[:-1]}{pin.point}}}", named.unit, named.is_vector)
    )


def leaning_symbol(mech: Mechanism, at: str | tuple[str, str]) -> str:
    """Of the friction angle of a contact (its letter) or of a slide (its links), as it is given: φ_T, φ_{23}."""
    if isinstance(at, str):
        return f"φ_{{{at}}}"
    return f"φ_{{{slide_name(mech.number(at[0]), mech.number(at[1]))}}}"


def slide_named(mech: Mechanism, joint: Prismatic) -> str:
    """A slide by the printed numbers of block and guide, 45; a pin in a slot by those of the links, with its letter
    where there are two such: 12, 12B."""
    pin, number = mech.slot_pins.get(joint.block), mech.number(joint.block) + mech.number(joint.guide)
    alike = (
        []
        if pin is None
        else [one for one in mech.slot_pins.values() if (one.carrier, one.guide) == (pin.carrier, pin.guide)]
    )
    return number + (joint.pin if len(alike) > 1 else "")


def apart(mech: Mechanism) -> tuple[tuple[str, str], ...]:
    """Links that share a multiple joint without pressing on each other, since a third one carries the pin: R_ij = 0."""
    press = {frozenset(pair) for pair in pairs(mech)}
    thought = {*mech.substitutes, *mech.slot_pins}
    found = [pair for names in hinges(mech).values() for pair in combinations(names, 2)]
    return tuple(dict.fromkeys(pair for pair in found if frozenset(pair) not in press and not thought & set(pair)))


def quantities(mech: Mechanism, loads: Loads) -> dict[str, Named]:
    """Every quantity of the loaded mechanism by its key."""
    unknown = load_named(loads.unknown)
    found = [unknown, Named("eta", "η", ""), without_friction(unknown)]
    found += [balanced_by(way, loads) for way in ("lever", "power")]
    found += [load_named(load) for load in loads.all if load.law is not None]
    found += [spring_named(spring) for spring in loads.springs]
    if loads.constant is not None:
        found.append(Named(loads.constant.name, load_symbol(loads.constant.name), "N·m"))
    if unknown.unit == "N·m":
        found.append(Named("h", "h", "m"))
    for a, b in (*pairs(mech), *apart(mech)):
        for by, on in ((a, b), (b, a)):
            named = press_named(mech, by, on)
            found += [named, without_friction(named)]
    for mass in loads.masses:
        found += [*inertia_named(mass), *mass_named(mass)]
    return {named.key: named for named in found}


def balanced_by(way: str, loads: Loads) -> Named:
    """The balancing load found in another way; where there is no friction, M_1,0 would be another name of M_1."""
    unknown = load_named(loads.unknown)
    alone = without_friction(unknown) if loads.friction else unknown
    return Named(f"{unknown.key}_{way}", alone.symbol, unknown.unit)


def inertia_named(mass: Mass) -> tuple[Named, Named, Named]:
    """Inertia force and couple of a link, and by how far the force is displaced to replace both."""
    link = mass.link
    force, couple = Named(f"F_I{link}", f"F_{{I{link}}}", "N", True), Named(f"M_I{link}", f"M_{{I{link}}}", "N·m")
    return force, couple, Named(f"h_{link}", f"h_{link}", "m")


def mass_named(mass: Mass) -> tuple[Named, Named]:
    """Mass and moment of inertia of a link."""
    link = mass.link
    return Named(f"m_{link}", f"m_{{{link}}}", "kg"), Named(f"J_{link}", mass.inertia_symbol, "kg·m^2")


def given_value(loads: Loads, key: str) -> float | None:
    """The value of ``m_2`` (kg) or ``J_2`` (kg·m²), which need no equilibrium; None for every other key."""
    mass = loads.mass(key[2:]) if key[:2] in ("m_", "J_") else None
    return None if mass is None else mass.mass if key[0] == "m" else mass.inertia
