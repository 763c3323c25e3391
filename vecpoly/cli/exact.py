"""vecpoly exact: the analytic answers alone, for any linkage the oracle knows, class III included."""

from __future__ import annotations

import cmath
from math import degrees
from typing import Any

from .errors import Tally, about
from .files import write_json
from .jobs import problems
from .options import JsonOption, Lang, LangOption, Problems
from .terminal import add, progress, show, table
from .wording import bare, number, symbol, unit

_COLUMNS = {"zh": ("量", "精确", "单位", "方向"), "en": ("symbol", "exact", "unit", "direction")}


def exact(names: Problems, json: JsonOption = None, lang: LangOption = "en") -> None:
    """Print the analytic answers, without a drawing."""
    found = problems(names)
    from ..check.exact import exact_values

    tally = Tally()
    data: list[dict[str, Any]] = []
    for problem in progress(found, "solving"):
        with tally.job(), about(problem.id):
            values = exact_values(problem)
            data.append({"id": problem.id, "answers": {key: _plain(key, value) for key, value in values.items()}})
            if json != "-":
                _print(f"{problem.id}  {bare(problem.title.of(lang))}", values, lang)
    if json is not None and not tally.failed:
        write_json(data if len(found) > 1 else data[0], json)
    tally.settle()


def _plain(key: str, value: complex | float) -> dict[str, Any]:
    from ..names import parse_rel

    si = parse_rel(key).kind.unit
    if not isinstance(value, complex):
        return {"unit": si, "exact": value}
    if key.startswith("p_"):
        return {"unit": si, "exact_xy": [value.real, value.imag]}
    return {"unit": si, "exact": abs(value), "direction_deg": degrees(cmath.phase(value))}


def _print(title: str, values: dict[str, complex | float], lang: Lang) -> None:
    from ..names import parse_rel

    made = table(title, [(name, "right" if i == 1 else "left") for i, name in enumerate(_COLUMNS[lang])])
    for key, value in values.items():
        way = "—"
        if not isinstance(value, complex):
            size = number(value, 7)
        elif key.startswith("p_"):
            size = f"({number(value.real, 7)}, {number(value.imag, 7)})"
        else:
            size, way = number(abs(value), 7), f"{degrees(cmath.phase(value)):.3f}°".replace("-", "−")
        add(made, (symbol(key), size, unit(parse_rel(key).kind.unit), way))
    show(made)
