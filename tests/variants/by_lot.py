"""`vary:` by lot: up to three numbers of a problem of the library, each in steps of a twentieth to either side."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal
from typing import Any

import numpy as np

from tests.generators.library import Data, data_of, over
from vecpoly.errors import VecpolyError
from vecpoly.problem.library import Entry, library
from vecpoly.problem.load import loads
from vecpoly.problem.meaning import said
from vecpoly.problem.values.parameters import named
from vecpoly.problem.values.slot import Slot
from vecpoly.solution import solve
from vecpoly.variants.draw import Variant, variants
from vecpoly.variants.pilot import pilot
from vecpoly.variants.seeds import Seed

_NUMBER = re.compile(r"\s*(-?\d+(?:\.\d+)?)\s*([^\d\s].*)?")
_SENSE = re.compile(r"\s*(ccw|cw|顺时针|逆时针)$")
STEPS = 2  # to either side
MOST = 3  # numbers that vary
AGREE = 1e-6


@dataclass(frozen=True, slots=True, kw_only=True)
class Varied:
    """A text with ranges; why it was refused, or how many variants were drawn, and what is wrong with them."""

    text: str
    refused: str = ""
    drawn: int = 0
    wrong: str = ""


def varied(rng: np.random.Generator) -> Varied:
    """Some numbers of some problem varied: two students' variants are drawn, by paper and in closed form."""
    entry = library()[int(rng.integers(len(library())))]
    text = written(entry, rng)
    try:
        return _judged(text)
    except VecpolyError as error:
        return Varied(text=text, refused=str(error))


def written(entry: Entry, rng: np.random.Generator) -> str:
    """The problem with `vary`, and now and then with a gate that lets students be alike."""
    data = _data(entry)
    known = named(data)
    ranges = dict[str, str]()
    taken = set[object]()
    for name in rng.permutation(sorted(known)):
        slot = known[name][0]
        if len(ranges) < rng.integers(1, MOST + 1) and slot.path not in taken and (span := _range(data, slot)):
            ranges[str(name)] = span
            taken.add(slot.path)
    gate = "gate: {apart: 0}\n" if rng.random() < 0.5 else ""
    rows = "".join(f'  "{name}": "{span}"\n' for name, span in ranges.items())
    return f"id: varied\ntitle: varied\nextends: {entry.id}\n{gate}" + (f"vary:\n{rows}" if rows else "")


def _data(entry: Entry) -> Data:
    """What the file says, with what it extends; every scalar is its text."""
    data = data_of(entry.path.read_text(encoding="utf-8"))
    if "extends" not in data:
        return data
    return over(_data(next(one for one in library() if one.id == data["extends"])), data)


def _range(data: Mapping[str, Any], slot: Slot) -> str:
    """A range about the number that stands there; nothing of a point, of nought, and of what is no number."""
    found = None if slot.pair else _NUMBER.fullmatch(said(data, slot))
    if found is None or not (value := Decimal(found[1])):
        return ""
    step, unit = Decimal(f"{abs(value) / 20:.2g}"), (found[2] or "").strip()
    low, high = (f"{value + way * STEPS * step:f} {unit}".strip() for way in (-1, 1))
    return f"{low} .. {high} by {step:f} {_SENSE.sub('', unit)}".strip()


def _judged(text: str) -> Varied:
    problem = loads(text)
    if not problem.ranges:
        return Varied(text=text)
    standard = pilot(problem).standard
    found = []
    for student in ("1", "2"):
        seed = Seed(assignment="lot", problem="varied", student=student, salt="")
        one, again = (next(variants(problem, seed, standard), None) for _ in range(2))
        if one is None or again is None:
            continue
        if dict(one.values) != dict(again.values):
            return Varied(text=text, wrong=f"{one.values} and {again.values} for one seed")
        found.append(one)
    return Varied(text=text, drawn=len(found), wrong="".join(map(_wrong, found)))


def _wrong(variant: Variant) -> str:
    """What a drawing by an exact hand says otherwise than the closed form, or an alarm."""
    solution = solve(variant.problem, by="exact", repeats=0)
    if (warning := solve(variant.problem).construction.warning) is not None:
        return f"{dict(variant.values)}: alarm: {warning.en}"
    for key, one in solution.answers.items():
        drawn, exact = (one.drawn, one.exact) if one.drawn_vector is None else (one.drawn_vector, one.exact_vector)
        if not one.undefined and exact is not None and abs(drawn - exact) > AGREE * max(AGREE, abs(exact)):
            return f"{dict(variant.values)}: {key} drawn {drawn}, exact {exact}"
    return ""
