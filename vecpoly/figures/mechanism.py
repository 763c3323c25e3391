"""机构运动简图: the kinematic diagram, to the scale of lengths."""

from __future__ import annotations

from ..words import Words
from .kind import View, register
from .mu import LENGTH

View.MECHANISM = register(
    View(
        name="mechanism",
        order=10,
        title=Words("机构运动简图", "Kinematic diagram"),
        called=Words("机构位置图", "the diagram"),
        mu=LENGTH,
        bodies=True,
        wide=True,
    )
)
