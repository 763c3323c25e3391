"""Curves of a course report: each with its title, of half the width where there are many,
so that two stand beside each other."""

from __future__ import annotations

from collections.abc import Sequence

from ....drawing.scene import Scene
from ....findings.study.study import Study
from ....words import Words

LINES = 4  # in one panel
_WIDE, _NARROW = (150.0, 60.0), (83.0, 57.0)  # mm
_FLAT, _LOW = 80.0, 57.0  # mm, height of a plane; of a long report
Plotted = tuple[Scene, Words]


def curve(study: Study, lang: str, keys: Sequence[str]) -> Plotted:
    """These columns in one pair of axes (one for each unit)."""
    from ....curves import curves

    width, panel = _NARROW if study.dense else _WIDE
    plot = curves(study.turn, tuple(keys), "en" if lang == "en" else "zh", width=width, panel=panel)
    return plot.scene, plot.title


def way(study: Study, lang: str, letter: str) -> Plotted:
    """The path of a point."""
    from ....curves import trace

    plot = trace(
        study.turn, (letter,), "en" if lang == "en" else "zh", width=_NARROW[0], height=_LOW if study.dense else _FLAT
    )
    return plot.scene, plot.title


def posed(study: Study, lang: str, letter: str, *, small: bool) -> Plotted:
    """The mechanism in several positions with the path of the point; small: beside another figure."""
    from ....curves import poses

    plot = poses(
        study.turn,
        letter,
        "en" if lang == "en" else "zh",
        **({"width": _NARROW[0], "height": _LOW} if small else {"height": 88.0}),
    )
    return plot.scene, plot.title


def swept(study: Study, lang: str, key: str) -> Plotted:
    """The hodograph of a vector."""
    from ....curves import hodograph

    plot = hodograph(
        study.turn, key, "en" if lang == "en" else "zh", width=_NARROW[0], height=_LOW if study.dense else _FLAT
    )
    return plot.scene, plot.title
