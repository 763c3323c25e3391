"""Section of chapter 5, the forces: tables and curves of what changes, and in words what does not."""

from __future__ import annotations

from typing import Any

import numpy as np

from ....findings.shown import shown, span
from ....findings.study.study import Study
from ....words import Words
from ..analysis import duties as force_duties
from ..analysis import force_words
from ..analysis.stated import direction
from ..numbering import Press
from .plots import LINES, curve
from .tabled import COLUMNS, halved, tabled

_NOTHING = 1e-9  # of the largest force of the cycle: rounding


def section(study: Study, press: Press) -> dict[str, Any]:
    """The balancing load, the efficiency and the reactions."""
    parts, still = force_duties.table(study, press), unchanged(study)
    rest, tables, mirrored = [key for key in study.forces if key not in still], list[str](), list[Words]()
    while rest:
        part: list[str] = []
        while rest and sum(len(study.turn.info(key).parts) for key in (*part, rest[0])) <= COLUMNS + 1:
            part.append(rest.pop(0))
        tables.append(tabled(study, press, part, Words("平衡载荷与运动副反力", "The balancing load and the reactions")))
        mirrored += [one for one in [halved(study, part)] if one.zh]
    changing = [key for key in study.forces if study.varies(key)]
    plots = []
    for unit in dict.fromkeys(study.turn.info(key).shown_unit for key in changing):
        keys = [key for key in changing if study.turn.info(key).shown_unit == unit]
        plots += [curve(study, press.lang, keys[i : i + LINES]) for i in range(0, len(keys), LINES)]
    said = [_LISTED] if tables and plots else []
    words = force_words.joined([*said, *mirrored, *constant(study, still), force_words.results(study)])
    return {
        "title": Words("平衡载荷与反力", "The balancing load and the reactions").of(press.lang),
        "words": words.of(press.lang),
        "alone": bool(still),
        "before": [],
        "tables": [*([parts] if parts else []), *tables],
        "figures": press.figures(plots),
    }


_LISTED = Words(
    "平衡载荷和各运动副反力按分量列表，按大小作曲线。",
    "The balancing load and the reactions are listed by their components, and drawn by their magnitudes.",
)


def unchanged(study: Study) -> list[str]:
    """The forces that are the same in every position, in size and direction."""
    return [key for key in study.forces if not any(_changes(study, part) for part in study.turn.info(key).parts)]


def _changes(study: Study, part: str) -> bool:
    values = study.turn.real(part)
    return study.varies(part) or not bool(np.isfinite(values).all())


def constant(study: Study, keys: list[str]) -> list[Words]:
    """What is the same in every position, with its value, in one sentence."""
    told = [_told(study, key) for key in keys]
    if not told:
        return []
    return [
        Words(
            f"{span(study).zh}内{'；'.join(w.zh for w in told)}，各位置都相同，不另列表。",
            f"In every position of the {span(study).en}, {'; '.join(w.en for w in told)}.",
        )
    ]


def _told(study: Study, key: str) -> Words:
    """$R_{43}$ = 200 N, downwards; of zero neither unit nor direction."""
    info = study.turn.info(key)
    values = [float(np.mean(study.turn.real(part))) for part in info.parts]
    vector = complex(*values) if info.is_vector else complex(values[0])
    if abs(vector) <= _NOTHING * _top(study):
        return Words.same(f"${info.symbol}$ = 0")
    size = abs(vector) if info.is_vector else vector.real
    value = Words.same(f"${info.symbol}$ = {shown(study, key, size)}")
    return value + (Words("，", ", ") + direction(vector) if info.is_vector else Words("", ""))


def _top(study: Study) -> float:
    """The largest of all forces and loads that are told."""
    loads = study.problem.loads
    given = [abs(load.size) for load in loads.all if load.size is not None] if loads else []
    return max([float(np.nanmax(np.abs(study.turn.real(key)))) for key in study.forces] + given)
