"""Two driving links, and groups of any form of joint upon both."""

from __future__ import annotations

from ..family import family
from ..linkages import GROUPS, crank, grown, slide
from ..linkages.asks import motion_asks
from ..linkages.sketch import Sketch
from .words import Random


@family("mixed-two-drives", often=1)
def two_drives(rng: Random) -> str:
    """Cranks or sliders as both drives, one to three groups on whatever is there."""
    sketch, inputs = Sketch(rng), []
    for name in "12":
        (slide if sketch.chance(0.4) else crank)(sketch, name)
        inputs.append(sketch.input)
    for _ in range(int(rng.integers(1, 4))):
        sketch = grown(sketch, GROUPS[int(rng.integers(len(GROUPS)))])
    motion_asks(sketch)
    sketch.input = f"[{', '.join(inputs)}]"
    return sketch.yaml()
