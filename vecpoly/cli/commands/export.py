"""vecpoly export: a construction that moves, for GeoGebra; the profile of a cam for a workshop."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from ...words import Words
from ..errors import Tally, about
from ..files import put, spared
from ..jobs import each, problems
from ..onward import ThenOption, onward
from ..options import Lang, LangOption, OutOption, OutsideOption
from ..terminal import warn
from .draw import Id

if TYPE_CHECKING:
    from ...problem.problem import Problem

ENDINGS = (".ggb", ".dxf", ".csv")


def export(
    name: Id,
    output: OutOption = None,
    lang: LangOption = "zh",
    allow_outside: OutsideOption = False,
    then: ThenOption = None,
) -> None:
    """Write a GeoGebra file: turn the crank with a slider, and diagram, velocity and acceleration polygon follow.

    Points are made of earlier points, as on the sheet; poles can be dragged. Drawn exactly; loads are left away.
    Of a cam: its profile, splines as .dxf or points as .csv.
    """
    path = output or Path(f"{Path(name).stem}.ggb")
    tally = Tally()
    found = onward(problems([name], tally, allow_outside), then, tally, lang)
    spared(path, ENDINGS, found)
    for problem in found:
        with tally.job(), about(problem):
            target = each(path, problem.id, len(found))
            if path.suffix.lower() == ".ggb":
                _moving(problem, target, lang)
            else:
                put(target, _profile(problem, path.suffix.lower()))
    tally.settle()


def _moving(problem: Problem, target: Path, lang: Lang) -> None:
    from ...export.geogebra.document import to_ggb
    from ...export.recording import record

    recording = record(problem)
    put(target, to_ggb(recording, lang))
    if recording.left_out:
        keys = recording.left_out
        zh, en = "、".join(keys), ", ".join(keys)
        said = Words(f"{zh} 不随原动件变动，未写入", f"{en} would not follow the input and is left out")
        warn(problem.id, [said], lang)


def _profile(problem: Problem, ending: str) -> bytes:
    """The profile of a cam; raises NoMethodError for another problem."""
    from ...export.cams.drawing import cam_dxf
    from ...export.cams.profile import profile_of
    from ...export.cams.table import cam_csv

    profile = profile_of(problem)
    return cam_csv(profile) if ending == ".csv" else cam_dxf(profile)
