"""Random force problems in all the words of the manual: several loads on a link, round bars, centres by lengths,
V-grooves, who carries a pin, what is asked."""

from __future__ import annotations

from math import degrees

import numpy as np

from ..equilibrium import in_equilibrium
from ..family import family
from ..forces import force, free, moment, numbered, renumbering, simple, template
from ..loaded import Chain, rrp, rrr


def several(c: Chain, without: str = "") -> str:
    """Two or three loads on one link, and sometimes one on another."""
    names = [name for name in c.links if name != without]
    first, other = (str(c.rng.choice(names)) for _ in range(2))
    text = "".join(_load(c, f"q{i}", first) for i in range(int(c.rng.integers(2, 4))))
    return text + (_load(c, "q9", other) if c.rng.random() < 0.4 else "")


def _load(c: Chain, tail: str, link: str) -> str:
    return (
        moment(c, f"M_{tail}", link)
        if c.rng.random() < 0.3
        else force(c, f"F_{tail}", link, str(c.rng.choice(c.links[link])))
    )


def masses(c: Chain) -> str:
    """Masses of some links: on a letter, set out by offsets or by two lengths, of a round bar, at the one pin."""
    text = "".join(f"  @{name}: {{{_mass(c, name)}}}\n" for name in c.links if c.rng.random() < 0.7)
    return (
        f"masses:\n{text}weight: {c.rng.choice(['yes', 'no'])}\ninertia: {c.rng.choice(['yes', 'yes', 'no'])}\n"
        if text
        else ""
    )


def _mass(c: Chain, name: str) -> str:
    letters, mass = c.links[name], f"mass: {c.rng.integers(200, 4000)} g"
    if len(letters) < 2 or not c.text[name].startswith(letters[0] + letters[1]):
        return mass if len(letters) == 1 else f"{mass}, centre: {letters[-1]}"
    p, q = letters[:2]
    match int(c.rng.integers(4)):
        case 0:
            return f"rod: {{diameter: {c.rng.integers(8, 30)} mm, density: 7800 kg/m^3}}"
        case 1:
            length, x, y = abs(c.at[q] - c.at[p]), c.rng.uniform(10, 80), c.rng.uniform(5, 40)
            s = f"S@{name}"
            place = (
                f"{{{p}{s}: {np.hypot(x, y):.9g} mm, {q}{s}: {np.hypot(length - x, y):.9g} mm, side: "
                f"{c.rng.choice(['left', 'right'])} of {p}{q}}}"
            )
        case 2:
            place = (
                f"{{along: {p}{q}, at: {c.rng.integers(-20, 120)} mm, {c.rng.choice(['left', 'right'])}: "
                f"{c.rng.integers(0, 40)} mm}}"
            )
        case _:
            place = str(c.rng.choice(letters))
    return f"{mass}, inertia: {c.rng.integers(0, 20000)} kg*mm^2, centre: {place}"


def hinges(c: Chain) -> dict[str, list[str]]:
    """Letter of a pin → the moving links there."""
    found = {
        p: [name for name, letters in c.links.items() if p in letters] for letters in c.links.values() for p in letters
    }
    return {p: names for p, names in found.items() if len(names) + (p in c.frame) > 1}


def friction(c: Chain) -> str:
    """Every way to write the friction of a pin or of a slide."""
    text = "".join(f"  {p}: {{{_pin(c)}}}\n" for p in sorted(hinges(c)) if c.rng.random() < 0.8)
    text += "".join(f"  {_ends(c, a, b)}: {{{_slide(c)}}}\n" for a, b in c.slides if c.rng.random() < 0.8)
    return f"friction:\n{text}" if text else ""


def _ends(c: Chain, a: str, b: str) -> str:
    return f"@{a}-@{b}" if c.rng.random() < 0.5 else f"@{b}-@{a}"


def _pin(c: Chain) -> str:
    rho, f = c.rng.uniform(0.3, 3), c.rng.uniform(0.05, 0.3)
    return str(
        c.rng.choice([f"rho: {rho:.3f} mm", f"f: {f:.3f}, r: {rho / f:.3f} mm", f"f_v: {f:.3f}, r: {rho / f:.3f} mm"])
    )


def _slide(c: Chain) -> str:
    phi = float(np.radians(c.rng.uniform(2, 9)))
    f, v = np.tan(phi), c.rng.uniform(35, 80)
    return str(
        c.rng.choice(
            [
                f"phi: {degrees(phi):.3f} deg",
                f"f: {f:.4f}",
                f"f_v: {f:.4f}",
                f"f: {f * np.sin(np.radians(v)):.4f}, V: {v:.2f} deg",
            ]
        )
    )


def carriers(c: Chain, always: bool = False) -> str:
    """Some link carries the pin of a multiple joint between moving links."""
    compound = {p: names for p, names in hinges(c).items() if len(names) > 2 and p not in c.frame}
    said = ", ".join(f"{p}: @{c.rng.choice(names)}" for p, names in compound.items() if always or c.rng.random() < 0.5)
    return f"pins: {{{said}}}\n" if said else ""


def asked(c: Chain) -> str:
    """What is asked of forces: by name, without friction, by lever and power, efficiency."""
    keys = ["X_b", *(key for key in ("X_b_0", "X_b_lever", "X_b_power", "eta") if c.rng.random() < 0.5)]
    return f"find: [{', '.join(keys)}]\n" if c.rng.random() < 0.4 else ""


@family("forces-written", also=in_equilibrium, often=1, first=1)
def as_written(rng: np.random.Generator) -> str:
    """Loads, masses, friction, pins, in all their spellings."""
    c = simple(rng)
    further = (
        (masses(c) if rng.random() < 0.5 else "") + (friction(c) if rng.random() < 0.5 else "") + carriers(c) + asked(c)
    )
    return numbered(c, template(c, several(c) + free(c, "L0"), further), renumbering(rng, c))


@family("forces-pins", also=in_equilibrium, often=1)
def carried(rng: np.random.Generator) -> str:
    """Bars and sliders with multiple joints, whose pins any link may carry, with friction or without."""
    c = simple(rng, (rrr, rrp))
    while not carriers(c, always=True):
        c = simple(rng, (rrr, rrp))
    further = (
        (masses(c) if rng.random() < 0.3 else "")
        + (friction(c) if rng.random() < 0.4 else "")
        + carriers(c, always=True)
    )
    return numbered(c, template(c, several(c) + free(c, "L0"), further), renumbering(rng, c))
