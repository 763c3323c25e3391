"""Every reaction in mechanisms with a group of class III, balanced on any link, with friction and without."""

from __future__ import annotations

import re

import numpy as np

from vecpoly import loads
from vecpoly.mechanism.groups.assur import hinges
from vecpoly.mechanism.model import Prismatic

from .class_iii import LEGS, Layout, class_iii, crank, made
from .family import family
from .powers import every_reaction, loaded


def balanced(rng: np.random.Generator, text: str) -> str:
    """Loads anywhere, the balancing one on any link."""
    mech = loads(text).mechanism
    link = str(rng.choice(mech.numbered)) if rng.random() < 0.5 else mech.drive.link
    point = str(rng.choice(list(mech.link(link).points)))
    way = f", at: {point}, direction: {rng.integers(-179, 180)} deg"
    force = (link == mech.drive.link and mech.drive.slide) or rng.random() < 0.3
    return loaded(rng, text, f'  X_b: {{on: {link}{way if force else ""}, size: "?"}}\n', find="")


@family("forces-class-iii", also=every_reaction, often=1)
def of_class_iii(rng: np.random.Generator) -> str:
    """A central link on three legs."""
    return balanced(rng, class_iii(rng))


@family("forces-class-iii-friction", also=every_reaction, often=1, first=2)
def with_friction(rng: np.random.Generator) -> str:
    """The same with friction circles of some pins."""
    bare = class_iii(rng)
    pins = [p for p in hinges(loads(bare).mechanism) if rng.random() < 0.7]
    rubbing = "".join(f"  {p}: {{rho: {rng.uniform(0.2, 2):.2f} mm}}\n" for p in pins)
    return re.sub(r"\n+$", "\n", balanced(rng, bare)) + (f"friction:\n{rubbing}" if rubbing else "")


def on_crank(rng: np.random.Generator) -> str:
    """Two legs on the crank more often than not: then no other link makes class II of it."""
    lay = Layout(rng)
    return made(lay, crank(lay), "", ["frame", "1", "1"], [str(kind) for kind in rng.choice(LEGS, 3)])


@family("forces-special-points", also=every_reaction, often=1)
def by_special_points(rng: np.random.Generator) -> str:
    """A central link with legs of any kind on the crank, loads on each of them."""
    return balanced(rng, on_crank(rng))


def rubbed(rng: np.random.Generator, bare: str) -> str:
    """Friction in some pins and slides, the balancing moment on the crank."""
    mech = loads(bare).mechanism
    sliding = {pin.point for pin in mech.slot_pins.values()}  # these turn in no bearing
    pins = [p for p in hinges(mech) if p not in sliding and rng.random() < 0.7]
    rubbing = "".join(f"  {p}: {{rho: {rng.uniform(0.1, 0.8):.2f} mm}}\n" for p in pins)
    slides = [j for j in mech.joints if isinstance(j, Prismatic) and j.block not in mech.slot_pins]
    rubbing += "".join(
        f"  {mech.number(j.block)}-{mech.number(j.guide)}: {{phi: {rng.integers(2, 10)} deg}}\n"
        for j in slides
        if rng.random() < 0.7
    )
    free = '  X_b: {on: 1, size: "?"}\n'
    return re.sub(r"\n+$", "\n", loaded(rng, bare, free, find="")) + (f"friction:\n{rubbing}" if rubbing else "")


@family("forces-special-points-friction", also=every_reaction, often=1)
def by_special_points_with_friction(rng: np.random.Generator) -> str:
    """The same with friction in pins and slides."""
    return rubbed(rng, on_crank(rng))


def with_two_slides(rng: np.random.Generator) -> str:
    """A leg with two slides, two others of any kind: no link on the frame makes class II of it."""
    lay = Layout(rng)
    kinds = ["parallel", *(str(kind) for kind in rng.choice(LEGS, 2))]
    rng.shuffle(kinds)
    return made(lay, crank(lay), "", ["frame", "1", "1"], kinds)


@family("forces-two-slides", also=every_reaction, often=1, first=1)
def on_two_slides(rng: np.random.Generator) -> str:
    """A central link one leg of which has two slides, loads on any link, balanced on any."""
    return balanced(rng, with_two_slides(rng))


@family("forces-two-slides-friction", also=every_reaction, often=1)
def on_two_slides_with_friction(rng: np.random.Generator) -> str:
    """The same with friction in pins and slides."""
    return rubbed(rng, with_two_slides(rng))
