"""Branch statements that tell two assemblies apart."""

from __future__ import annotations

from itertools import permutations

from .sketch import Grazing, Sketch

SURE = 2.0  # mm


def which(sketch: Sketch, c: str, at: complex, other: complex, *near: str) -> None:
    """Say on which side C lies, in words that do not fit its other place."""
    places = sketch.places
    refs = [p for p in dict.fromkeys((*near, *places)) if p != c]
    single = [
        f"{c} {side} {ref}"
        for ref in refs
        for side, of in (("left of", -1), ("right of", 1))
        if min(of * (at - places[ref]).real, -of * (other - places[ref]).real) > SURE
    ]
    single += [
        f"{c} {side} {ref}"
        for ref in refs
        for side, of in (("below", -1), ("above", 1))
        if min(of * (at - places[ref]).imag, -of * (other - places[ref]).imag) > SURE
    ]
    rays = []
    for x, y in permutations(refs, 2):
        ray = places[y] - places[x]
        if abs(ray) < SURE:
            continue
        here, there = (((z - places[x]) / ray * abs(ray)).imag for z in (at, other))
        rays += (
            [f"{c} {'left' if here > 0 else 'right'} of {x}{y}"]
            if here * there < 0 and min(abs(here), abs(there)) > SURE
            else []
        )
    said = [*single[:3], *rays[:4]]
    if not said:
        raise Grazing
    sketch.branches.append(sketch.one(said))
