"""Any task of synthesis with `take` and `omega`: what is asked without a number is that of the solution which is taken,
and the linkage that is moved is that one, its crank turning as it says."""

from __future__ import annotations

import json
from math import pi

import numpy as np

from vecpoly.designs.base import Design
from vecpoly.errors import VecpolyError
from vecpoly.mechanism.model import Mechanism
from vecpoly.solution import Solution

from ..family import families, family
from ..library import data_of
from .written import apart, solved


def as_numbered(solution: Solution) -> str:
    """Without `take` the same solution answers under its number, and the crank turns as is asked."""
    data = data_of(solution.problem.text)
    n, omega = int(data["data"].pop("take")), float(str(data["data"].pop("omega")).split()[0])
    sense = -1 if "cw" in str(data_of(solution.problem.text)["data"]["omega"]).split() else 1
    asked = list(data["find"])
    first = solved(json.dumps(data | {"find": [f"{key}_{n}" for key in asked]}))
    for key in asked:
        if wrong := apart(key, solution.answers[key], first.answers[f"{key}_{n}"]):
            return wrong
    linkage = solution.linkage
    if linkage is None or not isinstance(linkage.subject, Mechanism):
        return ""
    rate = sense * omega * pi / 30
    found = linkage.mechanism.drive.rate
    return "" if abs(found - rate) <= 1e-9 * abs(rate) else f"the crank turns with {found}, asked was {rate}"


@family("keys-taken", also=as_numbered, often=2)
def taken(rng: np.random.Generator) -> str:
    """A member of another family that has several solutions; one of them is taken, and turned."""
    known = [one for one in families() if one.name.startswith("design-")]
    while True:
        text = known[int(rng.integers(len(known)))].make(rng)
        try:
            first = solved(text)
        except VecpolyError:
            continue
        count = sum(one.reason is None for one in first.construction.candidates)
        if isinstance(first.problem.subject, Design) and count > 1:
            data = data_of(text)
            omega = f"{rng.integers(5, 200)} r/min {rng.choice(['cw', 'ccw'])}"
            more = {"take": str(rng.integers(1, min(count, 9) + 1)), "omega": omega}
            return json.dumps(data | {"data": data["data"] | more}, ensure_ascii=False, indent=1)
