"""vecpoly export: a construction that moves, for GeoGebra."""

from __future__ import annotations

from pathlib import Path

from ...words import Words
from ..errors import Tally, about
from ..files import put, spared
from ..jobs import each, problems
from ..options import LangOption, OutOption, OutsideOption
from ..terminal import warn
from .draw import Id

ENDINGS = (".ggb",)


def export(name: Id, output: OutOption = None, lang: LangOption = "zh", allow_outside: OutsideOption = False) -> None:
    """Write a GeoGebra file: turn the crank with a slider, and diagram, velocity and acceleration polygon follow.

    Points are made of earlier points, as on the sheet; poles can be dragged. Drawn exactly; loads are left away.
    """
    path = output or Path(f"{Path(name).stem}.ggb")
    tally = Tally()
    found = problems([name], tally, allow_outside)
    spared(path, ENDINGS, found)
    from ...export.geogebra.document import to_ggb
    from ...export.recording import record

    for problem in found:
        with tally.job(), about(problem.id):
            recording = record(problem)
            put(each(path, problem.id, len(found)), to_ggb(recording, lang))
            if recording.left_out:
                keys = recording.left_out
                zh, en = "、".join(keys), ", ".join(keys)
                said = Words(f"{zh} 不随原动件变动，未写入", f"{en} would not follow the input and is left out")
                warn(problem.id, [said], lang)
    tally.settle()
