"""构件受力图: a link drawn apart with the forces on it, to the scale of lengths; its arrows have the ink of forces."""

from __future__ import annotations

from ..words import Words
from .hue import Hue
from .kind import View, register
from .mu import LENGTH

INK = Hue("force", (0.02, 0.33, 0.20))

View.BODY = register(
    View(
        name="body",
        order=40,
        title=Words("构件受力图", "Free body"),
        called=Words("各构件的受力图", "the free bodies"),
        mu=LENGTH,
        ink=INK,
        bodies=True,
    )
)
