"""Random force problems in which pins run in slots without a block:
of the crank, of bars, of the frame; in slots that turn, slide or stand still."""

from __future__ import annotations

import cmath

import numpy as np

from .equilibrium import in_equilibrium
from .family import family
from .forces import free, friction, masses, some, written
from .loaded import Chain, chain, rpr, rrp, rrr


def turning(c: Chain) -> None:
    """A pin of the mechanism in the slot of a link on another pin; the slot passes through that pin, or beside it."""
    p = c.anchor()
    q = c.other(p)
    slot = _slotted(c, q, p)
    c.joints.append(f"{p} runs in @{slot}")
    _rubbing(c, p, slot)


def standing(c: Chain) -> None:
    """A slotted link on a pin of the mechanism, in whose slot a pin of the frame runs."""
    p = c.anchor()
    k = c.fixed(c.at[p] + c.polar(60, 200))
    slot = _slotted(c, p, k)
    c.joints.append(f"{k} runs in @{slot}")
    _rubbing(c, k, slot)


def sliding(c: Chain) -> None:
    """A pin of the mechanism in the slot of a bar that slides on a fixed guide."""
    p = c.anchor()
    angle, turn = int(c.rng.integers(-80, 80)), int(c.rng.integers(40, 140))
    u = cmath.rect(1.0, np.radians(angle))
    k = c.fixed(c.at[p] + c.polar(30, 150))
    way = u * cmath.rect(1.0, np.radians(turn))
    x = c.letter(c.at[k] + u * ((c.at[p] - c.at[k]) / way).imag / (u / way).imag)
    bar = c.add([x], f"slot: {x}")
    c.joints += [f"{p} runs in @{bar}", f"@{bar} slides on line through {k} at {angle} deg turned {turn} deg"]
    c.slides.append((bar, "frame"))
    _rubbing(c, p, bar)


def fixed(c: Chain) -> None:
    """A bar whose end runs in a fixed slot."""
    p = c.anchor()
    angle = int(c.rng.integers(-80, 80))
    u = cmath.rect(1.0, np.radians(angle))
    k = c.fixed(c.at[p] + 1j * u * c.rng.choice([-1, 1]) * c.rng.uniform(10, 150) + u * c.rng.uniform(-20, 20))
    place = c.at[k] + u * c.rng.choice([-1, 1]) * c.rng.uniform(60, 200)
    branch = f" {c.side(place, p, k)} of {p}{k}"
    x = c.letter(place)
    c.bar(p, x)
    c.joints.append(f"{x} runs in line through {k} at {angle} deg")
    c.branches.append(x + branch)
    _rubbing(c, x, "frame")


def moving(c: Chain) -> None:
    """A bar on a pin of the frame whose end runs along the line of a bar of the mechanism."""
    bars = [
        name
        for name, letters in c.links.items()
        if len(letters) > 1 and c.text[name].startswith(f"{letters[0]}{letters[1]}")
    ]
    bar = str(c.rng.choice(bars))
    a, b = c.links[bar][:2]
    u = (c.at[b] - c.at[a]) / abs(c.at[b] - c.at[a])
    place = c.at[a] + u * c.rng.choice([-1, 1]) * c.rng.uniform(40, 200)
    q = c.fixed(
        c.at[a] + 1j * u * c.rng.choice([-1, 1]) * c.rng.uniform(50, 200) + u * c.rng.uniform(-10, 10)
    )  # square to the bar near its end, which tells the two places apart
    branch = f" {c.side(place, q, a)} of {q}{a}"
    x = c.letter(place)
    c.bar(q, x)
    c.joints.append(f"{x} runs in {a}{b} of @{bar}")
    c.branches.append(x + branch)
    _rubbing(c, x, bar)


def _slotted(c: Chain, at: str, through: str) -> str:
    """A slotted link on the pin `at`, its slot through a place, and a further point of it."""
    ray = c.at[through] - c.at[at]
    beside = float(c.rng.choice([0, 0, 1])) * c.rng.uniform(-0.5, 0.5) * min(abs(ray), 60.0)
    u = ray / abs(ray) * cmath.exp(-1j * np.arcsin(beside / abs(ray)))
    along, left = int(c.rng.integers(30, 260)), int(c.rng.integers(-40, 40))
    e = c.letter(c.at[at] + u * (along + 1j * left))
    slot = f"{{through: {at}, {'left' if beside > 0 else 'right'}: {abs(beside):.4f} mm}}" if beside else at
    return c.add([at, e], f"slot: {slot}, {e}: {{along: {at}, at: {along} mm, left: {left} mm}}")


def _rubbing(c: Chain, pin: str, slot: str) -> None:
    """The pin's slide, for friction: by the one link that carries the pin; what is hung on the pin later makes it
    another's, and spoils no more than this."""
    carriers = ["frame"] if pin in c.frame else [name for name, letters in c.links.items() if pin in letters]
    if len(carriers) == 1:
        c.slides.append((carriers[0], slot))


KINDS = (turning, turning, standing, sliding, fixed, moving, rrr, rrp, rpr)


def slotted(rng: np.random.Generator) -> Chain:
    """One to three groups, at least one of them with a pin in a slot."""
    while True:
        c = chain(rng, int(rng.integers(1, 4)), KINDS)
        if any(" runs in " in joint for joint in c.joints):
            return c


@family("forces-slots", also=in_equilibrium, often=1)
def slots(rng: np.random.Generator) -> str:
    """Loads on any links, masses, balanced on the crank."""
    c = slotted(rng)
    return written(c, some(c, 3) + free(c, "L0"), masses(c) if rng.random() < 0.3 else "")


@family("forces-slots-friction", also=in_equilibrium, often=1)
def rubbing(rng: np.random.Generator) -> str:
    """The same against friction."""
    c = slotted(rng)
    return written(c, some(c, 2) + free(c, "L0"), friction(c))
