"""Scales and sheets that are given: the figures have them, and the answers are those of any other scale; answers that
are printed, right and wrong ones, as values and as lengths on paper."""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from vecpoly import loads
from vecpoly.check.printed.answers import check_problem
from vecpoly.check.printed.verdict import Verdict
from vecpoly.errors import VecpolyError
from vecpoly.figures import scales
from vecpoly.solution import Solution, scales_of

from ..family import OnText, families, family
from ..library import data_of
from ..retold.original import Change, against, solved, told

Random = np.random.Generator
KINDS = ("linkage-rr", "four-bar", "flywheel by", "reduced", "run-up")
ROUND = (0.8, 1.25, 1.6)


def _member(rng: Random, starts: tuple[str, ...]) -> tuple[dict[str, Any], Solution]:
    """A member of such a family that is solved, none of which has a scale of its own."""
    known = [one for one in families() if one.name.startswith(starts)]
    while True:
        data = data_of(known[int(rng.integers(len(known)))].make(rng))
        if "scales" in data:
            continue
        try:
            return data, solved(json.dumps(data, ensure_ascii=False))
        except VecpolyError:
            continue


def drawn_so(solution: Solution) -> str:
    """Every figure has the scale that is given for its kind, and the answers are those without."""
    data = data_of(solution.problem.text)
    for key, text in data["scales"].items():
        value = float(text.split()[0])
        for figure in solution.construction.figures:
            if figure.view.mu.key == key and not figure.aside and abs(figure.scale.value / value - 1) > 1e-9:
                return f"{key} of {figure.view} is {figure.scale.value}, given {text}"
    first = solved(json.dumps({key: one for key, one in data.items() if key not in ("scales", "sheet")}))
    return against(solution, first, Change())


@family("keys-scales", also=drawn_so, often=1)
def scaled(rng: Random) -> str:
    """Scales somewhat finer or coarser than those that were chosen, of all kinds of figure; a sheet of some sort."""
    data, first = _member(rng, KINDS)
    known = scales()
    given = {
        key: f"{float(f'{value * rng.choice(ROUND):.3g}')!r} {known[key].example.split(' ', 1)[1]}"
        for key, value in scales_of(first.construction).given.items()
        if key in known
    }
    sheet = {"orientation": str(rng.choice(["portrait", "landscape"])), "format": str(rng.choice(["A4", "letter"]))}
    return told(data | {"scales": given, "sheet": sheet}, "scaled")


def told_rightly(text: str) -> str:
    """What is printed as it is exact is right; what is half as large again, or points elsewhere, is wrong."""
    data = data_of(text)
    found = check_problem(loads(text))
    for line, said in zip(found.answers, data["printed"], strict=True):
        if (line.verdict is Verdict.WRONG) is not (said["note"]["en"] == "wrong"):
            return f"{said} is {line.verdict}"
    return "" if found.answers else "nothing is checked"


@family("keys-printed", also=OnText(told_rightly), often=2)
def printed(rng: Random) -> str:
    """Velocities, accelerations and rates of a linkage as books print them."""
    while True:
        data, first = _member(rng, ("linkage-r", "four-bar"))
        rows = [row for key in first.answers if (row := _row(rng, first, key)) is not None]
        if rows:
            break
    errata = [{"zh": "勘误", "en": "An erratum"}, "one more"][: int(rng.integers(0, 3))]
    return told(data | {"printed": rows, "errata": errata}, "printed")


def _row(rng: Random, first: Solution, key: str) -> dict[str, Any] | None:
    """One printed answer; None of what is nothing."""
    answer, wrong = first.answers[key], bool(rng.random() < 0.3)
    unit = answer.reading.unit
    vector = answer.exact_vector
    if unit not in ("m/s", "m/s^2", "rad/s", "rad/s^2") or abs(answer.exact) < 1e-3:
        return None
    size = (answer.exact if vector is None else abs(vector)) * (1.5 if wrong else 1.0)
    row: dict[str, Any] = {"symbol": key, "value": f"{size:.5g} {unit}", "note": {"zh": "注", "en": "right"}}
    if vector is not None and rng.random() < 0.5:
        row |= {"value": f"{abs(size) / 0.02:.5g} mm", "scale": f"0.02 ({unit})/mm"}
    if vector is not None and rng.random() < 0.5:
        row["direction"] = f"{np.degrees(np.angle(vector)):.3f} deg"
    row |= {"kind": str(rng.choice(["calculated", "graphical"]))} if rng.random() < 0.7 else {}
    row |= {"figures": "4"} if rng.random() < 0.3 else {}
    return row | {"note": {"zh": "注", "en": "wrong" if wrong else "right"}}
