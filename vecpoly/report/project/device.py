"""A chapter on a device: a cam, a train of gears."""

from __future__ import annotations

from typing import Any

from ...project.part import Part
from ...words import Words
from ..content import cautions, conclusions, sections, statement
from ..picture import diagram, picture
from ..tables import readings_table
from .binder import Binder
from .linkage import captioned
from .task import scene

_PICTURE = (110.0, 70.0)  # mm


def chapter(part: Part, binder: Binder) -> dict[str, Any]:
    """Given, asked, sketch, steps, results."""
    press, lang, solution = binder.press, binder.lang, part.solution
    drawn = picture(part.problem, solution.construction, *_PICTURE)
    blocks = diagram(solution.construction)
    name = part.problem.title
    sketch = Words(f"{name.zh}简图", f"{name.en}: sketch")
    return {
        **statement(solution, lang),
        "picture": press.figure(scene(drawn, binder), sketch) if drawn and not blocks else "",
        "diagram": press.figure(scene(blocks, binder), blocks.title) if blocks else "",
        "sections": sections(solution, lang, press.objects),
        "sheets": "" if blocks else binder.numbers(part),
        "table": captioned(
            readings_table(solution, lang), Words("量取结果与精确值", "Readings and exact values"), binder
        ),
        "conclusions": conclusions(solution, lang),
        "cautions": cautions(solution, lang),
    }
