"""Curves of a course report, each with its title: over the drive's position as wide as the text, so that peaks have
room for their numbers; paths and hodographs of half the width, two beside each other."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING

from numpy.typing import ArrayLike

from ....cycle import Cycle, extremes
from ....drawing.hues import ink_of
from ....drawing.scene import Scene
from ....figures.hue import Hue
from ....findings.study.study import Study
from ....words import Lang, Words

if TYPE_CHECKING:
    from ....curves.plot import Plot

LINES = 4  # in one panel
WIDE = 165.0, 60.0  # mm: curves over the drive's position
_NARROW, _BROAD = 83.0, 130.0  # mm: beside another one, alone
_LEAST_HIGH = 62.0  # mm: what is lower beside another one stands alone
_FLAT, _LOW = 80.0, 57.0  # mm, height of a plane; of a long report
Plotted = tuple[Scene, Words]


def inks(study: Study, keys: Sequence[str]) -> dict[str, Hue]:
    """The ink of each of these vectors that is drawn in one."""
    bases = dict.fromkeys(key.partition(".")[0] for key in keys)
    found = {base: ink_of(base, study.solution.construction.tones) for base in bases}
    return {base: hue for base, hue in found.items() if hue != Hue.BLACK}


def curve(study: Study, lang: str, keys: Sequence[str], turn: Cycle | None = None) -> Plotted:
    """These columns in one pair of axes (one for each unit). turn: another cycle than the study's own."""
    from ....curves import curves

    width, panel = WIDE
    plot = curves(
        turn or study.turn,
        tuple(keys),
        "en" if lang == "en" else "zh",
        width=width,
        panel=panel,
        inks=inks(study, keys),
        known=study.extremes if turn is None else partial(extremes, turn),
    )
    return plot.scene, plot.title


def given(
    study: Study,
    lang: str,
    line: tuple[ArrayLike, ArrayLike],
    label: tuple[str, str],
    title: Words,
    *,
    marks: tuple[tuple[float, float], ...] = (),
    level: float | None = None,
) -> Plotted:
    """Values that are no columns over the drive's angle (degrees). label: symbol, unit; marks: dots; level: dashed."""
    from ....curves import given_values

    width, panel = WIDE
    which: Lang = "en" if lang == "en" else "zh"
    plot = given_values(study.turn, *line, label, title, which, marks=marks, level=level, width=width, panel=panel)
    return plot.scene, plot.title


def way(study: Study, lang: str, letter: str) -> Plotted:
    """The path of a point."""
    from ....curves import trace

    plot = _large(lambda width: trace(study.turn, (letter,), _tongue(lang), width=width, height=_FLAT))
    return plot.scene, plot.title


def posed(study: Study, lang: str, letter: str) -> Plotted:
    """The mechanism in several positions, beside the path of the point."""
    from ....curves import poses

    plot = _large(lambda width: poses(study.turn, letter, _tongue(lang), width=width, height=_FLAT))
    return plot.scene, plot.title


def _large(plotted: Callable[[float], Plot]) -> Plot:
    """Beside another one; where that would leave it low, and its letters no room, as wide as the text."""
    narrow = plotted(_NARROW)
    return narrow if narrow.scene.extents.height >= _LEAST_HIGH else plotted(_BROAD)


def _tongue(lang: str) -> Lang:
    return "en" if lang == "en" else "zh"


def swept(study: Study, lang: str, key: str, turn: Cycle | None = None) -> Plotted:
    """The hodograph of a vector. turn: another cycle than the study's own."""
    from ....curves import hodograph

    plot = hodograph(
        turn or study.turn,
        key,
        "en" if lang == "en" else "zh",
        width=_NARROW,
        height=_LOW if study.dense else _FLAT,
        ink=inks(study, [key]).get(key),
    )
    return plot.scene, plot.title
