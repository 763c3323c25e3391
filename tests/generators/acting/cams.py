"""Forces in cams and eccentrics: a disc on the crank or on a rod, a follower with a round tip or a flat face, friction
in the contact and everywhere."""

from __future__ import annotations

import cmath

import numpy as np

from ..equilibrium import in_equilibrium
from ..family import family
from ..forces import free, numbered, renumbering, template
from ..loaded import Chain, rrp, rrr
from .written import friction, masses, several


def _disc(c: Chain) -> tuple[str, complex, float]:
    """A disc about a moving letter of a bar that has none yet."""
    bars = [name for name, text in c.text.items() if "disc" not in text and len(c.links[name]) > 1]
    name = str(c.rng.choice(bars))
    o = str(c.rng.choice([p for p in c.links[name] if p not in c.frame]))
    radius = float(c.rng.uniform(15, 50))
    c.text[name] += f", disc: {o}, radius: {radius:.4f} mm"
    return name, c.at[o], radius


def round_lever(c: Chain) -> str:
    """A lever with a round tip."""
    driver, o, radius = _disc(c)
    tip = float(c.rng.uniform(5, 20))
    e = c.letter(o + (radius + tip) * cmath.exp(1j * c.rng.uniform(-np.pi, np.pi)))
    away = (c.at[e] - o) * cmath.exp(1j * c.rng.choice([-1, 1]) * c.rng.uniform(0.9, 2.2))
    pivot = c.fixed(c.at[e] + away / abs(away) * c.rng.uniform(80, 200))
    centre = next(p for p in c.links[driver] if c.at[p] == o)
    c.branches.append(f"{e} {c.side(c.at[e], centre, pivot)} of {centre}{pivot}")
    lever = c.bar(pivot, e)
    c.text[lever] += f", disc: {e}, radius: {tip:.4f} mm"
    c.joints.append(f"@{driver} touches @{lever} at {_contact(c)}")
    return lever


def flat_lever(c: Chain) -> str:
    """A lever with a flat face through its pivot, or beside it."""
    driver, o, radius = _disc(c)
    pivot = c.fixed(o + c.polar(90, 220))
    beside, side = int(c.rng.integers(-15, 15)), str(c.rng.choice(["left", "right"]))
    g, ray = int(c.rng.integers(60, 200)), o - c.at[pivot]
    aside = beside + (radius if side == "left" else -radius)
    way = ray / abs(ray) * cmath.exp(-1j * cmath.asin(aside / abs(ray)))
    point = c.letter(c.at[pivot] + way * g)
    face = c.add(
        [pivot, point], f"face: {{through: {pivot}, left: {beside} mm}}, {point}: {{along: {pivot}, at: {g} mm}}"
    )
    c.joints.append(f"@{driver} touches @{face} at {_contact(c)} {side} of the face")
    return face


def round_slider(c: Chain) -> str:
    """A tappet with a round tip."""
    driver, o, radius = _disc(c)
    tip, way = float(c.rng.uniform(5, 20)), cmath.exp(1j * c.rng.uniform(-np.pi, np.pi))
    e = c.letter(o + (radius + tip) * way)
    k, tilt = _guide(c, c.at[e], way)
    steep = (way / tilt).real * (radius + tip)
    other, centre = c.at[e] - 2 * steep * tilt, next(p for p in c.links[driver] if c.at[p] == o)
    if abs((c.at[e] - other).real) > abs((c.at[e] - other).imag):
        c.branches.append(
            f"{e} {'right' if c.at[e].real > other.real else 'left'} of {centre}"
            if (c.at[e].real - o.real) * (other.real - o.real) < 0
            else ""
        )
    else:
        c.branches.append(
            f"{e} {'above' if c.at[e].imag > other.imag else 'below'} {centre}"
            if (c.at[e].imag - o.imag) * (other.imag - o.imag) < 0
            else ""
        )
    c.branches = [one for one in c.branches if one]
    block = c.add([e], f"block: {e}, disc: {e}, radius: {tip:.4f} mm")
    c.joints += [
        f"@{block} slides on line through {k} at {np.degrees(cmath.phase(tilt)):.9f} deg",
        f"@{driver} touches @{block} at {_contact(c)}",
    ]
    c.slides.append((block, "frame"))
    return block


def flat_slider(c: Chain) -> str:
    """A tappet with a flat face."""
    driver, o, radius = _disc(c)
    way, side = cmath.exp(1j * c.rng.uniform(-np.pi, np.pi)), str(c.rng.choice(["left", "right"]))
    foot = o + (-1j if side == "left" else 1j) * way * radius
    f = c.letter(foot + way * c.rng.uniform(-30, 30))
    k, tilt = _guide(c, c.at[f], 1j * way)
    block = c.add(
        [f], f"block: {f}, face: {{through: {f}, angle: {np.degrees(cmath.phase(way / tilt)):.9f} deg from line}}"
    )
    c.joints += [
        f"@{block} slides on line through {k} at {np.degrees(cmath.phase(tilt)):.9f} deg",
        f"@{driver} touches @{block} at {_contact(c)} {side} of the face",
    ]
    c.slides.append((block, "frame"))
    return block


def _guide(c: Chain, at: complex, way: complex) -> tuple[str, complex]:
    """A fixed guide through this place, not far from this direction."""
    tilt = way * cmath.exp(1j * c.rng.uniform(-0.6, 0.6)) * c.rng.choice([-1, 1])
    letter = c.fixed(at - tilt * c.rng.uniform(60, 120))
    tilt = (at - c.at[letter]) / abs(at - c.at[letter])  # its letter's place is rounded
    return letter, tilt * (1 if c.rng.random() < 0.5 else -1)


def _contact(c: Chain) -> str:
    letter = c.letter(0j)
    c.contacts.append(letter)
    return letter


@family("forces-cams", also=in_equilibrium)
def cams(rng: np.random.Generator) -> str:
    """A cam and its follower, sometimes a dyad before or behind; friction in half of them."""
    c = Chain(rng)
    c.fixed(0j)
    c.at["B"] = c.polar(12, 60)
    c.bar("A", "B")
    kinds = [(round_lever, flat_lever, round_slider, flat_slider)[int(rng.integers(4))]]
    if rng.random() < 0.3:
        (rrr, rrp)[int(rng.integers(2))](c)
    follower = kinds[0](c)
    if rng.random() < 0.3:
        (rrr, rrp)[int(rng.integers(2))](c)
    further = masses(c) if rng.random() < 0.2 else ""
    if rng.random() < 0.5:
        rubbing = friction(c)
        touching = "".join(f"  {letter}: {{{rng.choice(['f: 0.12', 'phi: 8 deg'])}}}\n" for letter in c.contacts)
        further += (rubbing or "friction:\n") + touching
    loads = several(c, without="L0") if rng.random() < 0.5 else _pressing(c, follower)
    return numbered(c, template(c, loads + free(c, "L0"), further), renumbering(rng, c))


def _pressing(c: Chain, follower: str) -> str:
    return (
        f"  F_q: {{on: @{follower}, at: {c.links[follower][-1]}, size: {c.rng.integers(50, 500)} N, direction: "
        f"{c.rng.integers(-179, 180)} deg}}\n"
    )
