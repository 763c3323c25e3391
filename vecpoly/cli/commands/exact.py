"""vecpoly exact: the analytic answers alone, for anything the oracle knows, linkages of class III included."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from math import degrees, isnan
from typing import TYPE_CHECKING, Any

from ...names import is_centre, is_place, written_unit
from ...words import Words, bare
from ..errors import Tally, about
from ..files import STDOUT, spared, write_json
from ..jobs import problems
from ..options import JSON, JsonOption, Lang, LangOption, OutsideOption, Problems
from ..terminal import add, progress, say, show, table, warn
from ..wording import YES_NO, number, place, scalar, sense, symbol

if TYPE_CHECKING:
    from ...check.truth import ActsAt
    from ...names import Key
    from ...task import Task

_COLUMNS = {"zh": ("量", "精确", "单位", "方向"), "en": ("symbol", "exact", "unit", "direction")}


def exact(
    names: Problems, json: JsonOption = None, lang: LangOption = "en", allow_outside: OutsideOption = False
) -> None:
    """Print the analytic answers, without a drawing."""
    tally = Tally()
    found = problems(names, tally, allow_outside)
    spared(json, JSON, found)
    from ...check.designs.several import several_of
    from ...check.designs.unsolvable import conclusion
    from ...check.precision import noise, settled, sizes
    from ...check.resting import at_rest
    from ...check.truth import truth_of
    from ...methods.drawing import drawing_of
    from ...task import Task

    data: list[dict[str, Any]] = []
    for problem in progress(found, Words("求解", "solving")):
        with tally.job(), about(problem):
            warn(problem.id, (*problem.warnings, *at_rest(problem)), lang)
            truth = truth_of(problem)
            size = sizes(problem, truth)
            off = noise(problem, truth, size)  # refuses what has lost its digits
            values = {key: settled(value, off[key], size[key]) for key, value in truth.values.items()}
            task = Task(problem, drawing_of(problem), truth)
            answers = {
                key: _plain(task.asked[key], value) | _sense(task, key, value) | _line(truth.lines.get(key))
                for key, value in values.items()
            }
            data.append({"id": problem.id, "answers": answers})
            if json != STDOUT:
                _print(task, values, size, lang)
                if (several := several_of(problem, truth)) is not None:
                    say(f"{problem.id}: {several.of(lang)}")
            tally.weigh(problem.id, None, lang, conclusion(problem))
    if json is not None and data:
        from ...answer import plain

        data = plain(data)
        write_json(data if len(data) + len(tally.failed) > 1 else data[0], json)
    tally.settle()


def _plain(rel: Key, value: complex | float) -> dict[str, Any]:
    si = rel.unit
    if not isinstance(value, complex):
        endless = is_centre(rel)  # an instant centre at infinity: its direction
        if isnan(value):
            return {"unit": si, "exact": None, "undefined": True}
        return {"unit": "deg" if endless else si, "exact": bool(value) if si == YES_NO else value} | (
            {"at_infinity": True} if endless else {}
        )
    from ...answer import bearing, place_of

    if is_place(rel):
        return {"unit": si, "exact_xy": place_of(value)}
    return {"unit": si, "exact": abs(value), "direction_deg": bearing(value) if value else None}


def _told(task: Task, rel: Key, value: complex | float, zero: float, lang: Lang) -> tuple[str, str, str]:
    """Size, unit and direction or sense."""
    from ...printed.angles import bearing_told

    unit = written_unit(rel.unit)
    if not isinstance(value, complex) and is_centre(rel):
        return "∞", "", f"{value:.3f}°"
    if not isinstance(value, complex):
        turned = task.turns(rel) and abs(value) > zero
        size = scalar(abs(value) if turned else value, rel.unit, lang, 7, zero)
        return size, unit, sense(value, lang) if turned else "—"
    if is_place(rel):
        return place(value, 7, zero), "mm", "—"
    way = bearing_told(degrees(cmath.phase(value)), 3) if abs(value) > zero else "—"
    return number(abs(value), 7, zero), unit, way


def _sense(task: Task, key: str, value: complex | float) -> dict[str, Any]:
    """ccw or cw of what turns; none of what does not turn now."""
    if isinstance(value, complex) or isnan(value) or not task.turns(task.asked[key]):
        return {}
    return {"sense": "ccw" if value > 0 else "cw" if value else None}


def _line(line: ActsAt | None) -> dict[str, Any]:
    """A point (m) of a reaction's line,
    the sense of its moment about the pin where it touches a friction circle, a slide's couple (N·m)."""
    if line is None:
        return {}
    couple = {} if line.couple is None else {"couple": line.couple}
    from ...answer import place_of

    return {"point": place_of(line.point), "tangent": line.tangent or None} | couple


def _print(task: Task, values: Mapping[str, complex | float], sizes: Mapping[str, float], lang: Lang) -> None:
    from ...check.precision import NOTHING

    problem = task.problem
    title = f"{problem.id}  {bare(problem.title.of(lang))}"
    made = table(title, [(name, "right" if i == 1 else "left") for i, name in enumerate(_COLUMNS[lang])])
    for key, rel in task.asked.items():
        if key in values:  # none of a synthesis without a solution
            add(made, (symbol(key), *_told(task, rel, values[key], NOTHING * min(1.0, sizes[key]), lang)))
    if values:
        show(made)
    from ...check.ending import ending_of

    if (told := ending_of(problem)) is not None:
        say(f"{problem.id}: {told.of(lang)}")
    from ...check.shaking import shaking_of

    if (shaken := shaking_of(problem, {})) is not None:
        say(f"{problem.id}: {shaken.of(lang)}")
    if not problem.asks:
        from ...problem.asked.hints import nothing_asked

        say(f"{problem.id}: {nothing_asked(problem).of(lang)}")
