"""Machines that turn right round, with masses, and loads by every law of the manual."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

Random = np.random.Generator


@dataclass(frozen=True, slots=True, kw_only=True)
class Turning:
    """A mechanism as written, without its drive; slider: link and point on a guide, rocker: a link that swings."""

    text: str
    slider: tuple[str, str] | None
    rocker: str | None
    masses: tuple[str, ...]


def crank_rocker(rng: Random) -> Turning:
    """Grashof, the crank shortest."""
    crank = rng.uniform(40, 90)
    coupler, rocker = (crank * rng.uniform(2.2, 3.5) for _ in range(2))
    base = rng.uniform(max(abs(coupler - rocker) + crank * 1.1, crank * 1.6), coupler + rocker - 1.1 * crank)
    text = (
        f"frame: {{A: [0 mm, 0 mm], D: [{base:.3f} mm, 0 mm]}}\n"
        f"links: {{1: {{AB: {crank:.3f} mm}}, 2: {{BC: {coupler:.3f} mm}}, 3: {{CD: {rocker:.3f} mm}}}}\n"
        f"branch: [C {rng.choice(['left', 'right'])} of BD]\n"
    )
    middle = f"{{along: BC, at: {coupler * rng.uniform(0.2, 0.8):.3f} mm, left: {rng.integers(-30, 30)} mm}}"
    return Turning(text=text, slider=None, rocker="3", masses=("A", middle, "C"))


def slider_crank(rng: Random) -> Turning:
    """Central or offset, to the right, upwards or aslant."""
    crank = rng.uniform(30, 80)
    rod, offset = crank * rng.uniform(2.2, 4.5), crank * rng.choice([0.0, rng.uniform(-0.9, 0.9)])
    up = rng.random() < 0.4
    guide = f"3 slides on {'x' if up else 'y'} = {offset:.3f} mm"
    side = "above B" if up else "right of B"
    text = (
        f"frame: {{A: [0 mm, 0 mm]}}\n"
        f"links: {{1: {{AB: {crank:.3f} mm}}, 2: {{BC: {rod:.3f} mm}}, 3: {{block: C}}}}\n"
        f"joints: [{guide}]\nbranch: [C {side}]\n"
    )
    middle = f"{{along: BC, at: {rod * rng.uniform(0.2, 0.8):.3f} mm}}"
    return Turning(text=text, slider=("3", "C"), rocker=None, masses=("A", middle, "C"))


def shaper(rng: Random) -> Turning:
    """A crank in a swinging or turning slotted link, which moves a ram."""
    crank, base = rng.uniform(40, 90), rng.uniform(110, 220)
    lever, rod = rng.uniform(1.2, 1.6) * (base + crank), rng.uniform(120, 260)
    text = (
        f"frame: {{A: [0 mm, 0 mm], D: [0 mm, {-base:.3f} mm]}}\n"
        f"links: {{1: {{AB: {crank:.3f} mm}}, 2: {{block: B}}, 3: {{slot: D, C: {{along: D, at: {lever:.3f} mm}}}}, "
        f"4: {{CE: {rod:.3f} mm}}, 5: {{block: E}}}}\n"
        f"joints: [2 slides in 3, 5 slides on y = {lever - base:.3f} mm]\nbranch: [E left of C]\n"
    )
    return Turning(text=text, slider=("5", "E"), rocker="3", masses=("A", "B", "C", "C", "E"))


SORTS = (crank_rocker, slider_crank, shaper)


def driven(rng: Random, made: Turning) -> str:
    """The drive, either way round."""
    way = rng.choice(["ccw", "cw"])
    return (
        f"{made.text}input: {{link: 1, phi: {rng.integers(0, 360)} deg, omega: {rng.integers(30, 300)} r/min {way}}}\n"
    )


def weighed(rng: Random, made: Turning) -> str:
    """Masses of the links, of some none; weights in some."""
    rows = [
        f"  {n}: {{mass: {rng.uniform(0.5, 9):.3f} kg, inertia: {rng.uniform(0.005, 0.1):.4f} kg*m^2, centre: {at}}}\n"
        for n, at in enumerate(made.masses, 1)
        if rng.random() < 0.75 or n == len(made.masses)
    ]
    return "masses:\n" + "".join(rows) + ("weight: yes\n" if rng.random() < 0.4 else "")


def loaded(rng: Random, made: Turning) -> str:
    """One or two loads, each by a law of its own; no damper, for its work depends on the speed."""
    return "".join(_load(rng, made, f"q{i}") for i in range(int(rng.integers(1, 3))))


def _load(rng: Random, made: Turning, name: str) -> str:
    slides = made.slider is not None and (made.rocker is None or rng.random() < 0.6)
    if not slides:
        return _moment(rng, made.rocker or "1", f"M_{name}")
    assert made.slider is not None
    link, point = made.slider
    head = f"  F_{name}: {{on: {link}, at: {point}, "
    level = "x = " not in made.text
    way, ways = (0 if level else 90) + 180 * int(rng.integers(2)), ("left", "right") if level else ("up", "down")
    tail = f", direction: {way} deg}}\n"
    size = f"size: {rng.integers(50, 3000)} N"
    match int(rng.integers(5)):
        case 0:
            return f"{head}{size}, {_during(rng)}{tail}"
        case 1:
            return f"{head}{size}, while: {point} moves {rng.choice(ways)}{tail}"
        case 2:
            low, high = sorted(int(x) for x in rng.choice(101, 2, replace=False))
            return f"{head}{size}, while: {point} moves {rng.choice(ways)}, between: [{low} %, {high} %]{tail}"
        case 3:
            return f"{head}size: {{columns: [s (mm), F (N)], rows: {_card(rng)}}}{tail}"
    return f"  F_{name}: {{spring: {point}{link}-A, k: {rng.integers(1, 20)} N/mm, l_0: {rng.integers(50, 300)} mm}}\n"


def _during(rng: Random) -> str:
    return f"during: [{rng.integers(0, 360)} deg, {rng.integers(0, 360)} deg]"


def _card(rng: Random) -> str:
    """Sizes over a travel, one way for both strokes or a loop; the table is longer than any stroke."""
    out = [[x, int(rng.integers(0, 2000))] for x in (0, 20, 45, 90, 1000)]
    back = [[x, int(rng.integers(0, 900))] for x in (60, 25)] if rng.random() < 0.5 else []
    return str([*out, *back, *([out[0]] if back else [])])


def _moment(rng: Random, link: str, name: str) -> str:
    head, way = f"  {name}: {{on: {link}, ", rng.choice(["cw", "ccw"])
    match int(rng.integers(3)):
        case 0:
            return f"{head}size: {rng.integers(20, 900)} N*m {way}, {_during(rng)}}}\n"
        case 1 if link != "1":
            return f"{head}size: {rng.integers(20, 900)} N*m, while: {link} turns {way}}}\n"
    turns = 720 if rng.random() < 0.3 else 360
    sizes = [int(x) for x in rng.integers(-300, 300, size=6)]
    rows = [[turns * k // 6, m] for k, m in enumerate([*sizes, sizes[0]])]
    return f"{head}size: {{columns: [phi (deg), M (N*m)], rows: {rows}}}}}\n"
