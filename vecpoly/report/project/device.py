"""A chapter on a device: a cam, a train of gears."""

from __future__ import annotations

from typing import Any

from ...project.part import Part
from ...words import Words
from ..picture import diagram, picture
from .binder import Binder
from .linkage import told
from .task import scene

_PICTURE = (110.0, 70.0)  # mm


def chapter(part: Part, binder: Binder) -> dict[str, Any]:
    """Given, asked, sketch, steps, results."""
    press, construction = binder.press, part.solution.construction
    drawn = picture(part.problem, construction, *_PICTURE)
    blocks = diagram(construction)
    name = part.problem.title
    sketch = Words(f"{name.zh}简图", f"{name.en}: sketch")
    return {
        "picture": press.figure(scene(drawn, binder), sketch) if drawn and not blocks else "",
        "diagram": press.figure(scene(blocks, binder), blocks.title) if blocks else "",
        "sheets": "" if blocks else binder.numbers(part),
        **told(part, binder),
    }
