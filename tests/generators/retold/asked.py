"""Members of other families of which something else is asked: instant centres and velocities by them; points with a
given velocity or acceleration."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vecpoly import oracle
from vecpoly.mechanism.model import FRAME, Mechanism
from vecpoly.names import At, Kind, Rel, parse_rel
from vecpoly.oracle.motion import Motion
from vecpoly.problem.asked.asks import AskPoint
from vecpoly.solution import Solution

from ..family import family
from ..library import data_of
from .original import original, solved, told

JOINTED = (
    "four-bar",
    "linkage-rrr",
    "linkage-rrp",
    "linkage-rpr",
    "linkage-prp",
    "linkage-rpp",
    "linkage-cam",
    "gears-pivots",
    "gears-arms",
    "gears-trains",
)
STEP = 1e-5  # of the drive; beside a limit position the differences of it and of its half tell their own error


def one_velocity_at_each_centre(solution: Solution) -> str:
    """Both links have one velocity at their centre, by central differences of the oracle's positions;
    the other answers are the original's."""
    mech = solution.problem.subject
    assert isinstance(mech, Mechanism)
    moves = [_moved(mech, step) for step in (STEP, STEP / 2)]
    fastest = max(abs(moves[0].velocity(name, 0j)) for name in mech.bodies)
    for key, answer in solution.answers.items():
        if key.startswith("P_") and answer.exact_vector is not None:
            names = [_named(mech, n) for n in key.split("_", 1)[1]]
            (far, also), (one, two) = ([moved.velocity(name, answer.exact_vector) for name in names] for moved in moves)
            if not abs(one - two) <= 1e-6 * (fastest + abs(one) + abs(two)) + 2 * (abs(one - far) + abs(two - also)):
                return f"at {key} {answer.exact_vector} the links have {one} and {two} m/s"
    return ""


def _named(mech: Mechanism, number: str) -> str:
    return FRAME if number == mech.frame_number else mech.named(number)


@dataclass(frozen=True, slots=True)
class _Moved:
    """Three positions a step apart."""

    mech: Mechanism
    motion: Motion
    step: float  # rad, or m

    def velocity(self, link: str, place: complex) -> complex:
        """Of the point of a link that is here now."""
        if link == FRAME:
            return 0j
        at, angle = self.motion.origin(link), np.exp(1j * self.motion.angle(link))
        path = at + angle * ((place - at[1]) / angle[1])
        return complex(path[2] - path[0]) / (2 * self.step) * self.mech.drive.rate


def _moved(mech: Mechanism, step: float) -> _Moved:
    step *= mech.scale if mech.drive.slide else 1.0
    return _Moved(mech, oracle.solve(mech, mech.drive.position + np.array([-1.0, 0.0, 1.0]) * step, order=0), step)


@family("asked-centres", also=one_velocity_at_each_centre, often=1, first=3)
def centres(rng: np.random.Generator) -> str:
    """All instant centres of a mechanism, and its velocities by them."""
    while True:
        mark, text = original(rng, JOINTED)
        data = data_of(text)
        if len(data["links"]) < 8:
            break
    turning = [f"omega_{name}" for name in data["links"]]
    points = [
        key
        for key in data["find"]
        if key.startswith("v_") and key[2:].isalpha() and key.count("_") == 1 and len(key) == 3
    ]
    return told(data | {"method": "centres", "find": ["centres", *turning, *points]}, mark)


def as_given(solution: Solution) -> str:
    """Each point found has, by its link's angular velocity and acceleration and another point, what was given of it."""
    motion = oracle.solve(solution.problem.mechanism)
    for ask in solution.problem.asks:
        if isinstance(ask, AskPoint):
            at = ask.name
            place = solution.answers[f"p_{at}"].exact_vector
            given, kind = (ask.velocity, Kind.V) if ask.velocity is not None else (ask.acceleration, Kind.A)
            assert place is not None and given is not None
            found = _rate(motion, solution.problem.mechanism, ask.link, place, kind)
            if not abs(found - given) <= 1e-9 * (abs(found) + abs(given) + 1.0):
                return f"p_{at} has {found}, given was {given}"
    return ""


def _rate(motion: Motion, mech: Mechanism, link: str, place: complex, kind: Kind) -> complex:
    """v + ω × r, or a + α × r − ω² r, from the link's first letter."""
    letter = next(iter(mech.link(link).points))
    arm, first = place - complex(motion.position(letter)), complex(motion.value(Rel(kind, At(letter, link))))
    turning = 1j * complex(motion.value(parse_rel(f"omega_{link}")))
    return (
        first
        + (turning if kind is Kind.V else 1j * complex(motion.value(parse_rel(f"alpha_{link}"))) + turning**2) * arm
    )


@family("asked-points", also=as_given, often=1, first=1)
def points(rng: np.random.Generator) -> str:
    """Points with a given velocity or acceleration, Coriolis terms yes or no."""
    mark, text = original(rng, JOINTED)
    data, solution = data_of(text), solved(text)
    turning = [
        name
        for name in data["links"]
        if solution.answers.get(f"omega_{name}") and abs(solution.answers[f"omega_{name}"].exact) > 1e-3
    ]
    asks: list[object] = []
    asks += [{"coriolis": key.removeprefix("ak_")} for key in data["find"] if key.startswith("ak_")][:2]
    for i, name in enumerate(rng.permutation(turning)[:2]):
        kind, unit = [("velocity", "m/s"), ("acceleration", "m/s^2")][int(rng.integers(2))]
        given: object = "0" if rng.random() < 0.3 else [f"{rng.uniform(-0.6, 0.6):.3f} {unit}" for _ in range(2)]
        asks += [
            {"point": f"{'MQ'[i]}z{name}", "on": str(name), kind: given},
            f"v_{'MQ'[i]}z{name}",
            f"a_{'MQ'[i]}z{name}",
        ]
    return told(data | {"find": asks or data["find"][:1]}, mark)
