"""Random force problems: mechanisms of class II groups in any numbering,
with loads, masses, weights, inertia and friction."""

from __future__ import annotations

import re

import numpy as np

from .equilibrium import in_equilibrium
from .family import family
from .loaded import Chain, Grow, chain, phi, rpp, rpr, rrp, rrr


def written(c: Chain, loads: str, further: str = "") -> str:
    """The problem's text, its links renumbered and reordered at random; @L0 in the texts stands for a link."""
    return numbered(c, template(c, loads, further), renumbering(c.rng, c))


def renumbering(rng: np.random.Generator, c: Chain) -> dict[str, str]:
    """Link's own name → its number in the file, in the order in which the links are to be written."""
    names = sorted(c.links, key=lambda name: rng.random())
    return dict(zip(names, map(str, 1 + rng.permutation(len(names))), strict=True)) | {"frame": str(len(names) + 1)}


def template(c: Chain, loads: str, further: str = "") -> str:
    """The problem's text with @L0 for every link's number and @links for their list."""
    frame = ", ".join(f"{p}: [{c.at[p].real:.2f} mm, {c.at[p].imag:.2f} mm]" for p in c.frame)
    return f"""
id: forces
title: forces
frame: {{{frame}}}
links:
@links
joints: [{", ".join(c.joints)}]
branch: [{", ".join(c.branches)}]
input:
  link: @L0
  phi: {phi(c):.4f} deg
  omega: {c.rng.choice([-12, 4, 9])} rad/s
  alpha: {c.rng.choice([0, 30])} rad/s^2
loads:
{loads}{further}"""


def numbered(c: Chain, text: str, numbers: dict[str, str]) -> str:
    """The template with these numbers."""
    links = "\n".join(f"  {numbers[name]}: {{{c.text[name]}}}" for name in numbers if name in c.links)
    return re.sub(r"@(L\d+|frame)", lambda m: numbers[m[1]], text.replace("@links", links))


def force(c: Chain, name: str, link: str, point: str, *, size: str = "") -> str:
    """A force of random direction at a point of a link."""
    way = int(c.rng.integers(-179, 180))
    value = size or f"{c.rng.integers(20, 900)} N"
    return f"  {name}: {{on: @{link}, at: {point}, size: {value}, direction: {way} deg}}\n"


def moment(c: Chain, name: str, link: str, *, size: str = "") -> str:
    """A couple on a link."""
    value = size or f"{c.rng.choice([-1, 1]) * c.rng.integers(1, 40)} N*m"
    return f"  {name}: {{on: @{link}, size: {value}}}\n"


def some(c: Chain, most: int, without: str = "") -> str:
    """One to `most` loads on any links."""
    names = [name for name in c.links if name != without]
    text = ""
    for i in range(int(c.rng.integers(1, most + 1))):
        link = str(c.rng.choice(names))
        text += (
            moment(c, f"M_q{i}", link)
            if c.rng.random() < 0.4
            else force(c, f"F_q{i}", link, str(c.rng.choice(c.links[link])))
        )
    return text


def masses(c: Chain) -> str:
    """Masses of some links, with weight or without."""
    text = ""
    for name, letters in c.links.items():
        if c.rng.random() < 0.6:
            bar = len(letters) > 1 and c.text[name].startswith(letters[0] + letters[1])
            centre = (
                f", inertia: {c.rng.uniform(0, 0.02):.4f} kg*m^2, centre: {{along: {letters[0]}{letters[1]}, "
                f"at: {c.rng.integers(0, 120)} mm}}"
                if bar
                else ""
            )
            centre = centre or (f", centre: {letters[-1]}" if len(letters) > 1 else "")
            text += f"  @{name}: {{mass: {c.rng.uniform(0.2, 4):.2f} kg{centre}}}\n"
    return f"masses:\n{text}weight: {c.rng.choice(['yes', 'no'])}\n" if text else ""


def friction(c: Chain) -> str:
    """Friction circles of some pins, friction angles of some slides."""
    pins = {
        p
        for letters in c.links.values()
        for p in letters
        if sum(p in other for other in [*c.links.values(), c.frame]) > 1
    }
    text = "".join(f"  {p}: {{rho: {c.rng.uniform(0.3, 3):.2f} mm}}\n" for p in sorted(pins) if c.rng.random() < 0.7)
    text += "".join(f"  @{a}-@{b}: {{phi: {c.rng.integers(2, 10)} deg}}\n" for a, b in c.slides if c.rng.random() < 0.7)
    return f"friction:\n{text}" if text else ""


def simple(rng: np.random.Generator, kinds: tuple[Grow, ...] | None = None) -> Chain:
    """One to three groups."""
    groups = int(rng.integers(1, 4))
    return chain(rng, groups, kinds) if kinds else chain(rng, groups)


def free(c: Chain, link: str) -> str:
    """The load that balances: a moment, or a force at a point of the link."""
    if c.rng.random() < 0.5:
        return moment(c, "X_b", link, size='"?"')
    return force(c, "X_b", link, str(c.rng.choice([p for p in c.links[link] if p != "A"])), size='"?"')


@family("forces", also=in_equilibrium, often=1)
def forces(rng: np.random.Generator) -> str:
    """Loads on any links, balanced by a moment or a force on the crank."""
    c = simple(rng)
    return written(c, some(c, 3) + free(c, "L0"))


@family("forces-elsewhere", also=in_equilibrium, often=1)
def elsewhere(rng: np.random.Generator) -> str:
    """Balanced by a moment or a force on any link, the crank among the loaded ones."""
    c = simple(rng)
    link = str(rng.choice(list(c.links)))
    return written(c, some(c, 2, without=link) + free(c, link))


@family("forces-masses", also=in_equilibrium, often=1)
def with_masses(rng: np.random.Generator) -> str:
    """Inertia forces, weights, perhaps loads."""
    c = simple(rng)
    return written(c, (some(c, 1) if rng.random() < 0.4 else "") + free(c, "L0"), masses(c))


@family("forces-couples", also=in_equilibrium, often=1)
def couples(rng: np.random.Generator) -> str:
    """Nothing but couples, in mechanisms with slides: slides that pass on a couple and no force."""
    c = simple(rng, (rpp, rpr, rrp, rrr))
    links = [str(rng.choice(list(c.links))) for _ in range(int(rng.integers(1, 3)))]
    return written(c, "".join(moment(c, f"M_q{i}", link) for i, link in enumerate(links)) + free(c, "L0"))


@family("forces-friction", also=in_equilibrium, often=1, first=4)
def with_friction(rng: np.random.Generator) -> str:
    """Loads against friction everywhere; bars with many multiple joints, or any groups;
    inertia, or none; balanced on the crank, or elsewhere."""
    c = simple(rng, (rrr, rrp) if rng.random() < 0.4 else None)
    link = "L0" if rng.random() < 0.7 else str(rng.choice(list(c.links)))
    further = masses(c) if rng.random() < 0.3 else ""
    return written(c, some(c, 2, without=link if link != "L0" else "") + free(c, link), further + friction(c))
