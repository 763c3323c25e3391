"""Chapter 5, the results: the table, the curves, the paths, the extreme values."""

from __future__ import annotations

from typing import Any

import numpy as np

from ....cycle.facts.path import Shape
from ....cycle.facts.path_words import path_sentences
from ....findings.shown import dead_points
from ....findings.study.study import Study
from ....findings.study.working_range import SOUND
from ....findings.transmission import transmission
from ....names import subscripted
from ....words import Words
from ..analysis import force_words
from ..numbering import SMALL, TINY, Press
from . import loaded
from .circling import is_trivial
from .circling import told as circling_told
from .extreme_values import extremes
from .plots import LINES, Plotted, curve, posed, swept, way
from .tabled import COLUMNS, TIGHT, halved, tabled

_ABREAST = 4  # links in one table
_FLAT = 5.0  # times as large as another curve: that one has a figure of its own
_STEMS = {
    "phi": Words("构件的转角", "Angles of the links"),
    "omega": Words("构件的角速度", "Angular velocities of the links"),
    "alpha": Words("构件的角加速度", "Angular accelerations of the links"),
}


def chapter(study: Study, press: Press) -> dict[str, Any]:
    """Sections with their tables, figures and words in order."""
    press.chapter = "5"
    extreme = extremes(study, press)
    return {
        "sections": sections(study, press),
        "extremes": extreme,
        "step": _step(study),
        "count": len(study.turn.phi),
        "loaded": bool(study.forces),
        "rubs": "eta" in study.forces,
        "range": _range(study, press) + force_words.one_sided(study).of(press.lang),
    }


def sections(study: Study, press: Press) -> list[dict[str, Any]]:
    """Links, points, transmission angles, forces: those of which there is something to show."""
    found = [
        _links(study, press),
        *(_point(study, press, letter) for letter in study.points),
        _angles(study, press),
        loaded.section(study, press),
    ]
    told = [one for one in found if any(one.get(part) for part in ("tables", "figures", "before", "alone"))]
    return [one | {"shown": press.shown(one["tables"], one["figures"])} for one in told]


def _links(study: Study, press: Press) -> dict[str, Any]:
    """Angles, ω, α of all links that turn unevenly; of the others ω in words alone."""
    every = [f"{stem}_{link}" for stem in _STEMS for link in study.links]
    even = {f"phi_{link}" for link in study.links if not study.varies(f"omega_{link}")}
    keys = [key for key in every if study.varies(key) and key not in even]
    title = Words("构件的转角、角速度和角加速度", "Angles, angular velocities and accelerations of the links")
    blocks = (
        [keys]
        if len(keys) <= TIGHT
        else [
            [key for key in keys if key.partition("_")[2] in study.links[i : i + _ABREAST]]
            for i in range(0, len(study.links), _ABREAST)
        ]
    )
    tables = [tabled(study, press, some, title, SMALL if len(some) <= COLUMNS else TINY) for some in blocks if some]
    stems = [[key for key in keys if key.startswith(f"{stem}_")] for stem in _STEMS]
    panels = [alike for some in stems for alike in ([some] if study.dense else _alike(study, some))]
    plots = [curve(study, press.lang, some[i : i + LINES]) for some in panels for i in range(0, len(some), LINES)]
    steady = [_steady(study, key[6:]) for key in every if key.startswith("omega_") and key not in keys]
    said = [*steady, *(halved(study, some) for some in blocks if some)]
    return {
        "title": Words("构件的转动", "Rotation of the links").of(press.lang),
        "words": Words("".join(w.zh for w in said), "".join(w.en for w in said)).of(press.lang),
        "alone": bool(steady),
        "before": [],
        "tables": tables,
        "figures": press.figures(plots),
    }


def _alike(study: Study, keys: list[str]) -> list[list[str]]:
    """Those that can share an axis: none so small beside another that its curve would lie flat on zero."""
    size = {key: float(np.nanmax(np.abs(study.turn.real(key)))) for key in keys}
    large = [key for key in keys if size[key] * _FLAT >= max(size.values())]
    small = [key for key in keys if key not in large]
    return [large, *_alike(study, small)] if small else [large] if large else []


def _steady(study: Study, link: str) -> Words:
    """A link that turns evenly; or, where the drive's own acceleration is given, that has the same rates everywhere."""
    (omega, size), (alpha, growth) = (_mean(study, f"{stem}_{link}") for stem in ("omega", "alpha"))
    if study.mech.drive.accel:
        return Words(
            f"构件 {link} 在各位置均有 {omega} = {size}，{alpha} = {growth}。",
            f"Link {link} has {omega} = {size} and {alpha} = {growth} in every position. ",
        )
    return Words(
        f"构件 {link} 匀速转动，{omega} = {size}，角加速度为零。",
        f"Link {link} rotates uniformly: {omega} = {size}, and its angular acceleration is zero. ",
    )


def _mean(study: Study, key: str) -> tuple[str, str]:
    """The symbol of a rate, and what it is on the average."""
    info, value = study.whole.info(key), float(np.nanmean(study.turn.real(key)))
    return f"${info.symbol}$", f"{info.factor * value:.5g} {info.shown_unit}".replace("-", "−")


def _point(study: Study, press: Press, letter: str) -> dict[str, Any]:
    """Position, velocity, acceleration of a point; its path and hodographs where it runs on a curve of its own (a
    straight path or an arc is told)."""
    trivial, found = is_trivial(study, letter), study.path(letter)
    tables = [] if trivial else [_rates_table(study, press, letter)]
    words = (" " if press.lang == "en" else "").join(w.of(press.lang) for w in path_sentences(study.whole, found))
    words += (circling_told(study, letter) if trivial else _symmetry(study, letter)).of(press.lang)
    own, last = found.shape is Shape.CURVE, letter == study.points[-1]
    before = [posed(study, press.lang, letter)] if last else []
    if own and (last or study.dense):
        before.append(way(study, press.lang, letter))
    first = press.figures(before)
    if last:
        words += _of_poses(press.through_all(first), own=own).of(press.lang)
    plots = [] if trivial else _rates_curves(study, press, letter, own, path=not (last or study.dense))
    return {
        "title": Words(f"${subscripted(letter)}$ 点的运动", f"Motion of ${subscripted(letter)}$").of(press.lang),
        "words": words,
        "before": first,
        "tables": tables,
        "figures": press.figures(plots),
    }


def _of_poses(where: str, *, own: bool) -> Words:
    path_zh, path_en = ("以及该点的轨迹", ", and the path,") if own else ("", "")
    return Words(
        f"机构在原动件等间隔各位置（彩色细线）和题设位置（黑色粗线）的简图{path_zh}见{where}。",
        f" The mechanism at equal steps of its drive (thin, in colour) and in the given position (thick, black)"
        f"{path_en} {'are' if own else 'is'} drawn in {where}.",
    )


def _symmetry(study: Study, letter: str) -> Words:
    return Words("", " ") + halved(study, [f"{stem}_{letter}" for stem in "pva"])


def _rates_table(study: Study, press: Press, letter: str) -> str:
    at = subscripted(letter)
    title = Words(f"${at}$ 点的位置、速度和加速度", f"Position, velocity and acceleration of ${at}$")
    keys = [f"{stem}_{letter}" for stem in "pva"]
    return tabled(study, press, keys, title, TINY if study.dense else SMALL)


def _rates_curves(study: Study, press: Press, letter: str, own: bool, *, path: bool) -> list[Plotted]:
    """own: whether it runs on a curve of its own, so that it has hodographs; path: the curve has no figure yet."""
    plots = [curve(study, press.lang, keys) for stem in "pva" if (keys := _components(study, f"{stem}_{letter}"))]
    if own:
        plots += [
            *([way(study, press.lang, letter)] if path else []),
            *(swept(study, press.lang, f"{stem}_{letter}") for stem in "va"),
        ]
    return plots


def _components(study: Study, key: str) -> list[str]:
    """A vector's parts that change, and its magnitude where both do (of a place never)."""
    parts = [part for part in study.turn.info(key).parts if study.varies(part)]
    return [key, *parts] if len(parts) > 1 and not key.startswith("p_") else parts


def _angles(study: Study, press: Press) -> dict[str, Any]:
    """The transmission angles that change: what they are, and their curves."""
    told = [t for t in study.facts.transmissions if not t.is_constant]
    plots = [curve(study, press.lang, [t.key for t in told[:LINES]])] if told else []
    return {
        "title": Words("传动角", "Transmission angles").of(press.lang),
        "words": transmission(study, told).of(press.lang),
        "before": [],
        "tables": [],
        "figures": press.figures(plots),
    }


def _range(study: Study, press: Press) -> str:
    """The working range where the drive cannot turn right round."""
    if study.whole.whole:
        return ""
    low, high = (study.where(q).split(" = ")[1] for q in (study.whole.low, study.whole.high))
    drive = (
        Words("原动件的行程有限", "The drive has a limited stroke")
        if study.mech.drive.slide
        else Words("原动件不能整周转动", "The drive cannot make full revolutions")
    )
    told = drive + Words(
        f"，以下只列出其工作范围 {low} 至 {high}", f"; the tables cover its working range, {low} to {high}."
    )
    if not study.facts.dead:
        return (told + Words("。", "")).of(press.lang)
    dead, many = dead_points(study), len(study.facts.dead) > 1
    lies = f"the dead point{'s' * many}, at {dead.en}"
    beyond = Words(
        f"。该范围不包括死点（{dead.zh}）附近杆组行列式小于其最大值 {100 * SOUND:.0f} % 的位置，"
        "那里速度和加速度急剧增大。",
        f" It leaves out the neighbourhood of {lies}, where a determinant is under {100 * SOUND:.0f} % of its largest "
        "value and velocities and accelerations grow without bound.",
    )
    return (told + beyond).of(press.lang)


def _step(study: Study) -> str:
    drive = study.turn.drive
    return f"{drive.factor * study.step:g}{'°' if drive.shown_unit == '°' else ' ' + drive.shown_unit}"
