"""Beside the wheels of an epicyclic train: numbers of teeth outside the rims, arrows of ω in their sense."""

from __future__ import annotations

from cmath import exp, pi

from ....board.construction import View
from ....devices.gears.epicyclic import Epicyclic
from ....diagram.wheels import body_of_ring
from ....words import Words
from ..bench import Bench
from ..turning import arrow_about

INSIDE, LEAST, BESIDE, CLEAR = 0.62, 9.0, 3.0, 6.0  # of a radius; mm: not smaller within it; outside it; of the carrier
LOW_RIGHT, LOW_LEFT = exp(-0.25j * pi), exp(-0.75j * pi)


def teeth(bench: Bench, train: Epicyclic) -> None:
    """z of every wheel outside its rim; of a ring outside its body."""
    mm = bench.board.scale_of(View.MECHANISM).value
    reach = (train.radii["H"] + train.radii["2"]) / mm
    for key, centre, radius, side in _wheels(bench, train):
        count = {"1": train.sun, "2": train.planet[0], "2′": train.planet[-1], "3": train.other}[key]
        rim = body_of_ring(radius, reach) if key == "3" and train.ring else radius
        words = Words.same(f"$z_{{{key}}}$ = {count}")
        bench.board.note(View.MECHANISM, centre + side * (rim + 2.0), words)


def turning(bench: Bench, train: Epicyclic, key: str, omega: float) -> None:
    """The arrow of ω on a wheel or on the carrier; none for what stands still."""
    if omega == 0.0:
        return
    mm = bench.board.scale_of(View.MECHANISM).value
    radii = {name: radius / mm for name, radius in train.radii.items()}
    centre = 1j * radii["H"] if key == "2" else 0j
    if key == "H":
        radius, middle = min(radii["1"] + CLEAR, radii["H"]), 1 + 0j
    elif key == "3":
        radius, middle = (radii["3"] - CLEAR, LOW_LEFT) if train.ring else (radii["3"] + BESIDE, LOW_LEFT)
    else:
        within = INSIDE * radii[key]
        radius, middle = within if within >= LEAST else radii[key] + BESIDE, -1 + 0j
    arrow_about(bench.board, View.MECHANISM, centre, radius, middle, omega > 0, f"ω_{key}")


def _wheels(bench: Bench, train: Epicyclic) -> list[tuple[str, complex, float, complex]]:
    """Every wheel: its number, its centre, its radius (mm), the side on which its teeth are noted."""
    mm = bench.board.scale_of(View.MECHANISM).value
    radii = {name: radius / mm for name, radius in train.radii.items()}
    arm = 1j * radii["H"]
    stepped = [("2′", arm, radii["2′"], LOW_LEFT)] if len(train.planet) > 1 else []
    return [
        ("1", 0j, radii["1"], LOW_RIGHT),
        ("2", arm, radii["2"], LOW_RIGHT),
        *stepped,
        ("3", 0j, radii["3"], LOW_RIGHT),
    ]
