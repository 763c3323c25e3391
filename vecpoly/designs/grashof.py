"""Whether a four-bar chain has a crank, what each of its links gives as the frame, and how long one may be."""

from __future__ import annotations

from collections.abc import Collection
from typing import ClassVar

from pydantic import model_validator

from ..devices.base import Length
from ..errors import FaultError
from ..names import Named
from ..words import Words
from .base import Design
from .quantities import FOUR_BAR

ENDS, MIDDLE = Named("ends", "l_{min} + l_{max}", "mm"), Named("middle", "l′ + l″", "mm")
LEAST, MOST = Named("CD_min", "l_{f min}", "mm"), Named("CD_max", "l_{f max}", "mm")  # f: which link, is asked


class Grashof(Design):
    """The lengths of the chain AB, BC, CD, AD; CD is opposite AB, the shortest, and its length may vary as the frame
    of a double rocker."""

    kind: ClassVar[str] = "grashof"
    AB: Length
    BC: Length
    CD: Length
    AD: Length

    @model_validator(mode="after")
    def _possible(self) -> Grashof:
        lengths = {named.key: getattr(self, named.key) for named in FOUR_BAR}
        longest = max(lengths, key=lambda key: float(lengths[key].si))
        others = sum(one.si for key, one in lengths.items() if key != longest)
        if lengths[longest].si >= others:
            raise FaultError(
                Words(
                    f"{longest} = {lengths[longest].text} 不小于其余三杆之和 {1e3 * others:.6g} mm，四杆不能装配；请改"
                    f"动长度",
                    f"{longest} = {lengths[longest].text} is not below the sum of the others, {1e3 * others:.6g} mm: "
                    f"no "
                    "closed chain; change a length",
                ),
                longest,
                code="out-of-range",
            )
        if self.AB.si >= min(self.BC.si, self.AD.si):
            raise FaultError(
                Words(
                    f"AB = {self.AB.text} 应是 AB、BC、AD 中最短者；请改换字母，使 AB 最短",
                    f"AB = {self.AB.text} must be the shortest of AB, BC and AD; name the links so that it is",
                ),
                "AB",
                code="out-of-range",
            )
        return self

    def task(self, asked: Collection[str]) -> Words:
        """A chain, each link of which may be the frame."""
        return Words(
            "铰链四杆机构 $ABCD$ 各杆 $AB$、$BC$、$CD$、$AD$ 的长度已知。判断以 $AD$ 为机架时有无曲柄，以哪一杆为机架"
            "得双曲柄机构，以哪一杆为机架得双摇杆机构。",
            "The lengths of the links $AB$, $BC$, $CD$ and $AD$ of a four-bar chain $ABCD$ are given. Find whether "
            "there is a crank with $AD$ as the frame, which link as the frame gives a double crank, and which a "
            "double rocker.",
        )

    def quantities(self) -> tuple[Named, ...]:
        """Both sums of the condition; the bounds of CD as the frame of a double rocker; the lengths."""
        return (ENDS, MIDDLE, LEAST, MOST, *FOUR_BAR)

    def given(self) -> tuple[tuple[str, str], ...]:
        """The four lengths."""
        return tuple((named.symbol, getattr(self, named.key).text) for named in FOUR_BAR)

    @property
    def is_found(self) -> bool:
        """Whether CD alone gives a double rocker as the frame: AB is the shortest link, and has room to turn."""
        least, *middle, most = sorted((self.AB.si, self.BC.si, self.CD.si, self.AD.si))
        return self.AB.si == least and least + most <= sum(middle) * (1 + 1e-9)

    @property
    def size(self) -> float:
        """All links end to end."""
        return self.AB.si + self.BC.si + self.CD.si + self.AD.si
