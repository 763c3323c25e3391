"""Pins from shared letters; sliding and rolling joints in words: ``4 slides in 5``, ``4 rolls on 3 at H``."""

from __future__ import annotations

from itertools import pairwise

from ...errors import FaultError
from ...mechanism.model import FRAME, Joint, Revolute
from ...words import Words
from ..links.bodies import Bodies
from .slides import read_slide

_FORMS = (
    "'4 slides in 5', '5 slides on y = 600 mm', '2 passes through 3', 'B runs in 3', '3 rolls on y = 0 mm at "
    "D', '4 rolls on 3 at H'"
)
EXAMPLES = Words(f"{_FORMS} 或 '1 touches 2 at K'", f"{_FORMS} or '1 touches 2 at K'")


def revolutes(bodies: Bodies) -> tuple[Revolute, ...]:
    """A letter on two bodies is a pin; on k bodies a multiple joint of k - 1 pins. The frame comes last."""
    pins = []
    for letter in bodies.letters():
        names = [name for name, draft in bodies.drafts.items() if letter in draft.points]
        names += [FRAME] if letter in bodies.frame else []
        pins += [Revolute(point=letter, a=a, b=b) for a, b in pairwise(names)]
    return tuple(pins)


def read_joint(text: object, bodies: Bodies) -> Joint:
    """One entry of `joints`. A pin in a slot adds its massless block to the bodies."""
    if not isinstance(text, str):
        raise FaultError(Words(f"运动副应写成一句话，如 {EXAMPLES.zh}", f"a joint is a sentence such as {EXAMPLES.en}"))
    if (slide := read_slide(text, bodies)) is not None:
        return slide
    raise FaultError(
        Words(
            f"“{text}”不是运动副的写法；应写 {EXAMPLES.zh}（转动副不必写：字母相同即为铰链）",
            f"'{text}' is no joint; write {EXAMPLES.en} (pins need no entry: shared letters make them)",
        ),
        code="spelling",
    )
