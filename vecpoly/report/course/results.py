"""Chapter 5, the results: the table, the curves, the paths, the extreme values."""

from __future__ import annotations

from collections.abc import Sequence
from math import floor, log10
from typing import Any

import numpy as np

from ...cycle import Column, path, table
from ...cycle.path import Shape
from ...cycle.sentences import path_sentences
from ...words import Words
from ..flow.style import Style
from .numbering import SMALL, TINY, Press
from .study import Study

_COLUMNS, _TIGHT = 9, 12  # beside the drive's position, in small and in tiny type
_LINES = 4  # in one panel
_PANEL = 49.0  # mm
_STEMS = {"phi": Words("构件的转角", "Angles of the links"), "omega": Words("构件的角速度", "Angular velocities of the links"),
          "alpha": Words("构件的角加速度", "Angular accelerations of the links")}
_EXTREMES = {"zh": ["量", "单位", "最大值", "位置", "最小值", "位置"], "en": ["Quantity", "Unit", "Greatest", "At", "Least", "At"]}


def chapter(study: Study, press: Press) -> dict[str, Any]:
    """Sections with their tables, figures and words in order."""
    press.chapter = "5"
    extreme = _extremes(study, press)
    sections = [_links(study, press), *(_point(study, press, letter) for letter in study.points), _angles(study, press), _forces(study, press)]
    return {"sections": [s for s in sections if s["tables"] or s["figures"]], "extremes": extreme, "step": _step(study), "count": len(study.turn.phi), "range": _range(study, press)}


def _links(study: Study, press: Press) -> dict[str, Any]:
    """Angles, ω, α of all links that turn."""
    keys = [f"{stem}_{link}" for stem in _STEMS for link in study.links]
    if len(keys) <= _TIGHT:
        style = SMALL if len(keys) <= _COLUMNS else TINY
        tables = [tabled(study, press, keys, Words("构件的转角、角速度和角加速度", "Angles, angular velocities and accelerations of the links"), style)] if keys else []
    else:
        tables = [tabled(study, press, [f"{stem}_{link}" for link in study.links][:_COLUMNS], title) for stem, title in _STEMS.items()]
    figures = [_curves(study, press, [f"{stem}_{link}" for link in study.links[i:i + _LINES]]) for stem in _STEMS for i in range(0, len(study.links), _LINES)]
    return {"title": Words("构件的转动", "Rotation of the links").of(press.lang), "words": "", "before": [], "tables": tables, "figures": figures}


def _point(study: Study, press: Press, letter: str) -> dict[str, Any]:
    """Position, velocity, acceleration of a point; its path and hodograph where it runs on a curve of its own."""
    from ...curves import hodograph, trace

    title = Words(f"${letter}$ 点的运动", f"Motion of ${letter}$")
    table = tabled(study, press, [f"p_{letter}", f"v_{letter}", f"a_{letter}"], Words(f"${letter}$ 点的位置、速度和加速度", f"Position, velocity and acceleration of ${letter}$"))
    found = path(study.whole, letter)
    words = (" " if press.lang == "en" else "").join(w.of(press.lang) for w in path_sentences(study.whole, found))
    own = found.shape is Shape.CURVE
    way = trace(study.turn, (letter,), press.lang, width=120.0, height=105.0) if own else None
    before = [press.figure(way.scene, way.title)] if way else []
    figures = [_curves(study, press, keys) for stem in "pva" if (keys := _components(study, f"{stem}_{letter}"))]
    if own:
        swept = hodograph(study.turn, f"v_{letter}", press.lang, width=105.0, height=90.0)
        figures.append(press.figure(swept.scene, swept.title))
    return {"title": title.of(press.lang), "words": words, "before": before, "tables": [table], "figures": figures}


def _components(study: Study, key: str) -> list[str]:
    """A vector's parts that change, and its magnitude where both do (of a place never)."""
    parts = [part for part in study.turn.info(key).parts if study.varies(part)]
    return [key, *parts] if len(parts) > 1 and not key.startswith("p_") else parts


def _angles(study: Study, press: Press) -> dict[str, Any]:
    """The transmission angles that change."""
    told = [t.key for t in study.facts.transmissions if t.greatest.value - t.least.value > 1e-9]
    return {"title": Words("传动角", "Transmission angles").of(press.lang), "words": "", "before": [], "tables": [], "figures": [_curves(study, press, told[:_LINES])] if told else []}


def _forces(study: Study, press: Press) -> dict[str, Any]:
    """The balancing load, the efficiency and the reactions."""
    rest, tables = [*study.forces], []
    while rest:
        part: list[str] = []
        while rest and sum(len(study.turn.info(key).parts) for key in (*part, rest[0])) <= _COLUMNS + 1:
            part.append(rest.pop(0))
        tables.append(tabled(study, press, part, Words("平衡载荷与运动副反力", "The balancing load and the reactions")))
    figures = []
    for unit in dict.fromkeys(study.turn.info(key).shown_unit for key in study.forces):
        keys = [key for key in study.forces if study.turn.info(key).shown_unit == unit]
        figures += [_curves(study, press, keys[i:i + _LINES]) for i in range(0, len(keys), _LINES)]
    return {"title": Words("平衡载荷与反力", "The balancing load and the reactions").of(press.lang), "words": "", "before": [], "tables": tables, "figures": figures}


def _curves(study: Study, press: Press, keys: Sequence[str]) -> str:
    from ...curves import curves

    plot = curves(study.turn, tuple(keys), press.lang, panel=_PANEL)
    return press.figure(plot.scene, plot.title)


def _range(study: Study, press: Press) -> str:
    """The working range where the drive cannot turn right round."""
    if study.whole.whole:
        return ""
    low, high = (study.where(q).split(" = ")[1] for q in (study.whole.low, study.whole.high))
    return Words(f"原动件不能整周转动，以下只列出其工作范围 {low} 至 {high}；两端接近死点，速度和加速度急剧增大，未予列出。",
                 f"The drive cannot turn right round; told is its working range, {low} to {high}. Beyond it lie dead points, towards which the rates run away.").of(press.lang)


def _step(study: Study) -> str:
    drive = study.turn.drive
    return f"{drive.factor * study.step:g}{'°' if drive.shown_unit == '°' else ' ' + drive.shown_unit}"


def tabled(study: Study, press: Press, keys: Sequence[str], title: Words, style: Style = SMALL) -> str:
    """A table of these columns at the rows of the table."""
    parts = dict.fromkeys(part for key in keys for part in study.turn.info(key).parts)
    made = table(study.turn, tuple(part for part in parts if study.varies(part)) or tuple(parts), study.rows)
    header = [_head(column) for column in made.columns]
    formats = [_decimals(made.values[:, i]) for i in range(len(made.columns))]
    body = [tuple(_number(value, places) for value, places in zip(row, formats, strict=True)) for row in made.values.tolist()]
    return press.table(title, header, body, "r" * len(header), style=style)


def _head(column: Column) -> str:
    unit = column.shown_unit.replace("^2", "²").replace("·", "·")
    return f"${column.symbol}$" + (f" /({unit})" if "/" in unit or "·" in unit else f" /{unit}" if unit else "")


def _decimals(values: Any) -> int:
    """As many decimals as give the largest number five significant digits."""
    known = np.abs(values[np.isfinite(values)])
    top = float(known.max()) if known.size else 0.0
    if not top or np.allclose(known, np.round(known), atol=1e-9):
        return 0
    return int(min(6, max(0, 4 - floor(log10(top)))))


def _number(value: float, places: int) -> str:
    if not np.isfinite(value):
        return "—"
    text = f"{value:.{places}f}"
    return (text.lstrip("-") if float(text) == 0 else text).replace("-", "−")


def _extremes(study: Study, press: Press) -> str:
    """Greatest and least values to full accuracy, and where they stand."""
    keys = [f"{stem}_{link}" for link in study.links for stem in ("omega", "alpha")]
    keys += [key for letter in study.points for key in (f"p_{letter}.x", f"p_{letter}.y", f"v_{letter}", f"a_{letter}")]
    keys += list(study.forces)
    rows = []
    for key in keys:
        found, info = study.extremes(key), study.whole.info(key)
        if found.highest is None or found.lowest is None or found.is_constant or not study.varies(key):
            continue
        top = max(abs(found.highest.value), abs(found.lowest.value))
        spots = [text for spot in (found.highest, found.lowest)
                 for text in ("∞" if study.unbounded(key, spot) else _exact(info.factor * spot.value, info.factor * top), study.where(spot.phi).split(" = ")[1])]
        symbol = f"$|{info.symbol}|$" if info.is_vector else f"${info.symbol}$"
        rows.append((symbol, info.shown_unit.replace("^2", "²") or "—", *spots))
    drive = study.turn.drive
    header = [text if i not in (3, 5) else f"${drive.symbol}$" for i, text in enumerate(_EXTREMES[press.lang])]
    return press.table(Words("极值及其位置", "Extreme values and where they stand"), header, rows, "lcrrrr")


def _exact(value: float, top: float) -> str:
    """Five significant digits; zero for what rounding leaves beside the largest value."""
    if abs(value) < 1e-9 * top:
        return "0"
    return _number(value, int(min(6, max(0, 4 - floor(log10(abs(value)))))))
