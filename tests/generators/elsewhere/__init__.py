"""Questions that take a mechanism to other positions of its drive: strokes, paths, centrodes, periods.

The statements are true at the given position, and many of them nowhere else; a third party walks there in
small strides.
"""

from __future__ import annotations

import numpy as np

from vecpoly import loads
from vecpoly.board.acts import Curve
from vecpoly.board.construction import Pane, View
from vecpoly.board.paper.marks import Role
from vecpoly.cycle.pose import posed
from vecpoly.mechanism.asked.pressure import driven_links
from vecpoly.oracle import solve
from vecpoly.problem.problem import Problem
from vecpoly.solution import Solution

from ..acting.laws import balanced_by_hand
from ..family import family
from ..pressures import by_velocities
from ..running.machines import weighed
from . import gears  # noqa: F401  a family of its own
from .machines import ALL, BARS, SMALL, Random, made
from .walk import both_ways

OFF = 0.05  # mm: as far as a drawn path may lie from the chords of the strides
SAME = 1e-7  # of the mechanism's size
REACH = np.radians(45.0)  # of the path of a curvature, to both sides
SHEET = 25.0  # mm: a path that goes farther may leave the paper


def as_walked(solution: Solution) -> str:
    """The oracle's letters lie where the walk comes to, and a problem that is posed there has them there."""
    mech = solution.problem.mechanism
    for walk in both_ways(mech):
        at = mech.drive.position + walk.sense * np.array(walk.ways)
        motion = solve(mech, at, order=0, strict=False)
        letters = [p for link in mech.links for p in link.points]
        for letter in letters:
            off = np.abs(np.broadcast_to(motion.position(letter), at.shape) - walk.path(letter)).max()
            if not off < SAME * mech.scale:
                return f"{letter} by the oracle {1e3 * off:.3g} mm off the walk"
        some = np.arange(0, len(at), max(1, len(at) // 7))
        for k, there in zip(some, posed(solution.problem, at[some]), strict=True):
            if there is not None:
                moved = solve(there.mechanism, order=0)
                off = max(abs(complex(moved.position(p)) - walk.path(p)[k]) for p in letters)
                if not off < 1e-4 * mech.scale:
                    return f"posed {1e3 * off:.3g} mm off the walk"
    return ""


def on_the_path(solution: Solution) -> str:
    """The path of E that is drawn beside its osculating circle lies on the walk's, as far as that goes."""
    mech = solution.problem.mechanism
    place = next((at for at in (Pane(View.MECHANISM, "curvature"), View.MECHANISM) if _curves(solution, at)), None)
    figure = None if place is None else solution.construction.figure(place)
    if figure is None:
        return ""
    back, ahead = both_ways(mech, REACH + 0.01)
    mm, whole = 1 / figure.scale.value, np.concatenate([back.path("E")[::-1], ahead.path("E")])
    runs = [one.points for one in _curves(solution, place) if one.role is Role.GIVEN]
    for run in runs:
        if (off := _off(run, whole * mm)) > OFF:
            return f"path {off:.3g} mm off the walk"
    ends = [min(walk.ways[-1], REACH) for walk in (back, ahead)]
    expected = sum(int(end / np.radians(5.0) + 1e-9) for end in ends) + 1
    drawn = len(runs[0]) if runs else 0
    is_cut = max(abs(spot) for spot in whole) * mm > SHEET  # what lies off the paper is not drawn
    return f"path of {drawn} places, {expected} by the walk" if drawn < expected and not is_cut else ""


def on_the_turn(solution: Solution) -> str:
    """The path of E beside the curve that is given lies on the walk's, and is as long."""
    mech = solution.problem.mechanism
    scale = next(f.scale.value for f in solution.construction.figures if f.view is View.MECHANISM)
    back, ahead = both_ways(mech)
    whole = np.concatenate([back.path("E")[::-1], ahead.path("E")]) / scale
    arcs = [one.points for one in _curves(solution, View.MECHANISM) if one.role is Role.CONSTRUCTION]
    off = max((_off(arc, whole) for arc in arcs), default=0.0)
    if off > OFF:
        return f"path {off:.3g} mm off the walk"
    step = np.radians(3.0)
    full = min(ahead.ways[-1], back.ways[-1]) > 2 * np.pi - 1e-9
    expected = 121 if full else sum(int(walk.ways[-1] / step + 1e-9) for walk in (back, ahead)) + 1
    drawn = sum(map(len, arcs))
    return f"path of {drawn} places, {expected} by the walk" if abs(drawn - expected) > 2 else ""


def _curves(solution: Solution, place: object) -> list[Curve]:
    return [act for act in solution.construction.acts if isinstance(act, Curve) and act.head.place == place]


def _off(run: tuple[complex, ...], path: np.ndarray) -> float:
    """How far the farthest of these points lies from the chords of a path."""
    a, ray = path[:-1], np.diff(path)
    a, ray = a[np.abs(ray) > 1e-12], ray[np.abs(ray) > 1e-12]
    if not len(ray):
        return max(float(abs(spot - path[0])) for spot in run)
    shares = [np.clip(np.real((spot - a) / ray), 0.0, 1.0) for spot in run]
    return max(float(np.abs(a + share * ray - spot).min()) for spot, share in zip(run, shares, strict=True))


@family("elsewhere-stroke", also=balanced_by_hand, often=1)
def stroke(rng: Random) -> str:
    """A force that acts in part of the stroke of its point, by a window or by a table."""
    text, one = made(rng)
    link, point = one.slider or ("3", "C")
    way = rng.integers(-179, 180)
    low, high = sorted(int(x) for x in rng.choice(101, 2, replace=False))
    sizes = [[x, int(rng.integers(0, 2000))] for x in (0, 20, 45, 90, 1000)]
    size, when = f"{rng.integers(50, 900)} N", f", while: {point} moves along {way} deg, between: [{low} %, {high} %]"
    if one.slider is not None and rng.random() < 0.4:
        size, when = f"{{columns: [s (mm), F (N)], rows: {sizes}}}", ""
    return (
        f"{text}loads:\n  F_q: {{on: {link}, at: {point}, size: {size}, direction: {way} deg{when}}}\n"
        f'  F_p: {{on: {link}, at: {point}, size: 50 N, direction: 77 deg}}\n  M_b: {{on: 1, size: "?"}}\nfind: [M_b]\n'
    )


@family("elsewhere-curvature", also=on_the_path, often=1)
def curvature(rng: Random) -> str:
    """The path of a point of the coupler."""
    text, _ = made(rng, SMALL)
    return f"{text}method: curvature\nfind: [p_OE, rho_E]\n"


@family("elsewhere-centrodes", often=1)
def centrodes(rng: Random) -> str:
    """Both centrodes, far round."""
    text, _ = made(rng, SMALL)
    here = int(text.split("phi: ")[1].split(" deg")[0])
    far = int(rng.integers(5, 60))
    over = f"[{here - int(rng.integers(0, far))} deg, {here + far} deg]"
    return f"{text}method: curvature\nfind: [{{centrodes: 2, positions: {rng.integers(4, 9)}, over: {over}}}]\n"


@family("elsewhere-target", also=on_the_turn, often=1)
def target(rng: Random) -> str:
    """The path of a point beside a curve."""
    text, _ = made(rng, BARS)
    spots = ", ".join(f"[{x} mm, {y} mm]" for x, y in rng.integers(-90, 90, (4, 2)))
    return f"{text}target: {{point: E, through: [{spots}]}}\nfind: [v_C]\n"


@family("elsewhere-pressure", also=by_velocities, often=1)
def pressure(rng: Random) -> str:
    """Angles that are told apart by a little motion of the drive."""
    text, _ = made(rng, BARS)
    problem = loads(text + "find: [omega_2]\n")
    assert isinstance(problem, Problem)
    keys = [named.key for one in driven_links(problem.mechanism) for named in (one.alpha, one.gamma)]
    return f"{text}find: [{', '.join(keys)}]\n"


@family("elsewhere-machine", often=1, first=2)
def machine(rng: Random) -> str:
    """A period with a load in part of a stroke, and the constant moment that does its work."""
    text, one = made(rng)
    link, point = one.slider or ("3", "C")
    low, high = sorted(int(x) for x in rng.choice(101, 2, replace=False))
    return (
        f"{text}loads:\n  F_q: {{on: {link}, at: {point}, size: {rng.integers(50, 900)} N, direction: "
        f"{rng.integers(0, 360)} deg, while: {point} moves along {rng.integers(0, 180)} deg, "
        f"between: [{low} %, {high} %]}}\n  M_c: {{on: 1, size: constant}}\n{weighed(rng, one)}"
        "machine: {n: 100 r/min, delta: 0.05}\nfind: [M_c, dW_max, J_F]\n"
    )


@family("elsewhere-motion", also=as_walked, often=1, first=1)
def motion(rng: Random) -> str:
    """Positions alone, all round: by the oracle, and as they are posed for reports and the player."""
    return f"{made(rng, (*ALL, *BARS))[0]}find: [omega_2]\n"
