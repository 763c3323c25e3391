"""Data of syntheses that no other family gives: AC of a shaper, lines on a link, the position that is kept, either side
of a cognate."""

from __future__ import annotations

from math import acos, cos, pi, radians, sin

import numpy as np
from numpy.typing import NDArray

from vecpoly.designs.inversion.angle_pairs import AnglePairs
from vecpoly.designs.quick_return import Shaper, Whitworth
from vecpoly.solution import Solution

from ..designed.bodies import KEPT, keeps_its_lengths
from ..designed.written import off, task, valid
from ..family import family
from ..library import data_of

Random = np.random.Generator
NEAR = 1e-4  # of AD: the curve is known by places
Places = NDArray[np.complex128]


def by_tangents(solution: Solution) -> str:
    """AB of a shaper, or of Whitworth's mechanism, from the angle of its quick stroke; CD from H."""
    design, found = solution.problem.subject, {key: one.drawn for key, one in solution.answers.items()}
    assert isinstance(design, Shaper | Whitworth) and design.AC is not None
    between, frame = 1e3 * design.AC.si, pi * (design.K.si - 1) / (design.K.si + 1)
    if isinstance(design, Shaper):
        wrong = off("AB", found["AB"], between * sin(frame / 2))
        return wrong or off("CD", found["CD"], 1e3 * design.H.si / (2 * sin(frame / 2)))
    return off("K", (2 * pi - 2 * acos(between / found["AB"])) / (2 * acos(between / found["AB"])), design.K.si) or off(
        "CD", found["CD"], 500 * design.H.si
    )


@family("keys-guide-bars", also=by_tangents, often=2)
def guide_bars(rng: Random) -> str:
    """From K, stroke and the distance of the pivots."""
    kind = str(rng.choice(["shaper", "whitworth"]))
    data = {
        "K": f"{rng.uniform(1.05, 2.4):.2f}",
        "H": f"{rng.integers(80, 500)} mm",
        "AC": f"{rng.integers(50, 300)} mm",
    }
    return task(kind, data, "theta, AB, CD")


def on_its_line(solution: Solution) -> str:
    """The pin lies on the line of its link that was asked, and the bar keeps its length."""
    design = solution.problem.subject
    assert isinstance(design, AnglePairs)
    letter, line = ("B", design.B) if design.slides else ("C", design.C)
    for one in valid(solution) if line is not None else ():
        pivot = one.pins["A" if design.slides else "D"]
        for n, pair in enumerate(design.pairs, 1):
            turned = pair.one if design.slides else pair.two
            own = (one.pins[f"{letter}{n}"] - pivot) * np.exp(-1j * turned)
            text = str(data_of(solution.problem.text)["data"][letter])
            axis, at = text.split()[1], float(text.split()[3])
            size = abs(one.pins["B1"] - one.pins["C1"])
            drawn = (own.imag if axis == "y" else own.real) / size
            true = at / one.values["BC"]
            if abs(drawn - true) > KEPT * max(1.0, abs(true)):
                return f"{letter} lies at {drawn} of BC in the coordinates of its link, not at {true}"
    return keeps_its_lengths(solution)


@family("keys-lines-of-links", also=on_its_line, often=2)
def lines_of_links(rng: Random) -> str:
    """Two pairs; the pin on a line of the rocker, or of the crank of a slider."""
    line = f"on {rng.choice(['x', 'y'])} = {rng.integers(5, 60)} mm"
    phi, far = int(rng.integers(0, 300)), int(rng.integers(10, 60))
    if rng.random() < 0.5:
        psi = int(rng.integers(0, 300))
        pairs = f"[{phi} deg -> {psi} deg, {phi + far} deg -> {psi + int(rng.integers(10, 60))} deg]"
        data = {"AB": f"{rng.integers(15, 60)} mm", "AD": f"{rng.integers(60, 130)} mm", "pairs": pairs, "C": line}
        return task("angle-pairs", data | {"onto": f"{rng.integers(1, 3)}"}, "BC, CD, delta_C")
    s = int(rng.integers(60, 140))
    pairs = f"[{phi} deg -> {s} mm, {phi + far} deg -> {s - int(rng.integers(5, 40))} mm]"
    data = {"guide": f"on y = {rng.integers(-30, 30)} mm", "pairs": pairs, "B": line}
    return task("angle-pairs", data | {"onto": f"{rng.integers(1, 3)}"}, "AB, BC, delta_B")


@family("keys-onto", also=keeps_its_lengths, often=2)
def onto(rng: Random) -> str:
    """Two or three positions of a body, one of them kept."""
    count = int(rng.integers(2, 4))
    x, y, phi, poses = 0, 0, 0, []
    for _ in range(count):
        poses.append(f'"({x}, {y}) mm at {phi} deg"')
        x, y, phi = x + int(rng.integers(10, 60)), y + int(rng.integers(-20, 30)), phi + int(rng.integers(8, 45))
    where, p, q = ("body", "B", "C") if rng.random() < 0.5 else ("frame", "A", "D")
    spots = [f"[{rng.integers(-60, 60)} mm, {rng.integers(-60, 60)} mm]" for _ in range(2)]
    data = {"poses": f"[{', '.join(poses)}]", where: f"{{{p}: {spots[0]}, {q}: {spots[1]}}}"}
    for letter in {"B": "AD", "A": "BC"}[p] if count == 2 else "":
        data[letter] = f"on {rng.choice(['x', 'y'])} = {rng.integers(-80, 80)} mm"
    return task("positions", data | {"onto": f"{rng.integers(1, count + 1)}"}, "AB, BC, CD, AD")


def one_path(solution: Solution) -> str:
    """C lies on the side that is asked; both cognates lead E along the curve of the four-bar, by circles alone; lengths
    follow from the triangle of the coupler."""
    for one in solution.construction.candidates:
        pins = dict(one.pins)
        here = _curve(pins, ("A", "B", "C", "D"))
        for letters in (("A", "G", "H", "F"), ("D", "M", "N", "F")):
            aside = max(float(np.abs(here - point).min()) for point in _curve(pins, letters)[::97])
            if aside > NEAR * abs(pins["D"]):
                return f"{''.join(letters)} leads E {aside} mm beside the curve"
        left = ((pins["D"] - pins["B"]).conjugate() * (pins["C"] - pins["B"])).imag > 0
        if left != (data_of(solution.problem.text)["data"]["side"] == "left"):
            return "C lies on the other side of BD"
    return _ratios(solution)


def _curve(pins: dict[str, complex], letters: tuple[str, ...]) -> Places:
    """E near its place, while the first link turns a little to either side."""
    a, b, c, d = (pins[letter] for letter in letters)
    e = (pins["E"] - b) / (c - b)
    wide = 0.1 if letters[1] == "B" else 0.002
    at = a + (b - a) * np.exp(1j * np.linspace(-wide, wide, 20001))
    r, s, span = abs(c - b), abs(c - d), np.abs(d - at)
    along = (r * r - s * s + span * span) / (2 * span)
    side = np.sign(((d - b).conjugate() * (c - b)).imag)
    pin = at + (d - at) / span * (along + 1j * side * np.sqrt(np.maximum(r * r - along**2, 0.0)))
    return np.asarray(at + e * (pin - at))


def _ratios(solution: Solution) -> str:
    """The sides of the cognates from complex ratios of the coupler triangle: AG = BE, GE = AB, and so on."""
    data = data_of(solution.problem.text)["data"]
    found = {key: one.exact for key, one in solution.answers.items()}
    ab, bc, cd, ad = (float(str(data[key]).split()[0]) for key in ("AB", "BC", "CD", "AD"))
    x, y = (float(part) for part in str(data["E"]).strip("()m ").replace(")", "").split(","))
    be, ce = abs(complex(x, y)), abs(complex(x - bc, y))
    wanted = {
        "AG": be,
        "GH": ab * be / bc,
        "HF": cd * be / bc,
        "AF": ad * be / bc,
        "DM": ce,
        "MN": cd * ce / bc,
        "NF": ab * ce / bc,
        "DF": ad * ce / bc,
    }
    return next((text for key in wanted if (text := off(key, found[key], wanted[key]))), "")


@family("keys-cognates", also=one_path, often=2)
def cognates(rng: Random) -> str:
    """C on either side of BD."""
    phi = int(rng.integers(0, 360))
    ab, bc, cd = (int(rng.integers(25, 100)) for _ in range(3))
    ad = int(rng.integers(30, 120))
    while not abs(bc - cd) + 3 < abs(ad - ab * complex(cos(radians(phi)), sin(radians(phi)))) < bc + cd - 3:
        bc, cd = (int(rng.integers(25, 140)) for _ in range(2))
    data = {"AB": f"{ab} mm", "BC": f"{bc} mm", "CD": f"{cd} mm", "AD": f"{ad} mm"}
    data |= {"E": f'"({rng.integers(-20, 70)}, {rng.integers(5, 60)}) mm"', "phi": f"{phi} deg"}
    return task("cognates", data | {"side": str(rng.choice(["left", "right"]))}, "AG, GH, HF, AF, DM, MN, NF, DF")
