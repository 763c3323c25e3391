"""Wedges, inclined planes, clamps, guides, screws with random data; a third party solves ΣF = 0 with leaning forces."""

from __future__ import annotations

from math import atan, degrees, pi, tan

import numpy as np

from vecpoly.devices.incline import Incline
from vecpoly.devices.ring_spring import RingSpring
from vecpoly.devices.screw_jack import ScrewJack
from vecpoly.devices.wedges import Wedges
from vecpoly.solution import Solution
from vecpoly.units.reading import Quantity

from ..family import family

CLOSE = 1e-9
Random = np.random.Generator


def file(kind: str, data: str) -> str:
    """A device of which all is asked."""
    return f"id: x\ntitle: x\ndevice: {kind}\ndata: {{{data}}}\n"


def unit(angle: float) -> complex:
    return complex(np.exp(1j * angle))


def in_two(known: complex, one: complex, other: complex) -> tuple[float, float]:
    """a, b of known + a one + b other = 0."""
    a, b = np.linalg.solve([[one.real, other.real], [one.imag, other.imag]], [-known.real, -known.imag])
    return float(a), float(b)


def _said(solution: Solution, true: dict[str, float]) -> str:
    """The first of these that the oracle has otherwise."""
    for key, value in true.items():
        found = solution.answers[key].exact if key in solution.answers else value
        if abs(found - value) > CLOSE * max(1.0, abs(value)):
            return f"{key} = {found}, but {value} by a third party"
    return ""


def wedges_balance(solution: Solution) -> str:
    """The force on wedge 1: ΣF of wedge 2, then of wedge 1, every reaction leaning against the sliding."""
    device = solution.problem.device
    assert isinstance(device, Wedges)
    alpha, beta = device.alpha.si, device.beta.si
    phi = {face: atan(device.friction(face).si) for face in ("12", "13", "23")}

    def pushed(share: float) -> float:
        on_two = unit(beta - share * phi["12"])  # normal to the face: at β to the x axis
        press, _ = in_two(-1j * device.Q.si, on_two, unit(pi + share * phi["23"]))
        along = unit(pi / 2 - alpha)
        for side in (-1, 1):  # of its guide on which wedge 1 presses
            force, guide = in_two(-press * on_two, along, side * 1j * along * unit(side * share * phi["13"]))
            if guide >= 0:
                return force
        return float("nan")

    return _said(solution, {"F": pushed(1.0), "F_0": pushed(0.0), "eta": pushed(0.0) / pushed(1.0)})


@family("device-wedges", also=wedges_balance)
def wedges(rng: Random) -> str:
    """One coefficient of friction, or one for each face."""
    alpha, beta = rng.integers(5, 120), rng.integers(10, 85)
    same = rng.random() < 0.5
    rubs = f"f: {rng.uniform(0, 0.3):.3f}"
    if not same:
        rubs = ", ".join(f"f{face}: {rng.uniform(0.01, 0.3):.3f}" for face in ("12", "13", "23"))
    return file("wedges", f"alpha: {alpha} deg, beta: {beta} deg, Q: {rng.integers(50, 9000)} N, {rubs}")


def block_balances(solution: Solution) -> str:
    """F up the plane, F′ that holds, from Q, F and R at φ on either side of the normal."""
    device = solution.problem.device
    assert isinstance(device, Incline)
    slope, phi, weight = device.slope, atan(device.f.si), device.Q.si * -1j
    normal = slope + pi / 2
    up, _ = in_two(weight, unit(device.beta.si), unit(normal + phi))
    free, _ = in_two(weight, unit(device.beta.si), unit(normal))
    down, _ = in_two(weight, unit(device.beta.si), unit(normal - phi))
    true = {"F": up, "F_0": free, "phi": degrees(phi), "eta": free / up}
    return _said(solution, true | ({"F_r": down} if phi < slope else {}))


@family("device-incline", also=block_balances)
def incline(rng: Random) -> str:
    """Any slope, the force from below the plane's direction to above it."""
    return file(
        "incline",
        f"f: {rng.uniform(0.01, 0.6):.3f}, beta: {rng.integers(-30, 80)} deg, Q: {rng.integers(50, 9000)} N"
        + (f", alpha: {rng.integers(3, 70)} deg" if rng.random() < 0.9 else ""),
    )


def buffer_balances(solution: Solution) -> str:
    """The side wedge between two leaning faces, then the pushed one: F = 2 Q tan-like closures solved as vectors."""
    device = solution.problem.device
    assert isinstance(device, RingSpring)
    alpha, phi = device.alpha.si, atan(device.f.si)
    true = {"phi": degrees(phi)}
    for key, lean in (("F", phi), ("F_0", 0.0), ("F_r", -phi)):
        if 0 < alpha - lean < pi / 2:
            size, _ = in_two(-1j * device.Q.si, unit(alpha - lean), unit(pi - (alpha - lean)))
            true[key] = 2 * size * float(np.cos(alpha - lean))
    return _said(solution, true)


@family("device-ring-spring", also=buffer_balances)
def ring_spring(rng: Random) -> str:
    """Flat and steep faces."""
    return file(
        "ring-spring",
        f"alpha: {rng.integers(8, 80)} deg, f: {rng.uniform(0.01, 0.5):.3f}, Q: {rng.integers(20, 5000)} N",
    )


def _friction(device: ScrewJack, own: Quantity | None) -> float:
    found = device.f if own is None else own
    assert found is not None
    return found.si


def screw_turns(solution: Solution) -> str:
    """M / Q from the developed thread, and the ring under the head as a sum over its radii."""
    device = solution.problem.device
    assert isinstance(device, ScrewJack)
    mean = (device.d.si + device.d1.si) / 2
    flank = device.beta.si if device.beta is not None else 0.0
    thread, ring = (_friction(device, one) for one in (device.f_thread, device.f_collar))
    lead = atan(device.starts * device.p.si / (pi * mean))
    radii = np.linspace(device.d0.si / 2, device.D.si / 2, 20_001)
    collar = ring * float(np.trapezoid(radii**2, radii) / np.trapezoid(radii, radii))
    first = mean / 2 * tan(lead + atan(thread / np.cos(flank)))
    found = solution.answers["M_over_Q"].exact
    true = 1e3 * (first + collar)
    return "" if abs(found - true) <= 1e-6 * true else f"M/Q = {found}, but {true} mm by sums"


@family("device-screw-jack", also=screw_turns)
def screw_jack(rng: Random) -> str:
    """Threads of one or more starts, square or with flanks, one coefficient of friction or two."""
    d1 = int(rng.integers(12, 60))
    d, d0 = d1 + int(rng.integers(2, 12)), int(rng.integers(2, 12))
    rubs = (
        f"f: {rng.uniform(0.03, 0.25):.3f}"
        if rng.random() < 0.5
        else f"f_thread: {rng.uniform(0.03, 0.25):.3f}, f_collar: {rng.uniform(0.03, 0.25):.3f}"
    )
    more = f", starts: {rng.integers(1, 4)}" if rng.random() < 0.4 else ""
    more += f", beta: {rng.choice([3, 15, 30])} deg" if rng.random() < 0.4 else ""
    driven = f"F: {rng.integers(20, 400)} N" if rng.random() < 0.5 else f"Q: {rng.integers(500, 90_000)} N"
    return file(
        "screw-jack",
        f"d: {d} mm, d1: {d1} mm, p: {rng.integers(2, 9)} mm, D: {d0 + rng.integers(8, 50)} mm, d0: {d0} mm, "
        f"l: {rng.integers(100, 900)} mm, {rubs}, {driven}{more}",
    )


@family("device-guides-and-clamps")
def guides_and_clamps(rng: Random) -> str:
    """A V-guide, a wedge that clamps, an eccentric disc that clamps."""
    f = f"f: {rng.uniform(0.02, 0.4):.3f}"
    match int(rng.integers(3)):
        case 0:
            return file(
                "vee-guide",
                f"{f}, G: {rng.integers(100, 9000)} N, l1: {rng.integers(20, 300)} mm, l2: {rng.integers(20, 300)} mm, "
                f"theta: {rng.integers(15, 85)} deg",
            )
        case 1:
            return file("wedge-clamp", f"alpha: {rng.integers(2, 60)} deg, {f}, R: {rng.integers(100, 9000)} N")
    sense = str(rng.choice(["ccw", "cw"]))
    turn = 1 if sense == "ccw" else -1
    radius, handle = int(rng.integers(25, 90)), int(rng.integers(-180, 180))
    return file(
        "eccentric-clamp",
        f"e: {rng.uniform(1, 0.5 * radius):.2f} mm, theta: {180 * (turn > 0) + rng.integers(-80, 80)} deg, "
        f"R: {radius} mm, l: {rng.integers(100, 400)} mm, handle: {handle} deg, "
        f"F: {handle + turn * rng.integers(30, 150)} deg, closing: {sense}, {f}, "
        f"rho: {rng.uniform(0, 0.1 * radius):.2f} mm, Q: {rng.integers(50, 9000)} N",
    )
