"""Drives between two moving links: cylinders in all positions,
with groups behind them, and a motor in a hinge between two links."""

from __future__ import annotations

import numpy as np

from .family import family

_FRAME = {"A": 0j, "D": 300 + 0j}


def _number(value: float) -> str:
    return f"{value:.9g}"


def _rates(rng: np.random.Generator) -> str:
    return f"v: {rng.choice([0.1, -0.05, 0.3])} m/s, a: {rng.choice([0, 0.2, -0.5])} m/s^2"


def _pair(rng: np.random.Generator, near: str, far: str, d: str, c: str) -> tuple[str, str, str]:
    """The two links of a cylinder and their joint:
    cylinder and piston, a rod through a block, or the cylinder turned end for end."""
    forms = [
        (f"  {near}: {{cylinder: {d}}}\n  {far}: {{piston: {c}}}\n", f"{far} slides in {near}"),
        (f"  {near}: {{piston: {d}}}\n  {far}: {{cylinder: {c}}}\n", f"{near} slides in {far}"),
        (f"  {near}: {{rod: {d}}}\n  {far}: {{block: {c}}}\n", f"{near} passes through {far}"),
        (f"  {near}: {{slot: {d}}}\n  {far}: {{block: {c}}}\n", f"{far} slides in {near}"),
    ]
    links, joint = forms[int(rng.integers(len(forms)))]
    return links, joint, f"{near}-{far}"


def _left(a: complex, b: complex, c: complex) -> str:
    return "left" if ((b - a).conjugate() * (c - a)).imag > 0 else "right"


@family("cylinder-lever")
def lever(rng: np.random.Generator) -> str:
    """A cylinder on the frame lifts a lever; sometimes the lever moves a dyad or a slider on."""
    d = complex(*rng.integers(-300, 300, 2))
    reach, lean = rng.integers(60, 300), rng.uniform(0, 2 * np.pi)
    c = reach * np.exp(1j * lean)
    f = complex(*rng.integers(100, 500, 2))
    e_along, e_left = rng.integers(-100, 300), rng.integers(-100, 100)
    e = (e_along + 1j * e_left) * np.exp(1j * lean)
    links, joint, pair = _pair(rng, "2", "3", "D", "C")
    lengths = _number(abs(c - d))
    more, said, asked, joints = _behind(rng, e, f)
    return f"""
id: lever
title: lever
frame: {{A: [0 mm, 0 mm], D: [{d.real} mm, {d.imag} mm], F: [{f.real} mm, {f.imag} mm]}}
links:
  1: {{AC: {reach} mm, E: {{along: AC, at: {e_along} mm, left: {e_left} mm}}}}
{links}{more}joints: [{", ".join([joint, *joints])}]
input: {{cylinder: {pair}, length: {lengths} mm, {_rates(rng)}}}
branch: [{", ".join([f"C {_left(0j, d, c)} of AD", *said])}]
find: [v_C, v_E, a_C, a_E, omega_1, omega_2, alpha_1, alpha_2{asked}]
"""


def _behind(rng: np.random.Generator, e: complex, f: complex) -> tuple[str, list[str], str, list[str]]:
    """What the lever's point E moves: nothing, a dyad to F, or a slider on a line through F."""
    match int(rng.integers(3)):
        case 0:
            return "", [], "", []
        case 1:
            apart = abs(f - e)
            one = apart * rng.uniform(0.4, 1.2)
            two = rng.uniform(abs(apart - one) * 1.05, (apart + one) * 0.95)
            return (
                f"  4: {{EG: {_number(one)} mm}}\n  5: {{FG: {_number(two)} mm}}\n",
                ["G left of EF"],
                ", v_G, a_G, omega_4, alpha_5",
                [],
            )
        case _:
            angle = rng.uniform(0, 180)
            away = abs((np.exp(-1j * np.radians(angle)) * (e - f)).imag)
            way = np.exp(1j * np.radians(angle))
            return (
                f"  4: {{EG: {_number(away * rng.uniform(2.5, 5))} mm}}\n  5: {{block: G}}\n",
                [f"G {'right' if way.real > 0 else 'left'} of E" if abs(way.real) > 0.5 else "G above E"],
                ", v_G, a_G, omega_4",
                [f"5 slides on line through F at {_number(angle)} deg"],
            )


@family("cylinder-slider")
def slider(rng: np.random.Generator) -> str:
    """A cylinder on the frame pushes a block along a fixed guide."""
    d, angle, along = complex(*rng.integers(-300, 300, 2)), rng.uniform(-90, 90), rng.integers(-300, 300)
    way = np.exp(1j * np.radians(angle))
    c = 50 + 20j + way * along
    links, joint, pair = _pair(rng, "2", "3", "D", "C")
    return f"""
id: slider
title: slider
frame: {{A: [50 mm, 20 mm], D: [{d.real} mm, {d.imag} mm]}}
links:
  1: {{block: C, E: {{CE: 80 mm, angle: 40 deg from line}}}}
{links}joints: [1 slides on line through A at {_number(angle)} deg, {joint}]
input: {{cylinder: {pair}, length: {_number(abs(c - d))} mm, {_rates(rng)}}}
guesses: {{C: [{c.real:.1f} mm, {c.imag:.1f} mm]}}
find: [v_C, v_E, a_C, a_E, omega_2, alpha_2]
"""


@family("cylinder-offset")
def offset(rng: np.random.Generator) -> str:
    """The rod passes its block beside the pin, so the input is the travel."""
    d = complex(*rng.integers(-300, 300, 2))
    lean, reach, e = rng.uniform(0, 2 * np.pi), rng.integers(100, 300), rng.integers(-50, 50)
    c = reach * np.exp(1j * lean)
    if abs(c - d) < abs(e) + 5:
        return offset(rng)
    travel = np.sqrt(abs(c - d) ** 2 - float(e) ** 2)
    return f"""
id: offset
title: offset
frame: {{A: [0 mm, 0 mm], D: [{d.real} mm, {d.imag} mm]}}
links:
  1: {{AC: {reach} mm}}
  2: {{rod: D}}
  3: {{block: C}}
joints: [3 slides on 2 with C {abs(e)} mm {"left" if e > 0 else "right"}]
input: {{cylinder: 2-3, s: {_number(travel)} mm, {_rates(rng)}}}
branch: [C {_left(0j, d, c)} of AD]
find: [v_C, a_C, omega_1, omega_2, alpha_1, alpha_2]
"""


@family("cylinder-inside", often=1)
def inside(rng: np.random.Generator) -> str:
    """A cylinder between two moving links of a four-bar:
    crank and rocker, crank and coupler, coupler and rocker, frame and coupler."""
    phi, ab, bc = rng.uniform(0, 2 * np.pi), rng.integers(60, 250), rng.integers(100, 300)
    b, d = ab * np.exp(1j * phi), 300 + 0j
    bent = rng.uniform(0, 2 * np.pi)
    c = b + bc * np.exp(1j * bent)
    cd = abs(c - d)
    ends = {"1": (0j, b, "AB"), "2": (b, c, "BC"), "3": (d, c, "DC"), "frame": (0j, 0j, "")}
    one, two = [("1", "3"), ("1", "2"), ("2", "3"), ("frame", "2"), ("frame", "3")][int(rng.integers(5))]
    drawn, places = {}, {}
    for letter, link in (("P", one), ("Q", two)):
        start, end, _ = ends[link]
        at, left = (int(rng.integers(20, 150)), int(rng.integers(-80, 80)))
        if link == "frame":
            places[letter] = complex(*rng.integers(-200, 400, 2))
            continue
        places[letter] = start + (at + 1j * left) * (end - start) / abs(end - start)
        drawn[link] = f", {letter}: {{along: {ends[link][2]}, at: {at} mm, left: {left} mm}}"
    links, joint, pair = _pair(rng, "4", "5", "P", "Q")
    fixed = f", P: [{places['P'].real} mm, {places['P'].imag} mm]" if one == "frame" else ""
    return f"""
id: inside
title: inside
frame: {{A: [0 mm, 0 mm], D: [300 mm, 0 mm]{fixed}}}
links:
  1: {{AB: {ab} mm{drawn.get("1", "")}}}
  2: {{BC: {bc} mm{drawn.get("2", "")}}}
  3: {{DC: {_number(cd)} mm{drawn.get("3", "")}}}
{links}joints: [{joint}]
input: {{cylinder: {pair}, length: {_number(abs(places["P"] - places["Q"]))} mm, {_rates(rng)}}}
branch: [C {_left(b, d, c)} of BD]
guesses: {{B: [{b.real:.2f} mm, {b.imag:.2f} mm], C: [{c.real:.2f} mm, {c.imag:.2f} mm]}}
find: [v_B, v_C, a_C, omega_1, omega_2, omega_3, omega_4, alpha_1, alpha_2, alpha_3, alpha_4, v_Q, a_Q]
"""


@family("motor-in-hinge", often=1)
def motor(rng: np.random.Generator) -> str:
    """A motor at the hinge of coupler and rocker, or of crank and coupler."""
    phi, ab, bc = rng.uniform(0, 2 * np.pi), rng.integers(60, 250), rng.integers(100, 300)
    b, d = ab * np.exp(1j * phi), 300 + 0j
    c = b + bc * np.exp(1j * rng.uniform(0, 2 * np.pi))
    link, on, pin, ends = [("3", "2", c, (d, b)), ("2", "3", c, (b, d)), ("2", "1", b, (c, 0j))][int(rng.integers(3))]
    angle = np.degrees(np.angle((ends[0] - pin) / (ends[1] - pin)))
    side = rng.choice(
        [f"C {_left(b, d, c)} of BD", f"B {_left(0j, d, b)} of AD"]
    )  # the angle says the one, and in general not the other
    return f"""
id: motor
title: motor
frame: {{A: [0 mm, 0 mm], D: [300 mm, 0 mm]}}
links:
  1: {{AB: {ab} mm}}
  2: {{BC: {bc} mm}}
  3: {{DC: {_number(abs(c - d))} mm}}
input:
  link: {link}
  on: {on}
  phi: {_number(angle)} deg
  omega: {rng.choice([2, -1, 5])} rad/s
  alpha: {rng.choice([0, 3, -10])} rad/s^2
branch: [{side}]
guesses: {{B: [{b.real:.2f} mm, {b.imag:.2f} mm], C: [{c.real:.2f} mm, {c.imag:.2f} mm]}}
find: [v_B, v_C, a_C, omega_1, omega_2, omega_3, alpha_1, alpha_2, alpha_3]
"""


@family("pin-in-two-slots")
def two_slots(rng: np.random.Generator) -> str:
    """The crank's pin, or a point of the coupler of a slider-crank, runs in two slotted links."""
    a, d, f = (complex(*rng.integers(-200, 300, 2)) for _ in range(3))
    reach = rng.integers(30, 120)
    slots = [
        f"{{slot: {letter}}}"
        if rng.random() < 0.6
        else f"{{slot: {{through: {letter}, {rng.choice(['left', 'right'])}: {rng.integers(1, 12)} mm}}}}"
        for letter in "DF"
    ]
    return f"""
id: two-slots
title: two slots
frame: {{A: [{a.real} mm, {a.imag} mm], D: [{d.real} mm, {d.imag} mm], F: [{f.real} mm, {f.imag} mm]}}
links:
  1: {{AB: {reach} mm}}
  2: {slots[0]}
  3: {slots[1]}
joints: [B runs in 2, B runs in 3]
input:
  link: 1
  phi: {rng.uniform(0, 360):.3f} deg
  omega: {rng.choice([-8, 3, 10])} rad/s
  alpha: {rng.choice([0, 5, -20])} rad/s^2
find: [v_B, v_B2, v_B3, omega_2, omega_3, alpha_2, alpha_3, ak_B2B1, ak_B3B1]
"""


@family("roller")
def roller(rng: np.random.Generator) -> str:
    """An eccentric moves a translating or a swinging follower with a roller that is written as a link."""
    eccentric, large, small, off = rng.integers(5, 25), rng.integers(30, 60), rng.integers(5, 20), rng.integers(-20, 20)
    turn = f"{rng.uniform(0, 360):.3f} deg, omega: {rng.choice([-8, 10])} rad/s, alpha: {rng.choice([0, 30])} rad/s^2"
    if rng.random() < 0.5:
        frame, links, joints, branch = "", "  2: {block: E}\n", f"2 slides on x = {off} mm, ", "E above A"
        find = "v_E, a_E, p_E"
    else:
        frame, links, joints, branch = (
            ", D: [150 mm, 0 mm]",
            f"  2: {{DE: {rng.integers(100, 180)} mm, G: {{along: DE, at: 220 mm}}}}\n",
            "",
            "E above AD",
        )
        find = "v_E, a_E, omega_2, alpha_2, v_G, a_G"
    return f"""
id: roller
title: roller
frame: {{A: [0 mm, 0 mm]{frame}}}
links:
  1: {{AO: {eccentric} mm, disc: O, radius: {large} mm}}
{links}  3: {{disc: E, radius: {small} mm}}
joints: [{joints}1 touches 3 at K]
input: {{link: 1, phi: {turn}}}
branch: [{branch}]
find: [{find}]
"""


@family("offset-slot-drives")
def offset_slot(rng: np.random.Generator) -> str:
    """A turning slot beside its pin leads the pin of a bar, or a block with a bar;
    which assembly a rough place tells."""
    phi, left, d = rng.uniform(0, 2 * np.pi), rng.integers(-60, 60), complex(*rng.integers(-150, 150, 2))
    along = rng.integers(-200, 200)
    b = (along + 1j * left) * np.exp(1j * phi)
    side, blocks = "left" if left >= 0 else "right", rng.random() < 0.5
    joint, more = ("4 slides in 1", "  4: {block: B}\n") if blocks else ("B runs in 1", "")
    return f"""
id: offset-slot
title: offset slot
frame: {{A: [0 mm, 0 mm], D: [{d.real} mm, {d.imag} mm]}}
links:
  1: {{slot: {{through: A, {side}: {abs(left)} mm}}, E: {{AE: 50 mm, angle: 30 deg from line}}}}
  2: {{DB: {_number(abs(b - d))} mm, G: {{along: DB, at: 30 mm, left: 20 mm}}}}
{more}joints: [{joint}]
input:
  link: 1
  phi: {_number(np.degrees(phi))} deg
  omega: {rng.choice([-8, 3])} rad/s
  alpha: {rng.choice([0, 20])} rad/s^2
guesses: {{B: [{b.real:.1f} mm, {b.imag:.1f} mm]}}
find: [p_B, v_B, a_B, omega_2, alpha_2, v_E, v_G, a_G]
"""
