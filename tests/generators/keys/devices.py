"""Data of devices that no other family gives: stations of a cam, an arm to either side, a speed at which a train or a
run starts, a time at which its speed is asked, what is drilled out of a rotor, the frame of a scheme by its number."""

from __future__ import annotations

import json
import re
from math import pi

import numpy as np

from vecpoly.solution import Solution

from ..designed.cams import LAWS
from ..designed.written import task
from ..family import families, family
from ..library import data_of
from .loads import number
from .written import apart, solved

Random = np.random.Generator


def of_any_stations(solution: Solution) -> str:
    """Exact radii do not depend on how many stations are drawn; an arm to the left is one to the right whose cam turns
    the other way."""
    data = data_of(solution.problem.text)
    other = {**data["data"], "stations": "15 deg"}
    if "arm" in other["follower"] and other["turns"] == "cw":
        return _same(solution, data, other)
    side = other["follower"].get("arm", {}).get("side")
    if side is not None:
        arm = other["follower"]["arm"] | {"side": {"left": "right", "right": "left"}[side]}
        turned = {"ccw": "cw", "cw": "ccw"}[other["turns"]]
        other = other | {"follower": other["follower"] | {"arm": arm}, "turns": turned}
    return _same(solution, data, other)


def _same(solution: Solution, data: dict[str, object], other: dict[str, object]) -> str:
    again = solved(json.dumps(data | {"data": other}, ensure_ascii=False))
    keys = [key for key in solution.answers if key in again.answers]
    return next((told for key in keys if (told := apart(key, solution.answers[key], again.answers[key]))), "")


@family("keys-cams", also=of_any_stations, often=1)
def cams(rng: Random) -> str:
    """A roller, a knife edge or an arm to either side, with stations near or far apart."""
    arm = f"{{OA: {rng.integers(70, 110)} mm, AB: {rng.integers(60, 90)} mm, side: {rng.choice(['left', 'right'])}}}"
    follower, by = [
        (f"{{roller: {rng.integers(4, 12)} mm, arm: {arm}}}", f"{rng.integers(8, 25)} deg"),
        (f"{{knife: yes, arm: {arm}}}", f"{rng.integers(8, 25)} deg"),
        (f"{{roller: {rng.integers(4, 12)} mm, offset: {rng.integers(-9, 9)} mm}}", f"{rng.integers(8, 30)} mm"),
    ][int(rng.integers(3))]
    up, back = (int(x) for x in rng.choice([90, 100, 120, 130], 2))
    one, two = (str(law) for law in rng.choice(LAWS[1:], 2))
    data = {
        "follower": follower,
        "r0": f"{rng.integers(35, 70)} mm",
        "turns": str(rng.choice(["ccw", "cw"])),
        "stations": f"{rng.choice([5, 10, 12, 20, 30, 45])} deg",
        "motion": f"[rise {by} in {up} deg {one}, return in {back} deg {two}, dwell {360 - up - back} deg]",
    }
    return task("cam", data, "rho_min, r_60, alpha_60", "device")


def by_small_steps(solution: Solution) -> str:
    """ω at the time asked, by a hundred thousand steps of the equation of motion, which is linear."""
    data = data_of(solution.problem.text)["data"]
    a, b = (number(text) for text in data["motor"])
    c, d = (number(text) for text in data["load"])
    steps, omega = 100_000, number(data.get("start", "0")) * pi / 30
    h = number(data["at"]) / steps
    rate, steady = (b + d) / number(data["J"]), (a - c) / (b + d)
    omega = steady + (omega - steady) * ((1 - rate * h / 2) / (1 + rate * h / 2)) ** steps
    found = solution.answers["omega_t"].exact
    return "" if abs(found - omega) <= 1e-6 * max(1.0, abs(omega)) else f"omega_t = {found}, by steps {omega}"


@family("keys-run-up", also=by_small_steps, often=2)
def run_up(rng: Random) -> str:
    """From rest, or from a speed; the speed at a time is asked."""
    a, b, c, d = rng.integers(80, 400), rng.uniform(0.3, 3), rng.integers(1, 50), rng.uniform(0, 1)
    inertia = rng.uniform(0.3, 9)
    share = rng.uniform(0.3, 2.0)
    data = {
        "motor": f"[{a} N*m, {b:.4f} N*m*s]",
        "load": f"[{c} N*m, {d:.4f} N*m*s]",
        "J": f"{inertia:.3f} kg*m^2",
        "to": "97 %",
        "at": f"{share * inertia / (b + d):.4f} s",
    }
    if rng.random() < 0.6:
        data["start"] = f"{0.5 * (a - c) / (b + d) * 30 / pi:.1f} r/min"
    return task("run-up", data, "omega_t, t", "device")


def of_even_acceleration(solution: Solution) -> str:
    """With constant moments ω, turns and time are those of an even acceleration from the start."""
    data = data_of(solution.problem.text)["data"]
    found = {key: float(np.real(one.exact)) for key, one in solution.answers.items()}
    start, alpha = number(data["start"]) * pi / 30, found["alpha_1"]
    if "after" in data:
        t = number(data["after"])
        wanted = {"omega_1": start + alpha * t, "N": (start * t + alpha * t * t / 2) / (2 * pi)}
    else:
        end = number(data["until"]) * pi / 30
        wanted = {"t": (end - start) / alpha, "N": (end**2 - start**2) / (4 * pi * alpha)}
    for key, value in wanted.items():
        if key in found and abs(found[key] - value) > 1e-9 * max(1.0, abs(value)):
            return f"{key} = {found[key]}, evenly accelerated {value}"
    return "" if wanted.keys() & found.keys() else "nothing of the run is answered"


@family("keys-train-start", also=of_even_acceleration, often=2)
def train_start(rng: Random) -> str:
    """Two shafts that already turn."""
    start = int(rng.integers(50, 600))
    shafts = (
        f"{{1: {{J: {rng.uniform(0.05, 2):.3f} kg*m^2, drives: {rng.integers(50, 500)} N*m}}, "
        f"2: {{J: {rng.uniform(0.05, 2):.3f} kg*m^2, resists: {rng.integers(1, 20)} N*m}}}}"
    )
    data = {"shafts": shafts, "pairs": f"[1 to 2 by {rng.integers(18, 40)}/{rng.integers(40, 90)}]", "to": "1"}
    data["start"] = f"{start} r/min"
    if rng.random() < 0.5:
        data["after"] = f"{rng.uniform(0.1, 3):.2f} s"
        return task("reduced-train", data, "alpha_1, omega_1, N", "device")
    data["until"] = f"{start + int(rng.integers(50, 900))} r/min"
    return task("reduced-train", data, "alpha_1, t, N", "device")


def under_another_number(solution: Solution) -> str:
    """The scheme has the freedom and the groups that it has with the frame called 0."""
    data = data_of(solution.problem.text)
    frame = str(data["data"]["frame"])
    joints = {letter: _called(str(text), frame) for letter, text in data["data"]["joints"].items()}
    rest = {key: value for key, value in data["data"].items() if key not in ("frame", "links")}
    return _same(solution, data, rest | {"joints": joints})


def _called(text: str, frame: str) -> str:
    head, _, tail = text.partition(")")
    return re.sub(rf"\b{frame}\b", "0", head) + ")" + tail


@family("keys-structures", also=under_another_number, often=1)
def structures(rng: Random) -> str:
    """A scheme of another family whose frame has a number; all its links are named."""
    known = [one for one in families() if one.name.startswith("device-structure")]
    while True:
        data = data_of(known[int(rng.integers(len(known)))].make(rng))
        heads = [str(text).partition(")")[0] for text in data["data"]["joints"].values()]
        names = sorted({name for head in heads for name in re.findall(r"\b\d+\b", head)}, key=int)
        if any(" about " in head or "(" in head[2:] for head in heads) or "0" not in names:
            continue
        frame = str(max(map(int, names)) + 1)
        joints = {
            letter: re.sub(r"\b0\b", frame, str(text).partition(")")[0]) + ")" + str(text).partition(")")[2]
            for letter, text in data["data"]["joints"].items()
        }
        links = [frame if name == "0" else name for name in names]
        more = {"joints": joints, "frame": frame} | ({"links": links} if rng.random() < 0.6 else {})
        return json.dumps(data | {"data": data["data"] | more}, ensure_ascii=False)
