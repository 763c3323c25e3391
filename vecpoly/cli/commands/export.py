"""vecpoly export: a construction that moves, for GeoGebra; the profile of a cam for a workshop."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from ...words import Words
from ..errors import Tally, about
from ..files import put, spared
from ..jobs import each, problems
from ..onward import ThenOption, onward
from ..options import Lang, LangOption, OutOption, OutsideOption
from ..terminal import warn
from ..wording import symbol
from .draw import Id

if TYPE_CHECKING:
    from ...export.recording import Recording
    from ...problem.problem import Problem

_STIFF = Words("：其作图不能随原动件变动，未写入", ": found by a construction that cannot follow the input, left out")
_LOADED = Words("：属力分析，GeoGebra 文件不含载荷，未写入", ": found from loads, which a GeoGebra file leaves away")
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
    warn(problem.id, _left_out(recording), lang)


def _left_out(recording: Recording) -> Iterator[Words]:
    """What is asked and does not stand in the file; that it shows the moving diagram alone, where nothing does."""
    for keys, why in ((recording.left_out, _STIFF), (recording.loads, _LOADED)):
        if keys:
            names = [symbol(key) for key in keys]
            yield Words("、".join(names), ", ".join(names)) + why
    if not recording.follow and (recording.left_out or recording.loads):
        yield Words("文件中只有随原动件运动的机构图", "the file has the moving diagram alone")


def _profile(problem: Problem, ending: str) -> bytes:
    """The profile of a cam; raises NoMethodError for another problem."""
    from ...export.cams.drawing import cam_dxf
    from ...export.cams.profile import profile_of
    from ...export.cams.table import cam_csv

    profile = profile_of(problem)
    return cam_csv(profile) if ending == ".csv" else cam_dxf(profile)
